# SPDX-License-Identifier: BSD-3-Clause
"""A simulated log, gmapping_spa with its view on, and a browser that looks at it."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
BINARIES = pathlib.Path(os.environ.get("GMAPPING_SPA_BINARIES", ROOT / "build" / "bin"))
WORLDS = ROOT / "experiments" / "simulation" / "worlds"
sys.path.insert(0, str(ROOT / "experiments" / "view"))
import browser

NEEDS_BROWSER = unittest.skipIf(browser.MISSING, f"no {' and no '.join(browser.MISSING)}")


class Program:
    """gmapping_spa with --view, or another program with a page, from when the page is served."""

    def __init__(self, *flags, port=0, name="gmapping_spa"):
        self.process = subprocess.Popen(
            [BINARIES / name, f"--view_port={port}", *flags], text=True,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        said = []
        for line in self.process.stderr:
            said.append(line)
            if line.startswith("view: "):
                break
        else:
            raise AssertionError(f"it ended with {self.process.wait()}: {''.join(said)}")
        self.url = line.split()[1]
        self.port = int(self.url.rstrip("/").rsplit(":", 1)[1])

    def wait(self, timeout_s=120):
        """Its exit status."""
        self.process.communicate(timeout=timeout_s)
        return self.process.returncode

    def end(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()


class ViewTestCase(unittest.TestCase):
    """With a log of half a minute on the simulated building's short tour, made once."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.shared = pathlib.Path(folder.name)
        subprocess.run([BINARIES / "simulate", f"--world={WORLDS / 'paper_building.yaml'}",
                        f"--path={WORLDS / 'paper_building.short.path.yaml'}", "--seed=1",
                        f"--output_dir={cls.shared}"], check=True, capture_output=True)
        cls.log = cls.shared / "log.clf"

    def setUp(self):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *flags, port=0, output="out"):
        """SLAM on the log, which waits for the first page."""
        program = Program(f"--log={self.log}", f"--output_dir={self.folder / output}", "--view",
                          "--view_wait", *flags, port=port)
        self.addCleanup(program.end)
        return program

    def show(self, *folders):
        program = Program(f"--view={','.join(map(str, folders))}")
        self.addCleanup(program.end)
        return program

    def open_browser(self, url):
        opened = browser.Browser(str(self.folder / "profile"))
        self.addCleanup(opened.close)
        opened.call("/url", {"url": url})
        return opened
