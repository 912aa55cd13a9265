#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does the runs of studies, scores them and writes the report.

A stopped study goes on where it was when it is started again with the same folder of results.
A run that fails is counted and does not stop the study; the exit status tells whether the study
came to its end.
"""
import argparse
import fcntl
import os
import pathlib
import shutil
import sys

import commands
import plan as plans
import results_folder
import stored_versions
from report import checks
from study import StudyError, load_study

ROOT = commands.ROOT
HERE = pathlib.Path(__file__).resolve().parent
SNAKEMAKE = pathlib.Path("/usr/bin/snakemake")
EVALUATORS = ["evaluate_relations", "evaluate_trajectory", "evaluate_map"]


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("studies", nargs="+", type=pathlib.Path, metavar="STUDY.yaml")
    parser.add_argument("--work_dir", type=pathlib.Path,
                        help="results; default: out/study/NAME, with --quick out/study/NAME_quick")
    parser.add_argument("--quick", action="store_true", help="the studies' quick versions")
    parser.add_argument("-j", "--jobs", type=int,
                        help="runs side by side; default: one a core, or what the profile says")
    parser.add_argument("--profile", type=pathlib.Path,
                        help="a Snakemake profile, such as experiments/profiles/slurm")
    parser.add_argument("--until", choices=["runs", "scores", "report"], default="report",
                        help="where to stop")
    parser.add_argument("--fresh", action="store_true", help="does finished runs again")
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path(
        os.environ.get("GMAPPING_SPA_DATA", ROOT.parent / "shared" / "data")),
        help="folder with carmen/ and relations/")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin",
                        help="folder of the executables")
    args = parser.parse_args()
    args.bin, args.data = args.bin.resolve(), args.data.resolve()
    if args.work_dir is None:
        name = args.studies[0].stem + ("_quick" if args.quick else "")
        args.work_dir = ROOT / "out" / "study" / name
    args.work_dir = args.work_dir.resolve()
    return args


def lock(work: pathlib.Path) -> None:
    """Held until the workflow ends, which inherits it."""
    file = os.open(work / ".lock", os.O_RDWR | os.O_CREAT)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise StudyError(f"{work}: another study is at work in this folder") from None
    os.set_inheritable(file, True)


def write_if_changed(file: pathlib.Path, value) -> None:
    """An old file keeps its time, which decides what has to be done again."""
    results_folder.write_json(file.with_suffix(".new"), value)
    if file.exists() and file.read_bytes() == file.with_suffix(".new").read_bytes():
        file.with_suffix(".new").unlink()
    else:
        file.with_suffix(".new").rename(file)


def evaluators(args: argparse.Namespace) -> dict[str, str]:
    """Versions of the executables that score: another version scores again."""
    for name in EVALUATORS:
        if not (args.bin / name).is_file():
            raise StudyError(f"{args.bin / name}: no such file; build it, or name its folder by "
                             "--bin")
    return {name: commands.version(args.bin / name) for name in EVALUATORS}


def prepare(args: argparse.Namespace) -> None:
    """Checks all, then writes what the workflow reads."""
    if not SNAKEMAKE.is_file():
        raise StudyError(f"{SNAKEMAKE}: no such file; experiments/install_packages.sh experiments "
                         "installs it")
    studies = [load_study(path, args.bin, args.data, args.quick) for path in args.studies]
    checks.check(studies)
    plan = plans.make_plan(studies, args.bin, args.data, args.quick)
    versions = None if args.until == "runs" else evaluators(args)
    work = args.work_dir
    work.mkdir(parents=True, exist_ok=True)
    lock(work)
    shutil.rmtree(work / "partial", ignore_errors=True)
    if args.fresh:
        stored_versions.remove(work, plan)
    write_if_changed(work / "plan.json", plan)
    if versions:
        write_if_changed(work / "evaluators.json", versions)
    done = sum((work / "runs" / run / "outcome.json").exists() for run in plan["runs"])
    print(f"{', '.join(s.title for s in studies)}: {len(plan['runs'])} runs, {done} of them done; "
          f"results in {work}", flush=True)
    for warning in stored_versions.warnings(work, plan):
        print(f"warning: {warning}", flush=True)


def main() -> None:
    args = parse_arguments()
    try:
        prepare(args)
    except (StudyError, OSError) as error:
        sys.exit(f"run_study.py: error: {error}")
    words = [
        "snakemake", f"--snakefile={HERE / 'Snakefile'}", f"--directory={args.work_dir}",
        "--keep-going", "--scheduler=greedy", "--rerun-triggers", "mtime",
        f"--log-handler-script={HERE / 'progress.py'}",
        # Outputs appear whole, and the folder is locked already.
        "--ignore-incomplete", "--nolock",
        *([f"--profile={args.profile.resolve()}"] if args.profile else []),
        *([f"--jobs={args.jobs or os.cpu_count()}"] if args.jobs or not args.profile else []),
        args.until]
    os.execv(SNAKEMAKE, words)


if __name__ == "__main__":
    main()
