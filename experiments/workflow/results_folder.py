# SPDX-License-Identifier: BSD-3-Clause
"""Folders of results that appear whole, with outcome.json, or not at all."""
import errno
import json
import os
import pathlib
import shutil
import socket
from typing import Any


def begin(final: pathlib.Path) -> pathlib.Path:
    """An empty folder to work in, on the same file system as the final one."""
    name = f"{final.parent.name}-{final.name}-{socket.gethostname()}-{os.getpid()}"
    partial = final.parent.parent / "partial" / name
    shutil.rmtree(partial, ignore_errors=True)
    partial.mkdir(parents=True)
    return partial


def commit(partial: pathlib.Path, final: pathlib.Path, outcome: dict[str, Any]) -> None:
    write_json(partial / "outcome.json", outcome)
    final.parent.mkdir(parents=True, exist_ok=True)
    try:
        partial.rename(final)
    except OSError as error:
        # A process left over from a killed study was faster; its result is the same.
        if error.errno not in (errno.ENOTEMPTY, errno.EEXIST):
            raise
        shutil.rmtree(partial)


def write_json(file: pathlib.Path, value: Any) -> None:
    """The file appears whole."""
    partial = file.with_name(f".partial-{socket.gethostname()}-{os.getpid()}-{file.name}")
    partial.write_text(json.dumps(value, indent=1, sort_keys=True) + "\n")
    partial.rename(file)
