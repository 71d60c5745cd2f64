# SPDX-License-Identifier: BSD-3-Clause
"""The figures that ParaView draws. Each function makes one, and returns the numbers its caption tells."""

import numpy

import meshes
import plots
import stage
from palette import (
    BLUE, GREEN, GREY, INK, LIGHT_BLUE, LIGHT_GREEN, LIGHT_ORANGE, ORANGE, PALE, RAMP, VERMILLION)  # fmt: skip
from stage import Panel

PAPERS = {"InsertionOrder": "Adaptive Hilbert", "ControlPoints": "First level", "GeneRotation": 1}
BARE = {"InsertionOrder": "Adaptive Hilbert", "ControlPoints": "Off", "GeneRotation": 1}
UNTURNED = {"InsertionOrder": "Adaptive Hilbert", "ControlPoints": "Off", "GeneRotation": 0}
DEFAULT = {"InsertionOrder": "Adaptive Hilbert", "ControlPoints": "Every level", "GeneRotation": 1}
LINES = {"InsertionOrder": "Regular grid"}
GRIDS = {"InsertionOrder": "Multi-grid", "ControlPoints": "Off"}
GIVEN = {"InsertionOrder": "As given"}

MANY = 100000  # points for numbers that show jumps at work
COUNTED = 2000000  # points of each distribution, for NP and NR
STEPPED = 400  # points that are inserted one by one


def over(xy, width, margin=0.03):
    """A panel for all of these places."""
    places = xy.reshape(-1, 2)
    return Panel(places.min(axis=0), places.max(axis=0), width, margin)


def half_done(panel, run, fill=ORANGE):
    """The mesh of a run, its long triangles filled; returns how many of how many are long."""
    long = meshes.aspect_ratios(run.xy, run.triangles) > meshes.LONG
    panel.faces(run.xy, run.triangles[long], fill)
    panel.mesh(run.xy, run.triangles, GREY, 1.0)
    return int(long.sum()), len(long)


# --- one point, and the order of all -------------------------------------------------------------


def one_point(path):
    """Finding the place, opening the cavity, closing it with a star."""
    points = meshes.source("Uniform", 200, 4)
    before = meshes.triangulate(points, 94, **GIVEN)
    after = meshes.triangulate(points, 95, **GIVEN)
    xy, last, new = before.xy, before.xy[before.order[-1]], after.xy[after.order[-1]]
    removed = meshes.without(before.triangles, after.triangles)
    made = meshes.without(after.triangles, before.triangles)
    way = meshes.walked(xy, before.triangles, last, new)

    finding = over(xy, 400)
    finding.faces(xy, before.triangles[way], LIGHT_BLUE)
    finding.mesh(xy, before.triangles, GREY)
    finding.way(numpy.array([last, new]), BLUE, 3.0)
    opening = over(xy, 400)
    opening.faces(xy, before.triangles[removed], LIGHT_ORANGE)
    opening.mesh(xy, before.triangles, GREY)
    for triangle in before.triangles[removed]:
        centre, radius = meshes.circumcircle(xy[triangle])
        turn = numpy.linspace(0.0, 2.0 * numpy.pi, 90)
        circle = centre + radius * numpy.column_stack([numpy.cos(turn), numpy.sin(turn)])
        opening.lines(circle, [range(90)], VERMILLION, 1.0)
    closing = over(xy, 400)
    closing.faces(xy, after.triangles[made], LIGHT_GREEN)
    closing.mesh(xy, after.triangles, GREY)
    closing.mesh(xy, after.triangles[made], GREEN, 2.5)
    for panel in (finding, opening, closing):
        panel.points(xy[before.order], INK, 6.0)
        panel.points(new[None], VERMILLION, 14.0)
    finding.points(last[None], BLUE, 14.0)
    stage.figure(
        path, [panel.image() for panel in (finding, opening, closing)],
        ["1  Find the place", "2  Open the cavity", "3  Close it with a star"],
        key=[(BLUE, "dot", "the point before"), (VERMILLION, "dot", "the new point")])  # fmt: skip
    return {
        "points": len(before.order),
        "crossed": int(way.sum()),
        "removed": int(removed.sum()),
        "made": int(made.sum()),
    }


def order(path):
    """The way from point to point, at random and along the curve."""
    points = meshes.source("Uniform", 300, 2)
    panels = []
    for settings in (GIVEN, BARE):
        run = meshes.triangulate(points, Nmax=8, **settings)
        panel = over(run.xy, 480)
        panel.boxes(run.boxes, PALE)
        panel.way(run.xy[run.order], BLUE if settings is BARE else VERMILLION, 2.0)
        panel.points(run.xy, INK, 6.0)
        panels.append(panel.image())
    many = meshes.source("Uniform", 10000)
    given, bare = meshes.triangulate(many, **GIVEN), meshes.triangulate(many, **BARE)
    stage.figure(
        path,
        panels,
        [
            "As they come\n10,000 points: NP %.1f" % given.np,
            "Along a Hilbert curve\n10,000 points: NP %.1f" % bare.np,
        ],
    )
    return {"np_given": given.np, "np_curve": bare.np, "nr_given": given.nr, "nr_curve": bare.nr}


# --- lines of boxes ------------------------------------------------------------------------------


def regular_grid(path):
    """Figure 2: line by line, and the long triangles along the boundary of what is done."""
    points, limit = meshes.source("Uniform", 1000, 5), 560
    run = meshes.triangulate(points, limit, **LINES)
    visits = over(run.boxes, 560)
    visits.boxes(run.boxes, GREY)
    draw_visits(visits, run)
    mesh = over(run.boxes, 560)
    mesh.boxes(run.boxes, PALE)
    long, total = half_done(mesh, run)
    mesh.points(run.xy[run.order], INK, 4.0)
    mesh.points(run.xy[run.order[-1:]], VERMILLION, 14.0)
    stage.figure(
        path,
        [visits.image(), mesh.image()],
        ["The boxes, line by line", "The mesh after %d of 1,000 points" % limit],
        key=[
            (BLUE, "line", "to the next box"),
            (VERMILLION, "line", "back"),
            (GREEN, "dot", "first box"),
            (INK, "dot", "last box"),
            (ORANGE, "face", "long triangles"),
            (VERMILLION, "dot", "last point"),
        ],
    )
    return {"limit": limit, "long": long, "triangles": total}


def draw_visits(panel, run, width=2.5, size=7.0):
    """A line through the middles of the boxes as visited; steps that jump in another colour."""
    centres = run.boxes.mean(axis=1)
    far = meshes.jumps(run.boxes)
    steps = numpy.arange(len(centres) - 1)
    for which, colour in ((~far, BLUE), (far, VERMILLION)):
        panel.lines(centres, [[k, k + 1] for k in steps[which]], colour, width)
        panel.arrows(centres[:-1][which], centres[1:][which], colour, size)
    panel.points(centres, BLUE, 2 * width)
    panel.points(centres[:1], GREEN, 4 * width)
    panel.points(centres[-1:], INK, 4 * width)
    return int(far.sum())


def multi_grid(path):
    """Figure 1: the boxes are divided where points are crowded, and visited line by line."""
    points = meshes.source("Mixed", 250, 3)
    run = meshes.triangulate(points, Nmax=16, **GRIDS)
    spread = over(run.boxes, 560)
    spread.boxes(run.boxes, GREY)
    spread.points(run.xy, INK, 6.0)
    visits = over(run.boxes, 560)
    visits.boxes(run.boxes, GREY)
    far = draw_visits(visits, run)
    stage.figure(
        path, [spread.image(), visits.image()],
        ["Boxes are divided where it is crowded", "All boxes, line by line"],
        key=[(BLUE, "line", "to a neighbour"), (VERMILLION, "line", "to a box that is no neighbour"),
             (GREEN, "dot", "first box"), (INK, "dot", "last box")])  # fmt: skip
    return {"boxes": len(run.boxes), "jumps": far, "levels": int(run.levels.max())}


def far_apart(path):
    """Figure 4: two points that follow each other, and the triangles between them."""
    points = meshes.source("Uniform", 1000, 5)
    whole = meshes.triangulate(points, **LINES)
    way = whole.xy[whole.order]
    most = (0, None, None)
    for k in first_of_boxes(whole, 300, 700):
        before = meshes.triangulate(points, k, **LINES)
        crossed = meshes.walked(before.xy, before.triangles, way[k - 1], way[k])
        near = numpy.hypot(*(way[k] - way[k - 1])) < 0.4  # not the return at the end of a line
        most = max(most, (int(crossed.sum()) * near, k, before), key=lambda found: found[0])
    count, k, before = most
    crossed = meshes.walked(before.xy, before.triangles, way[k - 1], way[k])
    middle = (way[k - 1] + way[k]) / 2
    corners = before.xy[before.triangles[crossed]].reshape(-1, 2)
    reach = max(0.3, numpy.abs(corners - middle)[:, 0].max() + 0.02)
    panel = Panel(middle - [reach, 0.2], middle + [reach, 0.2], 1100, 0.0)
    panel.boxes(before.boxes, PALE, 2.5)
    panel.faces(before.xy, before.triangles[crossed], LIGHT_BLUE)
    panel.mesh(before.xy, before.triangles, GREY, 1.5)
    panel.points(way[:k], INK, 8.0)
    panel.way(way[k - 1 : k + 1], BLUE, 4.0)
    panel.points(way[k - 1][None], BLUE, 20.0)
    panel.points(way[k][None], VERMILLION, 20.0)
    stage.figure(
        path, [panel.image()], [""],
        key=[(BLUE, "dot", "the point before"), (VERMILLION, "dot", "the next point"),
             (LIGHT_BLUE, "face", "triangles on the way"), (PALE, "line", "boxes")])  # fmt: skip
    long = meshes.aspect_ratios(before.xy, before.triangles[crossed]) > meshes.LONG
    return {"crossed": int(count), "place": k, "long": int(long.sum())}


def first_of_boxes(run, low, high):
    """Places in the order at which a new box begins."""
    begins = numpy.cumsum(run.counts)
    return [int(k) for k in begins if low <= k < high]


# --- the curve ------------------------------------------------------------------------------------


def hilbert(path):
    """Figure 5: orders 1 to 3, as the filter walks through lattices."""
    panels = []
    for count in (64, 256, 1024):
        run = meshes.triangulate(meshes.source("Lattice", count), Nmax=16, **BARE)
        panel = over(run.boxes, 400)
        panel.boxes(run.boxes, PALE, 2.0)
        draw_visits(panel, run, 4.0, 10.0 if count < 1024 else 7.0)
        panels.append(panel.image())
    stage.figure(
        path, panels, ["Order 1: 4 boxes", "Order 2: 16 boxes", "Order 3: 64 boxes"],
        key=[(GREEN, "dot", "first box"), (INK, "dot", "last box")])  # fmt: skip
    return {}


def jump(path):
    """Figures 6 and 8: the curve in divided boxes, not turned and turned."""
    points = meshes.source("Mixed", 250, 4)
    panels, numbers = [], {}
    for name, settings in (("off", UNTURNED), ("on", BARE)):
        run = meshes.triangulate(points, Nmax=16, **settings)
        panel = over(run.boxes, 560)
        panel.boxes(run.boxes, PALE, 2.0)
        panel.points(run.xy, GREY, 5.0)
        numbers["jumps_" + name] = draw_visits(panel, run, 3.5, 8.0)
        panels.append(panel.image())
        many = meshes.triangulate(meshes.source("Mixed", MANY), **settings)
        numbers["np_" + name], numbers["nr_" + name] = many.np, many.nr
    stage.figure(
        path,
        panels,
        [
            "Gene off: %d jumps" % numbers["jumps_off"],
            "Gene on: %s" % ("no jump" if not numbers["jumps_on"] else numbers["jumps_on"]),
        ],
        key=[
            (BLUE, "line", "to a neighbour"),
            (VERMILLION, "line", "jump"),
            (GREEN, "dot", "first box"),
            (INK, "dot", "last box"),
        ],
    )
    return numbers


def adaptive(path):
    """The curve is as fine as the points are crowded."""
    panels = []
    for name in ("Spiral", "Mixed"):
        run = meshes.triangulate(meshes.source(name, 2000), Nmax=16, **BARE)
        panel = over(run.boxes, 560, 0.01)
        panel.boxes(run.boxes, PALE, 1.0)
        panel.points(run.xy, GREY, 3.0)
        panel.way(run.boxes.mean(axis=1), BLUE, 2.0)
        panels.append(panel.image())
    stage.figure(
        path,
        panels,
        ["Spiral", "Mixed"],
        key=[(PALE, "line", "boxes"), (BLUE, "line", "the curve through them")],
    )
    return {}


# --- control points -------------------------------------------------------------------------------


def hull(path):
    """Figure 3: long triangles at the hull of a mesh that grows along the curve."""
    points = meshes.source("Uniform", 400, 7)
    panels = []
    for limit in (40, 110, 240):
        run = meshes.triangulate(points, limit, **BARE)
        panel = over(run.xy, 400)
        half_done(panel, run)
        panel.points(run.xy[run.order], INK, 5.0)
        panel.points(run.xy[run.order[-1:]], VERMILLION, 14.0)
        panels.append(panel.image())
    stage.figure(
        path, panels, ["40 of 400 points", "110 points", "240 points"],
        key=[(ORANGE, "face", "long triangles"), (VERMILLION, "dot", "the last point")])  # fmt: skip
    return {}


def control_points(path):
    """Figures 9a and 9b, and what this filter does by default: 2,000 of 10,000 points."""
    points = meshes.source("Uniform", 10000)
    panels, numbers = [], {}
    for name, settings in (("off", BARE), ("first", PAPERS), ("every", DEFAULT)):
        run = meshes.triangulate(points, 2000, **settings)
        panel = over(run.xy, 440, 0.01)
        long, total = half_done(panel, run)
        panels.append(panel.image())
        whole = meshes.triangulate(points, **settings)
        numbers.update({"np_" + name: whole.np, "nr_" + name: whole.nr, "long_" + name: 100.0 * long / total})
    titles = [
        "%s\nNP %.2f, NR %.2f" % (words, numbers["np_" + name], numbers["nr_" + name])
        for name, words in (("off", "No control points"), ("first", "First level"), ("every", "Every level"))
    ]
    stage.figure(path, panels, titles, key=[(ORANGE, "face", "long triangles")])
    return numbers


def film(path):
    """The mesh as it grows, without control points and with them at every level."""
    points = meshes.source("Mixed", 5000)
    limits = (50, 500, 2000, 0)
    panels = []
    for settings in (BARE, DEFAULT):
        for limit in limits:
            run = meshes.triangulate(points, limit, **settings)
            panel = over(run.xy, 330, 0.01)
            panel.mesh(run.xy, run.triangles, GREY, 1.0)
            tail = run.xy[run.order[-max(6, len(run.order) // 25) :]]
            panel.way(tail, BLUE, 2.5)
            panel.points(tail[-1:], VERMILLION, 7.0)
            panels.append(panel.image())
    titles = [
        "%s\n%s" % (words, "{:,} points".format(limit) if limit else "all 5,000 points")
        for words in ("No control points", "Every level")
        for limit in limits
    ]
    stage.figure(
        path, panels, titles, 4,
        key=[(BLUE, "line", "the latest points"), (VERMILLION, "dot", "the last point")])  # fmt: skip
    return {}


def rank(path):
    """When each point comes, as its colour."""
    points = meshes.source("Mixed", 5000)
    panels = []
    for settings in (LINES, BARE, PAPERS, DEFAULT):
        run = meshes.triangulate(points, **settings)
        panel = over(run.xy, 440, 0.02)
        share = numpy.linspace(0.0, 1.0, len(run.order))
        panel.points(run.xy[run.order[::-1]], INK, 5.0, share[::-1])  # the first on top
        panels.append(panel.image())
    stage.figure(
        path, panels,
        ["Regular grid", "Hilbert curve, no control points",
         "Control points: first level", "Control points: every level"], 2,
        key=[(RAMP[0], "dot", "first"), (RAMP[2], "dot", "half-way"), (RAMP[4], "dot", "last")])  # fmt: skip
    return {}


def distributions(path):
    """Figure 10, and the lattice."""
    names = ("Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed", "Lattice")
    panels = []
    for name in names:
        run = meshes.triangulate(meshes.source(name, 10000), **DEFAULT)
        centre = (run.xy.min(axis=0) + run.xy.max(axis=0)) / 2
        reach = numpy.ptp(run.xy, axis=0).max() / 2
        panel = Panel(centre - reach, centre + reach, 330)
        panel.points(run.xy, INK, 2.0)
        panels.append(panel.image())
    stage.figure(path, panels, list(names), 4)
    return {}


def ledger(_):
    """How many triangles each order builds and removes again, and how many of them are long. No picture."""
    source = meshes.source("Uniform", STEPPED, 7)
    told = {"points": STEPPED}
    for key, settings in (("rg", LINES), ("off", BARE), ("first", PAPERS), ("every", DEFAULT)):
        removed = long = 0
        before = meshes.triangulate(source, 3, **settings)
        for limit in range(4, STEPPED + 1):
            after = meshes.triangulate(source, limit, **settings)
            gone = before.triangles[meshes.without(before.triangles, after.triangles)]
            removed += len(gone)
            long += int((meshes.aspect_ratios(before.xy, gone) > meshes.LONG).sum())
            before = after
        told.update({"removed_" + key: removed, "long_" + key: long, "share_" + key: 100.0 * long / removed})
    return told


def work(path, paper):
    """NP and NR of each order for each distribution, counted, beside the paper's."""
    rows = {}
    for name in plots.DISTRIBUTIONS:
        points = meshes.source(name, COUNTED)
        for system, settings in (("RG", LINES), ("MG", GRIDS), ("HG", PAPERS), (plots.EVERY, DEFAULT)):
            np, nr = meshes.count_work(points, **settings)
            rows[COUNTED, name, system] = {"np": np, "nr": nr}
    plots.work(path, rows, paper, COUNTED)
    told = {"points": COUNTED}
    for system, key in (("RG", "rg"), ("MG", "mg"), ("HG", "hg"), (plots.EVERY, "every")):
        for column in ("np", "nr"):
            values = [rows[COUNTED, name, system][column] for name in plots.DISTRIBUTIONS]
            told["%s_%s" % (column, key)] = "%.2f to %.2f" % (min(values), max(values))
    return told


FIGURES = {
    "one-point": one_point,
    "order": order,
    "regular-grid": regular_grid,
    "far-apart": far_apart,
    "multi-grid": multi_grid,
    "hilbert": hilbert,
    "jump": jump,
    "adaptive": adaptive,
    "hull": hull,
    "control-points": control_points,
    "film": film,
    "rank": rank,
    "distributions": distributions,
    "ledger": ledger,
}


def figures(paper):
    """{name: function(path)}; `paper` has the rows of the paper's tables, see plots.Results."""
    return dict(FIGURES, work=lambda path: work(path, paper))
