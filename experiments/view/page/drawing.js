// SPDX-License-Identifier: BSD-3-Clause
// What lies over the map: grid, graph, paths, particles, scan, robot.
import {POSE_VALUES} from "./run.js";

// pen: {context, camera, size, colors}

export function drawGrid({context, camera, size, colors}) {
  const step_m = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].find((step) => step * camera.scale > 36) ?? 5000;
  const [left, top] = camera.to_world(0, 0, size);
  const [right, bottom] = camera.to_world(size.width, size.height, size);
  context.beginPath();
  for (let x = Math.ceil(left / step_m) * step_m; x <= right; x += step_m) {
    const px = Math.round(camera.to_screen(x, 0, size)[0]) + 0.5;
    context.moveTo(px, 0);
    context.lineTo(px, size.height);
  }
  for (let y = Math.ceil(bottom / step_m) * step_m; y <= top; y += step_m) {
    const py = Math.round(camera.to_screen(0, y, size)[1]) + 0.5;
    context.moveTo(0, py);
    context.lineTo(size.width, py);
  }
  context.strokeStyle = colors.grid;
  context.lineWidth = 1;
  context.stroke();
  return step_m;
}

export function drawScale({context, camera, size, colors}, step_m) {
  const length = step_m * camera.scale, x = size.width - length - 16, y = size.height - 14;
  const text = `${step_m} m`;
  context.font = "12px system-ui, sans-serif";
  const box = Math.max(length, context.measureText(text).width);
  context.fillStyle = colors.panel;
  context.globalAlpha = 0.8;
  context.fillRect(size.width - box - 22, y - 20, box + 12, 28);
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = colors.text;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x, y);
  context.lineTo(x + length, y);
  context.lineTo(x + length, y - 4);
  context.stroke();
  context.textAlign = "right";
  context.fillText(text, size.width - 16, y - 6);
  context.textAlign = "left";
}

// The first `count` poses of values with POSE_VALUES a pose.
export function drawPath({context, camera, size}, poses, count, color, width) {
  context.beginPath();
  for (let i = 0; i < count; ++i) {
    context.lineTo(...camera.to_screen(poses[POSE_VALUES * i], poses[POSE_VALUES * i + 1], size));
  }
  context.strokeStyle = color;
  context.lineWidth = width;
  context.lineJoin = "round";
  context.stroke();
}

export function drawNodes({context, camera, size}, poses, count, color) {
  context.fillStyle = color;
  for (let i = 0; i < count; ++i) {
    const [x, y] = camera.to_screen(poses[POSE_VALUES * i], poses[POSE_VALUES * i + 1], size);
    context.fillRect(x - 2, y - 2, 4, 4);
  }
}

export function drawClosures({context, camera, size}, lines, color, width, dash) {
  context.beginPath();
  for (const {from, to} of lines) {
    context.moveTo(...camera.to_screen(from.x, from.y, size));
    context.lineTo(...camera.to_screen(to.x, to.y, size));
  }
  context.strokeStyle = color;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
}

// Around both ends of closures, which may be short.
export function drawEnds({context, camera, size}, lines, color) {
  context.beginPath();
  for (const {from, to} of lines) {
    for (const end of [from, to]) {
      const [x, y] = camera.to_screen(end.x, end.y, size);
      context.moveTo(x + 9, y);
      context.arc(x, y, 9, 0, 2 * Math.PI);
    }
  }
  context.strokeStyle = color;
  context.lineWidth = 3;
  context.stroke();
}

// tail: x, y in turn, the latest one first
export function drawTail({context, camera, size, colors}, pose, tail) {
  context.beginPath();
  context.moveTo(...camera.to_screen(pose[0], pose[1], size));
  for (let i = 0; i < tail.length; i += 2) {
    context.lineTo(...camera.to_screen(tail[i], tail[i + 1], size));
  }
  context.strokeStyle = colors.trail;
  context.globalAlpha = 0.6;
  context.lineWidth = 1.5;
  context.stroke();
  context.globalAlpha = 1;
}

export function drawScan({context, camera, size, colors}, points) {
  const side = Math.max(2, 0.05 * camera.scale);
  context.fillStyle = colors.scan;
  for (let i = 0; i < points.length; i += 2) {
    const [x, y] = camera.to_screen(points[i], points[i + 1], size);
    context.fillRect(x - side / 2, y - side / 2, side, side);
  }
}

// An arrow head that points where the robot looks.
export function drawPose({context, camera, size}, [x, y, theta], color, radius_px, alpha = 1) {
  const [px, py] = camera.to_screen(x, y, size);
  context.save();
  context.translate(px, py);
  context.rotate(-theta);
  context.beginPath();
  context.moveTo(radius_px, 0);
  context.lineTo(-0.8 * radius_px, 0.7 * radius_px);
  context.lineTo(-0.4 * radius_px, 0);
  context.lineTo(-0.8 * radius_px, -0.7 * radius_px);
  context.closePath();
  context.globalAlpha = alpha;
  context.fillStyle = color;
  context.fill();
  context.restore();
}
