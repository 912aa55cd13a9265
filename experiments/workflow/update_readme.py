#!/usr/bin/env python3
"""Puts tables of a report into a README, between `<!-- NAME begin -->` and `<!-- NAME end -->`.

    update_readme.py README.md NAME TABLE.md...
"""
import pathlib
import sys


def main():
    if len(sys.argv) < 4 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    readme, name = pathlib.Path(sys.argv[1]), sys.argv[2]
    begin, end = f"<!-- {name} begin -->", f"<!-- {name} end -->"
    text = readme.read_text()
    if text.count(begin) != 1 or text.count(end) != 1 or text.index(end) < text.index(begin):
        sys.exit(f"update_readme.py: error: {readme}: expected one '{begin}' and one '{end}' after it")
    tables = "\n".join(pathlib.Path(table).read_text() for table in sys.argv[3:])
    start = text.index(begin) + len(begin)
    readme.write_text(f"{text[:start]}\n{tables}{text[text.index(end):]}")


if __name__ == "__main__":
    main()
