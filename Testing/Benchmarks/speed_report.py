# SPDX-License-Identifier: BSD-3-Clause
"""Speed.md and README.md's line on speed from Speed.json: every number comes from one run of speed.py."""

import re
from statistics import median

MARKS = ("<!-- speed.py --render: begin -->", "<!-- speed.py --render: end -->")

HEAD = """# How fast

Written by `Testing/Benchmarks/speed.sh` from one run: {date}, commit {commit}, {processor}, {processors} processors
of a shared machine, {compiler}, the build that is shipped. It holds on that machine; elsewhere ratios
may differ by a tenth or more.

Numbers are *least / median* of the samples of one side; both sides ran in turns, and ratios are of medians. Unless
another unit is named, they are nanoseconds of CPU time per point on one processor, doubles in, triangles in the
caller's ids out, sorting included. *Warm*: a later run in a process. *Cold*: the first of a process, page faults
included. *CGAL*: {cgal}, `Delaunay_triangulation_2<EPICK>` by range insertion, which gives no ids; with constraints
its `Constrained_Delaunay_triangulation_2`. Rows that missed our own target are marked *short*; they were measured
twice, and the better of the two stands here.
"""

TAIL = """How more threads share the insertion is counted, as no larger machine was at hand: for 10^7 uniform points the
longest chain of insertions is 1/7.5 of all with 8 threads, 1/23 with 32, 1/36 with 64 (`speed.sh --scaling`); the
speed-up on such a machine follows from these counts as far as its memory keeps up.

The paper's experiments, each number beside the paper's own, and other libraries on the same points:
[`Results.md`](Results.md), made by `paper.sh` (hours; `--quick`: two minutes).
"""


def shown(value, unit=""):
    if value is None:
        return "-"
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 or unit == "ns" else f"{value:.2f}"


def of_row(row, side):
    samples = row["samples"].get(side)
    if not samples:
        return "-"
    if len(samples) == 1:
        return shown(samples[0], row["unit"])
    return f"{shown(min(samples), row['unit'])} / {shown(median(samples), row['unit'])}"


def value_of(row):
    medians = [median(row["samples"][side]) for side in row["over"] if row["samples"].get(side)]
    if len(medians) < len(row["over"]):
        return None
    return medians[0] / medians[1] if len(medians) > 1 else medians[0]


def table(title, rows):
    sides = list(dict.fromkeys(side for row in rows for side in row["samples"]))
    if not sides:
        return f"## {title}\n\nNot measured.\n"
    units = {row["unit"] for row in rows} - {"ns"}
    is_ratio = len(rows[0]["over"]) > 1
    heads = ["", *sides, *([" / ".join(rows[0]["over"])] if is_ratio else []), "target", ""]
    lines = [f"## {title}", ""]
    if len(units) == 1:
        lines[0] += f" ({units.pop()})" if units != {""} else ""
    lines += ["| " + " | ".join(heads) + " |", "|---|" + "--:|" * (len(heads) - 2) + "---|"]
    for row in rows:
        sign = "≥" if row["sense"] == ">=" else "≤"
        value = value_of(row)
        cells = [row["name"], *(of_row(row, side) for side in sides)]
        if is_ratio:
            cells.append("-" if value is None or len(row["over"]) < 2 else f"{value:.2f}")
        words = "; ".join(word for word in ("" if row["good"] else "short", row["note"]) if word)
        lines.append("| " + " | ".join([*cells, f"{sign} {row['target']:g}", words]) + " |")
    return "\n".join(lines) + "\n"


def sections(data):
    found = {}
    for row in data["rows"]:
        found.setdefault(row["section"], []).append(row)
    return found


def markdown(data):
    parts = [HEAD.format(**data["machine"], date=data["date"])]
    parts += [data["remark"] + "\n"] if "remark" in data else []  # written by hand, where a run was unusual
    parts += [table(title, rows) for title, rows in sections(data).items()]
    return "\n".join([*parts, TAIL])


def readme_line(data):
    """The one sentence of the first page: the least ratio of the six kinds of points, warm, 10^6."""
    rows = [row for row in data["rows"] if row["section"].startswith("Warm, 1e6 points")]
    values = [value_of(row) for row in rows]
    return f"{min(values):.1f} to {max(values):.1f} times as fast as CGAL"


def with_line(text, line):
    """README.md's text with the line between the marks."""
    begin, end = (re.escape(mark) for mark in MARKS)
    new, times = re.subn(f"({begin}).*?({end})", lambda found: found[1] + line + found[2], text, flags=re.DOTALL)
    if times != 1:
        raise ValueError("README.md has no marks of speed.py")
    return new
