#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The live view in a real browser, by keys and clicks. With GMAPPING_SPA_SCREENSHOTS, a folder, it
leaves pictures there to look at."""
import os
import pathlib
import subprocess
import time
import unittest

import view_fixture

SCREENSHOTS = os.environ.get("GMAPPING_SPA_SCREENSHOTS")
VIEW = "gmapping_spa_view"
FRAME = f"{VIEW}.runs[0]?.frame"


@view_fixture.NEEDS_BROWSER
class ViewPageTest(view_fixture.ViewTestCase):
    def picture(self, name):
        if SCREENSHOTS:
            self.browser.screenshot(pathlib.Path(SCREENSHOTS) / f"{name}.png")

    def text(self, selector):
        return self.browser.run(f"return document.querySelector('{selector}').textContent")

    def scans(self):
        return self.browser.run(f"return {FRAME}.figures[1]")

    def begin(self, *flags, **options):
        self.program = self.start(*flags, **options)
        self.browser = self.open_browser(self.program.url)
        self.browser.wait_for(FRAME)

    def begin_paused(self):
        """Somewhere in the first half of the log, however fast the machine is."""
        self.begin("--view_keep", "--particles=20")
        self.browser.press(" ")
        self.browser.wait_for(f"{VIEW}.is_paused")
        time.sleep(0.3)

    def finish(self):
        self.browser.wait_for(f"{FRAME}?.phase === 'finished'")

    def expect_silent_console(self):
        self.assertEqual(self.browser.log("browser"), [])

    def test_map_grows_and_the_run_ends_with_its_results(self):
        self.begin()
        self.finish()
        self.assertEqual(self.program.wait(), 0)
        self.assertTrue((self.folder / "out" / "map.pgm").exists())
        self.browser.wait_for(f"{VIEW}.connection_state === 'lost'")
        self.browser.wait_for("document.getElementById('status').textContent.startsWith('run finished')")
        self.assertGreater(self.browser.run(f"return {VIEW}.runs[0].tiles.latest.size"), 500)
        self.assertGreater(self.browser.run(f"return {VIEW}.runs[0].trajectory.length"), 4 * 600)
        # The program has gone, which a browser says by itself; nothing else is wrong.
        others = [entry for entry in self.browser.log("browser")
                  if "ERR_CONNECTION_REFUSED" not in entry["message"]]
        self.assertEqual(others, [])

    def test_robot_that_is_not_found_in_an_old_map_is_said_to_be_looked_for(self):
        elsewhere = self.folder / "elsewhere"
        for words in (["simulate", f"--world={view_fixture.WORLDS / 'empty_hall.yaml'}", "--angular_resolution=2"],
                      ["gmapping_spa", f"--log={elsewhere / 'log.clf'}", f"--save_session={elsewhere / 'hall'}"]):
            subprocess.run([view_fixture.BINARIES / words[0], *words[1:], f"--output_dir={elsewhere}"],
                           check=True, capture_output=True)
        self.begin("--view_keep", f"--map_session={elsewhere / 'hall'}")
        badge = "document.querySelector('.pane .badge').textContent"
        self.browser.wait_for(f"{badge} === 'not found in the old map yet'")
        self.picture("not_found")
        self.finish()
        self.browser.wait_for(f"{badge} === ''")
        self.expect_silent_console()

    def test_map_is_drawn(self):
        self.begin("--view_keep")
        self.finish()
        time.sleep(0.5)
        self.picture("finished")
        counts = self.browser.run("""
            const canvas = document.querySelector('.pane canvas');
            const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            let free = 0, dark = 0;
            for (let i = 0; i < data.length; i += 4) {
              if (data[i] > 250 && data[i + 1] > 250 && data[i + 2] > 250) ++free;
              if (data[i] < 60 && data[i + 1] < 60 && data[i + 2] < 60) ++dark;
            }
            return [free / (data.length / 4), dark / (data.length / 4)];""")
        self.assertGreater(counts[0], 0.1)
        self.assertGreater(counts[1], 0.001)
        self.expect_silent_console()

    def test_keys_pause_step_and_go_on(self):
        self.begin_paused()
        held = self.scans()
        self.browser.wait_for_text("status", "paused")
        time.sleep(0.5)
        self.assertEqual(self.scans(), held)
        for step in (1, 2):
            self.browser.press(".")
            self.browser.wait_for(f"{FRAME}.figures[1] === {held + step}")
        self.picture("paused")
        self.browser.press(" ")
        self.finish()
        self.expect_silent_console()

    def test_click_on_a_closure_tells_its_reason(self):
        self.begin("--view_keep")
        self.finish()
        self.browser.press("rf+++++")  # with those refused, near by the robot, larger
        self.browser.press("f")
        self.assertEqual(self.text("#closure_details"), "")
        place = self.browser.run(f"""
            const app = {VIEW}, run = app.runs[0];
            const refused = run.candidates.find((c) => c.verdict !== 'accepted');
            const from = run.node(refused.old_node), to = run.node(refused.node);
            app.camera.mode = 'free';
            app.camera.x = (from.x + 3 * to.x) / 4;
            app.camera.y = (from.y + 3 * to.y) / 4;
            app.redraw();
            const box = document.querySelector('.pane canvas').getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2];""")
        self.browser.click_at(*place)
        self.browser.wait_for("document.getElementById('closure_reason')")
        self.assertRegex(self.text("#closure_reason"), "(Refused|Not accepted): ")
        self.picture("closure")
        self.browser.press("rc")
        self.browser.wait_for("document.getElementById('closure_reason')?.textContent.startsWith('Accepted')")
        self.expect_silent_console()

    def test_past_time_shows_the_map_of_then(self):
        self.begin_paused()
        self.browser.press(" ")
        self.finish()
        self.browser.press("[" * 30)
        self.browser.wait_for(f"{VIEW}.time_s !== null")
        time.sleep(0.3)
        self.picture("past")
        now, then = self.browser.run(f"""
            const run = {VIEW}.runs[0];
            return [run.tiles.latest.size, run.tiles.at({VIEW}.time_s).size];""")
        self.assertLess(then, now)
        self.browser.press("l")
        self.browser.wait_for(f"{VIEW}.time_s === null")
        self.expect_silent_console()

    def test_reload_and_lost_connection_come_back(self):
        self.begin_paused()
        held = self.scans()
        tiles = self.browser.run(f"return {VIEW}.runs[0].tiles.latest.size")
        rows = self.browser.run(f"return {VIEW}.runs[0].history.rows.length")
        self.browser.call("/refresh", {})
        self.browser.wait_for(f"{FRAME} && {VIEW}.is_paused")
        self.assertEqual(self.scans(), held)
        self.assertEqual(self.browser.run(f"return {VIEW}.runs[0].tiles.latest.size"), tiles)
        self.assertGreater(self.browser.run(f"return {VIEW}.runs[0].history.rows.length"), 0.5 * rows)
        self.expect_silent_console()
        self.program.end()
        self.browser.wait_for(f"{VIEW}.connection_state === 'lost'")
        self.browser.wait_for_text("status", "connection lost")
        self.assertEqual(self.scans(), held)  # what was received is kept
        # Without --view_keep the connection may be gone before anybody has seen that the run has finished.
        self.start("--view_keep", port=self.program.port, output="again")
        self.browser.wait_for(f"{VIEW}.connection_state === 'open' && {FRAME}?.phase === 'finished'")

    def test_everything_is_reached_by_tab_and_helped_by_a_key(self):
        self.begin_paused()
        reached = set()
        for _ in range(30):
            self.browser.press("\ue004")  # tab
            reached.add(self.browser.run("return document.activeElement.id || document.activeElement.tagName"))
        for name in ("pause", "step", "fit", "follow", "help_button", "CANVAS", "time", "SUMMARY"):
            self.assertIn(name, reached)
        self.browser.press("?")
        self.browser.wait_for("document.getElementById('help').open")
        self.browser.press("\ue00c")  # escape
        self.browser.wait_for("!document.getElementById('help').open")
        self.expect_silent_console()

    def test_narrow_window_shows_all_without_scrolling_sideways(self):
        self.begin_paused()
        self.browser.resize(500, 800)
        time.sleep(0.5)
        self.picture("narrow")
        width, inner = self.browser.run("return [document.documentElement.scrollWidth, innerWidth]")
        self.assertLessEqual(width, inner)
        for name in ("pause", "status", "time"):
            box = self.browser.run(f"const b = document.getElementById('{name}').getBoundingClientRect();"
                                   "return [b.left, b.right, b.width]")
            self.assertGreaterEqual(box[0], 0)
            self.assertLessEqual(box[1], inner)
            self.assertGreater(box[2], 20)
        self.expect_silent_console()

    def test_nothing_is_asked_of_other_machines(self):
        self.begin("--view_keep")
        self.finish()
        events = [entry["message"] for entry in self.browser.log("performance")]
        asked = [event for event in events if '"Network.requestWillBeSent"' in event
                 and f'"documentURL":"{self.program.url}"' in event]
        self.assertGreater(len(asked), 10)
        self.assertEqual([event for event in asked if f'"url":"{self.program.url}' not in event], [])


if __name__ == "__main__":
    unittest.main()
