// SPDX-License-Identifier: BSD-3-Clause
// A small chart of lines, with what they are now in its caption.

const LABEL_PX = 40;  // for the largest value

// Small numbers with two digits that count.
export const textOf = (value, digits) =>
    value !== 0 && Math.abs(value) < 1 && digits > 0 ? value.toPrecision(2) : value.toFixed(digits);

export class LineChart {
  // on_part(part of the way from the first x to the last): a click; null: clicks do nothing
  constructor(title, on_part = null) {
    this.title = title;
    this.figure = document.createElement("figure");
    const caption = document.createElement("figcaption");
    this.value = document.createElement("b");
    caption.append(title, this.value);
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.figure.append(caption, this.canvas);
    if (on_part === null) return;
    this.canvas.classList.add("clickable");
    this.canvas.addEventListener("click", (event) => {
      const {left, width} = this.canvas.getBoundingClientRect();
      on_part((event.clientX - left - LABEL_PX) / (width - LABEL_PX - 4));
    });
  }

  tell(text, spoken = text) {
    this.value.textContent = text;
    this.canvas.setAttribute("aria-label", `${this.title}: ${spoken}`);
  }

  // lines: {rows, x(row), y(row), color, dash}, from [first, min] to [last, max]; y may be null. max 0: there is nothing.
  // mark: x of a vertical line, or null; note: text instead of lines
  draw(lines, {first, last, min = 0, max, digits, mark = null, note = ""}, colors) {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    const ratio = devicePixelRatio;
    if (width === 0) return;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const context = this.canvas.getContext("2d");
    context.scale(ratio, ratio);
    const span = Math.max(last - first, 1e-9);
    const px = (x) => (x - first) / span * (width - LABEL_PX - 4) + LABEL_PX;
    const py = (y) => height - 3 - (max > min ? (y - min) / (max - min) : 0) * (height - 6);
    for (const {rows, x, y, color, dash = []} of lines) {
      let points = 0, latest = null;
      context.beginPath();
      for (const row of rows) {
        if (y(row) === null) continue;
        latest = [px(x(row)), py(y(row))];
        context.lineTo(...latest);
        ++points;
      }
      if (points === 1) context.arc(...latest, 1, 0, 2 * Math.PI);  // else there would be nothing to see
      context.strokeStyle = color;
      context.lineWidth = 1.5;
      context.setLineDash(dash);
      context.stroke();
    }
    if (max > min) {
      context.fillStyle = colors.quiet;
      context.font = "10px system-ui, sans-serif";
      context.textAlign = "right";
      context.fillText(textOf(max, digits), LABEL_PX - 4, 11);
      context.fillText(textOf(min, min === 0 ? 0 : digits), LABEL_PX - 4, height - 4);
    }
    if (note !== "") {
      context.fillStyle = colors.quiet;
      context.font = "12px system-ui, sans-serif";
      context.fillText(note, LABEL_PX, height / 2 + 4);
    }
    if (mark !== null) {
      context.fillStyle = colors.selected;
      context.fillRect(px(mark) - 1, 0, 2, height);
    }
  }
}
