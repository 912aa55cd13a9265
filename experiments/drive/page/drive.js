// SPDX-License-Identifier: BSD-3-Clause
// The page to drive on: takes what the program tells, draws it, and tells what is wanted.
import {Camera} from "./camera.js";
import {onThemeChange, readColors} from "./colors.js";
import {Connection} from "./connection.js";
import {DrivePane} from "./drive_pane.js";
import {HeldKeys} from "./held_keys.js";
import {listKeys, watchKeys} from "./keyboard.js";
import {Run} from "./run.js";
import {LINE_COLORS, ScoreCharts} from "./score_charts.js";
import {meters, part, VariantPanel} from "./variant_panel.js";

const ZOOM = 1.25;
const SLIDING_MS = 1000;  // then what was chosen has come back

const DRIVING = ["drive, while held", {ArrowUp: 0, ArrowLeft: 0, ArrowDown: 0, ArrowRight: 0, w: 0, a: 0, s: 0, d: 0}];
const KEYS = [
  ["pause, go on", {" ": null}, (app) => app.toggle_pause()],
  ["save", {v: null}, (app) => app.save()],
  ["zoom in, out", {"+": ZOOM, "=": ZOOM, "-": 1 / ZOOM}, (app, factor) => app.zoom(factor)],
  ["the whole world", {0: "fit"}, (app, mode) => app.set_mode(mode)],
  ["follow the robot", {f: "follow"}, (app, mode) => app.set_mode(mode)],
  ["back from a control to driving", {Escape: null}, () => document.activeElement?.blur()],
  ["this help", {"?": null}, (app) => app.help()],
];

const element = (id) => document.getElementById(id);

class App {
  runs = new Map();  // by their numbers
  panes = [];
  run = null;
  variants = [];
  status = null;
  camera = new Camera();
  colors = readColors(LINE_COLORS);
  layers = {map: true, scan: true, particles: true, path: true, nodes: false, accepted: true, refused: false};
  time_s = null;  // the latest, always
  selection = {run: null, position: null};
  world_T_start = [0, 0, 0];
  robot_radius_m = 0.5;
  connection_state = "connecting";
  #is_drawing = false;
  #slid_at_ms = -Infinity;  // when somebody moved a slider last

  constructor() {
    this.panel = new VariantPanel(element("variants"), (choice) => this.connection.send("add", choice),
                                  (run) => this.connection.send("remove", {run}));
    this.charts = new ScoreCharts(element("charts"), element("chart_lines"));
    this.held = new HeldKeys((wish) => this.connection.send("hold", wish));
    this.#watch_controls();
    onThemeChange(() => {
      this.colors = readColors(LINE_COLORS);
      for (const pane of this.panes) pane.theme_changed();
      this.redraw();
    });
    this.connection = new Connection("gmapping_spa.drive.v1", (message) => this.#take(message), (state) => {
      this.connection_state = state;
      if (state === "open") this.connection.send("hold", this.held.wish);
      this.redraw();
    });
  }

  #watch_controls() {
    const on_click = {
      pause: () => this.toggle_pause(), save: () => this.save(), fit: () => this.set_mode("fit"),
      follow: () => this.set_mode("follow"), zoom_in: () => this.zoom(ZOOM),
      zoom_out: () => this.zoom(1 / ZOOM), help_button: () => this.help(),
    };
    for (const [id, action] of Object.entries(on_click)) {
      element(id).addEventListener("click", () => {
        action();
        this.redraw();
      });
    }
    for (const id of ["noise", "slips"]) {
      element(id).addEventListener("input", () => {
        this.#slid_at_ms = performance.now();
        this.connection.send("odometry", {noise: Number(element("noise").value), slips: Number(element("slips").value)});
        this.#tell_sliders();
      });
    }
    listKeys([DRIVING, ...KEYS], element("keys"));
    watchKeys(KEYS, this);
  }

  #take(message) {
    if (message instanceof ArrayBuffer) {
      this.runs.get(new DataView(message).getUint8(1))?.take_tiles(message);
    } else if (message.op === "hello") {
      this.#begin(message);
    } else if (message.op === "status") {
      this.status = message;
      this.#take_sliders();
    } else if (message.op === "variants") {
      this.variants = message.list;
      for (const variant of this.variants) this.charts.add(variant);
    } else if (message.op === "scores") {
      this.charts.reset(message.run, message.rows);
    } else {
      this.runs.get(message.run)?.take(message);
    }
    this.redraw();
  }

  // Also when the connection has come back, and when maps were added or removed: all comes anew.
  #begin(hello) {
    for (const pane of this.panes) pane.remove();
    this.world_T_start = hello.world_T_start;
    this.robot_radius_m = hello.robot_radius_m;
    this.runs = new Map(hello.runs.map((run) => [run.run, Object.assign(new Run(run), {number: run.run})]));
    this.truth_run = this.runs.get(0);
    this.panes = [...this.runs.values()].map((run) => new DrivePane(run, this));
    element("panes").dataset.count = this.panes.length;
    element("panes").replaceChildren(...this.panes.map((pane) => pane.element));
    this.variants = [];
    this.#slid_at_ms = -Infinity;
    this.panel.begin(hello);
    this.charts.begin();
    document.title = `${hello.world} – drive`;
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
    this.#tell_status();
    element("fit").setAttribute("aria-pressed", String(this.camera.mode === "fit"));
    element("follow").setAttribute("aria-pressed", String(this.camera.mode === "follow"));
    if (this.panes.length === 0) return;
    this.#move_camera();
    for (const pane of this.panes) {
      pane.draw();
      const variant = this.variants.find(({run}) => run === pane.run.number);
      pane.figures.textContent = variant === undefined || variant.iou === null
          ? "" : `ATE ${meters(variant.ate_m)} · IoU ${part(variant.iou)}`;
    }
    this.panel.draw(this.variants, this.runs);
    this.charts.draw(this.variants, this.colors);
  }

  #tell_status() {
    const {status} = this;
    const is_open = this.connection_state === "open" && status !== null;
    let state = this.connection_state, text = "connecting";
    if (state === "lost") {
      text = "connection lost, trying again; what was received is kept";
    } else if (is_open) {
      state = status.state;
      const what = {waiting: "waiting for arrow keys, WASD or a click", driving: "driving",
                    paused: "paused", saving: "saving: maps are being finished"}[state];
      text = `${what} · ${status.time_s.toFixed(1)} s · ${status.path_m.toFixed(1)} m`;
      if (status.blocked_by !== "") text += ` · ${status.blocked_by} is in the way`;
    }
    element("status").dataset.state = state;
    if (element("status").textContent !== text) element("status").textContent = text;
    element("pause").textContent = status?.state === "paused" ? "Go on" : "Pause";
    element("pause").disabled = element("save").disabled = !is_open || state === "saving";
    if (status === null) return;
    const note = element("note");
    if (note.textContent !== status.note) note.textContent = status.note;
    note.classList.toggle("bad", /^not saved|failed|^stopped|no way|no more/.test(status.note));
    const [x, y] = status.pose, [ox, oy] = status.odometry;
    const rows = [["Speed", `${status.velocity[0].toFixed(2)} m/s`],
                  ["Turn rate", `${status.velocity[1].toFixed(2)} rad/s`],
                  ["Error of the wheels alone", meters(Math.hypot(x - ox, y - oy))]];
    element("figures").innerHTML = rows.map(([name, value]) => `<dt>${name}</dt><dd>${value}</dd>`).join("");
  }

  #take_sliders() {
    const {noise, slips} = this.status;
    const is_sliding = performance.now() - this.#slid_at_ms < SLIDING_MS;
    for (const [id, value] of Object.entries({noise, slips})) {
      if (!is_sliding || document.activeElement !== element(id)) element(id).value = value;
    }
    this.#tell_sliders();
  }

  #tell_sliders() {
    element("noise_text").textContent = `${Number(element("noise").value).toFixed(1)} times that of good wheels`;
    element("slips_text").textContent = `${Number(element("slips").value).toFixed(2)} a meter`;
  }

  #move_camera() {
    if (this.camera.mode === "follow" && this.status !== null) [this.camera.x, this.camera.y] = this.status.pose;
    if (this.camera.mode !== "fit") return;
    const box = this.panes[0].box();  // of the truth, which all panes share
    const sizes = this.panes.map(({size}) => size);
    const size = {width: Math.min(...sizes.map(({width}) => width)), height: Math.min(...sizes.map(({height}) => height))};
    if (box !== null) this.camera.fit(box, size);
  }

  toggle_pause() { this.connection.send(this.status?.state === "paused" ? "resume" : "pause"); }
  save() { this.connection.send("save"); }
  goal(x, y) { this.connection.send("goal", {x, y}); }
  set_mode(mode) { this.camera.mode = this.camera.mode === mode ? "free" : mode; }
  help() { element("help").showModal(); }
  choose() {}

  zoom(factor) {
    const size = this.panes[0]?.size ?? {width: 0, height: 0};
    this.camera.zoom(factor, size.width / 2, size.height / 2, size);
  }
}

// For the console of the browser, and for tests.
globalThis.gmapping_spa_drive = new App();
