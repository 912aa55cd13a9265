#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Packs the built package as a wheel (PEP 427), with the standard library alone.

The target gmapping_spa_wheel runs it. The same files give the same bytes.
"""

import argparse
import base64
import hashlib
import os
import pathlib
import sys
import sysconfig
import zipfile

METADATA = """\
Metadata-Version: 2.1
Name: gmapping-spa
Version: {version}
Summary: 2D lidar SLAM with interchangeable pose-graph back ends
License: BSD-3-Clause
Requires-Python: =={python}.*
Requires-Dist: numpy
"""
WHEEL = """\
Wheel-Version: 1.0
Generator: gmapping_spa
Root-Is-Purelib: false
Tag: {tag}
"""
EARLIEST = (1980, 1, 1, 0, 0, 0)  # that a zip file can tell


def tag():
    """Of this interpreter. Shared libraries of Debian are not part of the wheel: no manylinux."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def files_of(package, version, license_path):
    """(name, content, executable) of all files but RECORD, which lists them."""
    for path in sorted(package.iterdir()):
        if path.is_file():
            yield f"{package.name}/{path.name}", path.read_bytes(), os.access(path, os.X_OK)
    info = f"gmapping_spa-{version}.dist-info"
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    yield f"{info}/METADATA", METADATA.format(version=version, python=python).encode(), False
    yield f"{info}/WHEEL", WHEEL.format(tag=tag()).encode(), False
    yield f"{info}/LICENSE", license_path.read_bytes(), False


def write_wheel(package, version, license_path, output_dir):
    output = output_dir / f"gmapping_spa-{version}-{tag()}.whl"
    unfinished = output.with_suffix(".part")
    record = ""
    with zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED) as archive:

        def add(name, content, executable):
            entry = zipfile.ZipInfo(name, EARLIEST)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if executable else 0o100644) << 16
            archive.writestr(entry, content)

        for name, content, executable in files_of(package, version, license_path):
            add(name, content, executable)
            record += record_line(name, content)
        name = f"gmapping_spa-{version}.dist-info/RECORD"
        add(name, (record + f"{name},,\n").encode(), False)
    unfinished.replace(output)
    return output


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for flag, text in (
        ("--package", "folder of the built package"),
        ("--license", "file of the license"),
        ("--output_dir", "folder that gets the wheel"),
    ):
        parser.add_argument(flag, type=pathlib.Path, required=True, help=text)
    parser.add_argument("--version", required=True, help="of the project")
    flags = parser.parse_args()
    if not any(flags.package.glob("_core*.so")):
        sys.exit(f"{flags.package}: expected the built module _core*.so, found none")
    print(write_wheel(flags.package, flags.version, flags.license, flags.output_dir))


if __name__ == "__main__":
    main()
