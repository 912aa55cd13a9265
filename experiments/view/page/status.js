// SPDX-License-Identifier: BSD-3-Clause
// One line: what the program does, and whether it is there.
import {COLUMN} from "./history.js";

export function drawStatus(element, {connection_state, runs, run, is_paused}) {
  const frame = run?.frame ?? null;
  const is_over = runs.length > 0 && runs.every((r) => !r.live || r.frame?.phase === "finished");
  let state = connection_state, text = "connecting";
  if (connection_state === "lost") {
    state = is_over ? "finished" : "lost";
    text = is_over ? "run finished; what was received is kept" : "connection lost, trying again; what was received is kept";
  } else if (frame !== null) {
    state = is_over ? "finished" : is_paused ? "paused" : frame.phase;
    const what = {finished: "run finished", paused: "paused", finishing: "final optimization",
                  running: "running"}[state];
    const scans = frame.figures[COLUMN.scans];
    const speed = frame.figures[COLUMN.scans_per_s];
    text = `${what} · ${scans} scans` + (state === "running" && speed !== null ? ` · ${speed.toFixed(0)} a second` : "");
  } else if (connection_state === "open") {
    text = "connected; no scan yet";
  }
  element.dataset.state = state;
  if (element.textContent !== text) element.textContent = text;
}
