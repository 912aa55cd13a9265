# SPDX-License-Identifier: BSD-3-Clause
"""What the value of a flag may be, as its help text tells."""
import re
import xml.etree.ElementTree as xml

FILES = "FILES"
FOLDERS = "FOLDERS"

IN_PARENTHESES = re.compile(r" ?\([^()]*\)")
IN_QUOTES = re.compile(r"'([a-z]+)'")
WORD = re.compile(r"[a-z][a-z0-9_]*")
OF_A_FILE = re.compile(r"(?:\w+ )?[Ff]ile\b|Sensor log\b")


def choices(meaning: str, default: str) -> list[str]:
    """`a`, `b` and `c` of help texts such as "What it is: a (some explanation), b or c. More."; empty where
    the default is none of them."""
    plain = IN_PARENTHESES.sub("", " ".join(meaning.split()))
    for sentence in re.split(r"\.(?: |$)", plain):
        items = re.split(r",? or |, ", sentence.rpartition(": ")[2])
        words = [item for item in items if WORD.fullmatch(item)]
        if default in words:
            return words
    return [default] if WORD.fullmatch(default) else []


def values_of(flag: xml.Element) -> list[str]:
    """Words that may be the value of a flag of --helpxml, with FILES or FOLDERS where names of such may; empty
    for numbers and other text."""
    kind, meaning = flag.findtext("type"), flag.findtext("meaning", "")
    if kind == "bool":
        return ["true", "false"]
    if kind != "string":
        return []
    if meaning.startswith("Folder"):
        return [FOLDERS, *IN_QUOTES.findall(meaning)]
    if OF_A_FILE.match(meaning):
        return [FILES]
    words = choices(meaning, flag.findtext("default", ""))
    return words + [FILES] if words and "or the path of" in meaning else words
