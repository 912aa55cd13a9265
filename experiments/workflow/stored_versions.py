# SPDX-License-Identifier: BSD-3-Clause
"""Which builds made the results that are there: those of several must not mix silently."""
import json
import pathlib
import shutil
from collections.abc import Iterator
from typing import Any

import log_tools


def warnings(work: pathlib.Path, plan: dict[str, Any]) -> Iterator[str]:
    """One line for each kind of result of which some were made by another build."""
    binaries = pathlib.Path(plan["bin"])
    made = [("logs", [i for i, log in plan["logs"].items() if log["tool"] == tool], tool)
            for tool in sorted({log["tool"] for log in plan["logs"].values()})]
    for folder, ids, name in [*made, ("runs", list(plan["runs"]), "gmapping_spa")]:
        version = log_tools.version(name, binaries)
        files = [work / folder / i / "outcome.json" for i in ids]
        found = [json.loads(f.read_text())["version"] for f in files if f.exists()]
        others = sum(v != version for v in found)
        if others:
            yield (f"{others} of the {len(found)} {folder} that are there were made by another "
                   f"build of {name} than this one ({version}); --fresh does them again")


def remove(work: pathlib.Path, plan: dict[str, Any]) -> None:
    """Forgets what is there of the plan."""
    for folder, ids in (("logs", plan["logs"]), ("runs", plan["runs"])):
        for i in ids:
            shutil.rmtree(work / folder / i, ignore_errors=True)
    for i in plan["runs"]:
        (work / "scores" / f"{i}.json").unlink(missing_ok=True)
        (work / "scores" / f"{i}.error_map.png").unlink(missing_ok=True)
