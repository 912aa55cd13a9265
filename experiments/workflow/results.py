# SPDX-License-Identifier: BSD-3-Clause
"""What the runs of a study left in the folder of results."""
import dataclasses
import json
import pathlib
from typing import Any

from study import Run, Study


@dataclasses.dataclass(frozen=True)
class Result:
    """One run: how it ended and, unless it failed, what it wrote and how that scores."""
    run: Run
    outcome: dict[str, Any]
    scores: dict[str, float | None]
    record: dict[str, Any] | None  # run.json; None after a failure
    folder: pathlib.Path

    def failed(self) -> bool:
        return self.outcome["exit_status"] != 0


def load(study: Study, work: pathlib.Path) -> list[Result]:
    """The results of all runs, in their order; every run of the study must have been done."""
    results = []
    for run in study.runs:
        folder = work / "runs" / run.id
        outcome = json.loads((folder / "outcome.json").read_text())
        results.append(Result(
            run=run, outcome=outcome,
            scores=json.loads((work / "scores" / f"{run.id}.json").read_text()),
            record=(json.loads((folder / "run.json").read_text())
                    if outcome["exit_status"] == 0 else None),
            folder=folder))
    return results
