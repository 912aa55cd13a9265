# SPDX-License-Identifier: BSD-3-Clause
"""The tables of flags and values that completion.bash looks things up in."""
import xml.etree.ElementTree as xml

import flag_values

# Of gflags and glog; every executable has them.
COMMON_FLAGS = ["--flagfile=", "--help", "--helpfull", "--helpxml", "--version"]


def tables_of(program: str, description: xml.Element) -> str:
    """The lines of a program, with the element that its --helpxml prints."""
    flags, values = list(COMMON_FLAGS), {"flagfile": [flag_values.FILES]}
    for flag in description.iter("flag"):
        name = flag.findtext("name")
        if flag.findtext("type") == "bool":
            flags += [f"--{name}", f"--no{name}"]
        else:
            flags.append(f"--{name}=")
        if words := flag_values.values_of(flag):
            values[name] = words
    lines = [f"_gmapping_spa_flags[{program}]='{' '.join(sorted(flags))}'"]
    lines += [f"_gmapping_spa_values[{program}/{name}]='{' '.join(words)}'"
              for name, words in sorted(values.items())]
    return "\n".join(lines) + "\n"


def script_of(tables: list[str], programs: list[str], logic: str) -> str:
    """The file for bash-completion."""
    head, _, body = logic.partition("\n\n")
    return (f"{head}\n\ndeclare -gA _gmapping_spa_flags _gmapping_spa_values\n{''.join(tables)}\n{body}"
            f"\ncomplete -F _gmapping_spa_complete {' '.join(programs)}\n")
