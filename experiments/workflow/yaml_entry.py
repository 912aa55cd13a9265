# SPDX-License-Identifier: BSD-3-Clause
"""YAML values that know their place, so that a complaint can name file and line."""
from __future__ import annotations

import difflib
import pathlib
from collections.abc import Iterable
from typing import Any, NoReturn

import yaml

FORMER_NAMES = {"log": "dataset", "logs": "datasets", "says": "statement"}  # of keys


class StudyError(Exception):
    """What is wrong with a study, in one line: file, line, what was expected, what was found."""


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """The end of a complaint about an unknown name."""
    near = difflib.get_close_matches(name, list(known), n=1, cutoff=0.6)
    return f"; did you mean '{near[0]}'?" if near else ""


class Entry:
    """A value of a YAML file; `what` says what it is, for complaints."""

    def __init__(self, node: yaml.Node, file: pathlib.Path, what: str):
        self.node, self.file, self.what = node, file, what

    def fail(self, problem: str) -> NoReturn:
        raise StudyError(f"{self.file}:{self.node.start_mark.line + 1}: {self.what}: {problem}")

    def mapping(self, known: Iterable[str] | None = None) -> dict[str, Entry]:
        """The values by key; with `known`, other keys are an error."""
        if not isinstance(self.node, yaml.MappingNode):
            self.fail(f"expected 'key: value' pairs, found {self.found()}")
        entries: dict[str, Entry] = {}
        for key_node, value_node in self.node.value:
            key = Entry(key_node, self.file, self.what)
            name = key.text()
            if known is not None and name not in known:
                if FORMER_NAMES.get(name) in known:
                    key.fail(f"'{name}' is called '{FORMER_NAMES[name]}' now")
                key.fail(f"unknown key '{name}'{did_you_mean(name, known)}")
            if name in entries:
                key.fail(f"'{name}' is there twice")
            entries[name] = Entry(value_node, self.file, name)
        return entries

    def merged(self, other: Entry) -> Entry:
        """Both mappings as one; where both have a key, the other's value counts."""
        keys = {key.value for key, _ in other.node.value}
        pairs = [pair for pair in self.node.value if pair[0].value not in keys]
        node = yaml.MappingNode(self.node.tag, pairs + other.node.value, other.node.start_mark)
        return Entry(node, self.file, self.what)

    def with_text(self, text: str) -> Entry:
        """Another text at the same place."""
        node = yaml.ScalarNode("tag:yaml.org,2002:str", text, self.node.start_mark)
        return Entry(node, self.file, self.what)

    def sequence(self) -> list[Entry]:
        if not isinstance(self.node, yaml.SequenceNode):
            self.fail(f"expected a list, found {self.found()}")
        return [Entry(node, self.file, self.what) for node in self.node.value]

    def scalar(self) -> Any:
        """A number, a text, true or false, None."""
        if not isinstance(self.node, yaml.ScalarNode):
            self.fail(f"expected one value, found {self.found()}")
        try:
            return yaml.SafeLoader("").construct_object(self.node)
        except ValueError:  # such as 2023-99-99, which looks like a date
            return self.node.value

    def text(self) -> str:
        """The value as it is written in the file."""
        if self.scalar() is None:
            self.fail("expected a text, found nothing")
        return self.node.value

    def is_null(self) -> bool:
        return isinstance(self.node, yaml.ScalarNode) and self.scalar() is None

    def is_sequence(self) -> bool:
        return isinstance(self.node, yaml.SequenceNode)

    def found(self) -> str:
        if isinstance(self.node, yaml.SequenceNode):
            return "a list"
        if isinstance(self.node, yaml.MappingNode):
            return "'key: value' pairs"
        return f"'{self.node.value}'"


def read_yaml(file: pathlib.Path) -> Entry:
    """The whole file as one entry."""
    try:
        node = yaml.compose(file.read_text(encoding="utf-8"), Loader=yaml.SafeLoader)
    except OSError as error:
        raise StudyError(f"{file}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise StudyError(f"{file}: expected a text file, found other bytes") from error
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 1 if error.problem_mark else 1
        raise StudyError(f"{file}:{line}: not YAML: {error.problem}") from error
    except yaml.YAMLError as error:
        raise StudyError(f"{file}: not YAML: {' '.join(str(error).split())}") from error
    if node is None:
        raise StudyError(f"{file}:1: expected a study, found an empty file")
    return Entry(node, file, "study")
