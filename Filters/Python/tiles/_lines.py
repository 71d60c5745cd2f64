# SPDX-License-Identifier: BSD-3-Clause
"""Breaklines, and loops that bound the surface: chains of corners with heights, of GeoJSON or of geometries."""

from __future__ import annotations

import json
import os
from typing import Any, List, NamedTuple, Sequence

import numpy as np

from .._geometry import constraints_of
from ._errors import BadFile


class Chains(NamedTuple):
    """Corners one chain after the other; a loop is closed, without its first corner once more at its end."""

    points: np.ndarray  #: (m, 3)
    offsets: np.ndarray  #: (chains + 1,) int64
    lines: int  #: so many chains come first, the others are loops


def chains_of(lines: Sequence[Any], loops: Sequence[Any]) -> Chains:
    """Of paths of GeoJSON files, or of geometries as `delaunay` takes them. BadFile."""
    parts = [part for given in lines for part in _parts(given, False)]
    count = len(parts)
    parts += [part for given in loops for part in _parts(given, True)]
    offsets = np.cumsum([0, *map(len, parts)], dtype=np.int64)
    return Chains(np.concatenate(parts) if parts else np.empty((0, 3)), offsets, count)


def _parts(given: Any, areLoops: bool) -> List[np.ndarray]:
    isPath = isinstance(given, (str, os.PathLike))
    name = os.fspath(given) if isPath else "a geometry"
    try:
        found = constraints_of(_loaded(name) if isPath else given, "constraints")
    except (ValueError, TypeError, OSError) as error:
        raise BadFile(name, "cannot be read: %s" % error) from error
    points = found.points
    if points.shape[1] < 3 or not np.isfinite(points).all():
        raise BadFile(name, "has corners without z: lines and loops of tiles need heights")
    closed = [points[ids] for ids in found.loops]
    opened = [points[ids] for ids in found.lines]
    if not areLoops:
        return [*opened, *(np.concatenate((ring, ring[:1])) for ring in closed)]
    for line in opened:
        if len(line) < 4 or (line[0, :2] != line[-1, :2]).any():
            raise BadFile(name, "has a line that is not closed, and so no loop")
    return [*closed, *(line[:-1] for line in opened)]


def _loaded(path: str) -> Any:
    with open(path, encoding="utf-8") as file:
        return json.load(file)
