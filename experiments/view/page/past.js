// SPDX-License-Identifier: BSD-3-Clause
// What is shown of a run: the latest, or a time before.
import {COLUMN} from "./history.js";
import {POSE_VALUES} from "./run.js";

// {pose, particles: [{pose, tail, weight}], scan, path_length, tiles (null: the latest ones),
//  is_past, shown_s, is_map_of_that_time, is_finished}; null where nothing is known. time_s: null for the latest.
export function sceneOf(run, time_s) {
  if (run.frame === null) return null;
  const {figures, particles, scan, best, phase} = run.frame;
  if (time_s === null) {
    run.tiles.forget_past();
    return {
      pose: figures.slice(COLUMN.x, COLUMN.theta + 1), particles, scan, best, tiles: null,
      path_length: run.path.length / POSE_VALUES, is_past: false, shown_s: null, is_map_of_that_time: true,
      is_finished: phase === "finished",
    };
  }
  const row = run.history.at(time_s);
  // Of a live run all is shown at the last time that was recorded.
  const shown_s = run.live && row !== undefined ? row.values[COLUMN.stamp_s] : time_s;
  const of_row = [];
  for (let i = 0; i < (row?.particles?.length ?? 0); i += 3) {
    of_row.push({pose: row.particles.subarray(i, i + 3), tail: []});
  }
  const path_length = run.path_length(shown_s);
  const last = POSE_VALUES * (path_length - 1);
  // Where it was taken to be then; where nobody recorded that, by what is known now.
  const pose = run.live && row !== undefined ? row.values.slice(COLUMN.x, COLUMN.theta + 1)
                                             : run.path.slice(Math.max(last, 0), Math.max(last, 0) + 3);
  const is_map_of_that_time = run.tiles.first_s <= shown_s;
  return {
    pose, particles: of_row, scan: [], best: -1, path_length, is_past: true, shown_s, is_map_of_that_time,
    tiles: is_map_of_that_time ? run.tiles.at(shown_s) : null, is_finished: false,
  };
}
