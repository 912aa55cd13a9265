# SPDX-License-Identifier: BSD-3-Clause
"""The command line of scripts that write one table of a study."""
import argparse
import os
import pathlib
import sys
from collections.abc import Callable

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments" / "workflow"))

from report.table import Table
from study import Study, StudyError, load_study


def write_table(description: str, make: Callable[[Study, pathlib.Path], Table]) -> None:
    """Writes the table that `make` gives for the study and the folder of its results."""
    parser = argparse.ArgumentParser(description=description,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", type=pathlib.Path, metavar="STUDY.yaml")
    parser.add_argument("--work_dir", type=pathlib.Path, required=True, help="results of the runs")
    parser.add_argument("--quick", action="store_true", help="the study's quick version")
    parser.add_argument("--output", type=pathlib.Path, help="default: the work_dir's report/tables")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin")
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path(
        os.environ.get("GMAPPING_SPA_DATA", ROOT.parent / "shared" / "data")))
    args = parser.parse_args()
    output = args.output or args.work_dir / "report" / "tables"
    try:
        table = make(load_study(args.study, args.bin, args.data, args.quick), args.work_dir)
        table.write(output)
    except (StudyError, OSError) as error:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: error: {error}")
    print(f"table: {output / table.name}.md")
