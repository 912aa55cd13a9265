# SPDX-License-Identifier: BSD-3-Clause
"""The programs that make logs: where they are, what they call their output, which version it is."""
import hashlib
import pathlib
import subprocess
import sys

import commands
from yaml_entry import StudyError

STRESS = commands.ROOT / "experiments" / "stress"
RELATIONS = "log.relations"  # of a stressed log; beside it as a simulated log has its truth
SCRIPTS = ("random_world", "stress_log")
LOG_NAMES = {"simulate": "log.clf", "random_world": "log.clf", "stress_log": "log.clf.gz"}


def command(tool: str, argv: list[str], binaries: pathlib.Path) -> list[str]:
    """The tool with these arguments, without those that say where the output goes."""
    if tool not in SCRIPTS:
        return [str(binaries / tool), *argv]
    simulate = [f"--simulate={binaries / 'simulate'}"] if tool == "random_world" else []
    return [str(_script(tool)), *argv, *simulate]


def _script(tool: str) -> pathlib.Path:
    return STRESS / f"{tool}.py"


def output_arguments(tool: str, argv: list[str], folder: pathlib.Path) -> list[str]:
    """What sends the output of the tool with these arguments into the folder."""
    if tool != "stress_log":
        return [f"--output_dir={folder}"]
    output = [f"--output={folder / LOG_NAMES[tool]}"]
    if any(word.startswith("--relations=") for word in argv):
        output.append(f"--relations_output={folder / RELATIONS}")
    return output


def version(tool: str, binaries: pathlib.Path) -> str:
    """Changes when the tool may make another log."""
    if tool not in SCRIPTS:
        return commands.version(binaries / tool)
    digest = hashlib.sha256()
    for file in sorted(STRESS.glob("*.py")):
        digest.update(file.read_bytes())
    script = f"{tool}.py {digest.hexdigest()[:16]}"
    if tool != "random_world":
        return script
    return f"{script}, simulate {commands.version(binaries / 'simulate')}"


def kinds(tool: str) -> list[str]:
    """Of stresses or buildings, as the script lists them."""
    words = [sys.executable, _script(tool), "--list"]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        said = done.stderr.strip().splitlines() or ["no message"]
        raise StudyError(f"{words[1]} --list: {said[-1]}")
    return done.stdout.split()
