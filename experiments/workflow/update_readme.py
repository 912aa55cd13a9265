#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Puts tables of a report into a README, between `<!-- NAME begin -->` and `<!-- NAME end -->`."""
import argparse
import pathlib
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("readme", type=pathlib.Path, metavar="README.md")
    parser.add_argument("name", metavar="NAME")
    parser.add_argument("tables", nargs="+", type=pathlib.Path, metavar="TABLE.md")
    parser.add_argument("--rows", metavar="TEXT", help="only the rows of the tables that contain this")
    args = parser.parse_args()
    begin, end = f"<!-- {args.name} begin -->", f"<!-- {args.name} end -->"
    text = args.readme.read_text()
    if text.count(begin) != 1 or text.count(end) != 1 or text.index(end) < text.index(begin):
        fail(f"{args.readme}: expected one '{begin}' and one '{end}' after it")
    tables = "\n".join(chosen(table, args.rows) for table in args.tables)
    start = text.index(begin) + len(begin)
    args.readme.write_text(f"{text[:start]}\n{tables}{text[text.index(end):]}")


def chosen(table, wanted):
    """The table without the rows that do not contain the text."""
    lines = table.read_text().splitlines()
    first = next(k for k, line in enumerate(lines) if line.startswith("| ---")) + 1
    rows = [line for line in lines[first:] if wanted is None or wanted in line]
    if not rows:
        fail(f"{table}: no row contains '{wanted}'")
    return "\n".join(lines[:first] + rows) + "\n"


def fail(message):
    sys.exit(f"update_readme.py: error: {message}")


if __name__ == "__main__":
    main()
