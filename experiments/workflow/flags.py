# SPDX-License-Identifier: BSD-3-Clause
"""The flags that an executable has, as it tells them by --helpxml, and values that fit them."""
from __future__ import annotations

import pathlib
import subprocess
import xml.etree.ElementTree

from yaml_entry import Entry, StudyError, did_you_mean

INTEGERS = {
    "int32": (-2**31, 2**31 - 1),
    "uint32": (0, 2**32 - 1),
    "int64": (-2**63, 2**63 - 1),
    "uint64": (0, 2**64 - 1),
}

Value = bool | int | float | str


def read_flags(binary: pathlib.Path) -> dict[str, str]:
    """The type of each of the executable's own flags, not those of its libraries."""
    try:
        printed = subprocess.run([binary, "--helpxml"], capture_output=True, text=True).stdout
    except OSError as error:
        raise StudyError(f"{binary}: {error.strerror}; build it, or name its folder by --bin") \
            from error
    return {flag.findtext("name", ""): flag.findtext("type", "")
            for flag in xml.etree.ElementTree.fromstring(printed).iterfind("group/flag")}


def value_of(entry: Entry, kind: str) -> Value:
    """The entry as a value of a flag of this type; complains when it does not fit."""
    value = entry.scalar()
    if kind == "bool":
        if isinstance(value, bool):
            return value
        entry.fail(f"expected true or false, found {entry.found()}")
    if kind in INTEGERS:
        low, high = INTEGERS[kind]
        if isinstance(value, int) and not isinstance(value, bool) and low <= value <= high:
            return value
        entry.fail(f"expected an integer ({kind}), found {entry.found()}")
    if kind == "double":
        try:
            return float(entry.text())  # YAML takes 1e-8 for a text
        except ValueError:
            entry.fail(f"expected a number, found {entry.found()}")
    return entry.text()


def check_name(name: str, entry: Entry, flags: dict[str, str], reserved: dict[str, str]) -> None:
    """Complains unless this is a flag that a study may set; `reserved` says what sets others."""
    if name in reserved:
        entry.fail(f"--{name} is set by {reserved[name]}")
    if name not in flags:
        entry.fail(f"unknown flag '{name}'{did_you_mean(name, flags)}")


def as_text(value: Value) -> str:
    """The value as it is written behind --flag=, one way for each value."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        short = f"{value:g}"
        return short if float(short) == value else repr(value)
    return str(value)


def as_arguments(flags: dict[str, Value]) -> list[str]:
    return [f"--{name}={as_text(value)}" for name, value in sorted(flags.items())]
