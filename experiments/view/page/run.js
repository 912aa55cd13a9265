// SPDX-License-Identifier: BSD-3-Clause
// All that is known of one run: what the messages of the program make of it.
import {History} from "./history.js";
import {TileStore} from "./tile_store.js";

// x, y, theta, stamp of one pose after another.
export const POSE_VALUES = 4;

function countUpTo(poses, time_s) {
  let count = poses.length / POSE_VALUES;
  while (time_s !== null && count > 0 && poses[POSE_VALUES * count - 1] > time_s) --count;
  return count;
}

export class Run {
  constructor({name, live, resolution_m}) {
    this.name = name;
    this.live = live;
    this.resolution_m = resolution_m;
    this.tiles = new TileStore();
    this.history = new History();
    this.nodes = [];       // values, POSE_VALUES each
    this.trajectory = [];  // likewise, of all scans; empty before the end
    this.candidates = [];
    this.health = {findings: [], stretches: {}};
    this.frame = null;
    this.changed_tiles = new Set();  // since they were drawn
  }

  take_tiles(buffer) {
    for (const key of this.tiles.add(buffer)) this.changed_tiles.add(key);
  }

  take(message) {
    switch (message.op) {
      case "frame":
        this.frame = message;
        if (!this.live) break;
        for (const row of message.rows) this.history.add(row, []);
        this.history.add(message.figures, message.particles);
        break;
      case "history":
        this.history.reset(message.rows);
        break;
      case "nodes":
      case "trajectory":
        this[message.op].length = POSE_VALUES * message.from;
        for (const value of message.poses) this[message.op].push(value);
        break;
      case "candidates":
        for (const candidate of message.changed) this.candidates[candidate.position] = candidate;
        this.candidates.length = message.total;
        break;
      case "health":
        this.health = message;
        break;
    }
  }

  // Where a node is, by what is known now.
  node(index) {
    const at = POSE_VALUES * index;
    return at < this.nodes.length ? {x: this.nodes[at], y: this.nodes[at + 1], stamp_s: this.nodes[at + 3]}
                                  : null;
  }

  get path() { return this.trajectory.length > 0 ? this.trajectory : this.nodes; }

  // Number of poses up to a time (null: all); stamps ascend but for a clock that was set back.
  path_length(time_s) { return countUpTo(this.path, time_s); }
  count_nodes(time_s) { return countUpTo(this.nodes, time_s); }
}
