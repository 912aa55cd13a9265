#!/usr/bin/python3
"""Makes one simulated log: run_simulate.py PLAN LOG_ID, from the folder of results."""
import json
import pathlib
import shutil
import sys

import commands
import results_folder


def main() -> None:
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    log_id = sys.argv[2]
    binary = pathlib.Path(plan["bin"]) / "simulate"
    final = pathlib.Path("logs", log_id).absolute()
    words = [str(binary), *plan["logs"][log_id]]
    partial = results_folder.begin(final)
    try:
        status, error = commands.execute([*words, f"--output_dir={partial}"])
        results_folder.commit(partial, final, {
            "command": commands.command_line([*words, f"--output_dir={final}"], pathlib.Path.cwd(),
                                             pathlib.Path(plan["data"])),
            "exit_status": status,
            "error": error,
            "version": commands.version(binary),
        })
    except (commands.Interrupted, KeyboardInterrupt):
        sys.exit(f"log {log_id}: ended from outside")
    finally:
        shutil.rmtree(partial, ignore_errors=True)


if __name__ == "__main__":
    main()
