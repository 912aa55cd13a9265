#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scores one run: score.py PLAN RUN_ID, from the folder of results.

Metrics that do not apply, and all metrics of a failed run, are null.
"""
import json
import math
import os
import pathlib
import subprocess
import sys
from typing import Any

import log_tools
import results_folder
from metrics import METRICS

Scores = dict[str, float | None]

OBSTACLES = "truth_obstacles.yaml"  # beside the truth of a world with obstacles


def evaluate(binary: pathlib.Path, *words: str) -> dict[str, Any]:
    """What an evaluator prints as JSON."""
    done = subprocess.run([binary, *words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{binary.name} {' '.join(words)}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def relation_scores(binaries: pathlib.Path, folder: pathlib.Path, relations: pathlib.Path) -> Scores:
    errors = evaluate(binaries / "evaluate_relations", f"--relations={relations}",
                      f"--trajectory={folder / 'trajectory.tum'}")
    return {
        "relation_error_m": errors["translation_m"]["mean"],
        "relation_std_m": errors["translation_m"]["std"],
        "relation_median_m": errors["translation_m"]["median"],
        "relation_rotation_deg": errors["rotation_deg"]["mean"],
        "relations_used": errors["used"],
    }


def trajectory_scores(binaries: pathlib.Path, folder: pathlib.Path, truth: pathlib.Path) -> Scores:
    errors = evaluate(binaries / "evaluate_trajectory", f"--truth={truth / 'truth.tum'}",
                      f"--trajectory={folder / 'trajectory.tum'}", "--align=se2",
                      "--rpe_delta=1", "--rpe_unit=m")
    return {
        "ate_rmse_m": errors["ate"]["translation_m"]["rmse"],
        "ate_max_m": errors["ate"]["translation_m"]["max"],
        "heading_rmse_deg": errors["ate"]["rotation_deg"]["rmse"],
        "rpe_m_per_m": errors["rpe"]["translation_m"]["rmse"],
    }


def map_scores(binaries: pathlib.Path, folder: pathlib.Path, truth: pathlib.Path | None,
               error_map: pathlib.Path) -> Scores:
    """Of the map alone without `truth`; else against it, with a picture of the differences."""
    words = [f"--map={folder / 'map.yaml'}"]
    partial = error_map.with_name(f".partial-{os.getpid()}-{error_map.name}")
    if truth:
        words += [f"--truth={truth / 'truth.yaml'}", f"--truth_trajectory={truth / 'truth.tum'}",
                  f"--trajectory={folder / 'trajectory.tum'}", f"--error_map={partial}"]
        if (truth / OBSTACLES).exists():
            words.append(f"--objects={truth / OBSTACLES}")
    printed = evaluate(binaries / "evaluate_map", *words)
    if truth:
        partial.rename(error_map)
    alone = {f"map_{name}": printed["map"][name]
             for name in ("occupied_cells", "enclosed_areas", "corners")}
    return alone | (errors_of_map(printed) | flaws_of_map(printed) | scores_of_obstacles(
        printed.get("objects", [])) if truth else {})


def errors_of_map(printed: dict[str, Any]) -> Scores:
    scores = {f"map_{name}": printed[name]
              for name in ("missing", "extra", "precision", "recall", "iou", "known")}
    scores["map_blur_m"] = printed["blur_m"]["mean"]
    for name, key in (("map_shift", "shift_m"), ("map_to_truth", "map_to_truth_m"),
                      ("truth_to_map", "truth_to_map_m")):
        scores[f"{name}_m"] = printed[key]["mean"]
        scores[f"{name}_p95_m"] = printed[key]["p95"]
    return scores


def flaws_of_map(printed: dict[str, Any]) -> Scores:
    """What a reader of the map sees."""
    walls, ghosts, corners = printed["walls"], printed["ghost_walls"], printed["corners"]
    return {
        "map_broken": None if printed["broken"] is None else float(printed["broken"]),
        "map_ghost_walls": ghosts["number"],
        "map_ghost_walls_m": ghosts["length_m"],
        "map_doubled_walls_m": walls["doubled_m"],
        "map_missing_walls": part(walls["missing"], walls["in_sight"]),
        "map_broken_walls": part(walls["broken"], walls["in_sight"]),
        "map_wall_gaps": walls["gaps"],
        "map_corners_found": part(corners["found"], corners["in_sight"]),
        "map_corners_false": corners["false"],
    }


def part(some: int, whole: int) -> float | None:
    return some / whole if whole else None


def scores_of_obstacles(objects: list[dict[str, Any]]) -> Scores:
    """Means over those of which the robot could see something."""
    in_sight = [thing for thing in objects if thing["surface_m"] > 0.0]
    return {
        "obstacles_there": mean([float(thing["there"]) for thing in in_sight]),
        "obstacles_complete": mean([thing["complete"] for thing in in_sight]),
        "obstacles_blur_m": mean([thing["width_m"] for thing in in_sight
                                  if thing["width_m"] is not None]),
    }


def mean(values: list[float]) -> float | None:
    return sum(values) / len(values) if values else None


def record_scores(record: dict[str, Any]) -> Scores:
    """Costs and counts that the run itself wrote down."""
    used, closures = record["resources"], record["loop_closures"]
    return {
        "cpu_s": used["user_s"] + used["system_s"],
        "wall_s": used["processing_s"] + used["finish_s"] + used["writing_s"],
        "peak_memory_mb": used["peak_memory_mb"],
        "updates": record["counts"]["updates"],
        "closures_accepted": closures["accepted"],
        "closures_rejected": sum(closures["rejected"].values()),
        "scans": record["counts"]["scans"],
    }


def truth_of(run: dict[str, Any]) -> tuple[pathlib.Path | None, pathlib.Path | None]:
    """The folder with the truth of a simulated log; the relations of a recorded or stressed one."""
    if not run["log_id"]:
        return None, pathlib.Path(run["relations"]) if run["relations"] else None
    made = pathlib.Path("logs", run["log_id"])
    relations = made / log_tools.RELATIONS
    some_are_left = relations.exists() and relations.stat().st_size > 0
    return (made if (made / "truth.tum").exists() else None,
            relations if some_are_left else None)


def scores_of(plan: dict[str, Any], run_id: str) -> Scores:
    run, folder = plan["runs"][run_id], pathlib.Path("runs", run_id)
    scores: Scores = dict.fromkeys(METRICS)
    if json.loads((folder / "outcome.json").read_text())["exit_status"] != 0:
        return scores
    binaries = pathlib.Path(plan["bin"])
    truth, relations = truth_of(run)
    scores |= record_scores(json.loads((folder / "run.json").read_text()))
    scores |= map_scores(binaries, folder, truth, pathlib.Path("scores", f"{run_id}.error_map.png"))
    if truth:
        scores |= trajectory_scores(binaries, folder, truth)
    if relations:
        scores |= relation_scores(binaries, folder, relations)
    return {name: value if value is not None and math.isfinite(value) else None
            for name, value in scores.items()}


def main() -> None:
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    run_id = sys.argv[2]
    results_folder.write_json(pathlib.Path("scores", f"{run_id}.json"), scores_of(plan, run_id))


if __name__ == "__main__":
    main()
