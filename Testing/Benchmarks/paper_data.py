# SPDX-License-Identifier: BSD-3-Clause
"""The numbers of the paper's experiments, here and in the paper, and their consequences.

A row is a dict with points, distribution, configuration, and the known ones of np, nr (per point), grid, insert, total
(milliseconds). Results.json and PaperTables.json hold such rows.
"""

import json
import math
from pathlib import Path
from statistics import median

HERE = Path(__file__).resolve().parent

DISTRIBUTIONS = ["Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed"]
EVERY = "HG:control=every"
SYSTEMS = ["RG", "MG", "HG", EVERY, "default", "CGAL"]
TITLES = {EVERY: "HG, every level", "default": "our default"}
COLUMNS = ["np", "nr", "grid", "insert", "total"]

ABLATED = ["Uniform", "Line", "KuzminDisc"]
NMAX = [10, 20, 50, 100, 200, 400]
CONTROLS = ["none", "one", "every"]
GENES = ["on", "off"]


def title(configuration):
    return TITLES.get(configuration, configuration)


def by_control(control, genes):
    """The configuration HG, Nmax 50, with these control points and genes."""
    return (
        "HG" + ("" if control == "one" else f":control={control}") + (":genes=off" if genes == "off" else "")
    )


def by_nmax(order, nmax):
    """The configuration with the paper's settings for the order (MG, HG) and this Nmax."""
    return order if nmax == 50 else f"{order}:nmax={nmax}"


def ablations():
    """All configurations of the ablations, each once."""
    names = [by_control(control, genes) for control in CONTROLS for genes in GENES]
    names += [by_nmax(order, nmax) for order in ("MG", "HG") for nmax in NMAX]
    return list(dict.fromkeys(names))


class Rows:
    """Rows, found by number of points, distribution and configuration."""

    def __init__(self, rows):
        self.all = list(rows)
        self.found = {(r["points"], r["distribution"], r["configuration"]): r for r in self.all}
        self.sizes = sorted({r["points"] for r in self.all})

    def row(self, points, distribution, configuration):
        return self.found.get((points, distribution, configuration), {})

    def value(self, points, distribution, configuration, column):
        """None where it is not known."""
        return self.row(points, distribution, configuration).get(column)

    def cases(self):
        """All (points, distribution) there are, in the order of the tables."""
        there = {(r["points"], r["distribution"]) for r in self.all}
        return [(n, d) for n in self.sizes for d in DISTRIBUTIONS + ABLATED[2:] if (n, d) in there]


def paper_rows():
    return Rows(json.loads((HERE / "PaperTables.json").read_text())["tables"])


def gain(rows, case, of, over, column="total"):
    """How much less time `of` takes than `over`, in percent; negative if more; None if unknown."""
    a, b = (rows.value(*case, configuration, column) for configuration in (of, over))
    return None if a is None or not b else 100 * (b - a) / b


def gains(rows, of, over, column="total", distributions=None):
    """{case: gain} of the cases where it is known."""
    found = {case: gain(rows, case, of, over, column) for case in rows.cases()}
    return {
        case: value
        for case, value in found.items()
        if value is not None and (distributions is None or case[1] in distributions)
    }


def exponent(rows, distribution, configuration, column="total"):
    """b of the line log(time) = a + b log(points) of least squares; None for fewer than two sizes."""
    pairs = [(n, rows.value(n, distribution, configuration, column)) for n in rows.sizes]
    logs = [(math.log(n), math.log(t)) for n, t in pairs if t]
    if len(logs) < 2:
        return None
    x, y = (sum(values) / len(logs) for values in zip(*logs))
    return sum((a - x) * (b - y) for a, b in logs) / sum((a - x) ** 2 for a, _ in logs)


def deviation(row, column="total"):
    """Median distance of the rounds' times from their median, in percent of it."""
    times = row.get("rounds", {}).get(column, [])
    if not times:
        return 0.0
    middle = median(times)
    return 100 * median(abs(t - middle) for t in times) / middle


def tolerance(rows, column="total"):
    """Differences up to this, in percent, count as none: 1, or twice the typical deviation if more."""
    deviations = [deviation(row, column) for row in rows.all if "rounds" in row]
    return max(1.0, 2 * median(deviations)) if deviations else 1.0


def formatted(value, form="{:.1f}"):
    """As the format says, but zero without a sign."""
    text = form.format(value)
    return text if float(text) else text.lstrip("+-")


def span(values, form="{:.1f}"):
    """'3.1 to 4.5', or '3.1' if both are shown alike; '-' for none."""
    values = list(values)
    if not values:
        return "-"
    low, high = (formatted(v, form) for v in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"
