# SPDX-License-Identifier: BSD-3-Clause
"""What a set of studies needs to have done, as the Snakefile and its scripts read it."""
import pathlib
from typing import Any

from study import Run, Study


def make_plan(studies: list[Study], binaries: pathlib.Path, data: pathlib.Path,
              quick: bool) -> dict[str, Any]:
    """Runs and logs by id: what several studies ask for is there once."""
    runs = {run.id: run for study in studies for run in study.runs}
    return {
        "bin": str(binaries),
        "data": str(data),
        "studies": [str(study.path.resolve()) for study in studies],
        "quick": quick,
        "logs": {run.log_id: {"tool": run.log_tool, "argv": run.log_argv}
                 for run in runs.values() if run.log_id},
        "runs": {run_id: _run(run) for run_id, run in runs.items()},
    }


def _run(run: Run) -> dict[str, Any]:
    threads = [word.partition("=")[2] for word in run.argv if word.startswith("--threads=")]
    return {
        "label": f"{run.configuration.label()}, seed {run.seed}",
        "log_id": run.log_id,
        "log_file": str(run.log_file) if run.log_file else None,
        "relations": str(run.relations) if run.relations else None,
        "argv": run.argv,
        "threads": int(threads[0]) if threads else 1,
    }
