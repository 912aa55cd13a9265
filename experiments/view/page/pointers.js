// SPDX-License-Identifier: BSD-3-Clause
// Mouse and fingers on a pane: one drags, two pinch, the wheel zooms, a click picks.

const CLICK_PX = 4;
const WHEEL_FACTOR = 0.0015;

export function watchPointers(canvas, pane, app) {
  const pointers = new Map();  // id -> {x, y}
  let way_px = 0;

  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  };
  const spread = () => {
    const [a, b] = pointers.values();
    return {distance: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2};
  };

  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, at(event));
    way_px = 0;
    app.choose(pane.run);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (before === undefined) return;
    const now = at(event);
    way_px += Math.hypot(now.x - before.x, now.y - before.y);
    if (pointers.size === 2) {
      const old = spread();
      pointers.set(event.pointerId, now);
      const pinch = spread();
      app.camera.pan(pinch.x - old.x, pinch.y - old.y);
      if (old.distance > 0) app.camera.zoom(pinch.distance / old.distance, pinch.x, pinch.y, pane.size);
    } else {
      pointers.set(event.pointerId, now);
      if (way_px > CLICK_PX) app.camera.pan(now.x - before.x, now.y - before.y);
    }
    app.redraw();
  });
  canvas.addEventListener("pointerup", (event) => {
    const last = pointers.get(event.pointerId);
    if (pointers.delete(event.pointerId) && pointers.size === 0 && way_px <= CLICK_PX) {
      pane.click(last.x, last.y);
    }
  });
  canvas.addEventListener("pointercancel", (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const {x, y} = at(event);
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : 1;
    app.camera.zoom(Math.exp(-event.deltaY * lines * WHEEL_FACTOR), x, y, pane.size);
    app.redraw();
  }, {passive: false});
}
