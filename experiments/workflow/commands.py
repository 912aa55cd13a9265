# SPDX-License-Identifier: BSD-3-Clause
"""Runs the project's executables and writes command lines down as a reader can repeat them."""
import hashlib
import os
import pathlib
import platform
import shlex
import signal
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Interrupted(Exception):
    """Somebody ended the executable from outside: that says nothing about its run."""


def execute(words: list[str]) -> tuple[int, str]:
    """Exit status, negative for a signal, and the last line of stderr if the status is not 0."""
    done = subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          errors="replace")
    outside = {-signal.SIGKILL, -signal.SIGTERM, -signal.SIGINT, 128 + signal.SIGINT}
    if done.returncode in outside:
        raise Interrupted
    if done.returncode == 0:
        return 0, ""
    lines = done.stderr.strip().splitlines()
    if done.returncode < 0:
        lines.append(f"ended by {signal.Signals(-done.returncode).name}")
    return done.returncode, lines[-1] if lines else "no message"


def command_line(words: list[str], work: pathlib.Path, data: pathlib.Path) -> str:
    """To be pasted in the root of the repository, with the folders $W (results) and $DATA set."""
    shown = " ".join(shlex.quote(word) for word in words)
    for folder, name in ((work, "$W/"), (data, "$DATA/"), (ROOT, "")):
        shown = shown.replace(f"{folder.resolve()}{os.sep}", name)
    return shown


def version(binary: pathlib.Path) -> str:
    """What the executable says, and a hash of its file and of the back ends beside it."""
    said = subprocess.run([binary, "--version"], capture_output=True, text=True).stdout
    digest = hashlib.sha256(binary.read_bytes())
    for plugin in sorted((binary.parent.parent / "lib").glob("**/libgmapping_spa_*.so")):
        digest.update(plugin.read_bytes())
    return f"{said.split()[-1] if said.split() else 'unknown'}, build {digest.hexdigest()[:16]}"


def processor() -> str:
    """What the runs' costs were measured on."""
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.machine()
