# SPDX-License-Identifier: BSD-3-Clause
"""The figures with axes: what the orders cost, counted, and the times that Testing/Benchmarks/paper.sh
measured, beside those of the paper. Each function makes one and returns the numbers its caption tells."""

import collections
import json
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import matplotlib.ticker

from palette import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILLION

DISTRIBUTIONS = ("Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed")
EVERY = "HG:control=every"
# configuration: (name, colour). The paper has the first four.
SYSTEMS = {
    "CGAL": ("CGAL", GREY),
    "RG": ("RG", ORANGE),
    "MG": ("MG", SKY),
    "HG": ("HG", BLUE),
    EVERY: ("HG, every level", GREEN),
    "default": ("our default", VERMILLION),
}
COLOURS = (INK, ORANGE, GREEN, BLUE, VERMILLION, PURPLE)  # of the distributions
MARKS = "osD^vP"
DPI = 100

# here, paper: {(points, distribution, configuration): row}
Results = collections.namedtuple("Results", "here paper")


def read(results, paper):
    """Results of two files; without the first, `here` is empty."""

    def rows(path):
        if not path or not os.path.exists(path):
            return {}
        with open(path, encoding="utf-8") as file:
            found = json.load(file)["tables"]
        return {(row["points"], row["distribution"], row["configuration"]): row for row in found}

    return Results(rows(results), rows(paper))


def sizes(rows):
    return sorted({points for points, _, _ in rows})


def known(rows, points, configuration, column):
    """[(place, value)] of the distributions for which it is known."""
    found = [
        (k, rows.get((points, name, configuration), {}).get(column)) for k, name in enumerate(DISTRIBUTIONS)
    ]
    return [(k, value) for k, value in found if value is not None]


# --- drawing --------------------------------------------------------------------------------------


def new(columns, width=11.0, height=4.4, share=False):
    pyplot.rcParams.update({
        "font.family": "DejaVu Sans", "font.size": 13, "axes.titlesize": 15, "axes.titleweight": "bold",
        "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": GREY, "xtick.color": INK, "ytick.color": INK,
        "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "axes.axisbelow": True,
        "grid.color": "#e4e6e9"})  # fmt: skip
    figure, axes = pyplot.subplots(1, columns, figsize=(width, height), dpi=DPI, sharey=share, squeeze=False)
    return figure, axes[0]


def save(figure, axes, path):
    """With one key for all, below."""
    handles = {}
    for part in axes:
        for handle, label in zip(*part.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    if handles:
        figure.legend(
            handles.values(), handles.keys(), loc="lower center", ncol=len(handles), frameon=False,
            handlelength=1.4, columnspacing=1.4)  # fmt: skip
    figure.tight_layout(rect=(0, 0.09 if handles else 0, 1, 1), w_pad=2.5)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    figure.savefig(path, pil_kwargs={"optimize": True})
    print(
        "%s  %d × %d, %d KB" % (path, *figure.get_size_inches() * DPI, os.path.getsize(path) // 1024),
        flush=True,
    )
    pyplot.close(figure)


def bars(axes, rows, points, column, scale):
    """Groups of bars: a group for each distribution, a bar for each system that has numbers."""
    there = {name: known(rows, points, name, column) for name in SYSTEMS}
    there = {name: pairs for name, pairs in there.items() if pairs}
    width = 0.84 / max(1, len(there))
    for number, (name, pairs) in enumerate(there.items()):
        label, colour = SYSTEMS[name]
        places = [k - 0.42 + (number + 0.5) * width for k, _ in pairs]
        axes.bar(places, [scale * value for _, value in pairs], 0.9 * width, color=colour, label=label)
    axes.set_xticks(range(len(DISTRIBUTIONS)), DISTRIBUTIONS, rotation=30, ha="right", rotation_mode="anchor")
    axes.grid(axis="x", visible=False)
    axes.tick_params(axis="both", length=0)


# --- what it costs, counted -----------------------------------------------------------------------


def work(path, counted, paper, points, papers_points=2000000):
    """NP and NR by distribution: counted (as rows), and the paper's as rings."""
    figure, axes = new(2, height=4.9)
    for part, column, words in zip(
        axes, ("np", "nr"), ("NP: triangles walked per point", "NR: triangles removed per point")
    ):
        bars(part, counted, points, column, 1.0)
        shown = [name for name in SYSTEMS if known(counted, points, name, column)]
        width = 0.84 / len(shown)
        for number, name in enumerate(shown):
            pairs = known(paper, papers_points, name, column)
            part.plot(
                [k - 0.42 + (number + 0.5) * width for k, _ in pairs], [value for _, value in pairs],
                "o", color="white", markeredgecolor=INK, markersize=5,
                label="the paper, %d million" % (papers_points // 1000000) if name == "HG" else None)  # fmt: skip
        part.set_title(words)
    save(figure, axes, path)


# --- times ----------------------------------------------------------------------------------------


def times(path, results, points):
    """Figures 11 to 15: the total time of each system for each distribution."""
    figure, axes = new(2, height=4.9)
    for part, rows, words in zip(axes, results, ("here", "the paper, 2016")):
        bars(part, rows, points, "total", 0.001)
        part.set_title("%d million points, %s" % (points // 1000000, words))
        part.set_ylabel("seconds")
    save(figure, axes, path)
    return gains(results, points)


def gains(results, points):
    """How much less time HG took than others, in percent: from, to."""
    found = {}
    for over in ("RG", "MG", "CGAL"):
        for where, rows in zip(("here", "paper"), results):
            ours, theirs = (dict(known(rows, points, name, "total")) for name in ("HG", over))
            values = [100.0 * (theirs[k] - ours[k]) / theirs[k] for k in ours if k in theirs]
            if values:
                key = "%s_over_%s" % (where, over.lower())
                found[key] = "%.0f to %.0f" % (min(values), max(values))
    return found


def by_distribution(path, results):
    """Figure 16: the total time of HG against the number of points."""
    figure, axes = new(2)
    for part, rows, words in zip(axes, results, ("here", "the paper, 2016")):
        for name, colour, mark in zip(DISTRIBUTIONS, COLOURS, MARKS):
            pairs = series(rows, name, "HG")
            part.plot(*zip(*pairs), color=colour, marker=mark, linewidth=2, label=name)
        finish_growth(part, "HG, " + words)
    save(figure, axes, path)
    return {}


def by_system(path, results, distribution="Mixed"):
    """Figure 17: the total time of each system against the number of points."""
    figure, axes = new(2)
    for part, rows, words in zip(axes, results, ("here", "the paper, 2016")):
        for (configuration, (name, colour)), mark in zip(SYSTEMS.items(), MARKS):
            pairs = series(rows, distribution, configuration)
            if pairs:
                part.plot(*zip(*pairs), color=colour, marker=mark, linewidth=2, label=name)
        finish_growth(part, "%s, %s" % (distribution, words))
    save(figure, axes, path)
    return {}


def series(rows, distribution, configuration):
    """[(millions of points, seconds)]"""
    found = [(n, rows.get((n, distribution, configuration), {}).get("total")) for n in sizes(rows)]
    return [(n / 1e6, 0.001 * t) for n, t in found if t is not None]


def finish_growth(axes, title):
    axes.set_title(title)
    axes.set_xlabel("million points")
    axes.set_ylabel("seconds")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.xaxis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))
    axes.tick_params(length=0)


def figures(results):
    """{name: function(path)} of what can be drawn from the results: nothing without measured ones."""
    if not results.here:
        return {}
    there = [n for n in sizes(results.here) if n in sizes(results.paper)]
    made = {"times-%dm" % (n // 1000000): lambda path, n=n: times(path, results, n) for n in there}
    if len(sizes(results.here)) > 1:
        made["growth-by-distribution"] = lambda path: by_distribution(path, results)
        made["growth-by-system"] = lambda path: by_system(path, results)
    return made
