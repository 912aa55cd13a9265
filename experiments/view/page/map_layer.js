// SPDX-License-Identifier: BSD-3-Clause
// The map as canvases of 8 x 8 tiles each, of which only those that changed are drawn anew.
import {keyOf, TILE, xOf, yOf} from "./tile_store.js";

const BLOCK = 8;  // tiles
const PIXELS = BLOCK * TILE;

export class MapLayer {
  #blocks = new Map();  // by the key of the block -> {context, x, y}
  #image = new ImageData(TILE, TILE);
  #words = new Uint32Array(this.#image.data.buffer);

  clear() { this.#blocks.clear(); }

  draw_tile(key, cells, words_of_values) {
    const x = xOf(key), y = yOf(key);
    const block_x = Math.floor(x / BLOCK), block_y = Math.floor(y / BLOCK);
    const block_key = keyOf(block_x, block_y);
    let block = this.#blocks.get(block_key);
    if (block === undefined) {
      const canvas = document.createElement("canvas");
      canvas.width = canvas.height = PIXELS;
      block = {canvas, context: canvas.getContext("2d"), x: block_x, y: block_y};
      this.#blocks.set(block_key, block);
    }
    // Rows of pixels go down, those of cells up.
    for (let row = 0; row < TILE; ++row) {
      const to = (TILE - 1 - row) * TILE;
      for (let column = 0; column < TILE; ++column) {
        this.#words[to + column] = words_of_values[cells[row * TILE + column]];
      }
    }
    const row_of_tile = BLOCK - 1 - (y - block_y * BLOCK);
    block.context.putImageData(this.#image, (x - block_x * BLOCK) * TILE, row_of_tile * TILE);
  }

  paint(context, camera, size, resolution_m) {
    context.imageSmoothingEnabled = camera.scale * resolution_m < 1;
    const step_m = PIXELS * resolution_m;
    for (const {canvas, x, y} of this.#blocks.values()) {
      // Whole pixels, so that there is no seam between neighbors.
      const [left, bottom] = camera.to_screen(x * step_m, y * step_m, size).map(Math.round);
      const [right, top] = camera.to_screen((x + 1) * step_m, (y + 1) * step_m, size).map(Math.round);
      if (right < 0 || left > size.width || bottom < 0 || top > size.height) continue;
      context.drawImage(canvas, left, top, right - left, bottom - top);
    }
  }

  // Of the blocks, in m; null where there is nothing.
  static box(tiles, resolution_m) {
    let min_x = Infinity, min_y = Infinity, max_x = -Infinity, max_y = -Infinity;
    for (const key of tiles.keys()) {
      const x = xOf(key), y = yOf(key);
      min_x = Math.min(min_x, x);
      max_x = Math.max(max_x, x + 1);
      min_y = Math.min(min_y, y);
      max_y = Math.max(max_y, y + 1);
    }
    if (min_x > max_x) return null;
    const step_m = TILE * resolution_m;
    return {min_x: min_x * step_m, min_y: min_y * step_m, max_x: max_x * step_m, max_y: max_y * step_m};
  }
}
