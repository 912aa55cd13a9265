// SPDX-License-Identifier: BSD-3-Clause
// What the run noticed that its user should know.

const STRETCHES = {
  lost: "scans fit nothing before: where the robot was is a guess",
  ambiguous: "several motions fit the scans",
};

function item(kind, text, bad) {
  const element = document.createElement("li"), name = document.createElement("span");
  name.className = "kind";
  name.textContent = kind.replaceAll("_", " ");
  if (bad) name.classList.add("badge", "lost");
  element.append(name, `: ${text}`);
  return element;
}

const times = (first_s, last_s) => first_s === null ? "" :
    first_s === last_s ? ` (at ${first_s.toFixed(1)} s)` : ` (${first_s.toFixed(1)} to ${last_s.toFixed(1)} s)`;

export class HealthPanel {
  #shown = null;

  constructor() { this.element = document.getElementById("health"); }

  draw(run) {
    if (run.health === this.#shown) return;
    this.#shown = run.health;
    const items = [];
    for (const [kind, stretches] of Object.entries(run.health.stretches)) {
      if (stretches.length === 0) continue;
      const last = stretches.at(-1);
      items.push(item(kind, `${STRETCHES[kind] ?? ""}; ${stretches.length} stretches, the last one` +
                      times(last[0], last[1]), kind === "lost"));
    }
    for (const {kind, message, count, first_s, last_s} of run.health.findings) {
      items.push(item(kind, `${message}${count > 1 ? `, ${count} times` : ""}${times(first_s, last_s)}`, false));
    }
    if (items.length === 0) {
      this.element.replaceChildren("Nothing to report.");
      return;
    }
    const list = document.createElement("ul");
    list.append(...items);
    this.element.replaceChildren(list);
  }
}
