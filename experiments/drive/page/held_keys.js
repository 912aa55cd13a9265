// SPDX-License-Identifier: BSD-3-Clause
// Keys that drive as long as they are held.
import {isForControl} from "./keyboard.js";

const FORWARD = {ArrowUp: 1, KeyW: 1, ArrowDown: -1, KeyS: -1};
const LEFT = {ArrowLeft: 1, KeyA: 1, ArrowRight: -1, KeyD: -1};

// The program lets go of keys that it hears nothing of for a second.
const REPEAT_MS = 250;

export class HeldKeys {
  #held = new Set();  // by their places on the keyboard
  #timer = null;

  // on_wish({forward, left}), each -1, 0 or 1: when they change, and again and again while keys are held
  constructor(on_wish) {
    this.on_wish = on_wish;
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
    if (forward === before.forward && left === before.left) return;
    this.on_wish({forward, left});
    clearInterval(this.#timer);
    if (forward !== 0 || left !== 0) this.#timer = setInterval(() => this.on_wish(this.wish), REPEAT_MS);
  }
}
