#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Man pages and completion of executables, made from what they say about themselves (--helpxml).

Writes man1/NAME.1 for each executable, completions/gmapping_spa for bash-completion, and links to it by the
names of the others.
"""
import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "docs"))
import completion_tables  # noqa: E402
import flags_reference  # noqa: E402
import man_page  # noqa: E402


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, required=True, metavar="DIR")
    parser.add_argument("--version", required=True, help="of the project, which man pages tell")
    parser.add_argument("--data_folder", default="/usr/share/gmapping_spa", metavar="DIR",
                        help="where flag files and worlds will be")
    parser.add_argument("executables", nargs="+")
    given = parser.parse_args()

    described = {pathlib.PurePath(executable).name: flags_reference.read_help(executable)
                 for executable in sorted(given.executables)}
    programs = list(described)
    man_pages, completions = given.output / "man1", given.output / "completions"
    man_pages.mkdir(parents=True, exist_ok=True)
    completions.mkdir(parents=True, exist_ok=True)
    for program, description in described.items():
        (man_pages / f"{program}.1").write_text(man_page.page_of(
            program, description, given.version, given.data_folder, programs))
    tables = [completion_tables.tables_of(program, description)
              for program, description in described.items()]
    logic = (HERE / "completion.bash").read_text()
    (completions / "gmapping_spa").write_text(
        completion_tables.script_of(tables, programs, logic))
    for program in programs:
        if program != "gmapping_spa":
            link = completions / program
            link.unlink(missing_ok=True)
            link.symlink_to("gmapping_spa")


if __name__ == "__main__":
    main()
