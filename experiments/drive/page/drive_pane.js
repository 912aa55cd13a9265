// SPDX-License-Identifier: BSD-3-Clause
// The truth, or a map of SLAM as it lies in the world: its origin is where the robot started.
import {drawPath, drawPose} from "./drawing.js";
import {Pane} from "./pane.js";
import {POSE_VALUES} from "./run.js";

const RAYS = 120;

// Where a pose in the frame of `of` is in the world.
export function compose([x, y, theta], [px, py]) {
  const cos = Math.cos(theta), sin = Math.sin(theta);
  return [x + cos * px - sin * py, y + sin * px + cos * py];
}

export class DrivePane extends Pane {
  // app as that of Pane, and {status, world_T_start, robot_radius_m, truth_run, goal(x, y)}
  constructor(run, app) {
    super(run, app);
    this.is_truth = run.number === 0;
    this.figures = document.createElement("span");
    this.figures.className = "figures";
    this.caption.append(this.figures);
  }

  // A canvas as large as the diagonal about the same middle, turned: whatever is drawn in a part of it.
  in_map(pen, draw) {
    const {context, camera, size, colors} = pen;
    if (this.is_truth) return draw({...pen, colors: {...colors, robot: colors.accepted, path: colors.accepted}});
    const [start_x, start_y, theta] = this.app.world_T_start;
    const cos = Math.cos(theta), sin = Math.sin(theta);
    const dx = camera.x - start_x, dy = camera.y - start_y;
    const map_camera = Object.assign(Object.create(Object.getPrototypeOf(camera)), camera,
                                     {x: cos * dx + sin * dy, y: -sin * dx + cos * dy});
    const side = Math.ceil(Math.hypot(size.width, size.height));
    context.save();
    context.translate(size.width / 2, size.height / 2);
    context.rotate(-theta);
    context.translate(-side / 2, -side / 2);
    draw({...pen, camera: map_camera, size: {width: side, height: side}});
    context.restore();
  }

  box() {
    const box = super.box();
    if (this.is_truth || box === null) return box;
    const corners = [[box.min_x, box.min_y], [box.max_x, box.min_y], [box.max_x, box.max_y], [box.min_x, box.max_y]]
        .map((corner) => compose(this.app.world_T_start, corner));
    const xs = corners.map(([x]) => x), ys = corners.map(([, y]) => y);
    return {min_x: Math.min(...xs), min_y: Math.min(...ys), max_x: Math.max(...xs), max_y: Math.max(...ys)};
  }

  draw_over(pen, scene) {
    const {status, truth_run, colors} = this.app;
    if (status === null) return;
    if (!this.is_truth) drawPath(pen, truth_run.path, truth_run.path.length / POSE_VALUES, colors.accepted, 1);
    if (!this.is_truth) return this.#draw_outline(pen);  // over it, the map's robot can be seen
    this.#draw_rays(pen, scene);
    for (const walker of status.walkers) this.#draw_walker(pen, walker);
    this.#draw_way(pen);
    drawPose(pen, status.odometry, colors.selected, 8, 0.9);
    this.#draw_robot(pen);
  }

  #draw_rays({context, camera, size, colors}, scene) {
    if (scene === null) return;
    const from = camera.to_screen(...scene.pose, size);
    const step = 2 * Math.max(1, Math.floor(scene.scan.length / 2 / RAYS));
    context.beginPath();
    for (let i = 0; i < scene.scan.length; i += step) {
      context.moveTo(from[0], from[1]);
      context.lineTo(...camera.to_screen(scene.scan[i], scene.scan[i + 1], size));
    }
    context.strokeStyle = colors.scan;
    context.globalAlpha = 0.2;
    context.lineWidth = 1;
    context.stroke();
    context.globalAlpha = 1;
  }

  #draw_walker({context, camera, size, colors}, {pose, half_size}) {
    const [px, py] = camera.to_screen(pose[0], pose[1], size);
    const width = Math.max(2 * half_size[0] * camera.scale, 4), height = Math.max(2 * half_size[1] * camera.scale, 4);
    context.save();
    context.translate(px, py);
    context.rotate(-pose[2]);
    context.fillStyle = colors.refused;
    context.fillRect(-width / 2, -height / 2, width, height);
    context.restore();
  }

  #draw_way({context, camera, size, colors}) {
    const {way} = this.app.status;
    if (way.length === 0) return;
    context.beginPath();
    for (let i = 0; i < way.length; i += 2) context.lineTo(...camera.to_screen(way[i], way[i + 1], size));
    context.strokeStyle = colors.accent;
    context.lineWidth = 2;
    context.setLineDash([6, 5]);
    context.stroke();
    context.setLineDash([]);
    const [x, y] = camera.to_screen(...way.slice(-2), size);
    context.beginPath();
    context.arc(x, y, 6, 0, 2 * Math.PI);
    context.stroke();
  }

  #draw_outline({context, camera, size, colors}) {
    const {status, robot_radius_m} = this.app;
    const [x, y] = camera.to_screen(status.pose[0], status.pose[1], size);
    context.beginPath();
    context.arc(x, y, Math.max(robot_radius_m * camera.scale, 7), 0, 2 * Math.PI);
    context.strokeStyle = status.blocked_by === "" ? colors.accepted : colors.refused;
    context.lineWidth = 2;
    context.stroke();
  }

  #draw_robot(pen) {
    this.#draw_outline(pen);
    drawPose(pen, this.app.status.pose, this.app.colors.accepted, 9);
  }

  click(px, py) {
    this.app.goal(...this.app.camera.to_world(px, py, this.size));
  }
}
