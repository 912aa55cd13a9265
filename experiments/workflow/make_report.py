#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the report of studies: one HTML page, its tables as CSV and Markdown, its figures as PNG.

The claims.yaml beside the studies, if there is one, is put to the test as well.
"""
import argparse
import dataclasses
import os
import pathlib
import sys

import results
from report import figures, page, published, tables, verdicts
from report.measured import Measured
from study import StudyError, load_study

ROOT = pathlib.Path(__file__).resolve().parents[2]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("studies", nargs="+", type=pathlib.Path, metavar="STUDY.yaml")
    parser.add_argument("--work_dir", type=pathlib.Path, required=True, help="results of the runs")
    parser.add_argument("--output", type=pathlib.Path, help="default: the work_dir's report")
    parser.add_argument("--quick", action="store_true", help="the studies' quick versions")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin")
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path(
        os.environ.get("GMAPPING_SPA_DATA", ROOT.parent / "shared" / "data")))
    return parser.parse_args()


def measure(study, work):
    """The study with the results that are there; the page says how many are missing."""
    scored = [run for run in study.runs if (work / "scores" / f"{run.id}.json").exists()]
    return Measured(study, results.load(dataclasses.replace(study, runs=scored), work))


def write_whole(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    partial = file.with_name(f".partial-{file.name}")
    partial.write_text(text, encoding="utf-8")
    partial.rename(file)


def write_report(args):
    all_measured = [measure(load_study(path, args.bin, args.data, args.quick), args.work_dir)
                    for path in args.studies]
    all_tables = [tables.tables(measured) for measured in all_measured]
    for measured, of_study in zip(all_measured, all_tables):
        of_study |= published.tables_beside(measured)
    findings = verdicts.judge_beside(all_measured)
    html = page.render(all_measured, all_tables, findings, args.work_dir / "scores", args.bin,
                       args.quick)
    output = args.output or args.work_dir / "report"
    for table in [t for of_study in all_tables for t in of_study.values()] + (
            [findings.verdicts, *findings.tests] if findings else []):
        table.write(output / "tables")
    (output / "figures").mkdir(parents=True, exist_ok=True)
    for measured in all_measured:
        for name, png in figures.figures(measured, args.work_dir / "scores"):
            (output / "figures" / name).write_bytes(png)
    write_whole(output / "index.html", html)
    print(f"report: {output / 'index.html'}")


def main():
    try:
        write_report(parse_arguments())
    except (StudyError, OSError) as error:
        sys.exit(f"make_report.py: error: {error}")


if __name__ == "__main__":
    main()
