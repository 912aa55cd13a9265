// SPDX-License-Identifier: BSD-3-Clause
// Figures over time as small line charts; a click picks a time.
import {COLUMN} from "./history.js";
import {LineChart, textOf} from "./line_chart.js";

const CHARTS = [
  {title: "Effective particles (N_eff)", lines: [["n_eff", "path"]], digits: 1},
  {title: "Scans per second", lines: [["scans_per_s", "path"]], digits: 0},
  {title: "Cost of the graph", lines: [["cost", "path"]], digits: 1},
  {title: "Closures accepted / refused", lines: [["accepted", "accepted"], ["refused", "refused"]], digits: 0},
];

const stampOf = ({values}) => values[COLUMN.stamp_s];

function drawFigures(chart, {lines, digits}, {history, live: is_live}, row, is_past, colors) {
  chart.tell(lines.map(([name]) => row?.values[COLUMN[name]])
      .map((value) => value === null || value === undefined ? "–" : textOf(value, digits)).join(" / "));
  let max = 0, is_known = false;
  for (const {values} of history.rows) {
    for (const [name] of lines) {
      const value = values[COLUMN[name]];
      max = Math.max(max, value ?? 0);
      is_known ||= value !== null;
    }
  }
  chart.draw(lines.map(([name, color]) => ({rows: history.rows, x: stampOf, y: ({values}) => values[COLUMN[name]], color: colors[color]})),
             {first: history.first_s, last: history.last_s, max, digits,
              mark: is_past && row !== undefined ? stampOf(row) : null,
              note: is_live || is_known ? "" : "not recorded by finished runs"}, colors);
}

export class Charts {
  // on_time(part of the time from the first row to the last)
  constructor(parent, on_time) {
    this.charts = CHARTS.map(({title}) => new LineChart(title, on_time));
    parent.append(...this.charts.map((chart) => chart.figure));
  }

  draw(run, time_s, colors) {
    const {history} = run;
    const row = time_s === null ? history.rows.at(-1) : history.at(time_s);
    this.charts.forEach((chart, i) => drawFigures(chart, CHARTS[i], run, row, time_s !== null, colors));
  }
}
