# SPDX-License-Identifier: BSD-3-Clause
"""A Triangulation as matplotlib has it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib.tri
import numpy as np

from ._results import Kind

if TYPE_CHECKING:
    from ._triangulation import Triangulation


class Finder(matplotlib.tri.TriFinder):
    """Finds triangles exactly, those that the mask leaves."""

    def __init__(self, shown: Shown) -> None:
        super().__init__(shown)
        self._shown = shown

    def _initialize(self) -> None:
        """After a change of the mask, which is looked at in each call."""

    def __call__(self, x: Any, y: Any) -> np.ndarray:
        """The triangle of each place, of the shape of x and y; -1: none."""
        x, y = np.asarray(x, np.float64), np.asarray(y, np.float64)
        if x.shape != y.shape:
            raise ValueError("x and y must be of one shape, not %s and %s" % (x.shape, y.shape))
        shown = self._shown
        kinds, found, corners = shown.made.locate(np.stack((x.ravel(), y.ravel()), axis=1))
        if shown.mask is not None:
            hidden = np.flatnonzero((found >= 0) & shown.mask[found])
            found[hidden] = self._beside(shown.mask, kinds[hidden], found[hidden], corners[hidden])
        made: np.ndarray = found.astype(np.int32).reshape(x.shape)
        return made

    def _beside(self, mask: np.ndarray, kinds: np.ndarray, found: np.ndarray, corners: np.ndarray) -> np.ndarray:
        """In place of hidden triangles those that have the place on their border; -1: none."""
        made = self._shown.made
        beside = np.full_like(found, -1)
        onEdge = np.flatnonzero(kinds == Kind.ON_EDGE)
        if len(onEdge):
            isEnd = (made.triangles[found[onEdge], :, None] == corners[onEdge, None, :2]).any(axis=2)
            across = made.neighbors[found[onEdge], (isEnd.argmin(axis=1) + 1) % 3]  # after the corner that is no end
            beside[onEdge] = np.where((across >= 0) & ~mask[across], across, -1)
        onVertex = kinds == Kind.ON_VERTEX
        if onVertex.any():
            left = np.flatnonzero(~mask)[::-1]
            first = np.full(len(self._shown.x), -1, found.dtype)
            first[made.triangles[left]] = left[:, None]
            beside[onVertex] = first[corners[onVertex, 0]]
        return beside


class Shown(matplotlib.tri.Triangulation):
    """See Triangulation.to_matplotlib()."""

    def __init__(self, made: Triangulation, mask: Any) -> None:
        if not len(made.triangles):
            raise ValueError("there are no triangles, which matplotlib needs")
        self.made = made
        x, y = made.plane_points[:, :2].T.copy()
        lost = ~(np.isfinite(x) & np.isfinite(y))  # they are in no triangle, and would take the axes' limits away
        x[lost], y[lost] = made.plane_points[made.triangles[0, 0], :2]
        super().__init__(x, y, made.triangles, mask)
        self.is_delaunay = True  # else matplotlib would turn slivers around whose area is rounded to less than 0
        self._trifinder = Finder(self)
