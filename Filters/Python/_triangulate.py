# SPDX-License-Identifier: BSD-3-Clause
"""What `delaunay` does."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Optional, Tuple

import numpy as np

from . import _library as library
from ._geometry import constraints_of
from ._input import DEFAULTS, Request, points_of, with_heights
from ._keywords import WANTED
from ._simplified import numbers_of
from ._triangulation import Triangulation
from ._warnings import tell, warn

_IDS = frozenset((np.dtype(np.int32), np.dtype(np.int64)))  # of the machine's byte order
_OTHERS = ("points", "constraints", "source_points", "skip", "plane", "id_dtype", "want", "progress")


def _constrained(
    constraints: Any, others: Mapping[str, Any], isInSpace: bool, settings: Dict[str, Any]
) -> Tuple[Optional[np.ndarray], Dict[str, Any], Dict[str, Any]]:
    """Source points, chains and settings for constraints that bring their points. `others`: their names, and None.
    Heights that they lack are those of the surface."""
    for name, value in others.items():
        if value is not None:
            raise ValueError("constraints bring points of their own: give either these or %s" % name)
    made = constraints_of(constraints)
    if not len(made.points):
        return None, {}, {**settings, "source_heights": "own", "points_as_line": False}
    if made.points.shape[1] == 2:
        settings = {**settings, "source_heights": "surface"}
    elif settings["source_heights"] == "own" and np.isnan(made.points[:, 2]).any():
        settings = {**settings, "source_heights": "mixed"}
    return made.source(isInSpace), {"lines": made.lines, "loops": made.loops}, settings


def _with_heights(points: Any, heights: Any, settings: Dict[str, Any]) -> Any:
    """The points; heights that are a word go to the settings."""
    if not isinstance(heights, str):
        return points if heights is None else with_heights(points, heights)
    if settings["source_heights"] != DEFAULTS["source_heights"]:
        raise TypeError("delaunay() got source_heights and heights, which are two names for one argument")
    settings["source_heights"] = heights
    return points


def triangulate(settings: Dict[str, Any]) -> Triangulation:
    """`delaunay` of all its arguments by name; is left those that are one number or word each."""
    points, constraints, source_points, skip, plane, id_dtype, want, progress = map(settings.pop, _OTHERS)
    weights, keep = settings.pop("weights"), settings.pop("keep")
    chains = {name: settings.pop(name) for name in ("segments", "lines", "loops")}
    dtype = np.dtype(id_dtype)
    if dtype not in _IDS:
        raise TypeError("id_dtype must be numpy.int32 or numpy.int64, not %s" % dtype)
    wanted = (want,) if isinstance(want, str) else tuple(want)
    for name in wanted:
        if name not in WANTED:
            raise ValueError("want: %r is not one of %s" % (name, ", ".join(map(repr, WANTED))))
    if progress is not None and not callable(progress):
        raise TypeError("progress must be a function, not %r" % (progress,))
    points = _with_heights(points, settings.pop("heights"), settings)
    if constraints is not None:
        points = points_of("points", points)
        given = {**chains, "source_points": source_points}
        source_points, chains, settings = _constrained(constraints, given, points.shape[1] == 3, settings)
    request = Request(points, skip, source_points, chains, plane, settings)
    request.arrays.update(numbers_of(request, None, weights, keep))
    made = Triangulation(request, dtype, wanted, progress)
    warn(made._job, {"plane_was_chosen": 1} if request.plane_was_chosen else {})
    if request.columns == 2 and request.settings["duplicates"] != library.DUPLICATES_FIRST:
        tell(["duplicates=%r has no effect, since the points have no z: give (n, 3)" % settings["duplicates"]])
    return made
