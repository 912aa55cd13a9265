// SPDX-License-Identifier: BSD-3-Clause
// Candidates for loop closures: where they are, and why they were accepted or refused.

const REASONS = {
  accepted: "Accepted: it fits, it is unique, and enough other closures agree with it.",
  no_match: "Refused: no pose in the search window fits the old map.",
  ambiguous: "Refused: another pose fits nearly as well.",
  unstable: "Refused: fine alignment leaves the peak that the search found.",
  overlap: "Refused: the two places saw too little in common.",
  inlier_ratio: "Refused: what both saw does not look the same.",
  seen_through: "Refused: one saw through what stands in the way for the other.",
  mahalanobis: "Refused: farther off than the graph's uncertainty allows.",
  rival: "Refused: the map repeats itself by about as much as the estimate would be moved.",
  unconfirmed: "Not accepted: not enough other closures agree (yet).",
  rejected: "Refused by hand.",
  released: "Taken back: it was accepted, and the optimized graph contradicts it.",
};

const SOURCES = {
  near: "near by the estimate", place: "the place looks alike",
  hand: "added by hand",
  followed: "near if a closure found on the way is right",
};

const VALUES = [
  ["distance_m", "distance as estimated then", "m"], ["path_length_m", "way between them", "m"],
  ["score", "score of the match", ""], ["runner_up_score", "score of the best elsewhere", ""],
  ["overlap", "overlap", ""], ["inlier_ratio", "explained by the old map", ""],
  ["mutual_inlier_ratio", "explained the other way", ""],
  ["mahalanobis_sq", "squared Mahalanobis distance", ""],
];

export const isAccepted = (candidate) => candidate.verdict === "accepted";
export const reasonOf = (candidate) => REASONS[candidate.verdict] ?? candidate.verdict;
export const sourceOf = (candidate) => SOURCES[candidate.source] ?? candidate.source;

// Pairs of a name and a text. Tests that an earlier one made superfluous have left a zero.
export function valuesOf(candidate) {
  return VALUES.filter(([key]) => candidate[key])
      .map(([key, name, unit]) => [name, `${candidate[key]} ${unit}`.trim()]);
}

// {candidate, from, to} of those whose nodes are known and are not after time_s (null: all).
export function linesOf(run, time_s, wanted) {
  const lines = [];
  for (const candidate of run.candidates) {
    if (candidate === undefined || !wanted(candidate)) continue;
    const from = run.node(candidate.old_node), to = run.node(candidate.node);
    if (from === null || to === null || (time_s !== null && to.stamp_s > time_s)) continue;
    lines.push({candidate, from, to});
  }
  return lines;
}

// The one whose line is the nearest to a point in m, within reach_m; null where there is none.
export function nearest(lines, x, y, reach_m) {
  let best = null, best_m = reach_m;
  for (const line of lines) {
    const dx = line.to.x - line.from.x, dy = line.to.y - line.from.y;
    const square = dx * dx + dy * dy;
    const part = square > 0 ? ((x - line.from.x) * dx + (y - line.from.y) * dy) / square : 0;
    const on_line = Math.min(1, Math.max(0, part));
    const distance_m = Math.hypot(x - line.from.x - on_line * dx, y - line.from.y - on_line * dy);
    if (distance_m <= best_m) {
      best = line.candidate;
      best_m = distance_m;
    }
  }
  return best;
}
