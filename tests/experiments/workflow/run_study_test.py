# SPDX-License-Identifier: BSD-3-Clause
"""Whole studies of a tiny room: failures are counted, stopped ones go on, bad ones do not run."""
import fcntl
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

import workflow_test_case
from workflow_test_case import BINARIES

import metrics
import results
from study import load_study

STUDY = """
    title: A tiny room
    datasets:
      room: {world: room.yaml, simulate: {scan_rate: 5}}
    seeds: 1-2
    axes:
      particles: [1, 30]
    metrics: [ate_rmse_m]
"""


class RunStudyTest(workflow_test_case.WorkflowTestCase):
    def setUp(self):
        super().setUp()
        self.study = self.write("study.yaml", STUDY)

    def outcomes(self, work="work"):
        return {file.parent.name: json.loads(file.read_text())
                for file in (self.folder / work / "runs").glob("*/outcome.json")}

    def results_without_times(self, work):
        """Content of all files of results by name, as far as it must be the same every time."""
        contents = {}
        for file in (self.folder / work).glob("[lrs]*/**/*"):
            if file.is_dir() or file.name == ".snakemake_timestamp":
                continue
            content = file.read_bytes()
            if file.name == "run.json":
                content = json.loads(content)
                del content["resources"]
            elif file.parent.name == "scores" and file.suffix == ".json":
                content = json.loads(content)
                for name in metrics.TIMES:
                    del content[name]
            contents[str(file.relative_to(self.folder / work))] = content
        return contents

    def identities(self, work="work"):
        """Inode and time of each result: a result that is made again has others."""
        files = (self.folder / work).glob("[lrs]*/**/*")
        return {str(f): (f.stat().st_ino, f.stat().st_mtime_ns) for f in files if f.is_file()}

    def kill_when_some_runs_are_there(self, command):
        study = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 start_new_session=True)
        while len(self.outcomes()) < 3:
            self.assertIsNone(study.poll(), "the study ended before it could be killed")
            time.sleep(0.01)
        os.killpg(study.pid, signal.SIGKILL)
        study.wait()

    def test_a_killed_study_goes_on_with_nothing_lost_or_doubled(self):
        self.study = self.write("study.yaml", STUDY.replace("1-2", "1-4"))
        self.kill_when_some_runs_are_there(self.command(self.study, "--until=scores"))
        kept = self.outcomes()
        before = {name: i for name, i in self.identities().items() if "/runs/" in name
                  and not name.endswith(".snakemake_timestamp")}
        self.assertLess(len(kept), 8, "nothing was left to do")
        printed = self.check_study(self.study, "--until=scores").stdout
        self.assertEqual(printed.count("done   "), 8 - len(kept))
        self.check_study(self.study, "--until=scores", work="uninterrupted")
        self.assertEqual(len(self.outcomes()), 8)
        after = self.identities()
        self.assertEqual(before, {name: after[name] for name in before})
        self.assertEqual(self.results_without_times("work"),
                         self.results_without_times("uninterrupted"))
        self.assertFalse((self.folder / "work" / "partial").exists()
                         and any((self.folder / "work" / "partial").iterdir()))

    def test_a_finished_study_has_nothing_to_do_until_evaluators_change(self):
        binaries = self.folder / "bin"
        binaries.mkdir()
        for file in BINARIES.iterdir():
            (binaries / file.name).symlink_to(file)
        command = (self.study, "--until=scores", f"--bin={binaries}")
        self.check_study(*command)
        before = self.identities()
        self.check_study(*command)
        self.assertEqual(self.identities(), before)
        evaluator = binaries / "evaluate_relations"
        evaluator.unlink()
        shutil.copy(BINARIES / evaluator.name, evaluator)
        with open(evaluator, "ab") as file:
            file.write(b"another build")
        self.check_study(*command)
        changed = {name for name, identity in self.identities().items() if identity != before[name]}
        self.assertEqual(len([name for name in changed if name.endswith(".json")]), 4)
        self.assertTrue(all("/scores/" in name for name in changed))

    def test_failed_runs_are_results(self):
        self.study = self.write("study.yaml", STUDY.replace("[1, 30]", "[1, -4]"))
        printed = self.check_study(self.study, "--until=scores").stdout
        loaded = results.load(load_study(self.study, BINARIES, self.folder), self.folder / "work")
        failed = [result for result in loaded if result.failed()]
        self.assertEqual((len(loaded), len(failed)), (4, 2))
        self.assertEqual(printed.count("FAILED room, particles=-4"), 2)
        for result in failed:
            self.assertEqual(result.run.configuration.axes["particles"], -4)
            self.assertEqual(result.outcome["exit_status"], 1)
            self.assertIn("--particles: expected a value from 1", result.outcome["error"])
            self.assertEqual(set(result.scores.values()), {None})
            self.assertEqual({f.name for f in result.folder.iterdir()} - {".snakemake_timestamp"},
                             {"outcome.json"})
        for result in loaded:
            if not result.failed():
                self.assertLess(result.scores["ate_rmse_m"], 1.0)

    def test_a_log_that_cannot_be_simulated_is_a_failure_of_its_runs(self):
        self.write("room.path.yaml", "way_points: [[2, 1.6], [5, 4]]")
        self.check_study(self.study, "--until=scores")
        self.assertEqual(len(self.outcomes()), 4)
        for outcome in self.outcomes().values():
            self.assertNotEqual(outcome["exit_status"], 0)
            self.assertIn("simulate: error: ", outcome["error"])

    def test_a_bad_study_makes_nothing_run(self):
        good = self.write("good.yaml", STUDY)
        bad = self.write("bad.yaml", STUDY.replace("particles", "particels"))
        done = self.run_study(bad, good)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, "^run_study.py: error: .*/bad.yaml:6: particels: "
                                      "unknown flag 'particels'; did you mean 'particles'\\?\n$")
        self.assertFalse((self.folder / "work").exists())

    def test_two_studies_at_once_in_a_folder_are_refused(self):
        (self.folder / "work").mkdir()
        with open(self.folder / "work" / ".lock", "w", encoding="utf-8") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            done = self.run_study(self.study)
        self.assertEqual(done.returncode, 1)
        self.assertIn("another study is at work in this folder", done.stderr)

    def test_outcomes_tell_how_to_repeat_the_run_and_of_which_build_it_is(self):
        self.check_study(self.study, "--until=runs")
        for run, outcome in self.outcomes().items():
            work = self.folder / "work"
            command = outcome["command"].replace("$W", str(work)).replace(
                f"runs/{run}", "repeated")
            subprocess.run(command, shell=True, check=True, capture_output=True,
                           cwd=workflow_test_case.ROOT)
            self.assertEqual((work / "repeated" / "trajectory.tum").read_bytes(),
                             (work / "runs" / run / "trajectory.tum").read_bytes())
        run = next((self.folder / "work" / "runs").iterdir()) / "outcome.json"
        run.write_text(run.read_text().replace("build ", "build 0"))
        self.assertIn("warning: 1 of the 4 runs that are there were made by another build of "
                      "gmapping_spa", self.check_study(self.study, "--until=runs").stdout)
        again = self.check_study(self.study, "--until=runs", "--fresh").stdout
        self.assertEqual(again.count("done   "), 4)
        self.assertNotIn("warning", self.check_study(self.study, "--until=runs").stdout)


if __name__ == "__main__":
    unittest.main()
