// SPDX-License-Identifier: BSD-3-Clause
// Keys that drive as long as they are held.
import {isForControl} from "./keyboard.js";

const FORWARD = {ArrowUp: 1, KeyW: 1, ArrowDown: -1, KeyS: -1};
const LEFT = {ArrowLeft: 1, KeyA: 1, ArrowRight: -1, KeyD: -1};

export class HeldKeys {
  #held = new Set();  // by their places on the keyboard

  // on_change({forward, left}), each -1, 0 or 1
  constructor(on_change) {
    this.on_change = on_change;
    addEventListener("keydown", (event) => {
      if (!(event.code in FORWARD) && !(event.code in LEFT)) return;
      if (event.ctrlKey || event.altKey || event.metaKey || isForControl(event)) return;
      event.preventDefault();
      this.#change(() => this.#held.add(event.code));
    });
    addEventListener("keyup", (event) => this.#change(() => this.#held.delete(event.code)));
    // Who looks elsewhere does not hold anything any more.
    addEventListener("blur", () => this.release());
    document.addEventListener("visibilitychange", () => this.release());
  }

  get wish() {
    const sum = (values) => [...this.#held].reduce((all, code) => all + (values[code] ?? 0), 0);
    return {forward: Math.sign(sum(FORWARD)), left: Math.sign(sum(LEFT))};
  }

  release() { this.#change(() => this.#held.clear()); }

  #change(change) {
    const before = this.wish;
    change();
    const {forward, left} = this.wish;
    if (forward !== before.forward || left !== before.left) this.on_change({forward, left});
  }
}
