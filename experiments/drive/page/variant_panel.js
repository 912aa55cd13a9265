// SPDX-License-Identifier: BSD-3-Clause
// The maps that are compared, with their figures, and what may be added.
import {COLUMN} from "./history.js";

const PARTICLES = [1, 2, 5, 10, 20, 30, 50, 100];

export const meters = (value) => value === null || value === undefined ? "–"
    : value < 1 ? `${(100 * value).toFixed(1)} cm` : `${value.toFixed(2)} m`;
export const part = (value) => value === null || value === undefined ? "–" : value.toFixed(3);

function fill(select, values, chosen) {
  if (select.dataset.values === String(values)) return;
  select.dataset.values = String(values);
  select.replaceChildren(...values.map((value) => new Option(value, value, false, value === chosen)));
}

function put(list, name, text) {
  const term = document.createElement("dt"), value = document.createElement("dd");
  term.textContent = name;
  value.textContent = text;
  list.append(term, value);
}

export class VariantPanel {
  #boxes = new Map();  // run -> {box, values, state}

  // on_add({backend, particles, correction}), on_remove(run)
  constructor(parent, on_add, on_remove) {
    this.parent = parent;
    this.on_remove = on_remove;
    const [backend, particles, correction] = ["backend", "particles", "correction"].map((id) => document.getElementById(id));
    Object.assign(this, {backend, particles, correction, button: document.getElementById("add_button")});
    document.getElementById("add").addEventListener("submit", (event) => {
      event.preventDefault();
      on_add({backend: backend.value, particles: Number(particles.value), correction: correction.value});
    });
  }

  begin({backends, corrections, max_variants, max_particles}) {
    this.max_variants = max_variants;
    fill(this.backend, backends, backends.includes("none") ? "none" : backends[0]);
    fill(this.particles, PARTICLES.filter((count) => count <= max_particles), 30);
    fill(this.correction, corrections, "trajectory");
    this.#boxes.clear();
    this.parent.replaceChildren();
  }

  #box({run, name}) {
    const known = this.#boxes.get(run);
    if (known !== undefined) return known;
    const box = document.createElement("div"), title = document.createElement("h3");
    const remove = document.createElement("button"), state = document.createElement("div");
    const values = document.createElement("dl");
    box.className = "variant";
    values.className = "values";
    state.className = "state";
    remove.type = "button";
    remove.textContent = "✕";
    remove.title = remove.ariaLabel = `Remove ${name}`;
    remove.addEventListener("click", () => this.on_remove(run));
    title.append(name, remove);
    box.append(title, state, values);
    this.parent.append(box);
    const made = {box, values, state};
    this.#boxes.set(run, made);
    return made;
  }

  // runs: number -> Run
  draw(list, runs) {
    for (const variant of list) {
      const {values, state} = this.#box(variant);
      const figures = runs.get(variant.run)?.frame?.figures;
      const n_eff = figures?.[COLUMN.n_eff];
      const scans = figures?.[COLUMN.scans] ?? 0;
      state.textContent = `${variant.state} · ${scans} scans`;
      values.replaceChildren();
      put(values, "Error of the trajectory (ATE)", meters(variant.ate_m));
      put(values, "Map against truth (IoU)", part(variant.iou));
      put(values, "Effective particles (N_eff)", n_eff === null || n_eff === undefined ? "–" : n_eff.toFixed(1));
      put(values, "Loop closures", figures?.[COLUMN.accepted] ?? "–");
    }
    this.button.disabled = list.length >= this.max_variants;
  }
}
