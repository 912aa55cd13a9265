# SPDX-License-Identifier: BSD-3-Clause
"""A table, written as CSV for programs and as Markdown for people; the page shows it too."""
import csv
import dataclasses
import io


@dataclasses.dataclass(frozen=True)
class Shown:
    """A cell whose text says more than the number by which it sorts."""
    text: str
    value: float | None


@dataclasses.dataclass(frozen=True)
class Table:
    """Cells are text, numbers, None (no value) or Shown."""
    name: str
    caption: str
    header: list
    rows: list

    def csv(self):
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(self.header)
        writer.writerows([exact(cell) for cell in row] for row in self.rows)
        return out.getvalue()

    def markdown(self):
        lines = [self.header, ["---"] * len(self.header)]
        lines += [[text(cell).replace("|", "\\|") for cell in row] for row in self.rows]
        body = "\n".join("| " + " | ".join(line) + " |" for line in lines)
        return f"{self.caption}\n\n{body}\n"

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{self.name}.csv").write_text(self.csv())
        (folder / f"{self.name}.md").write_text(self.markdown())


def text(cell):
    """For people: four digits."""
    if cell is None:
        return "–"
    if isinstance(cell, Shown):
        return cell.text
    return f"{cell:.4g}" if isinstance(cell, float) else str(cell)


def exact(cell):
    """For programs: every digit."""
    if isinstance(cell, Shown):
        return cell.text
    return repr(cell) if isinstance(cell, float) else cell


def sort_value(cell):
    """What the page sorts by; empty for no value."""
    value = cell.value if isinstance(cell, Shown) else cell
    return "" if value is None else value


def p_value(p):
    """Never shown as 0, which no p is."""
    return Shown("< 0.0001" if p < 1e-4 else f"{p:.4f}", p)


def mean_or_median(summary, digits=3):
    """`mean (low to high)` with the interval of the mean; of values too few for one `median [min, max]`,
    and a single value alone."""
    if summary.mean is None:
        return Shown("–", None)
    middle = summary.median if summary.low is None else summary.mean
    shown = f"{middle:.{digits}g}"
    if summary.low is not None:
        shown += f" ({summary.low:.{digits}g} to {summary.high:.{digits}g})"
    elif summary.n_ok > 1:
        shown += f" [{summary.min:.{digits}g}, {summary.max:.{digits}g}]"
    return Shown(shown, middle)
