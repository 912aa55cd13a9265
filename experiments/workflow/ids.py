# SPDX-License-Identifier: BSD-3-Clause
"""Content addresses: equal input and flags have equal ids, so that nothing is done twice."""
import functools
import hashlib
import json
import pathlib
from typing import Any

import yaml


def content_id(*parts: Any) -> str:
    """16 hexadecimal digits for anything that JSON can write."""
    text = json.dumps(parts, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


@functools.cache
def file_hash(file: pathlib.Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


@functools.cache
def world_hash(world: pathlib.Path) -> str:
    """Of the world file and, if it names an image, of that."""
    try:
        image = yaml.safe_load(world.read_text())["image"]
        return content_id(file_hash(world), file_hash(world.parent / image))
    except (KeyError, TypeError, OSError, ValueError, yaml.YAMLError):
        return file_hash(world)  # without an image; if broken, the simulator says how
