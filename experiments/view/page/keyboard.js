// SPDX-License-Identifier: BSD-3-Clause
// Everything by keys. What a control does with a key by itself goes first.

const PAN_PX = 60;
const ZOOM = 1.25;

// [what help says, keys, action]
export const KEYS = [
  ["pan", {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}, (app, [dx, dy]) => {
    app.camera.pan(dx * PAN_PX, dy * PAN_PX);
  }],
  ["zoom in, out", {"+": ZOOM, "=": ZOOM, "-": 1 / ZOOM}, (app, factor) => app.zoom(factor)],
  ["the whole map", {0: "fit"}, (app, mode) => app.set_mode(mode)],
  ["follow the robot", {f: "follow"}, (app, mode) => app.set_mode(mode)],
  ["pause, go on", {" ": null}, (app) => app.toggle_pause()],
  ["one scan", {".": null}, (app) => app.step()],
  ["earlier, later", {"[": -0.02, "]": 0.02}, (app, part) => app.move_time(part)],
  ["latest time", {l: null}, (app) => app.set_time(null)],
  ["next, previous closure", {c: -1, C: 1}, (app, step) => app.select_next(step)],
  ["refused closures", {r: null}, (app) => app.toggle_layer("refused")],
  ["the other run", {o: null}, (app) => app.choose_next()],
  ["this help", {"?": null}, (app) => app.help()],
];

const NAMES = {ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓", " ": "space"};

export function isForControl(event) {
  const {target, key} = event;
  if (!(target instanceof Element)) return false;
  if (target.closest("dialog[open]") !== null) return true;
  if (target.matches("select")) return key !== "Escape" && key !== "?";
  if (target.matches("button, summary, input[type=checkbox]")) return key === " " || key === "Enter";
  return target.matches("input[type=range]") && (key.startsWith("Arrow") || key === " ");
}

export function watchKeys(list, app) {
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || isForControl(event)) return;
    for (const [, keys, action] of list) {
      if (!Object.hasOwn(keys, event.key)) continue;
      event.preventDefault();
      action(app, keys[event.key]);
      app.redraw();
    }
  });
}

export function listKeys(list, parent) {
  for (const [what, keys] of list) {
    const term = document.createElement("dt"), text = document.createElement("dd");
    term.textContent = Object.keys(keys).filter((key) => key !== "=")
        .map((key) => NAMES[key] ?? key).join(" ");
    text.textContent = what;
    parent.append(term, text);
  }
}
