#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of README.md from the live view of a simulated tour: live_view.gif and live_view.png.
Needs Chromium, ChromeDriver and Pillow (experiments/install_packages.sh experiments)."""
import io
import pathlib
import subprocess
import tempfile
import time

from PIL import Image

import browser

ROOT = pathlib.Path(__file__).resolve().parents[2]
BINARIES = ROOT / "build" / "bin"
WORLD = ROOT / "experiments" / "simulation" / "worlds" / "paper_building.yaml"
SCANS_A_FRAME = 60
FRAME_MS = 120
SIZE = (1100, 700)      # of the window
SHOWN = (580, 369)      # of the animation
PICTURE_AT_SCAN = 2300
VIEW = "gmapping_spa_view"


def simulate(folder):
    subprocess.run([BINARIES / "simulate", f"--world={WORLD}", "--seed=3", f"--output_dir={folder}"],
                   check=True, stdout=subprocess.DEVNULL)


def start_slam(folder):
    slam = subprocess.Popen(
        [BINARIES / "gmapping_spa", f"--log={folder / 'log.clf'}", f"--output_dir={folder / 'out'}",
         "--particles=15", "--view", "--view_port=0", "--view_wait", "--view_keep"],
        stderr=subprocess.PIPE, text=True)
    return slam, slam.stderr.readline().split()[1]


def screenshot(page, folder):
    path = folder / "frame.png"
    page.screenshot(path)
    return Image.open(io.BytesIO(path.read_bytes())).convert("RGB")


def film(page, folder):
    """A frame every so many scans, until the final optimization is done; and the one for the README."""
    page.wait_for(f"{VIEW}.runs[0]?.frame")
    page.run(f"{VIEW}.connection.send('pause')")
    page.wait_for(f"{VIEW}.is_paused")
    frames, picture = [], None
    while page.run(f"return {VIEW}.runs[0].frame.phase") == "running":
        scans = page.run(f"return {VIEW}.runs[0].frame.figures[1]")
        page.run(f"for (let i = 0; i < {SCANS_A_FRAME}; ++i) {VIEW}.connection.send('step');")
        page.wait_for(f"{VIEW}.runs[0].frame.figures[1] >= {scans + SCANS_A_FRAME} || "
                      f"{VIEW}.runs[0].frame.phase !== 'running'")
        if picture is None and scans > PICTURE_AT_SCAN:
            page.press("rc")  # refused closures, and why the latest one was accepted
            time.sleep(0.5)
            picture = screenshot(page, folder)
            page.press("rl")
            page.run(f"{VIEW}.select({VIEW}.run, null)")
        time.sleep(0.1)
        frames.append(screenshot(page, folder))
    page.wait_for(f"{VIEW}.runs[0].frame.phase === 'finished'")
    time.sleep(0.5)
    return [*frames, screenshot(page, folder)], picture


def write_animation(frames, path):
    small = [frame.resize(SHOWN, Image.Resampling.LANCZOS) for frame in frames]
    # Of several frames, as not all have all colors; those of thin lines are rare.
    strip = Image.new("RGB", (SHOWN[0], 4 * SHOWN[1]))
    for k in range(4):
        strip.paste(small[(k + 1) * len(small) // 4 - 1], (0, k * SHOWN[1]))
    palette = strip.quantize(96, method=Image.Quantize.MAXCOVERAGE)
    indexed = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in small]
    indexed[0].save(path, save_all=True, append_images=indexed[1:], optimize=True, loop=0,
                    duration=[FRAME_MS] * (len(indexed) - 1) + [3000])


def main():
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        folder = pathlib.Path(name)
        simulate(folder)
        slam, url = start_slam(folder)
        page = browser.Browser(str(folder / "profile"))
        try:
            page.resize(*SIZE)
            page.call("/url", {"url": url})
            frames, picture = film(page, folder)
        finally:
            page.close()
            slam.terminate()
            slam.communicate()
        here = pathlib.Path(__file__).resolve().parent
        write_animation(frames, here / "live_view.gif")
        picture.quantize(128).save(here / "live_view.png", optimize=True)


if __name__ == "__main__":
    main()
