// SPDX-License-Identifier: BSD-3-Clause
// From the world (m, y up) to the pixels of a pane (y down); panes share one.

const MIN_SCALE = 0.2, MAX_SCALE = 2000;  // pixels a meter

export class Camera {
  x = 0;
  y = 0;
  scale = 20;
  mode = "fit";  // "fit" the whole map, "follow" the robot, or "free"

  to_screen(x, y, size) {
    return [size.width / 2 + (x - this.x) * this.scale, size.height / 2 - (y - this.y) * this.scale];
  }

  to_world(px, py, size) {
    return [this.x + (px - size.width / 2) / this.scale, this.y - (py - size.height / 2) / this.scale];
  }

  pan(dx_px, dy_px) {
    this.mode = "free";
    this.x -= dx_px / this.scale;
    this.y += dy_px / this.scale;
  }

  // What is at the pixel stays there.
  zoom(factor, px, py, size) {
    if (this.mode === "fit") this.mode = "free";
    const [x, y] = this.to_world(px, py, size);
    this.scale = Math.min(Math.max(this.scale * factor, MIN_SCALE), MAX_SCALE);
    if (this.mode === "follow") return;
    this.x = x - (px - size.width / 2) / this.scale;
    this.y = y + (py - size.height / 2) / this.scale;
  }

  // box: {min_x, min_y, max_x, max_y} in m
  fit(box, size) {
    const margin = 24;
    this.x = (box.min_x + box.max_x) / 2;
    this.y = (box.min_y + box.max_y) / 2;
    const scale = Math.min((size.width - 2 * margin) / Math.max(box.max_x - box.min_x, 1),
                           (size.height - 2 * margin) / Math.max(box.max_y - box.min_y, 1));
    this.scale = Math.min(Math.max(scale, MIN_SCALE), MAX_SCALE);
  }
}
