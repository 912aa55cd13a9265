#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The flags of executables as a page of Markdown, made from what they say about themselves.

flags_reference.py EXECUTABLE... > flags.md
flags_reference.py --check PAGE... -- EXECUTABLE...    every flag that the pages name must exist
"""
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

# Of gflags and glog; pages may name them.
COMMON_FLAGS = {"help", "helpfull", "helpxml", "flagfile", "version", "minloglevel", "logtostderr"}
# `--name`, not within a longer word, and not an option of another program's command line.
NAMED_FLAG = re.compile(r"`--(?:no)?([a-z][a-z0-9_]*)")


def read_help(executable: str) -> xml.Element:
    done = subprocess.run([executable, "--helpxml"], capture_output=True, text=True)
    start = done.stdout.find("<?xml")
    if start < 0:
        sys.exit(f"{executable}: expected the XML of --helpxml, found '{done.stdout[:60]}'")
    return xml.fromstring(done.stdout[start:])


def shown_default(flag: xml.Element) -> str:
    value = flag.findtext("default", "")
    if flag.findtext("type") == "double":
        value = repr(float(value)).removesuffix(".0")
        shorter = f"{float(value):.6g}"  # gflags prints 0.05 as 0.050000000000000003
        value = shorter if float(shorter) == float(value) else value
    return f"`{value}`" if value else "(empty)"


def cell(text: str) -> str:
    """As one cell of a table; angle brackets are no HTML."""
    text = " ".join(text.split())
    return text.replace("|", "\\|").replace("<", "&lt;").replace(">", "&gt;")


def page_of(executables: list[str]) -> str:
    lines = ["# Flags", "",
             "Made from what the executables say about themselves (`--helpxml`).", ""]
    for executable in sorted(executables, key=lambda path: pathlib.PurePath(path).name):
        description = read_help(executable)
        name = pathlib.PurePath(executable).name
        lines += [f"## {name}", ""]
        lines += [cell(line) + "\n" for line in description.findtext("usage", "").splitlines()]
        for group in description.iter("group"):
            lines += [f"**{group.findtext('title')}**", "", "| flag | type | default | meaning |",
                      "|---|---|---|---|"]
            lines += [f"| `--{flag.findtext('name')}` | {flag.findtext('type')} | "
                      f"{shown_default(flag)} | {cell(flag.findtext('meaning', ''))} |"
                      for flag in group.iter("flag")]
            lines.append("")
    return "\n".join(lines)


def unknown_flags(pages: list[str], known: set[str]) -> list[str]:
    """A line for each flag that a page names and no executable has."""
    found = []
    for page in pages:
        for number, line in enumerate(pathlib.Path(page).read_text().splitlines(), 1):
            found += [f"{page}:{number}: expected a flag of an executable, found '--{name}'"
                      for name in NAMED_FLAG.findall(line) if name not in known]
    return found


def main(words: list[str]) -> None:
    if words[:1] == ["--check"] and "--" in words:
        end = words.index("--")
        known = {flag.findtext("name") for executable in words[end + 1:]
                 for flag in read_help(executable).iter("flag")}
        if unknown := unknown_flags(words[1:end], known | COMMON_FLAGS):
            sys.exit("\n".join(unknown))
    elif words and not words[0].startswith("-"):
        print(page_of(words))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
