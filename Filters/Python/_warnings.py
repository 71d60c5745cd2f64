# SPDX-License-Identifier: BSD-3-Clause
"""What a run has to say, though it succeeded."""

from __future__ import annotations

import sys
import warnings
from typing import Iterator, Mapping

Counts = Mapping[str, int]


class DelaunayWarning(UserWarning):
    """Something of the input is not in the triangulation, or there is no triangle: which, why, and how many.

    `warnings.simplefilter("error", DelaunayWarning)` makes errors of them.
    """


def _number(count: int, one: str) -> str:
    """"1 point", "2 points"."""
    return "%d %s%s" % (count, one, "" if count == 1 else "s")


def _of_points(counts: Counts, where: str) -> Iterator[str]:
    points = counts["points"]
    if counts["not_finite"]:
        yield "%d of %d points were left out, since %s; the first is point %d." % (
            counts["not_finite"], points, where, counts["first_not_finite"])  # fmt: skip
    if counts["odd_z"]:
        yield (
            "%d of %d points have a z that is NaN or infinite. They are part of the triangulation, which is computed "
            "in x and y." % (counts["odd_z"], points)
        )
    if counts["stacked"]:
        yield (
            "%d of %d points have the x and y of others and lie above or below them: of each stack one point is in "
            "the surface (see `duplicates`). For a wall, plane='best_fit'." % (counts["duplicates"], points)
        )


def _of_no_triangle(counts: Counts) -> Iterator[str]:
    inserted = counts["inserted"]
    if counts["delaunay_triangles"] == 0 and inserted + counts["not_finite"] > 0:
        few = inserted < 3
        if counts["beyond_limit"]:
            yield "There is no triangle yet: insertion_limit has only the first %d of %d distinct points inserted." % (
                inserted, inserted + counts["beyond_limit"])  # fmt: skip
        else:
            why = "there are fewer than three distinct points" if few else "all distinct points are collinear"
            merged = ", of which tolerance merged %d" % counts["merged_points"] if counts["merged_points"] else ""
            space = (
                ""
                if counts["on_one_line"] or not inserted
                else " They are not collinear in space: see plane='best_fit'."
            )
            yield "There is no triangle, because %s: %d among %d%s.%s" % (
                why, inserted, counts["points"], merged, space)  # fmt: skip
    elif counts["delaunay_triangles"] and counts["kept_triangles"] + counts["trimmed_triangles"] == 0:
        yield "There is no triangle, because the loops keep none of the %d triangles (see `fill_rule`)." % (
            counts["delaunay_triangles"])  # fmt: skip
    elif counts["kept_triangles"] and counts["cells"] == 0:
        yield (
            "Nothing is left: alpha and maximum_edge_length leave none of %s, no line and no vertex. Larger numbers "
            "keep more." % _number(counts["kept_triangles"], "triangle")
        )


def _of_rim(counts: Counts, area: float) -> Iterator[str]:
    trimmed = counts["trimmed_triangles"]
    if counts["bare_vertices"] or area > 0.1:
        yield (
            "Trimming the rim took %d of %d triangles away, %.0f %% of the area in the plane, and left %s without a "
            "triangle. rim='convex_hull' keeps them all."
            % (trimmed, trimmed + counts["kept_triangles"], 100 * min(1.0, max(0.0, area)),
               _number(counts["bare_vertices"], "point"))
        )


def _of_constraints(counts: Counts, split: bool) -> Iterator[str]:
    if counts["source_points"] and not counts["segments"]:
        yield (
            "The source_points constrain nothing: there are no segments, lines or loops of two points or more. "
            "They are points like the others."
        )
    if counts["points_off_surface"]:
        yield "%d of %d source points lie outside the surface and keep their own z (see `source_heights`)." % (
            counts["points_off_surface"], counts["source_points"])  # fmt: skip
    what = " segments or pieces of segments" if split else " of %d segments" % counts["segments"]
    unfilled = counts["unfilled_loops"]
    loops = (
        " %s nothing, since a segment is missing." % ("1 loop bounds" if unfilled == 1 else "%d loops bound" % unfilled)
        if unfilled
        else ""
    )
    if counts["segments_crossing"]:
        yield (
            "%d%s were left out, since they cross others that come before them; the first is in chain %d and crosses "
            "chain %d (segments come before lines, lines before loops).%s"
            % (counts["segments_crossing"], what, counts["first_crossing_cell"], counts["first_crossed_cell"], loops)
        )
        loops = ""
    bent = counts["bent_segments"]
    if bent:
        words = ("segment bends", "it") if bent == 1 else ("segments bend", "them")
        yield (
            "%d %s by rounding, led through a point that is not exactly on %s; the first is in chain %d (segments come "
            "before lines, lines before loops)." % (bent, *words, counts["first_bent_cell"])
        )
    if counts["segments_without_vertex"] and counts["delaunay_triangles"]:
        yield (
            "%d%s are no constraints, since an end of theirs is a point that is not finite, is skipped or lies beyond "
            "insertion_limit.%s" % (counts["segments_without_vertex"], what, loops)
        )


def warn(counts: Counts, trimmed_area: float, split: bool) -> None:
    """One DelaunayWarning for each message, in the name of the first caller outside of this package."""
    where = (
        "they have no finite place in the plane of the triangulation"
        if counts["is_projected"]
        else "their x or y is NaN or infinite"
    )
    for messages in (
        _of_points(counts, where),
        _of_no_triangle(counts),
        _of_rim(counts, trimmed_area),
        _of_constraints(counts, split),
    ):
        for message in messages:
            warnings.warn(message, DelaunayWarning, stacklevel=_depth())


def _depth() -> int:
    """The stacklevel of the first caller outside of this package, seen from warn(). By names of modules: files may have
    no path, as where the working directory was deleted."""
    inside, depth = __name__.rpartition(".")[0], 1
    frame = sys._getframe(1)
    while frame.f_back is not None and (str(frame.f_globals.get("__name__")) + ".").startswith(inside + "."):
        frame, depth = frame.f_back, depth + 1
    return depth
