// SPDX-License-Identifier: BSD-3-Clause
// The page: takes what the program tells, and draws it at most once a frame of the screen.
import {Camera} from "./camera.js";
import {Charts} from "./charts.js";
import {ClosurePanel} from "./closure_panel.js";
import {isAccepted} from "./closures.js";
import {onThemeChange, readColors} from "./colors.js";
import {Connection} from "./connection.js";
import {HealthPanel} from "./health_panel.js";
import {KEYS, listKeys, watchKeys} from "./keyboard.js";
import {Pane} from "./pane.js";
import {sceneOf} from "./past.js";
import {Run} from "./run.js";
import {drawStatus} from "./status.js";
import {Timeline} from "./timeline.js";

const element = (id) => document.getElementById(id);

class App {
  runs = [];
  panes = [];
  run = null;  // the one that the panels are about
  camera = new Camera();
  colors = readColors();
  layers = {};
  time_s = null;  // null: the latest
  selection = {run: null, position: null};
  is_paused = false;
  connection_state = "connecting";
  #is_drawing = false;

  constructor() {
    this.charts = new Charts(element("charts"), (part) => this.set_part(part));
    this.timeline = new Timeline((part) => this.set_part(part));
    this.closures = new ClosurePanel((position) => this.select(this.run, position));
    this.health = new HealthPanel();
    this.#watch_controls();
    onThemeChange(() => {
      this.colors = readColors();
      for (const pane of this.panes) pane.theme_changed();
      this.redraw();
    });
    this.connection = new Connection("gmapping_spa.view.v1", (message) => this.#take(message), (state) => {
      this.connection_state = state;
      this.redraw();
    });
  }

  #watch_controls() {
    const on_click = {
      pause: () => this.toggle_pause(), step: () => this.step(), fit: () => this.set_mode("fit"),
      follow: () => this.set_mode("follow"), zoom_in: () => this.zoom(1.25),
      zoom_out: () => this.zoom(0.8), help_button: () => this.help(),
    };
    for (const [id, action] of Object.entries(on_click)) {
      element(id).addEventListener("click", () => {
        action();
        this.redraw();
      });
    }
    for (const box of document.querySelectorAll("[data-layer]")) {
      this.layers[box.dataset.layer] = box.checked;
      box.addEventListener("change", () => {
        this.layers[box.dataset.layer] = box.checked;
        this.redraw();
      });
    }
    listKeys(KEYS, element("keys"));
    watchKeys(KEYS, this);
  }

  #take(message) {
    if (message instanceof ArrayBuffer) {
      this.runs[new DataView(message).getUint8(1)]?.take_tiles(message);
    } else if (message.op === "hello") {
      this.#begin(message.runs);
    } else if (message.op === "control") {
      this.is_paused = message.paused;
    } else {
      this.runs[message.run]?.take(message);
    }
    this.redraw();
  }

  // Also when the connection has come back, perhaps to another run: all comes anew.
  #begin(runs) {
    for (const pane of this.panes) pane.remove();
    this.runs = runs.map((run) => new Run(run));
    this.panes = this.runs.map((run) => new Pane(run, this));
    element("panes").replaceChildren(...this.panes.map((pane) => pane.element));
    this.run = this.runs[0];
    this.time_s = null;
    this.selection = {run: null, position: null};
    const choice = element("run_choice");
    choice.hidden = this.runs.length < 2;
    choice.replaceChildren(...this.runs.map((run) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = button.title = run.name;
      button.addEventListener("click", () => this.choose(run));
      return button;
    }));
    const is_live = this.runs.some((run) => run.live);
    element("pause").hidden = element("step").hidden = !is_live;
    document.title = `${runs.map((run) => run.name).join(", ")} – gmapping_spa`;
  }

  redraw() {
    if (this.#is_drawing) return;
    this.#is_drawing = true;
    requestAnimationFrame(() => {
      this.#is_drawing = false;
      this.#draw();
    });
  }

  #draw() {
    drawStatus(element("status"), this);
    const is_steerable = this.connection_state === "open" && this.run?.frame?.phase === "running";
    element("pause").textContent = this.is_paused ? "Go on" : "Pause";
    element("pause").disabled = element("step").disabled = !is_steerable;
    element("fit").setAttribute("aria-pressed", String(this.camera.mode === "fit"));
    element("follow").setAttribute("aria-pressed", String(this.camera.mode === "follow"));
    if (this.run === null) return;
    const scene = sceneOf(this.run, this.time_s);
    this.#move_camera(scene);
    for (const pane of this.panes) pane.draw();
    this.charts.draw(this.run, this.time_s, this.colors);
    const position = this.selection.run === this.run ? this.selection.position : null;
    this.closures.draw(this.run, position, this.layers.refused);
    this.health.draw(this.run);
    this.timeline.draw(this.run, this.time_s, scene);
    [...element("run_choice").children].forEach((button, i) => {
      button.setAttribute("aria-pressed", String(this.runs[i] === this.run));
    });
  }

  #move_camera(scene) {
    if (this.camera.mode === "follow" && scene?.pose.length === 3) [this.camera.x, this.camera.y] = scene.pose;
    if (this.camera.mode !== "fit") return;
    const boxes = this.panes.map((pane) => pane.box()).filter((box) => box !== null);
    if (boxes.length === 0) return;
    const box = {};
    for (const key of ["min_x", "min_y"]) box[key] = Math.min(...boxes.map((b) => b[key]));
    for (const key of ["max_x", "max_y"]) box[key] = Math.max(...boxes.map((b) => b[key]));
    this.camera.fit(box, this.panes[0].size);
  }

  toggle_pause() { this.connection.send(this.is_paused ? "resume" : "pause"); }
  step() { this.connection.send("step"); }
  set_mode(mode) { this.camera.mode = this.camera.mode === mode ? "free" : mode; }
  help() { element("help").showModal(); }

  zoom(factor) {
    const {size} = this.panes[this.runs.indexOf(this.run)] ?? {size: {width: 0, height: 0}};
    this.camera.zoom(factor, size.width / 2, size.height / 2, size);
  }

  toggle_layer(name) {
    const box = document.querySelector(`[data-layer="${name}"]`);
    box.checked = this.layers[name] = !box.checked;
  }

  choose(run) {
    this.run = run;
    this.redraw();
  }

  choose_next() { this.run = this.runs[(this.runs.indexOf(this.run) + 1) % this.runs.length] ?? null; }

  select(run, position) {
    this.run = run;
    this.selection = {run, position};
    this.redraw();
  }

  // Among those that are listed, in the order of the list for step -1.
  select_next(step) {
    const listed = (this.run?.candidates ?? []).filter((c) => c !== undefined && (this.layers.refused || isAccepted(c)));
    if (listed.length === 0) return;
    const at = listed.findIndex((c) => c.position === this.selection.position);
    const next = at < 0 ? listed.length - 1 : (at + step + listed.length) % listed.length;
    this.select(this.run, listed[next].position);
  }

  set_time(time_s) {
    this.time_s = time_s;
    this.redraw();
  }

  // A part of the time from the first figures to the last ones; null: the latest.
  set_part(part) {
    const {first_s, last_s} = this.run?.history ?? {first_s: 0, last_s: 0};
    this.set_time(part === null || part >= 1 ? null : first_s + Math.max(part, 0) * (last_s - first_s));
  }

  move_time(part) {
    if (this.run === null) return;
    const {first_s, last_s} = this.run.history;
    const now = this.time_s === null ? 1 : (this.time_s - first_s) / Math.max(last_s - first_s, 1e-9);
    this.set_part(now + part);
  }
}

// For the console of the browser, and for tests.
globalThis.gmapping_spa_view = new App();
