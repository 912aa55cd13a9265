# SPDX-License-Identifier: BSD-3-Clause
"""A browser for tests and pictures of pages."""
import base64
import json
import pathlib
import shutil
import subprocess
import time
import urllib.request

MISSING = [name for name in ("chromium", "chromedriver") if shutil.which(name) is None]
ARGUMENTS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
             "--disable-background-networking", "--disable-component-update", "--disable-sync",
             "--window-size=1280,1000"]


class Browser:
    """Chromium behind chromedriver, spoken to as the WebDriver standard says."""

    def __init__(self, profile):
        self.driver = subprocess.Popen(
            ["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            text=True)
        port = next(line.split("on port ")[1].strip(" .\n") for line in self.driver.stdout
                    if "successfully on port " in line)
        self.url = f"http://127.0.0.1:{port}/session"
        try:
            session = self.call("", {"capabilities": {"alwaysMatch": {
                "goog:chromeOptions": {
                    "binary": shutil.which("chromium"),
                    "args": [*ARGUMENTS, f"--user-data-dir={profile}"]},
                "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}}})
        except OSError:
            self.driver.kill()
            raise
        self.url += f"/{session['sessionId']}"

    def call(self, path, body=None, method="POST"):
        request = urllib.request.Request(
            self.url + path, method=method, headers={"Content-Type": "application/json"},
            data=None if body is None else json.dumps(body).encode())
        # Not through a proxy: the driver is on this machine.
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        with opener.open(request) as answer:
            return json.load(answer)["value"]

    def run(self, script):
        return self.call("/execute/sync", {"script": script, "args": []})

    def screenshot(self, path):
        pathlib.Path(path).write_bytes(base64.b64decode(self.call("/screenshot", method="GET")))

    def resize(self, width, height):
        self.call("/window/rect", {"width": width, "height": height})

    def press(self, keys):
        """Types the keys, one after the other, to what has the focus."""
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        self.call("/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def hold(self, keys, release=()):
        """Lets go of keys, then presses others and keeps them down."""
        actions = [{"type": "keyUp", "value": key} for key in release]
        actions += [{"type": "keyDown", "value": key} for key in keys]
        self.call("/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def click_at(self, x, y):
        """In pixels from the upper left corner of the page."""
        self.call("/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": [
            {"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)},
            {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]}]})

    def wait_for(self, condition, timeout_s=60):
        """Until the expression of JavaScript is true; returns its value."""
        end = time.monotonic() + timeout_s
        while True:
            value = self.run(f"return {condition}")
            if value:
                return value
            if time.monotonic() > end:
                raise AssertionError(f"{condition} is not so after {timeout_s} s")
            time.sleep(0.1)

    def wait_for_text(self, element_id, part):
        """Pages draw what they are told with their next frame."""
        self.wait_for(f"document.getElementById('{element_id}').textContent.includes('{part}')")

    def click(self, selector):
        element = self.call("/element", {"using": "css selector", "value": selector})
        self.call(f"/element/{next(iter(element.values()))}/click", {})

    def log(self, kind):
        return self.call("/se/log", {"type": kind})

    def close(self):
        self.call("", method="DELETE")
        self.driver.kill()
        self.driver.wait()
        self.driver.stdout.close()
