// SPDX-License-Identifier: BSD-3-Clause
// Figures over time, in bounded memory. Rows are arrays as they come: see COLUMN.

export const COLUMN = {
  stamp_s: 0, scans: 1, updates: 2, x: 3, y: 4, theta: 5, n_eff: 6, cost: 7, scans_per_s: 8,
  accepted: 9, refused: 10,
};

const MAX_ROWS = 4096;
const MAX_PARTICLES = 64;

export class History {
  rows = [];

  reset(rows) {
    this.rows = rows.map((values) => ({values, particles: null}));
  }

  // When it is full, every second row goes.
  add(values, particles) {
    const last = this.rows.at(-1);
    if (last !== undefined && values[COLUMN.stamp_s] < last.values[COLUMN.stamp_s]) return;
    if (last !== undefined && values[COLUMN.stamp_s] === last.values[COLUMN.stamp_s]) this.rows.pop();
    const kept = new Float32Array(3 * Math.min(particles.length, MAX_PARTICLES));
    for (let i = 0; 3 * i < kept.length; ++i) kept.set(particles[i].pose, 3 * i);
    this.rows.push({values, particles: kept});
    if (this.rows.length > MAX_ROWS) this.rows = this.rows.filter((_, i) => i % 2 === 0);
  }

  get first_s() { return this.rows.length > 0 ? this.rows[0].values[COLUMN.stamp_s] : 0; }
  get last_s() { return this.rows.length > 0 ? this.rows.at(-1).values[COLUMN.stamp_s] : 0; }

  // The last row up to a time, or the first one.
  at(time_s) {
    let low = 0, high = this.rows.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.rows[middle].values[COLUMN.stamp_s] <= time_s) low = middle + 1;
      else high = middle;
    }
    return this.rows[Math.max(low - 1, 0)];
  }
}
