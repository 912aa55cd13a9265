# SPDX-License-Identifier: BSD-3-Clause
"""What Snakemake says while a study runs: how far it is, and what went wrong.

Its own words, a dozen lines a run, go to the log file in .snakemake/log alone.
"""
import logging
import sys
from typing import Any

from snakemake.logging import logger

_shown = -1


def log_handler(message: dict[str, Any]) -> None:
    """Snakemake calls this for each of its messages (--log-handler-script)."""
    global _shown
    logger.stream_handler.setLevel(logging.CRITICAL + 1)
    if message["level"] == "progress":
        percent = 100 * message["done"] // message["total"]
        if percent > _shown:
            _shown = percent
            print(f"{message['done']} of {message['total']} steps, {percent} %", flush=True)
    elif message["level"] == "error":
        print(message["msg"], file=sys.stderr, flush=True)
    elif message["level"] == "job_error":
        outputs = " ".join(message["output"])
        print(f"step {message['name']} of {outputs} failed", file=sys.stderr, flush=True)
