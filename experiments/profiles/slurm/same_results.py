#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two folders of results: same_results.py ONE OTHER. Times and memory may differ."""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "workflow"))
import metrics


def comparable(file: pathlib.Path):
    content = file.read_bytes()
    if file.name == "run.json":
        return {k: v for k, v in json.loads(content).items() if k != "resources"}
    if file.parent.name == "scores" and file.suffix == ".json":
        return {k: v for k, v in json.loads(content).items() if k not in metrics.TIMES}
    return content


def results(work: pathlib.Path):
    """Content of all results by name."""
    return {str(file.relative_to(work)): comparable(file)
            for folder in ("logs", "runs", "scores") for file in (work / folder).glob("**/*")
            if file.is_file() and file.name != ".snakemake_timestamp"}


def main():
    one, other = (results(pathlib.Path(folder)) for folder in sys.argv[1:3])
    different = [name for name in sorted(one.keys() | other.keys())
                 if one.get(name) != other.get(name)]
    if different or not one:
        sys.exit(f"{len(different)} of {len(one)} results differ: {' '.join(different[:5])}")
    print(f"{len(one)} files of results are the same")


if __name__ == "__main__":
    main()
