// SPDX-License-Identifier: BSD-3-Clause
// The theme's colors, for canvases.

const NAMES = ["unknown", "free", "occupied", "grid", "path", "trail", "scan", "robot", "accepted", "refused",
               "selected", "text", "quiet", "line", "panel", "accent"];

function rgb(color) {
  const value = parseInt(color.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

// A word of a pixel (as in ImageData) for each value of a cell: 0 free to 100 occupied, 255 unknown.
function pixelWords(free, occupied) {
  const words = new Uint32Array(256);
  const pixel = new Uint8ClampedArray(words.buffer);
  for (let value = 0; value <= 100; ++value) {
    // Full contrast where half of the beams ended.
    const part = Math.min(1, Math.max(0, value - 4) / 46);
    for (let k = 0; k < 3; ++k) {
      pixel[4 * value + k] = free[k] + (occupied[k] - free[k]) * Math.sqrt(part);
    }
    pixel[4 * value + 3] = 255;
  }
  return words;  // those of unknown cells are transparent
}

// `more`: names of colors besides those of every page.
export function readColors(more = []) {
  const style = getComputedStyle(document.documentElement);
  const colors = {};
  for (const name of [...NAMES, ...more]) colors[name] = style.getPropertyValue(`--${name}`).trim();
  colors.pixels = pixelWords(rgb(colors.free), rgb(colors.occupied));
  return colors;
}

export function onThemeChange(callback) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", callback);
}
