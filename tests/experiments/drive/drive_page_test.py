#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page to drive on, in a real browser, by keys and clicks. With GMAPPING_SPA_SCREENSHOTS, a
folder, it leaves pictures there to look at."""
import json
import os
import pathlib
import time
import unittest

import yaml

import drive_fixture
import browser
import view_fixture

SCREENSHOTS = os.environ.get("GMAPPING_SPA_SCREENSHOTS")
APP = "gmapping_spa_drive"
STATUS = f"{APP}.status"
RIGHT, TAB, ESCAPE = "\ue014", "\ue004", "\ue00c"
SPEED = 1


# Somebody who looks where the robot is, and holds arrow keys: in the page, as what a driver of browsers
# does takes seconds where others keep the machine busy.
STEERING = """
const app = gmapping_spa_drive, points = %s, speed = %d, held = new Set();
const press = (code, is_down) => {
  if (held.has(code) === is_down) return;
  if (is_down) held.add(code); else held.delete(code);
  document.body.dispatchEvent(new KeyboardEvent(is_down ? 'keydown' : 'keyup', {code, key: code, bubbles: true, cancelable: true}));
};
let looked = performance.now(), backs = 0;
globalThis.way_points_left = points.length;
const look = () => {
  let [x, y, theta] = app.status.pose;
  const [v, omega] = app.status.velocity, now = performance.now();
  const delay_s = speed * (0.15 + Math.min((now - looked) / 1000, 1));  // of simulated time
  looked = now;
  x += v * delay_s * Math.cos(theta);
  y += v * delay_s * Math.sin(theta);
  theta += omega * delay_s + omega * Math.abs(omega) / 4;  // until it stops turning
  while (points.length > 0 && Math.hypot(points[0][0] - x, points[0][1] - y) < 0.6) points.shift();
  globalThis.way_points_left = points.length;
  if (points.length === 0) {
    for (const code of [...held]) press(code, false);
    return;
  }
  const dx = points[0][0] - x, dy = points[0][1] - y, distance = Math.hypot(dx, dy);
  const turn = Math.atan2(dy, dx) - theta, error = Math.atan2(Math.sin(turn), Math.cos(turn));
  press('ArrowLeft', error > 0.08);
  press('ArrowRight', error < -0.08);
  backs = app.status.blocked_by !== '' ? 30 : backs - 1;  // away from what is in the way
  press('ArrowDown', backs > 0);
  press('ArrowUp', backs <= 0 && Math.abs(error) < 0.4 && distance > 0.3 + v * v / 2 && v * delay_s < 1);
  setTimeout(look, 30);
};
look();
"""


@unittest.skipUnless(os.environ.get("GMAPPING_SPA_TEST_DRIVE"), "minutes: tests/run.sh drive")
@view_fixture.NEEDS_BROWSER
class DrivePageTest(drive_fixture.DriveTestCase):
    def begin(self, *flags):
        self.program = self.start(*flags)
        self.browser = browser.Browser(str(self.folder / "profile"))
        self.addCleanup(self.browser.close)
        self.browser.call("/url", {"url": self.program.url})
        self.browser.wait_for(STATUS)
        self.browser.wait_for(f"{APP}.runs.size > 1")

    def picture(self, name):
        if SCREENSHOTS:
            time.sleep(0.4)
            self.browser.screenshot(pathlib.Path(SCREENSHOTS) / f"{name}.png")

    def text(self, selector):
        return self.browser.run(f"return document.querySelector('{selector}').textContent")

    def expect_silent_console(self):
        self.assertEqual(self.browser.log("browser"), [])

    def go(self, x, y):
        self.browser.run(f"{APP}.goal({x}, {y})")
        self.browser.wait_for(f"Math.hypot({STATUS}.pose[0] - {x}, {STATUS}.pose[1] - {y}) < 0.6")

    def steer(self, way_points):
        self.browser.run(STEERING % (json.dumps(way_points), SPEED))
        self.browser.wait_for("way_points_left === 0", timeout_s=240)

    def save(self):
        self.browser.press("v")
        self.browser.wait_for(f"{STATUS}.note.includes('scans saved in')", timeout_s=180)

    def test_tour_by_keys_ends_with_a_map_as_good_as_that_of_the_log(self):
        self.begin(f"--speed={SPEED}", *drive_fixture.OBSTACLES)
        path = drive_fixture.WORLDS / "paper_building.short.path.yaml"
        way_points = yaml.safe_load(path.read_text())["way_points"][1:]
        self.steer(way_points[:3])
        self.browser.run(f"{APP}.connection.send('add', {{backend: 'none', particles: 30, correction: 'trajectory'}})")
        self.steer(way_points[3:6])
        self.picture("driving")
        self.steer(way_points[6:])
        self.save()
        self.picture("saved")
        online = self.browser.wait_for(f"{APP}.variants.find(({{run, iou}}) => run === 1 && iou !== null)")
        out = self.folder / "out"
        offline = self.run_offline()
        self.expect_same(offline / "trajectory.tum", out / "variant_1.tum")
        iou, ate_m = self.measure(offline)
        self.assertLess(abs(online["iou"] - iou), 0.005, f"IoU on the page {online['iou']}, offline {iou}")
        self.assertLess(abs(online["ate_m"] - ate_m), 0.005, f"ATE on the page {online['ate_m']} m, offline {ate_m} m")
        self.assertGreater(online["iou"], 0.8)
        self.assertLess(online["ate_m"], 0.1)
        self.expect_silent_console()

    def test_click_is_a_goal_and_keys_take_over(self):
        self.begin("--speed=5")
        place = self.browser.run(f"""
            const app = {APP}, pane = app.panes[0];
            const [x, y] = app.camera.to_screen(20.1, 4.2, pane.size);
            const box = pane.canvas.getBoundingClientRect();
            return [box.left + x, box.top + y];""")
        self.browser.click_at(*place)
        self.browser.wait_for(f"{STATUS}.way.length > 0")
        self.picture("goal")
        self.browser.wait_for(f"Math.hypot({STATUS}.pose[0] - 20.1, {STATUS}.pose[1] - 4.2) < 0.6", timeout_s=120)
        self.browser.wait_for(f"{STATUS}.state === 'waiting'")
        self.browser.click_at(*place[:1], place[1] - 40)
        self.browser.wait_for(f"{STATUS}.state === 'driving'")
        self.browser.hold("s")
        self.browser.wait_for(f"{STATUS}.way.length === 0 && {STATUS}.velocity[0] < 0")
        self.browser.hold("", "s")
        self.expect_silent_console()

    def test_keys_drive_while_they_are_held_but_not_while_the_page_hangs(self):
        self.begin()
        self.browser.hold("a")
        self.browser.wait_for(f"{STATUS}.velocity[1] > 0")
        time.sleep(2)
        self.assertGreater(self.browser.run(f"return {STATUS}.velocity[1]"), 0)
        # The program goes on telling, which the page looks at when it hangs no more.
        self.browser.run(f"""
            const {{connection}} = {APP}, take = connection.on_message;
            globalThis.stood = false;
            connection.on_message = (message) => {{
              take(message);
              globalThis.stood ||= {STATUS}.velocity[1] === 0;
            }};
            const end = performance.now() + 3000;
            while (performance.now() < end) ;""")
        self.browser.wait_for("stood")
        self.browser.wait_for(f"{STATUS}.velocity[1] > 0")
        self.browser.hold("", "a")
        self.browser.wait_for(f"{STATUS}.velocity[1] === 0")
        self.expect_silent_console()

    def test_maps_are_added_and_removed_by_keys_alone(self):
        self.begin("--speed=5")
        self.go(13, 8.2)
        for _ in range(40):
            self.browser.press(TAB)
            if self.browser.run("return document.activeElement.id") == "add_button":
                break
        self.browser.press(" ")
        self.browser.wait_for(f"{APP}.runs.size === 3 && {APP}.runs.get(2).frame")
        self.browser.wait_for_text("variants", "none, 30 particles")
        self.browser.wait_for(f"{APP}.variants.every(({{iou}}) => iou !== null)")
        self.browser.wait_for(f"[1, 2].every((run) => {APP}.charts.rows.get(run)?.length > 0)")
        self.assertEqual(self.text("#chart_lines"),
                         "blue: spa, 5 particles, trajectoryorange: none, 30 particles, trajectory")
        self.assertRegex(self.browser.run("return document.querySelector('#charts canvas').ariaLabel"),
                         r"^ATE in m: blue [0-9.]+, orange [0-9.]+$")
        self.picture("two_maps")
        self.browser.press(ESCAPE)
        self.assertEqual(self.browser.run("return document.activeElement.tagName"), "BODY")
        self.browser.click(".variant button")
        self.browser.wait_for(f"{APP}.runs.size === 2")
        self.expect_silent_console()

    def test_map_that_was_removed_is_gone_however_late_the_list_of_maps_comes(self):
        self.begin("--speed=5")
        self.browser.wait_for(f"{APP}.variants.length === 1")
        self.browser.run(f"""
            const {{connection}} = {APP}, take = connection.on_message;
            connection.on_message = (message) => setTimeout(() => take(message), message.op === 'variants' ? 300 : 0);""")
        self.browser.click(".variant button")
        self.browser.wait_for(f"{APP}.runs.size === 1")
        time.sleep(1)
        self.assertEqual(self.text("#variants"), "")
        self.expect_silent_console()

    def test_sliders_change_the_wheels(self):
        self.begin("--speed=5")
        self.browser.click("#noise")
        self.browser.wait_for(f"Math.abs({STATUS}.noise - 5) < 0.5")
        self.browser.press(RIGHT)
        self.browser.wait_for(f"{STATUS}.noise > 5")
        self.assertIn("times", self.text("#noise_text"))
        self.expect_silent_console()

    def test_reload_and_lost_connection_come_back(self):
        self.begin("--speed=5")
        self.go(13, 8.2)
        self.browser.wait_for(f"{STATUS}.state === 'waiting'")
        what = f"return [{STATUS}.pose, {APP}.runs.get(1).tiles.latest.size, {APP}.charts.rows.get(1)]"
        time.sleep(0.5)
        before = self.browser.run(what)
        self.assertGreater(len(before[2]), 0)
        self.browser.call("/refresh", {})
        self.browser.wait_for(f"{STATUS} && {APP}.runs.get(1)?.frame")
        time.sleep(0.5)
        after = self.browser.run(what)
        self.assertEqual(after, before)
        self.expect_silent_console()
        self.program.end()
        self.browser.wait_for(f"{APP}.connection_state === 'lost'")
        self.browser.wait_for_text("status", "connection lost")
        self.browser.run("document.getElementById('noise').focus()")
        self.browser.press(RIGHT)  # which nobody hears
        self.start("--speed=5", port=self.program.port, output="again")
        self.browser.wait_for(f"{APP}.connection_state === 'open' && {STATUS}.path_m === 0")
        self.browser.wait_for("document.getElementById('noise').value === '1'")

    def test_narrow_window_shows_all_without_scrolling_sideways(self):
        self.begin("--speed=5")
        self.go(13, 8.2)
        self.browser.resize(500, 900)
        time.sleep(0.5)
        self.picture("narrow")
        width, inner = self.browser.run("return [document.documentElement.scrollWidth, innerWidth]")
        self.assertLessEqual(width, inner)
        self.expect_silent_console()

    def test_help_opens_by_a_key(self):
        self.begin()
        self.browser.press("?")
        self.browser.wait_for("document.getElementById('help').open")
        self.picture("help")
        self.browser.press(ESCAPE)
        self.browser.wait_for("!document.getElementById('help').open")
        self.expect_silent_console()


if __name__ == "__main__":
    unittest.main()
