// SPDX-License-Identifier: BSD-3-Clause
// The socket to the program: it comes back by itself when it is lost.

const FIRST_WAIT_MS = 500;
const LONGEST_WAIT_MS = 4000;

export class Connection {
  #socket = null;
  #wait_ms = FIRST_WAIT_MS;

  // on_message(object or ArrayBuffer), on_state("connecting" | "open" | "lost")
  constructor(protocol, on_message, on_state) {
    this.protocol = protocol;
    this.on_message = on_message;
    this.on_state = on_state;
    this.#open();
    addEventListener("online", () => this.#open());
  }

  #open() {
    if (this.#socket !== null && this.#socket.readyState <= WebSocket.OPEN) return;
    const scheme = location.protocol === "https:" ? "wss:" : "ws:";
    const socket = new WebSocket(`${scheme}//${location.host}/`, this.protocol);
    this.#socket = socket;
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.#wait_ms = FIRST_WAIT_MS;
      this.on_state("open");
    };
    socket.onmessage = ({data}) => this.on_message(
        typeof data === "string" ? JSON.parse(data) : data);
    socket.onclose = () => {
      this.on_state("lost");
      this.#retry();
    };
  }

  // A socket that fails puts a line on the console that cannot be caught. A request that fails does
  // as well: so there is one try at a time, and less and less often.
  #retry() {
    setTimeout(() => this.#open(), this.#wait_ms);
    this.#wait_ms = Math.min(2 * this.#wait_ms, LONGEST_WAIT_MS);
  }

  send(op, values = {}) {
    if (this.#socket.readyState === WebSocket.OPEN) this.#socket.send(JSON.stringify({op, ...values}));
  }
}
