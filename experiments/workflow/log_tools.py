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
LOG_NAMES = {"simulate": "log.clf", "stress_log": "log.clf.gz"}


def program(tool: str, binaries: pathlib.Path) -> pathlib.Path:
    return STRESS / "stress_log.py" if tool == "stress_log" else binaries / tool


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
    if tool != "stress_log":
        return commands.version(program(tool, binaries))
    digest = hashlib.sha256()
    for file in sorted(STRESS.glob("*.py")):
        digest.update(file.read_bytes())
    return f"stress_log.py {digest.hexdigest()[:16]}"


def kinds_of_stress() -> list[str]:
    """As stress_log.py lists them."""
    words = [sys.executable, STRESS / "stress_log.py", "--list"]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        said = done.stderr.strip().splitlines() or ["no message"]
        raise StudyError(f"{words[1]} --list: {said[-1]}")
    return done.stdout.split()
