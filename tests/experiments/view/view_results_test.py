#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Results do not depend on whether, and how, somebody looks; and what is said on the way."""
import json
import subprocess
import unittest

import view_fixture
import web_socket

FILES = ("trajectory.tum", "map.pgm", "map.yaml", "map.png", "graph.g2o", "loop_closures.csv")
GMAPPING_SPA = view_fixture.BINARIES / "gmapping_spa"


class ViewResultsTest(view_fixture.ViewTestCase):
    def run_plain(self, *flags):
        return subprocess.run([GMAPPING_SPA, *flags], capture_output=True, text=True, timeout=120)

    def expect_same(self, expected, found):
        for name in FILES:
            self.assertEqual((expected / name).read_bytes(), (found / name).read_bytes(), name)
        records = [json.loads((folder / "run.json").read_text()) for folder in (expected, found)]
        for record in records:
            del record["resources"]
        self.assertEqual(*records)

    def test_results_are_the_same_with_a_page_and_without(self):
        plain = self.folder / "plain"
        self.assertEqual(self.run_plain(f"--log={self.log}", f"--output_dir={plain}").returncode, 0)
        program = self.start()
        page, _ = web_socket.open_socket(program.port)
        self.addCleanup(page.close)
        for op in ("pause", "step", "step", "resume"):
            web_socket.send(page, json.dumps({"op": op}).encode())
        self.assertTrue(web_socket.is_closed(page))
        self.assertEqual(program.wait(), 0)
        self.expect_same(plain, self.folder / "out")

    def test_simulated_run_without_a_log_can_be_looked_at(self):
        plain, world = self.folder / "plain", view_fixture.WORLDS / "paper_building.yaml"
        flags = (f"--world={world}", f"--path={world.with_suffix('.short.path.yaml')}")
        subprocess.run([view_fixture.BINARIES / "simulate_slam", f"--output_dir={plain}", *flags],
                       check=True, capture_output=True)
        program = view_fixture.Program(f"--output_dir={self.folder / 'out'}", "--view", "--view_wait",
                                       *flags, name="simulate_slam")
        self.addCleanup(program.end)
        page, _ = web_socket.open_socket(program.port)
        self.addCleanup(page.close)
        texts = []
        try:
            while True:
                opcode, data = web_socket.receive(page)
                if opcode == web_socket.TEXT:
                    texts.append(json.loads(data))
        except EOFError:
            pass
        self.assertEqual(texts[0]["runs"][0]["name"], "paper_building.yaml")
        self.assertEqual([text["phase"] for text in texts if text["op"] == "frame"][-1], "finished")
        self.assertEqual(program.wait(), 0)
        self.expect_same(plain, self.folder / "out")

    def test_only_changed_tiles_are_sent(self):
        program = self.start()
        page, _ = web_socket.open_socket(program.port)
        self.addCleanup(page.close)
        tiles, largest, frames = 0, 0, 0
        try:
            while True:
                opcode, data = web_socket.receive(page)
                if opcode == web_socket.BINARY:
                    count = (len(data) - 16) // 260
                    tiles, largest = tiles + count, max(largest, count)
                elif opcode == web_socket.TEXT and json.loads(data)["op"] == "frame":
                    frames += 1
        except EOFError:
            pass
        self.assertGreater(frames, 3)
        self.assertGreater(largest, 500)
        self.assertLess(tiles, 0.7 * frames * 1400)  # the map has 1400 tiles in the end

    def test_port_that_is_taken_is_an_error_before_the_run(self):
        program = self.start()
        done = self.run_plain(f"--log={self.log}", f"--output_dir={self.folder / 'x'}", "--view",
                              f"--view_port={program.port}")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"error: cannot listen at port \d+ of 127.0.0.1: ")
        self.assertFalse((self.folder / "x").exists())

    def test_what_is_no_folder_of_results_is_an_error(self):
        for view, expected in (("nowhere", "expected 'live' or a folder with results"),
                               (f"{self.folder}", "map.yaml"), ("a,b,c", "or two with a comma")):
            done = self.run_plain(f"--view={view}", "--view_port=0")
            self.assertEqual(done.returncode, 1, view)
            self.assertIn(expected, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
