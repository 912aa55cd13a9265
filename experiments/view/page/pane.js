// SPDX-License-Identifier: BSD-3-Clause
// The map of one run, drawn when something has changed.
import {isAccepted, linesOf, nearest} from "./closures.js";
import {drawClosures, drawEnds, drawGrid, drawNodes, drawPath, drawPose, drawScale, drawScan, drawTail} from "./drawing.js";
import {MapLayer} from "./map_layer.js";
import {sceneOf} from "./past.js";
import {watchPointers} from "./pointers.js";
import {UNKNOWN_TILE} from "./tile_store.js";

const CLICK_REACH_PX = 8;

export class Pane {
  #map = new MapLayer();
  #drawn_time_s = null;
  #needs_all_tiles = true;

  // app: {camera, layers, time_s, colors, selection, redraw(), select(run, candidate)}
  constructor(run, app) {
    this.run = run;
    this.app = app;
    this.element = document.createElement("div");
    this.element.className = "pane";
    this.canvas = document.createElement("canvas");
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.caption = document.createElement("p");
    this.caption.className = "caption";
    this.badge = document.createElement("span");
    this.badge.className = "badge";
    const name = document.createElement("span");
    name.className = "name";
    name.textContent = run.name;
    this.caption.append(name, this.badge);
    this.element.append(this.canvas, this.caption);
    this.context = this.canvas.getContext("2d");
    this.size = {width: 1, height: 1};
    this.resizing = new ResizeObserver(() => this.#resize());
    this.resizing.observe(this.element);
    watchPointers(this.canvas, this, app);
  }

  remove() {
    this.resizing.disconnect();
    this.element.remove();
  }

  #resize() {
    const ratio = devicePixelRatio;
    this.size = {width: this.element.clientWidth, height: this.element.clientHeight};
    this.canvas.width = Math.round(this.size.width * ratio);
    this.canvas.height = Math.round(this.size.height * ratio);
    this.app.redraw();
  }

  theme_changed() { this.#needs_all_tiles = true; }

  box() { return MapLayer.box(this.run.tiles.latest, this.run.resolution_m); }

  #update_map(scene) {
    const {pixels} = this.app.colors;
    const shown_s = scene.tiles === null ? null : scene.shown_s;
    if (this.#needs_all_tiles || shown_s !== this.#drawn_time_s) {
      this.#map.clear();
      for (const [key, cells] of scene.tiles ?? this.run.tiles.latest) {
        this.#map.draw_tile(key, cells, pixels);
      }
      this.#needs_all_tiles = false;
      this.#drawn_time_s = shown_s;
    } else if (shown_s === null) {
      for (const key of this.run.changed_tiles) {
        this.#map.draw_tile(key, this.run.tiles.latest.get(key) ?? UNKNOWN_TILE, pixels);
      }
    }
    this.run.changed_tiles.clear();
  }

  draw() {
    const {camera, colors, layers, time_s} = this.app;
    const {context, size} = this;
    const ratio = devicePixelRatio;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = colors.unknown;
    context.fillRect(0, 0, size.width, size.height);
    const scene = sceneOf(this.run, time_s);
    const pen = {context, camera, size, colors};
    if (scene !== null && layers.map) {
      this.#update_map(scene);
      context.globalAlpha = scene.is_map_of_that_time ? 1 : 0.35;
      this.in_map(pen, (map_pen) => {
        this.#map.paint(context, map_pen.camera, map_pen.size, this.run.resolution_m);
      });
      context.globalAlpha = 1;
    }
    const step_m = drawGrid(pen);
    if (scene !== null) this.in_map(pen, (map_pen) => this.#draw_scene(map_pen, scene));
    this.draw_over(pen, scene);
    drawScale(pen, step_m);
    this.#tell(scene);
  }

  // For panes that show more: calls draw with a pen in the frame of the map, and draws over all.
  in_map(pen, draw) { draw(pen); }
  draw_over() {}

  #draw_scene(pen, scene) {
    const {time_s, selection} = this.app;
    const {colors} = pen;
    // What the robot sees lies anywhere to the graph of an old map in which it is not found yet.
    const is_placed = scene.is_past || this.run.frame.placed;
    const layers = is_placed ? this.app.layers : {...this.app.layers, path: false, nodes: false, accepted: false, refused: false};
    if (layers.refused) {
      drawClosures(pen, linesOf(this.run, time_s, (c) => !isAccepted(c)), colors.refused, 1, [5, 4]);
    }
    if (layers.path) drawPath(pen, this.run.path, scene.path_length, colors.path, 2);
    if (layers.nodes) {
      drawNodes(pen, this.run.nodes, this.run.count_nodes(scene.shown_s), colors.path);
    }
    if (layers.accepted) {
      drawClosures(pen, linesOf(this.run, time_s, isAccepted), colors.accepted, 2, []);
    }
    if (is_placed && selection.run === this.run) {
      const selected = linesOf(this.run, null, (c) => c.position === selection.position);
      drawClosures(pen, selected, colors.selected, 4, []);
      drawEnds(pen, selected, colors.selected);
    }
    if (layers.scan) drawScan(pen, scene.scan);
    if (layers.particles) {
      for (const {pose, tail} of scene.particles) drawTail(pen, pose, tail);
      for (const {pose} of scene.particles) drawPose(pen, pose, colors.trail, 7, 0.8);
    }
    if (scene.pose.length === 3) drawPose(pen, scene.pose, colors.robot, 11);
  }

  #tell(scene) {
    const frame = this.run.frame;
    const doubt = scene === null || scene.is_past ? "" : frame.lost ? "lost" : frame.ambiguous ? "ambiguous" : "";
    const is_searched = scene !== null && !scene.is_past && !frame.placed;
    const words = is_searched ? "not found in the old map yet" : doubt;
    this.badge.className = `badge ${is_searched ? "lost" : doubt}`;
    this.badge.textContent = words;
    this.element.classList.toggle("chosen", this.app.panes.length > 1 && this.app.run === this.run);
    const where = scene === null || scene.pose.length < 3
        ? "nothing yet" : `robot at ${scene.pose[0].toFixed(1)}, ${scene.pose[1].toFixed(1)} m`;
    this.canvas.setAttribute("aria-label", `Map of ${this.run.name}: ${where}. ${words}`);
  }

  // Those that are drawn.
  click(px, py) {
    const {camera, layers, time_s} = this.app;
    const [x, y] = camera.to_world(px, py, this.size);
    const lines = linesOf(this.run, time_s, (c) => isAccepted(c) ? layers.accepted : layers.refused);
    this.app.select(this.run, nearest(lines, x, y, CLICK_REACH_PX / camera.scale)?.position ?? null);
  }
}
