// SPDX-License-Identifier: BSD-3-Clause
// The errors of the maps over time, a line a map.
import {LineChart, textOf} from "./line_chart.js";
import {part} from "./variant_panel.js";

const MAX_ROWS = 1024;
const STAMP = 0, ATE = 1, IOU = 2;  // columns of a row
// By the number of the run, from 1; drive.css says how they look.
const LINES = [["blue", []], ["orange", [7, 3]], ["green", [3, 2]], ["purple", [8, 3, 2, 3]]];
export const LINE_COLORS = LINES.map(([name]) => `line-${name}`);

const lineOf = (run) => LINES[(run - 1) % LINES.length];

export class ScoreCharts {
  rows = new Map();  // of a run

  constructor(parent, legend) {
    this.ate = new LineChart("ATE in m");
    this.iou = new LineChart("IoU");
    this.legend = legend;
    parent.append(this.ate.figure, this.iou.figure);
  }

  begin() { this.rows.clear(); }
  reset(run, rows) { this.rows.set(run, rows); }

  // When it is full, every second row goes.
  add({run, scored_s, ate_m, iou}) {
    if (ate_m === null && iou === null) return;
    const rows = this.rows.get(run) ?? [];
    const last_s = rows.at(-1)?.[STAMP] ?? -Infinity;
    if (scored_s < last_s) return;
    if (scored_s === last_s) rows.pop();
    rows.push([scored_s, ate_m, iou]);
    this.rows.set(run, rows.length > MAX_ROWS ? rows.filter((_, i) => i % 2 === 0) : rows);
  }

  draw(variants, colors) {
    const all = [...this.rows.values()].flat();
    const first = Math.min(...all.map((row) => row[STAMP])), last = Math.max(...all.map((row) => row[STAMP]));
    const lines = (column) => variants.map(({run}) => {
      const [name, dash] = lineOf(run);
      return {rows: this.rows.get(run) ?? [], x: (row) => row[STAMP], y: (row) => row[column], color: colors[`line-${name}`], dash};
    });
    const tell = (chart, column, text) => {
      const values = variants.map(({run}) => [lineOf(run)[0], text(this.rows.get(run)?.at(-1)?.[column])]);
      chart.tell(values.map(([, value]) => value).join(" / "), values.map((words) => words.join(" ")).join(", "));
    };
    tell(this.ate, ATE, (value) => value === null || value === undefined ? "–" : textOf(value, 2));
    tell(this.iou, IOU, part);
    const iou = all.map((row) => row[IOU]).filter((value) => value !== null);
    this.ate.draw(lines(ATE), {first, last, max: Math.max(0, ...all.map((row) => row[ATE] ?? 0)), digits: 2}, colors);
    // Maps that are nearly the truth differ in little.
    this.iou.draw(lines(IOU), {first, last, min: Math.floor(10 * Math.min(1, ...iou)) / 10, max: iou.length > 0 ? 1 : 0, digits: 1}, colors);
    this.#tell_legend(variants);
  }

  #tell_legend(variants) {
    const words = variants.map(({run, name}) => `${lineOf(run)[0]}: ${name}`);
    if (this.legend.dataset.words === String(words)) return;
    this.legend.dataset.words = String(words);
    this.legend.replaceChildren(...variants.map(({run}, i) => {
      const item = document.createElement("li");
      item.style.setProperty("--dot", `var(--line-${lineOf(run)[0]})`);
      item.textContent = words[i];
      return item;
    }));
  }
}
