# SPDX-License-Identifier: BSD-3-Clause
"""Studies: what is asked for becomes runs; what is wrong is named with file and line."""
import unittest

import workflow_test_case
from workflow_test_case import BINARIES, ROOT

from study import StudyError, load_study

STUDY = """
    title: A study
    datasets:
      room: {world: room.yaml, simulate: {scan_rate: 5}}
    seeds: 1-3
    flags: {threads: 1}
    variants:
      GMapping: {flagfile: gmapping.flags}
      improved: {}
    axes:
      particles: [1, 5]
    metrics: [ate_rmse_m, cpu_s]
    compare:
      - [{variant: improved, particles: 1}, {variant: GMapping, particles: 5}]
    quick:
      seeds: [7]
      datasets:
        room: {simulate: {odometry_noise: 2}}
"""


class StudyTest(workflow_test_case.WorkflowTestCase):
    def load(self, text=STUDY, quick=False):
        return load_study(self.write("study.yaml", text), BINARIES, self.folder, quick)

    def complaint(self, old, new):
        """What is said about the study after this change."""
        self.assertIn(old, STUDY)
        with self.assertRaises(StudyError) as caught:
            self.load(STUDY.replace(old, new))
        message = str(caught.exception)
        self.assertNotIn("\n", message)
        return message.replace(str(self.folder) + "/", "")

    def test_a_run_for_each_dataset_variant_axis_value_and_seed(self):
        study = self.load()
        self.assertEqual([config.label() for config in study.configurations], [
            "room, GMapping, particles=1", "room, GMapping, particles=5",
            "room, improved, particles=1", "room, improved, particles=5"])
        self.assertEqual(study.seeds, [1, 2, 3])
        self.assertEqual(len({run.id for run in study.runs}), 12)
        last = study.runs[-1]
        self.assertEqual(last.argv, ["--particles=5", "--threads=1", "--seed=3"])
        self.assertEqual(last.log_argv[-2:], ["--scan_rate=5", "--seed=3"])

    def test_the_seed_makes_the_log_and_runs_of_a_seed_share_it(self):
        study = self.load()
        logs = {(run.seed, run.log_id) for run in study.runs}
        self.assertEqual(len(logs), 3)
        self.assertEqual(len({log for _, log in logs}), 3)

    def test_flag_files_are_read_before_flags(self):
        argv = self.load().runs[0].argv
        self.assertRegex(argv[0], "--flagfile=/.*/experiments/flags/gmapping.flags")

    def test_studies_share_runs(self):
        whole = {run.id for run in self.load().runs}
        part = {run.id for run in self.load(STUDY.replace("[1, 5]", "[5, 1]")
                                            .replace("1-3", "[2]")).runs}
        self.assertEqual(len(part), 4)
        self.assertLess(part, whole)

    def test_ids_depend_on_flags_seed_and_content_of_files(self):
        def first(text=STUDY):
            return self.load(text).runs[0]
        before = first()
        self.assertNotEqual(first(STUDY.replace("[1, 5]", "[5, 1]")).id, before.id)
        self.assertNotEqual(first(STUDY.replace("1-3", "2-3")).id, before.id)
        self.assertNotEqual(first(STUDY.replace("rate: 5", "rate: 6")).log_id, before.log_id)
        self.write("other.yaml", workflow_test_case.WORLD + "      - [1, 6, 2, 6.5]\n")
        self.write("other.path.yaml", workflow_test_case.PATH)
        other = first(STUDY.replace("room.yaml", "other.yaml"))
        self.assertNotEqual(other.log_id, before.log_id)
        self.assertNotEqual(other.id, before.id)

    def test_quick_keys_replace_and_quick_datasets_merge(self):
        study = self.load(quick=True)
        self.assertEqual(study.seeds, [7])
        self.assertEqual(len(study.configurations), 4)
        self.assertEqual(study.runs[0].log_argv[-3:],
                         ["--odometry_noise=2", "--scan_rate=5", "--seed=7"])

    def test_null_leaves_a_dataset_out_of_the_quick_version(self):
        text = STUDY.replace("simulate: {scan_rate: 5}}",
                             "simulate: {scan_rate: 5}}\n      second: {world: room.yaml}")
        self.assertEqual(len(self.load(text).configurations), 8)
        text = text.replace("room: {simulate: {odometry_noise: 2}}", "second: null")
        self.assertEqual({c.dataset for c in self.load(text, quick=True).configurations}, {"room"})

    def test_an_axis_over_the_simulator_changes_the_log_alone(self):
        study = self.load(STUDY.replace("particles: [1, 5]", "simulate.odometry_noise: [1, 3]")
                          .replace(", particles: 1", "").replace(", particles: 5", ""))
        one, other = study.runs[0], study.runs[3]
        self.assertEqual(one.argv, other.argv)
        self.assertIn("--odometry_noise=3", other.log_argv)
        self.assertNotEqual(one.log_id, other.log_id)

    def test_real_logs_come_from_the_data_folder_with_their_relations(self):
        for folder in ("carmen", "relations"):
            (self.folder / folder).mkdir()
        self.write("carmen/hall.clf.gz", "not read here")
        self.write("relations/hall.relations.gz", "neither")
        run = self.load(STUDY.replace("room: {world: room.yaml, simulate: {scan_rate: 5}}",
                                      "hall: {carmen: hall}")
                        .replace("room: {simulate: {odometry_noise: 2}}", "hall: {}")).runs[0]
        self.assertIsNone(run.log_id)
        self.assertEqual(run.log_file, self.folder.resolve() / "carmen" / "hall.clf.gz")
        self.assertEqual(run.relations, self.folder / "relations" / "hall.relations.gz")

    def test_a_star_is_every_log_of_the_data_folder(self):
        text = (STUDY.replace("room: {world: room.yaml, simulate: {scan_rate: 5}}",
                              '"*": {carmen: "*"}')
                .replace("      datasets:\n        room: {simulate: {odometry_noise: 2}}\n", ""))
        (self.folder / "carmen").mkdir()
        with self.assertRaisesRegex(StudyError, r"study.yaml:3: .*no logs in .*carmen"):
            self.load(text)
        self.write("carmen/hall.clf.gz", "not read here")
        self.write("carmen/attic.clf", "neither")
        found = {(r.configuration.dataset, r.log_file.name) for r in self.load(text).runs}
        self.assertEqual(sorted(found),
                         [("attic", "attic.clf"), ("hall", "hall.clf.gz")])
        with self.assertRaisesRegex(StudyError, "expected {carmen: '\\*'}"):
            self.load(text.replace('carmen: "*"', "carmen: hall"))

    def test_studies_of_the_repository_are_good(self):
        (self.folder / "carmen").mkdir()
        for log in ("intel", "fr079", "aces"):
            self.write(f"carmen/{log}.clf.gz", "not read here")
        studies = sorted(file for folder in ("ablation", "stress")
                         for file in (ROOT / "experiments" / folder).glob("*.yaml"))
        self.assertGreater(len(studies), 1)
        for file in studies:
            for quick in (False, True):
                self.assertGreater(len(load_study(file, BINARIES, self.folder, quick).runs), 1)

    def test_selectors_find_configurations(self):
        study = self.load()
        [(left, right)] = study.compare
        self.assertEqual([c.label() for c in study.select(left)], ["room, improved, particles=1"])
        self.assertEqual([c.label() for c in study.select(right)], ["room, GMapping, particles=5"])

    def test_misspelt_flags_are_named_with_line_and_proposal(self):
        self.assertEqual(self.complaint("particles: [1, 5]", "partciles: [1, 5]"),
                         "study.yaml:10: partciles: unknown flag 'partciles'; "
                         "did you mean 'particles'?")
        self.assertIn("study.yaml:3: scan_rat: unknown flag 'scan_rat'; did you mean 'scan_rate'?",
                      self.complaint("scan_rate", "scan_rat"))
        self.assertIn("study.yaml:5: thread: unknown flag 'thread'; did you mean 'threads'?",
                      self.complaint("threads", "thread"))

    def test_unknown_keys_are_named_with_line(self):
        self.assertEqual(self.complaint("seeds: 1-3", "seedss: 1-3"),
                         "study.yaml:4: study: unknown key 'seedss'; did you mean 'seeds'?")
        self.assertIn("study.yaml:15: quick: unknown key 'sedes'",
                      self.complaint("seeds: [7]", "sedes: [7]"))
        self.assertIn("study.yaml:13: compare: unknown key 'particle'",
                      self.complaint("improved, particles", "improved, particle"))
        self.assertIn("unknown metric 'ate_rms_m'; did you mean 'ate_rmse_m'?",
                      self.complaint("ate_rmse_m", "ate_rms_m"))

    def test_a_former_key_is_refused_with_its_new_name(self):
        self.assertEqual(self.complaint("    datasets:\n      room: {w", "    logs:\n      room: {w"),
                         "study.yaml:2: study: 'logs' is called 'datasets' now")
        self.assertEqual(self.complaint("{variant: improved, part", "{log: room, part"),
                         "study.yaml:13: compare: 'log' is called 'dataset' now")

    def test_values_must_fit_the_type_of_their_flag(self):
        self.assertEqual(self.complaint("[1, 5]", "[1, many]"),
                         "study.yaml:10: particles: expected an integer (int32), found 'many'")
        self.assertIn("expected an integer", self.complaint("[1, 5]", "[1, 2.5]"))
        self.assertIn("expected true or false, found '3'",
                      self.complaint("particles: [1, 5]", "loop_closure: [3]"))
        self.assertIn("expected a number, found 'fast'",
                      self.complaint("scan_rate: 5", "scan_rate: fast"))

    def test_seeds_must_be_different_numbers(self):
        for seeds in ("3-1", "[]", "[1, 1]", "some", "[-1]"):
            self.assertIn("study.yaml:4: seeds: expected", self.complaint("1-3", seeds))

    def test_files_must_be_there(self):
        self.assertIn("study.yaml:3: world: no file 'hall.yaml'",
                      self.complaint("room.yaml", "hall.yaml"))
        self.assertIn("study.yaml:7: flagfile: no file 'gmaping.flags'",
                      self.complaint("gmapping.flags", "gmaping.flags"))
        self.assertIn("study.yaml:3: carmen: no file",
                      self.complaint("{world: room.yaml, simulate: {scan_rate: 5}}",
                                     "{carmen: hall}"))

    def test_flags_of_the_workflow_cannot_be_set(self):
        self.assertIn("--seed is set by the study's 'seeds'",
                      self.complaint("particles: [1, 5]", "seed: [1, 5]"))

    def test_an_axis_is_not_set_elsewhere(self):
        self.assertIn("study.yaml:10: particles: is an axis, and set by variant 'improved' as well",
                      self.complaint("improved: {}", "improved: {particles: 3}"))

    def test_compared_configurations_must_exist(self):
        self.assertIn("study.yaml:13: compare: selects no configuration of the study",
                      self.complaint("improved, particles: 1", "improved, particles: 2"))

    def test_broken_yaml_is_named_with_line(self):
        self.assertRegex(self.complaint("metrics: [ate_rmse_m, cpu_s]", "metrics: [ate_rmse_m"),
                         "^study.yaml:1[12]: not YAML: ")
        self.assertIn("'title' is there twice",
                      self.complaint("seeds: 1-3", "seeds: 1-3\n    title: again"))


if __name__ == "__main__":
    unittest.main()
