// Sorts a table by the column whose head is clicked, and the other way round on the next click.
// Numbers are sorted as numbers; cells without a value stay at the end.
"use strict";

function compareCells(a, b, sign) {
  if (a === "" || b === "") return (a === "") - (b === "");
  const [x, y] = [Number(a), Number(b)];
  const order = Number.isNaN(x) || Number.isNaN(y) ? a.localeCompare(b) : x - y;
  return sign * order;
}

function sortBy(head) {
  const sign = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
  for (const other of head.parentNode.children) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
  const body = head.closest("table").tBodies[0];
  const value = (row) => row.children[head.cellIndex].dataset.sort;
  body.append(...[...body.rows].sort((a, b) => compareCells(value(a), value(b), sign)));
}

for (const button of document.querySelectorAll(".sortable th button")) {
  button.addEventListener("click", () => sortBy(button.parentNode));
}
