# SPDX-License-Identifier: BSD-3-Clause
"""A folder of results with known numbers, as the workflow leaves it, for the report's tests."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[3]
WORKFLOW = ROOT / "experiments" / "workflow"
sys.path.insert(0, str(WORKFLOW))

from make_report import measure
from study import load_study

STUDY = """
title: Few particles
description: Plain against improved on a made-up building.
datasets:
  building: {world: paper_building.yaml}
seeds: 1-6
variants:
  GMapping: {flagfile: gmapping.flags}
  improved: {}
axes:
  particles: [30, 5]
metrics: [map_blur_m, map_recall, closures_accepted]
compare:
  - [{variant: improved, particles: 5}, {variant: GMapping, particles: 30}]
  - [{variant: improved}, {variant: GMapping}]
figures:
  - {title: Two by two, rows: variant, columns: particles}
quick: {seeds: 1-2}
"""

HELP = """<?xml version="1.0"?><AllFlags><group>
<flag><name>particles</name><type>int32</type></flag>
<flag><name>scan_rate</name><type>double</type></flag>
<flag><name>backend</name><type>string</type></flag>
</group></AllFlags>"""


class Results:
    """The study above and its results in a folder; everything can be changed before reporting."""

    def __init__(self, folder, study=STUDY):
        self.folder = pathlib.Path(folder)
        self.work = self.folder / "work"
        self.binaries = self.folder / "bin"
        self.study_file = self.folder / "few_particles.yaml"
        self.study_file.write_text(study)
        self._write_binaries()
        self.study = self.load()
        for run in self.study.runs:
            self.write(run)

    def load(self, quick=False):
        return load_study(self.study_file, self.binaries, self.folder, quick)

    def write(self, run, blur=None, **outcome):
        """One good run; its blur by default is `blur_of`, recall is 1 - blur."""
        blur = blur_of(run) if blur is None else blur
        folder = self.work / "runs" / run.id
        folder.mkdir(parents=True, exist_ok=True)
        write_json(folder / "outcome.json", {
            "command": f"build/bin/gmapping_spa {' '.join(run.argv)} --output_dir=$W/runs/{run.id}",
            "exit_status": 0, "error": "", "log_sha256": f"{run.seed:064x}",
            "log_command": f"build/bin/simulate --seed={run.seed}",
            "version": "0.1.0, build 00", "processor": "Made-up processor", **outcome})
        write_json(folder / "run.json", {"flags": {}})
        self.write_scores(run, {
            "map_blur_m": blur, "map_recall": 1 - blur, "closures_accepted": 3,
            "cpu_s": 2.0 * run.configuration.axes["particles"], "ate_rmse_m": None})
        self._write_map(run, folder)

    def write_scores(self, run, scores):
        (self.work / "scores").mkdir(parents=True, exist_ok=True)
        write_json(self.work / "scores" / f"{run.id}.json", scores)

    def fail(self, run):
        """The run ends with an error: an outcome without any output."""
        self.write(run, exit_status=1, error="no scan in the log")
        for name in ("run.json", "map.yaml", "map.pgm"):
            (self.work / "runs" / run.id / name).unlink()
        (self.work / "scores" / f"{run.id}.error_map.png").unlink()
        self.write_scores(run, {})

    def remove(self, run):
        (self.work / "scores" / f"{run.id}.json").unlink()

    def run(self, variant, particles, seed):
        return next(r for r in self.study.runs if r.seed == seed
                    and r.configuration.variant == variant
                    and r.configuration.axes["particles"] == particles)

    def report(self, *flags, output="report"):
        """make_report.py as a user calls it."""
        return subprocess.run(
            [WORKFLOW / "make_report.py", f"--work_dir={self.work}",
             f"--output={self.folder / output}", f"--bin={self.binaries}", f"--data={self.folder}",
             *flags, self.study_file], capture_output=True, text=True)

    def page(self, *flags):
        done = self.report(*flags)
        assert done.returncode == 0, done.stderr
        return (self.folder / "report" / "index.html").read_text()

    def _write_binaries(self):
        self.binaries.mkdir()
        for name in ("gmapping_spa", "simulate"):
            file = self.binaries / name
            file.write_text(f"#!/bin/sh\ncat <<'END'\n{HELP}\nEND\n")
            file.chmod(0o755)

    def _write_map(self, run, folder):
        """A room whose size grows with the seed: 205 is unknown, 254 free, 0 occupied."""
        gray = numpy.full((60, 80 + run.seed), 205, dtype=numpy.uint8)
        gray[10:50, 10:70 + run.seed] = 254
        gray[10:50, [10, 69 + run.seed]] = 0
        Image.fromarray(gray).save(folder / "map.pgm")
        (folder / "map.yaml").write_text(
            "image: map.pgm\nresolution: 0.05\norigin: [-1.0, -0.5, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
        errors = numpy.full((60 + 40, 80, 3), 255, dtype=numpy.uint8)  # 40 rows of legend
        errors[10:12] = (0, 115, 179)
        Image.fromarray(errors).save(self.work / "scores" / f"{run.id}.error_map.png")


def blur_of(run):
    """Improved: half of plain; both worse with fewer particles, and by seed."""
    base = {30: 0.10, 5: 0.16}[run.configuration.axes["particles"]] + 0.01 * run.seed
    return base if run.configuration.variant == "GMapping" else base / 2


def write_json(file, value):
    file.write_text(json.dumps(value))


class ResultsTestCase(unittest.TestCase):
    """Gives every test results of its own to spoil."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.results = Results(folder.name)

    def measured(self):
        return measure(self.results.study, self.results.work)


class SharedResultsTestCase(unittest.TestCase):
    """Results that no test of the class changes; `spoil` does before they are reported, once."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.results = Results(folder.name)
        cls.spoil()
        cls.page = cls.results.page()

    @classmethod
    def spoil(cls):
        pass
