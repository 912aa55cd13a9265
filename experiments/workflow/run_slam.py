#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does one run of a study: run_slam.py PLAN RUN_ID, from the folder of results.

A run that fails is a result: its outcome.json says how. One that is ended from outside leaves
nothing and is done again.
"""
import hashlib
import json
import pathlib
import shutil
import sys
from typing import Any

import commands
import log_tools
import results_folder


def log_of(plan: dict[str, Any], run: dict[str, Any], work: pathlib.Path) -> pathlib.Path:
    if run["log_file"]:
        return pathlib.Path(run["log_file"])
    tool = plan["logs"][run["log_id"]]["tool"]
    return work / "logs" / run["log_id"] / log_tools.LOG_NAMES[tool]


def slam(plan: dict[str, Any], run: dict[str, Any], partial: pathlib.Path,
         final: pathlib.Path) -> dict[str, Any]:
    """Runs gmapping_spa and returns the outcome."""
    work, data = pathlib.Path.cwd(), pathlib.Path(plan["data"])
    binary = pathlib.Path(plan["bin"]) / "gmapping_spa"
    outcome = {"version": commands.version(binary), "processor": commands.processor(),
               "log_sha256": None, "log_command": None}
    log = log_of(plan, run, work)
    words = [str(binary), f"--log={log}", *run["argv"]]
    outcome["command"] = commands.command_line([*words, f"--output_dir={final}"], work, data)
    if run["log_id"]:
        made = json.loads((log.parent / "outcome.json").read_text())
        outcome["log_command"] = made["command"]
        if made["exit_status"] != 0:
            return outcome | {"exit_status": made["exit_status"], "error": made["error"]}
    outcome["log_sha256"] = hashlib.sha256(log.read_bytes()).hexdigest()
    status, error = commands.execute([*words, f"--output_dir={partial}"])
    return outcome | {"exit_status": status, "error": error}


def main() -> None:
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    run_id = sys.argv[2]
    run = plan["runs"][run_id]
    final = pathlib.Path("runs", run_id).absolute()
    partial = results_folder.begin(final)
    try:
        outcome = slam(plan, run, partial, final)
        results_folder.commit(partial, final, outcome)
    except (commands.Interrupted, KeyboardInterrupt):
        sys.exit(f"{run['label']}: ended from outside")
    finally:
        shutil.rmtree(partial, ignore_errors=True)
    if outcome["exit_status"] == 0:
        print(f"done   {run['label']}", flush=True)
    else:
        print(f"FAILED {run['label']}: {outcome['error']}", flush=True)


if __name__ == "__main__":
    main()
