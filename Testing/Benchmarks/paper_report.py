# SPDX-License-Identifier: BSD-3-Clause
"""Results.md from Results.json, PaperTables.json and PaperText.md alone."""

import re
import sys
from pathlib import Path

import paper_verdicts as verdicts
from paper_data import (
    ABLATED,
    COLUMNS,
    CONTROLS,
    DISTRIBUTIONS,
    EVERY,
    GENES,
    HERE,
    NMAX,
    SYSTEMS,
    Rows,
    by_control,
    by_nmax,
    deviation,
    exponent,
    formatted,
    gain,
    paper_rows,
    span,
    title,
    tolerance,
)

TABLE_NUMBERS = {2000000: 2, 4000000: 3, 6000000: 4, 8000000: 5, 10000000: 6}
TEXT = {
    name: part.strip()
    for name, part in re.findall(
        r"<!-- part: ([\w ]+) -->(.*?)(?=<!-- part: |\Z)", (HERE / "PaperText.md").read_text(), re.DOTALL
    )
}
HEADS = {"np": "NP", "nr": "NR", "grid": "grid", "insert": "insert", "total": "total"}


def thousands(points):
    return f"{points:,}"


def shown(value, column="total"):
    """A number of a table; '-' for none."""
    if value is None:
        return "-"
    if column in ("np", "nr"):
        return f"{value:.2f}"
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}"


def beside(ours, theirs):
    """'189 / 2012', or ours alone where the paper has none."""
    return ours if theirs == "-" else f"{ours} / {theirs}"


def percent(value):
    return "-" if value is None else formatted(value)


def table(head, rows):
    """A Markdown table; the first column is text."""
    lines = ["| " + " | ".join(head) + " |", "|---" + "|--:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def text_table(head, rows):
    return table(head, rows).replace("|--:", "|---")


# --- Tables 2 to 6 ---------------------------------------------------------------------------------


def paper_table(here, paper, points):
    rows = []
    for distribution in DISTRIBUTIONS:
        first = True
        for system in SYSTEMS:
            if not here.row(points, distribution, system):
                continue
            cells = [
                beside(
                    shown(here.value(points, distribution, system, column), column),
                    shown(paper.value(points, distribution, system, column), column),
                )
                for column in COLUMNS
            ]
            rows.append([distribution if first else "", title(system), *cells])
            first = False
    number = TABLE_NUMBERS.get(points)
    head = f"### {thousands(points)} points" + (f" (the paper's Table {number})" if number else "")
    return (
        head
        + "\n\n"
        + table(["", "system", *(HEADS[c] for c in COLUMNS)], rows).replace("|---|--:", "|---|---", 1)
    )


def gain_table(here, paper):
    def cell(case, of, over, column="total"):
        return beside(*(percent(gain(rows, case, of, over, column)) for rows in (here, paper)))

    rows = []
    for case in here.cases():
        rows.append(
            [
                f"{thousands(case[0])} {case[1]}",
                cell(case, "HG", "RG"),
                cell(case, "HG", "MG"),
                cell(case, "HG", "CGAL"),
                cell(case, "HG", "RG", "insert"),
                cell(case, "HG", "MG", "insert"),
                cell(case, EVERY, "HG"),
                cell(case, "default", "HG"),
                cell(case, "default", "CGAL"),
            ]
        )
    head = [
        "points",
        "HG over RG",
        "HG over MG",
        "HG over CGAL",
        "insert: HG over RG",
        "insert: HG over MG",
        "every level over HG",
        "default over HG",
        "default over CGAL",
    ]
    return table(head, rows)


def growth_table(here, paper):
    def cell(distribution, system):
        values = (exponent(rows, distribution, system) for rows in (here, paper))
        return beside(*("-" if v is None else f"{v:.3f}" for v in values))

    if len(here.sizes) < 2:
        return "One number of points alone was measured: no growth."
    rows = [[d, *(cell(d, s) for s in SYSTEMS)] for d in DISTRIBUTIONS]
    return table(["exponent", *(title(s) for s in SYSTEMS)], rows)


def per_point_table(here, paper):
    """Nanoseconds per point at the smallest and the largest size."""

    def cell(distribution, system):
        cells = []
        for rows in (here, paper):
            found = [rows.value(n, distribution, system, "total") for n in (rows.sizes[0], rows.sizes[-1])]
            known = None not in found
            cells.append(
                " → ".join(f"{1e6 * t / n:.0f}" for t, n in zip(found, (rows.sizes[0], rows.sizes[-1])))
                if known
                else "-"
            )
        return beside(*cells)

    if len(here.sizes) < 2:
        return ""
    rows = [[d, *(cell(d, s) for s in SYSTEMS)] for d in DISTRIBUTIONS]
    return table(["ns per point", *(title(s) for s in SYSTEMS)], rows)


# --- Ablations -------------------------------------------------------------------------------------


def genes_table(rows, points):
    lines = []
    for distribution in ABLATED:
        for control in CONTROLS:
            for genes in GENES:
                row = rows.row(points, distribution, by_control(control, genes))
                cells = [shown(row.get(column), column) for column in COLUMNS]
                lines.append([distribution, control, genes, *cells])
    head = ["", "control points", "genes", *(HEADS[c] for c in COLUMNS)]
    return table(head, lines).replace("|---|--:|--:", "|---|---|---", 1)


def nmax_table(rows, points, columns):
    """The columns' values of each Nmax; the smallest total in bold."""
    lines = []
    for order in ("MG", "HG"):
        for distribution in ABLATED:
            found = [rows.row(points, distribution, by_nmax(order, nmax)) for nmax in NMAX]
            least = min((r["total"] for r in found if "total" in r), default=None)
            cells = [" / ".join(shown(r.get(c), c) for c in columns) for r in found]
            if columns == ["total"]:
                cells = [f"**{c}**" if r.get("total") == least else c for c, r in zip(cells, found)]
            lines.append([order, distribution, *cells])
    head = ["order", "", *(str(nmax) for nmax in NMAX)]
    return table(head, lines).replace("|---|--:", "|---|---", 1)


def ablation_sections(rows):
    parts = []
    for points in rows.sizes:
        sentences = verdicts.gene_sentences(rows, points) + verdicts.control_sentences(rows, points)
        parts += [
            f"### Genes and control points: HG, Nmax 50, {thousands(points)} points",
            TEXT["genes"],
            genes_table(rows, points),
            "\n".join(f"- {s}" for s in sentences),
            f"### Nmax from {NMAX[0]} to {NMAX[-1]}: total, ms, {thousands(points)} points",
            TEXT["nmax"],
            nmax_table(rows, points, ["total"]),
            "The same, NP / NR:",
            nmax_table(rows, points, ["np", "nr"]),
            "\n".join(f"- {s}" for s in verdicts.nmax_sentences(rows, points)),
        ]
    return parts


# --- The whole -------------------------------------------------------------------------------------


def made_table(made):
    machine = made["machine"]
    processor = machine["processor"] + (" (virtual machine)" if machine["virtual"] else "")
    rows = [
        ["processor", f"{processor}, {machine['processors']} processors, one used; {machine['caches']}"],
        ["memory", machine["memory"]],
        ["system", f"{machine['system']}, Linux {machine['kernel']}"],
        ["compiler", f"{made['compiler']}: {made['flags']}"],
        ["CGAL", made["cgal"] or "not found: left out"],
        ["sources", revision_of(made)],
        ["date", made["date"]],
        ["the paper", TEXT["paper machine"]],
    ]
    return text_table(["", ""], rows)


def revision_of(made):
    revision = made["revision"]
    if not revision.strip("+"):
        return "not under git"
    return "commit " + revision.replace("+", ", with changes")


def noise_sentence(rows, made):
    """How quiet it was, from the rounds themselves."""
    timed = [row for row in rows if row.get("rounds", {}).get("wall")]
    if not timed:
        return ""
    cpu, wall = (sum(sum(row["rounds"][k]) for row in timed) for k in ("total", "wall"))
    waited = (
        f"{100 * max(0.0, 1 - cpu / wall):.1f} % of the time on the wall was spent waiting, "
        f"which is not counted; the load of the machine was {made['loadBefore']:.1f} before."
    )
    counts = sorted({len(row["rounds"]["total"]) for row in timed})
    if counts == [1]:
        return f"Each was measured once, so how far the times are off is not known. {waited}"
    deviations = [deviation(row) for row in timed]
    return (
        f"Each time is the median of {span(counts, '{:.0f}')} rounds. The rounds' median "
        f"distance from it was {sum(deviations) / len(deviations):.1f} % on average, "
        f"{max(deviations):.1f} % at worst. {waited}"
    )


def checked_sentence(data):
    rows = data["tables"] + data["ablations"]
    certified = sum(row["checked"] == "certificate" for row in rows)
    same = sum(row["checked"] == "same bytes" for row in rows)
    cgal = [row for row in rows if row["configuration"] == "CGAL"]
    validated = sum("is_valid" in row["checked"] for row in cgal)
    return (
        f"Of each point set, the first result was certified in exact arithmetic ({certified} certificates); "
        f"all other runs of the engine had to give the same bytes ({same} configurations). CGAL's number "
        f"of triangles had to agree ({len(cgal)} point sets), and its own is_valid() was asked "
        f"at the smallest size ({validated})."
    )


def failures_section(data):
    if not data["failures"]:
        return []
    return ["## What went wrong", "\n".join(f"- {failure}" for failure in data["failures"])]


def of_peers(data, render_peers):
    """The result of a function of peers.py, by its name, for the peers' part of the data; [] without it."""
    if not data.get("peers"):
        return []
    sys.path.insert(0, str(Path(HERE) / "peers"))
    import peers

    return [getattr(peers, render_peers)(data["peers"])]


def render(data):
    """The whole report as Markdown."""
    here, paper, ablated = Rows(data["tables"]), paper_rows(), Rows(data["ablations"])
    cgal = f"CGAL {data['made']['cgal']}"
    parts = [TEXT["introduction"]] + ([TEXT["trial"]] if data["made"]["quick"] else [])
    parts += failures_section(data)
    if here.all:
        parts += ["## In short", "\n".join(f"- {s}" for s in verdicts.in_short(here, paper, ablated, cgal))]
        parts += [short_tables(data)]
    parts += [
        "## How it was measured",
        made_table(data["made"]),
        TEXT["method"],
        noise_sentence(here.all + ablated.all, data["made"]),
        checked_sentence(data),
        "### Where it may be biased",
        TEXT["bias"],
    ]
    if here.all:
        parts += ["## Tables 2 to 6", TEXT["legend"]]
        parts += [paper_table(here, paper, points) for points in here.sizes]
        parts += ["## Gains", TEXT["gains"], gain_table(here, paper)]
        parts += ["## Growth with the number of points", TEXT["growth"], growth_table(here, paper)]
        parts += [per_point_table(here, paper)]
        claims = text_table(["claim", "in the paper's tables", "here"], verdicts.claim_rows(here, paper))
        parts += ["## The paper's claims, checked", TEXT["claims"], claims]
    if ablated.all:
        deltas = {column: tolerance(ablated, column) for column in ("insert", "total")}
        parts += ["## Ablations", TEXT["ablation"].format(**deltas)]
        parts += ablation_sections(ablated)
    parts += ["## What differs from the paper, and why", TEXT["departures"]]
    parts += of_peers(data, "markdown")
    return "\n\n".join(part for part in parts if part) + "\n"


def short_tables(data):
    """CGAL's total over that of each system, at the largest size of the paper, and a line of each peer."""
    here, paper = Rows(data["tables"]), paper_rows()
    common = [n for n in here.sizes if n in paper.sizes] or here.sizes
    if not common:
        return ""
    points = common[-1]

    def cell(distribution, system):
        cells = []
        for rows in (here, paper):
            a, b = (rows.value(points, distribution, c, "total") for c in ("CGAL", system))
            cells.append(f"{a / b:.2f}" if a and b else "-")
        return beside(*cells)

    systems = [s for s in SYSTEMS if s != "CGAL"]
    rows = [[d.lower(), *(cell(d, s) for s in systems)] for d in DISTRIBUTIONS]
    ratios = table([f"{thousands(points)} points", *(title(s) for s in systems)], rows)
    told = "Times as fast as CGAL, cold, one core; here / in the paper's tables:"
    return "\n\n".join([told, ratios, *of_peers(data, "summary")])


def readme_table(data):
    """The table of README.md: this filter beside vtkDelaunay2D."""
    return "\n\n".join(of_peers(data, "first_page"))
