// SPDX-License-Identifier: BSD-3-Clause
// The list of candidates for loop closures, and what is known of the selected one.
import {isAccepted, reasonOf, sourceOf, valuesOf} from "./closures.js";

const MAX_LISTED = 200;

export class ClosurePanel {
  #shown = "";
  #detailed = "";

  // on_select(position or null)
  constructor(on_select) {
    this.on_select = on_select;
    this.counts = document.getElementById("closure_counts");
    this.details = document.getElementById("closure_details");
    this.list = document.getElementById("closure_list");
    this.list.addEventListener("click", (event) => {
      const button = event.target.closest("button");
      if (button !== null) this.on_select(Number(button.dataset.position));
    });
  }

  draw(run, position, with_refused) {
    this.#draw_list(run, position, with_refused);
    this.#draw_details(run, position);
  }

  #draw_list(run, position, with_refused) {
    const listed = run.candidates.filter((c) => c !== undefined && (with_refused || isAccepted(c)))
        .slice(-MAX_LISTED).reverse();
    // Buttons are left alone as long as nothing changes: one of them may have the focus.
    const shown = listed.map((c) => `${c.position}${c.verdict}`).join() + position;
    if (shown === this.#shown) return;
    this.#shown = shown;
    const accepted = run.candidates.filter((c) => c !== undefined && isAccepted(c)).length;
    this.counts.textContent = `${accepted} accepted, ${run.candidates.length - accepted} refused` +
        (with_refused || accepted === run.candidates.length ? "" : " (shown with the layer of refused ones)");
    const focused = document.activeElement?.dataset?.position;
    this.list.replaceChildren(...listed.map((candidate) => {
      const item = document.createElement("li"), button = document.createElement("button");
      button.type = "button";
      button.dataset.position = candidate.position;
      button.className = isAccepted(candidate) ? "accepted" : "refused";
      button.setAttribute("aria-pressed", String(candidate.position === position));
      button.textContent = `${candidate.old_node} – ${candidate.node}: ${candidate.verdict.replaceAll("_", " ")}`;
      item.append(button);
      return item;
    }));
    if (focused !== undefined) {
      this.list.querySelector(`[data-position="${focused}"]`)?.focus({preventScroll: true});
    }
  }

  #draw_details(run, position) {
    const candidate = run.candidates[position];
    const detailed = candidate === undefined ? "" : `${position}${candidate.verdict}${run.name}`;
    if (detailed === this.#detailed) return;
    this.#detailed = detailed;
    if (candidate === undefined) return this.details.replaceChildren();
    const title = document.createElement("h3"), reason = document.createElement("p");
    title.textContent = `Node ${candidate.old_node} – node ${candidate.node}`;
    reason.textContent = `${reasonOf(candidate)} Candidate because: ${sourceOf(candidate)}.`;
    reason.id = "closure_reason";
    const values = document.createElement("dl");
    values.className = "values";
    for (const [name, text] of valuesOf(candidate)) {
      const term = document.createElement("dt"), value = document.createElement("dd");
      term.textContent = name;
      value.textContent = text;
      values.append(term, value);
    }
    this.details.replaceChildren(title, reason, values);
  }
}
