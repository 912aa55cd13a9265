// SPDX-License-Identifier: BSD-3-Clause
// The slider of time: at its right end it stays with the latest.

const STEPS = 1000;

export class Timeline {
  // on_time(part of the time, or null for the latest)
  constructor(on_time) {
    this.on_time = on_time;
    this.slider = document.getElementById("time");
    this.text = document.getElementById("time_text");
    this.note = document.getElementById("time_note");
    this.latest = document.getElementById("to_latest");
    this.slider.addEventListener("input", () => {
      const step = Number(this.slider.value);
      this.on_time(step >= STEPS ? null : step / STEPS);
    });
    this.latest.addEventListener("click", () => this.on_time(null));
  }

  draw(run, time_s, scene) {
    const {first_s, last_s} = run.history;
    const part = time_s === null || last_s <= first_s ? 1 : (time_s - first_s) / (last_s - first_s);
    const shown_s = (scene?.shown_s ?? time_s ?? last_s) - first_s;
    this.slider.value = Math.round(part * STEPS);
    this.text.textContent = `${shown_s.toFixed(1)} of ${(last_s - first_s).toFixed(1)} s`;
    this.slider.setAttribute("aria-valuetext", `${shown_s.toFixed(1)} seconds`);
    this.latest.disabled = time_s === null;
    const note = scene === null || !scene.is_past || scene.is_map_of_that_time
        ? "" : "The map of that time is not kept: the latest one is shown, faded.";
    if (this.note.textContent !== note) this.note.textContent = note;
  }
}
