// SPDX-License-Identifier: BSD-3-Clause
// Figures over time as small line charts; a click picks a time.
import {COLUMN} from "./history.js";

const CHARTS = [
  {title: "Effective particles (N_eff)", lines: [["n_eff", "path"]], digits: 1},
  {title: "Scans per second", lines: [["scans_per_s", "path"]], digits: 0},
  {title: "Cost of the graph", lines: [["cost", "path"]], digits: 1},
  {title: "Closures accepted / refused", lines: [["accepted", "accepted"], ["refused", "refused"]], digits: 0},
];

const LABEL_PX = 34;  // for the largest value

// Small numbers with two digits that count.
const textOf = (value, digits) => value !== 0 && Math.abs(value) < 1 && digits > 0 ? value.toPrecision(2) : value.toFixed(digits);

class Chart {
  constructor({title, lines, digits}, on_time) {
    this.lines = lines;
    this.digits = digits;
    this.title = title;
    this.figure = document.createElement("figure");
    const caption = document.createElement("figcaption");
    this.value = document.createElement("b");
    caption.append(title, this.value);
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.canvas.addEventListener("click", (event) => {
      const {left, width} = this.canvas.getBoundingClientRect();
      on_time((event.clientX - left - LABEL_PX) / (width - LABEL_PX - 4));
    });
    this.figure.append(caption, this.canvas);
  }

  draw({history, live: is_live}, row, is_past, colors) {
    const text = this.lines.map(([name]) => row?.values[COLUMN[name]])
        .map((value) => value === null || value === undefined ? "–" : textOf(value, this.digits)).join(" / ");
    this.value.textContent = text;
    this.canvas.setAttribute("aria-label", `${this.title}: ${text}`);
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    const ratio = devicePixelRatio;
    if (width === 0) return;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const context = this.canvas.getContext("2d");
    context.scale(ratio, ratio);
    const span_s = Math.max(history.last_s - history.first_s, 1e-9);
    const x_of = (values) => (values[COLUMN.stamp_s] - history.first_s) / span_s * (width - LABEL_PX - 4) + LABEL_PX;
    let max = 0;
    for (const {values} of history.rows) {
      for (const [name] of this.lines) max = Math.max(max, values[COLUMN[name]] ?? 0);
    }
    for (const [name, color] of this.lines) {
      context.beginPath();
      for (const {values} of history.rows) {
        const value = values[COLUMN[name]];
        if (value === null) continue;
        context.lineTo(x_of(values), height - 3 - (max > 0 ? value / max : 0) * (height - 6));
      }
      context.strokeStyle = colors[color];
      context.lineWidth = 1.5;
      context.stroke();
    }
    if (max > 0) {
      context.fillStyle = colors.quiet;
      context.font = "10px system-ui, sans-serif";
      context.textAlign = "right";
      context.fillText(textOf(max, this.digits), LABEL_PX - 4, 11);
      context.fillText("0", LABEL_PX - 4, height - 4);
    }
    if (!is_live && history.rows.every(({values}) => this.lines.every(([name]) => values[COLUMN[name]] === null))) {
      context.fillStyle = colors.quiet;
      context.font = "12px system-ui, sans-serif";
      context.fillText("not recorded by finished runs", LABEL_PX, height / 2 + 4);
    }
    if (is_past && row !== undefined) {
      context.fillStyle = colors.selected;
      context.fillRect(x_of(row.values) - 1, 0, 2, height);
    }
  }
}

export class Charts {
  // on_time(part of the time from the first row to the last)
  constructor(parent, on_time) {
    this.charts = CHARTS.map((chart) => new Chart(chart, on_time));
    parent.append(...this.charts.map((chart) => chart.figure));
  }

  draw(run, time_s, colors) {
    const {history} = run;
    const row = time_s === null ? history.rows.at(-1) : history.at(time_s);
    for (const chart of this.charts) chart.draw(run, row, time_s !== null, colors);
  }
}
