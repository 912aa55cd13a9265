#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes one simulated or stressed log: make_log.py PLAN LOG_ID, from the folder of results."""
import json
import pathlib
import shutil
import sys

import commands
import log_tools
import results_folder


def main() -> None:
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    log_id = sys.argv[2]
    tool, argv = plan["logs"][log_id]["tool"], plan["logs"][log_id]["argv"]
    binaries = pathlib.Path(plan["bin"])
    final = pathlib.Path("logs", log_id).absolute()
    words = log_tools.command(tool, argv, binaries)
    partial = results_folder.begin(final)
    try:
        status, error = commands.execute(
            [*words, *log_tools.output_arguments(tool, argv, partial)])
        results_folder.commit(partial, final, {
            "command": commands.command_line(
                [*words, *log_tools.output_arguments(tool, argv, final)], pathlib.Path.cwd(),
                pathlib.Path(plan["data"])),
            "exit_status": status,
            "error": error,
            "version": log_tools.version(tool, binaries),
        })
    except (commands.Interrupted, KeyboardInterrupt):
        sys.exit(f"log {log_id}: ended from outside")
    finally:
        shutil.rmtree(partial, ignore_errors=True)


if __name__ == "__main__":
    main()
