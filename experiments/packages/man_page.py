# SPDX-License-Identifier: BSD-3-Clause
"""The man page of an executable, made from what it says about itself."""
import re
import xml.etree.ElementTree as xml

import examples
import flag_values
import flags_reference

# Not behind "et al."
END_OF_SENTENCE = re.compile(r"(?<! al)\.(?: |$)")
VALUE_NAMES = {"int32": "N", "int64": "N", "uint32": "N", "uint64": "N", "double": "X"}
NAMES_OF_PATHS = {flag_values.FILES: "FILE", flag_values.FOLDERS: "DIR"}
EXIT_STATUS = [("0", "Every output is complete."),
               ("1", "Something failed; one line on the standard error says what."),
               ("2", "Every output is complete, and the answer to what was asked is no."),
               ("130, 143", "Interrupted by Ctrl-C or SIGTERM.")]
COMMON_OPTIONS = [
    ("--flagfile=FILE", "Flags from a file with one --flag=value a line; the command line wins over files, "
                        "a later file over an earlier one."),
    ("--help", "Flags with their meanings and defaults."),
    ("--helpfull", "The flags of libraries, too."),
    ("--version", "The version, with the commit that it was built from.")]


def escape(text: str) -> str:
    """Text as groff takes it: no requests, plain minus signs."""
    text = " ".join(text.split()).replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")
    return "\\&" + text if text.startswith(".") else text


def breakable(value: str) -> str:
    """A list of choices may be longer than a line."""
    return escape(value).replace("|", "|\\:")


def bold_name(name: str, value: str = "") -> str:
    return f"\\fB{escape(name)}\\fR" + (f"=\\fI{breakable(value)}\\fR" if value else "")


def value_name(flag: xml.Element) -> str:
    values = flag_values.values_of(flag)
    if not values:
        return VALUE_NAMES.get(flag.findtext("type"), "TEXT")
    words = [NAMES_OF_PATHS.get(value, value) for value in values]
    # Of a single word, other text may take the place.
    return "|".join([*words, "TEXT"] if len(words) == 1 and words == values else words)


def option(flag: xml.Element) -> list[str]:
    name = flag.findtext("name")
    default = flags_reference.shown_default(flag).strip("`")
    if flag.findtext("type") == "bool":
        head = bold_name(f"--[no]{name}")
    else:
        head = bold_name(f"--{name}", value_name(flag))
    said = "" if default == "(empty)" else f" Default: {default}."
    return [".TP", head, escape(flag.findtext("meaning", "") + said)]


def split_usage(usage: str, program: str) -> tuple[list[str], list[str]]:
    """The command lines that a usage message shows, and its sentences."""
    commands, sentences = [], []
    for line in usage.splitlines():
        line = line.strip()
        command = line.removeprefix("Usage: ")
        if command != line or command.startswith(program + " --"):
            commands.append(command)
        elif line:
            sentences.append(line)
    return commands, sentences


def command_lines(commands: list[str]) -> list[str]:
    lines = []
    for command in commands:
        program, _, flags = command.partition(" ")
        lines += [".PP", f"{bold_name(program)} {escape(flags)}"]
    return lines


def example_lines(program: str, data_folder: str) -> list[str]:
    shown = examples.EXAMPLES.get(program, [])
    lines = [".SH EXAMPLES"] if shown else []
    for what, command in shown:
        lines += [".PP", escape(what), ".PP", ".RS 4",
                  escape(command.replace("DATA", data_folder)), ".RE"]
    return lines


def page_of(program: str, description: xml.Element, version: str, data_folder: str,
            programs: list[str]) -> str:
    commands, sentences = split_usage(description.findtext("usage", ""), program)
    summary = END_OF_SENTENCE.split(sentences[0])[0]
    has_back_ends = any(flag.findtext("name") == "backend" for flag in description.iter("flag"))
    lines = ["." + '\\" SPDX-License-Identifier: BSD-3-Clause',
             f'.TH {program.upper()} 1 "" "gmapping_spa {version}" "User Commands"',
             ".nh", ".ad l",  # names of flags and programs stay whole
             ".SH NAME", f"{program} \\- {escape(summary)}", ".SH SYNOPSIS", *command_lines(commands)]
    lines += [".SH DESCRIPTION", bold_name(program), *(escape(line) for line in sentences)]
    lines.append(".SH OPTIONS")
    for group in description.iter("group"):
        lines.append(f".SS {escape(group.findtext('title', ''))}")
        for flag in group.iter("flag"):
            lines += option(flag)
    lines.append(".SS Common to all programs")
    for name, meaning in COMMON_OPTIONS:
        lines += [".TP", bold_name(*name.split("=")), escape(meaning)]
    lines.append(".SH EXIT STATUS")
    for status, meaning in EXIT_STATUS:
        lines += [".TP", bold_name(status), escape(meaning)]
    if has_back_ends:
        lines += [".SH ENVIRONMENT", ".TP", bold_name("GMAPPING_SPA_PLUGIN_PATH"),
                  "Folders, with colons between, in which back ends are looked for first."]
    lines += [".SH FILES", ".TP", bold_name(f"{data_folder}/flags"), escape(
        "Flag files: GMapping as its authors published it, the paper read literally, and more."),
              ".TP", bold_name(f"{data_folder}/worlds"), "Worlds and tours for the simulator."]
    lines += example_lines(program, data_folder)
    others = [f"\\fB{escape(other)}\\fR(1)" for other in programs if other != program]
    lines += [".SH SEE ALSO", ", ".join(others)] if others else []
    return "\n".join(lines) + "\n"
