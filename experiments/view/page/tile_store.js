// SPDX-License-Identifier: BSD-3-Clause
// The map as tiles of 16 x 16 cells, and as it was at earlier times as far as memory goes.

export const TILE = 16;
const UNKNOWN = 255;
const TILE_BYTES = TILE * TILE;
const HEADER_BYTES = 16;
const RECORD_BYTES = 4 + TILE_BYTES;
const MAX_LOG_BYTES = 32 << 20;

export const keyOf = (x, y) => (x + 32768) * 65536 + (y + 32768);
export const xOf = (key) => Math.floor(key / 65536) - 32768;
export const yOf = (key) => (key % 65536) - 32768;

export const UNKNOWN_TILE = new Uint8Array(TILE_BYTES).fill(UNKNOWN);

// What a tile becomes in a map of tiles; those that are all unknown are left out.
function put(tiles, key, bytes) {
  if (bytes.every((value) => value === UNKNOWN)) tiles.delete(key);
  else tiles.set(key, bytes);
}

// Calls visit(key, bytes) for each tile of a message; bytes are part of it.
function forTiles(buffer, visit) {
  const view = new DataView(buffer);
  const count = view.getUint32(4, true);
  for (let i = 0, at = HEADER_BYTES; i < count; ++i, at += RECORD_BYTES) {
    visit(keyOf(view.getInt16(at, true), view.getInt16(at + 2, true)),
          new Uint8Array(buffer, at + 4, TILE_BYTES));
  }
}

export class TileStore {
  latest = new Map();  // key -> Uint8Array
  #log = [];           // {time_s, buffer} in the order in which they came
  #log_bytes = 0;
  #past = null;        // {time_s, tiles}, the last one asked for
  #base = null;        // what the log begins with, once its beginning was dropped: {time_s, tiles}

  // Returns the keys of what changed.
  add(buffer) {
    const time_s = new DataView(buffer).getFloat64(8, true);
    const keys = [];
    forTiles(buffer, (key, bytes) => {
      keys.push(key);
      put(this.latest, key, bytes.slice());
    });
    this.#log.push({time_s, buffer});
    this.#log_bytes += buffer.byteLength;
    if (this.#log_bytes > MAX_LOG_BYTES) this.#drop(MAX_LOG_BYTES / 2);
    return keys;
  }

  #drop(bytes_left) {
    this.#base ??= {time_s: 0, tiles: new Map()};
    let count = 0;
    for (; this.#log_bytes > bytes_left; ++count) {
      const {time_s, buffer} = this.#log[count];
      this.#base.time_s = time_s;
      forTiles(buffer, (key, bytes) => put(this.#base.tiles, key, bytes.slice()));
      this.#log_bytes -= buffer.byteLength;
    }
    this.#log.splice(0, count);
  }

  get first_s() { return this.#base?.time_s ?? this.#log[0]?.time_s ?? Infinity; }

  // The map at a time from first_s on.
  at(time_s) {
    if (this.#past?.time_s === time_s) return this.#past.tiles;
    const tiles = new Map(this.#base?.tiles);
    for (const entry of this.#log) {
      if (entry.time_s > time_s) break;
      forTiles(entry.buffer, (key, bytes) => put(tiles, key, bytes));
    }
    this.#past = {time_s, tiles};
    return tiles;
  }

  // Of what at() returned last.
  forget_past() { this.#past = null; }
}
