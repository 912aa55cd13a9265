#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is driven over a WebSocket and saved is what gmapping_spa makes of the log, and a tour that
is driven again gives the same bytes."""
import json
import shutil
import signal
import time
import unittest

import drive_fixture
import web_socket

DRIVE = "gmapping_spa.drive.v1"
FORWARD, LEFT = {"forward": 1, "left": 0}, {"forward": 0, "left": 1}


class DriveResultsTest(drive_fixture.DriveTestCase):
    def open(self, program):
        connection, status = web_socket.open_socket(program.port, DRIVE)
        self.assertEqual(status, 101)
        self.addCleanup(connection.close)
        return connection

    def send(self, connection, op, **values):
        web_socket.send(connection, json.dumps({"op": op, **values}).encode())

    def wait_for(self, connection, op, is_so, hold=None):
        """The first message of this kind that is so; says meanwhile what is held, as a page does."""
        held_at = None
        while True:
            if hold and (held_at is None or time.monotonic() - held_at > 0.25):
                held_at = time.monotonic()
                self.send(connection, "hold", **hold)
            opcode, data = web_socket.receive(connection)
            if opcode == web_socket.PING:
                web_socket.send(connection, data, web_socket.PONG)
            if opcode != web_socket.TEXT:
                continue
            message = json.loads(data)
            if message["op"] == op and is_so(message):
                return message

    def drive(self, connection):
        """A few meters, with a turn."""
        self.send(connection, "odometry", noise=3, slips=0.5)
        self.wait_for(connection, "status", lambda status: status["path_m"] > 5, FORWARD)
        self.wait_for(connection, "status", lambda status: status["pose"][2] > 0.5, LEFT)
        self.send(connection, "hold", forward=0, left=0)
        self.wait_for(connection, "status", lambda status: status["state"] == "waiting")

    def save(self, connection):
        self.send(connection, "save")
        self.wait_for(connection, "status", lambda status: "scans saved in" in status["note"])

    def test_each_map_is_that_of_gmapping_spa_on_the_log(self):
        program = self.start("--speed=20", "--particles=3", *drive_fixture.OBSTACLES)
        connection = self.open(program)
        self.drive(connection)
        self.send(connection, "add", backend="none", particles=7, correction="pose")
        self.save(connection)
        out = self.folder / "out"
        self.assertTrue((out / "truth_obstacles.yaml").exists())
        offline = self.run_offline("--particles=3")
        self.expect_same(offline / "trajectory.tum", out / "variant_1.tum")
        self.expect_same(offline / "map.pgm", out / "variant_1.pgm")
        offline = self.run_offline("--backend=none", "--particles=7", "--correction=pose")
        self.expect_same(offline / "trajectory.tum", out / "variant_2.tum")
        record = json.loads((out / "drive.json").read_text())
        iou, ate_m = self.measure(offline)
        self.assertAlmostEqual(record["variants"][1]["iou"], iou, delta=1e-6)
        self.assertAlmostEqual(record["variants"][1]["ate_m"], ate_m, delta=1e-6)
        self.assertEqual([variant["backend"] for variant in record["variants"]], ["spa", "none"])
        self.assertLess(record["variants"][0]["ate_m"], 0.2)

    def test_save_with_fewer_maps_leaves_none_of_an_earlier_one(self):
        program = self.start("--speed=20")
        connection = self.open(program)
        self.drive(connection)
        self.send(connection, "add", backend="none", particles=1, correction="pose")
        self.save(connection)
        out = self.folder / "out"
        self.assertEqual({path.name for path in out.glob("variant_2.*")},
                         {"variant_2.tum", "variant_2.pgm", "variant_2.yaml"})
        self.send(connection, "remove", run=2)
        self.wait_for(connection, "status", lambda status: status["velocity"][1] > 0.1, LEFT)
        self.send(connection, "hold", forward=0, left=0)
        self.save(connection)
        self.assertEqual(list(out.glob("variant_2.*")), [])
        self.assertEqual(len(list(out.glob("variant_1.*"))), 3)
        self.assertEqual(len(json.loads((out / "drive.json").read_text())["variants"]), 1)

    def test_tour_that_is_driven_again_gives_the_same_bytes(self):
        program = self.start("--speed=20")
        connection = self.open(program)
        self.drive(connection)
        self.save(connection)
        again = self.start(f"--replay={self.folder / 'out' / 'commands.csv'}", output="again")
        self.save(self.open(again))
        for name in ("log.clf", "truth.tum", "truth.pgm", "commands.csv", "variant_1.tum"):
            self.expect_same(self.folder / "out" / name, self.folder / "again" / name)

    def test_time_stands_still_after_a_save_until_somebody_drives_on(self):
        program = self.start("--speed=20")
        connection = self.open(program)
        self.wait_for(connection, "status", lambda status: status["path_m"] > 2, FORWARD)
        self.send(connection, "hold", forward=0, left=0)
        self.save(connection)  # while the robot rolls out
        time.sleep(0.5)
        later = self.open(program)
        variants = self.wait_for(later, "variants", lambda _: True)["list"]
        self.assertEqual([variant["state"] for variant in variants], ["finished"])
        self.assertIsNotNone(variants[0]["iou"])
        saved_s = len((self.folder / "out" / "commands.csv").read_text().splitlines()[1:]) / 10
        status = self.wait_for(later, "status", lambda _: True)
        self.assertEqual(status["state"], "waiting")
        self.assertAlmostEqual(status["time_s"], saved_s)
        self.wait_for(later, "variants", lambda message: message["list"][0]["state"] != "finished", FORWARD)
        self.wait_for(later, "status", lambda status: status["time_s"] > saved_s + 1, FORWARD)

    def test_save_says_which_maps_it_could_not_make(self):
        back_end = self.folder / "libmine.so"
        shutil.copy(drive_fixture.BINARIES.parent / "lib" / "gmapping_spa" / "libgmapping_spa_none.so", back_end)
        connection = self.open(self.start("--speed=20", f"--backend={back_end}"))
        self.drive(connection)
        self.save(connection)
        back_end.unlink()
        self.wait_for(connection, "variants", lambda message: message["list"][0]["state"].startswith("failed: "), LEFT)
        self.send(connection, "hold", forward=0, left=0)
        self.send(connection, "save")
        self.wait_for(connection, "status", lambda status: "but for 1 of the maps: failed" in status["note"])
        self.assertEqual(json.loads((self.folder / "out" / "drive.json").read_text())["variants"], [])

    def test_what_a_save_has_to_say_stays_while_keys_are_held(self):
        connection = self.open(self.start("--speed=20"))
        self.wait_for(connection, "status", lambda status: status["path_m"] > 1, FORWARD)
        self.send(connection, "save")
        saved = self.wait_for(connection, "status", lambda status: "scans saved in" in status["note"], LEFT)
        later = self.wait_for(connection, "status", lambda status: status["time_s"] > saved["time_s"] + 2, LEFT)
        self.assertEqual(later["note"], saved["note"])
        self.send(connection, "hold", forward=0, left=0)
        self.wait_for(connection, "status", lambda status: status["velocity"] == [0, 0])
        self.wait_for(connection, "status", lambda status: status["note"] == "", LEFT)

    def test_who_says_nothing_for_a_second_lets_go_of_the_keys(self):
        program = self.start()
        connection = self.open(program)
        self.send(connection, "hold", forward=0, left=1)
        self.wait_for(connection, "status", lambda status: status["velocity"][1] > 0)
        self.wait_for(connection, "status", lambda status: status["velocity"][1] == 0)

    def test_who_goes_away_lets_go_of_the_keys(self):
        program = self.start("--speed=20")
        connection = self.open(program)
        self.wait_for(connection, "status", lambda status: status["path_m"] > 1, FORWARD)
        connection.close()
        self.wait_for(self.open(program), "status", lambda status: status["state"] == "waiting")

    def test_what_is_not_saved_is_said_at_the_end(self):
        program = self.start("--speed=20")
        connection = self.open(program)
        self.drive(connection)
        program.process.send_signal(signal.SIGINT)
        _, err = program.process.communicate(timeout=60)
        self.assertEqual(program.process.returncode, 0, err)
        self.assertRegex(err, r"the last \d+ scans of the tour were not saved")

    def test_pages_of_other_origins_are_refused(self):
        program = self.start()
        for origin, expected in (("http://elsewhere.example", 403), (program.url.rstrip("/"), 101)):
            connection, status = web_socket.open_socket(program.port, DRIVE, origin=origin)
            connection.close()
            self.assertEqual(status, expected, origin)

    def test_nonsense_ends_its_own_connection_only(self):
        program = self.start("--speed=20")
        connection = self.open(program)
        bad = self.open(program)
        self.send(bad, "add", backend="/tmp/mine.so", particles=5, correction="pose")
        self.assertTrue(web_socket.is_closed(bad))
        self.drive(connection)

    def test_without_a_folder_to_save_in_maps_are_not_finished_for_nothing(self):
        program = self.start("--speed=20", "--output_dir=")
        connection = self.open(program)
        self.drive(connection)
        self.send(connection, "save")
        self.wait_for(connection, "status", lambda status: status["note"].startswith("not saved: "))
        variants = self.wait_for(self.open(program), "variants", lambda _: True)["list"]
        self.assertIn(variants[0]["state"], ("replaying", "following"))

    def test_folder_that_cannot_be_written_is_refused_before_somebody_drives(self):
        with self.assertRaisesRegex(AssertionError, "cannot make the folder '/proc/x'"):
            self.start("--output_dir=/proc/x")

    def test_flags_of_tours_are_refused(self):
        with self.assertRaisesRegex(AssertionError, "--crowd=3: expected to be left out"):
            self.start("--crowd=3")
        with self.assertRaisesRegex(AssertionError, "commands.csv: cannot be read"):
            self.start("--replay=/nowhere/commands.csv")


if __name__ == "__main__":
    unittest.main()
