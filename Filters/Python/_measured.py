# SPDX-License-Identifier: BSD-3-Clause
"""What follows from the triangles of a Triangulation: who is beside whom, and sizes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Tuple

import numpy as np

from ._made import frozen
from ._results import Adjacency
from ._sampling import Sampled

if TYPE_CHECKING:
    from ._edit import Edit
else:
    Edit = Any  # which imports this


def lists_of(owners: np.ndarray, items: np.ndarray, count: int, most: int, dtype: Any) -> Adjacency:
    """For each of `count` owners the items beside its number, ascending. Requires: items from 0 to most - 1."""
    keys = owners.astype(np.int64) * most + items
    keys.sort()
    offsets = np.zeros(count + 1, dtype)
    np.cumsum(np.bincount(owners, minlength=count), out=offsets[1:])
    return Adjacency(frozen(offsets), frozen((keys % most).astype(dtype) if most else keys.astype(dtype)))


def length(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Of each vector; of any scale, and with the same bits on every system."""
    largest = np.maximum(abs(x), abs(y))
    scale = np.ldexp(1.0, np.frexp(largest)[1] - 1)  # a power of two
    x, y = x / scale, y / scale
    made: np.ndarray = np.sqrt(x * x + y * y) * scale
    return made


class Measured(Sampled):
    """The part of a Triangulation that is about its triangles as a mesh. Sizes are those in the plane of the
    triangulation, in the unit of the points, from coordinates in float64."""

    if TYPE_CHECKING:
        triangles: Any
        edges: Any
        plane_points: Any

    @property
    def vertex_neighbors(self) -> Adjacency:
        """For each point the ids of those that an edge of the triangles leads to, ascending: those of point `i` are
        ``items[offsets[i]:offsets[i + 1]]``. In scipy: `vertex_neighbor_vertices`."""

        def make() -> Adjacency:
            ends = np.concatenate((self.edges, self.edges[:, ::-1]))
            count = self._counts["points"]
            return lists_of(ends[:, 0], ends[:, 1], count, count, self._dtype)

        made: Adjacency = self._made("vertex_neighbors", make)
        return made

    @property
    def vertex_triangles(self) -> Adjacency:
        """For each point the triangles that have it as a corner, ascending: those of point `i` are
        ``items[offsets[i]:offsets[i + 1]]``."""

        def make() -> Adjacency:
            count = len(self.triangles)
            return lists_of(
                self.triangles.ravel(), np.repeat(np.arange(count), 3), self._counts["points"], count, self._dtype
            )

        made: Adjacency = self._made("vertex_triangles", make)
        return made

    def _sides(self) -> Tuple[np.ndarray, np.ndarray]:
        """From the first corner of each triangle to its others: x, (t, 2), and y."""
        x, y = (self.plane_points[:, k][self.triangles] for k in range(2))
        return x[:, 1:] - x[:, :1], y[:, 1:] - y[:, :1]

    @property
    def areas(self) -> np.ndarray:
        """(t,) float64: the area of each triangle. Its error is a rounding or two of the product of two edges: a sliver
        may have an area of 0 or just below, though it is a triangle."""

        def make() -> np.ndarray:
            x, y = self._sides()
            return frozen((x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0]) / 2)

        made: np.ndarray = self._made("areas", make)
        return made

    @property
    def edge_lengths(self) -> np.ndarray:
        """(e,) float64: the length of each of `edges`, to rounding."""

        def make() -> np.ndarray:
            x, y = (self.plane_points[:, k][self.edges] for k in range(2))
            return frozen(length(x[:, 1] - x[:, 0], y[:, 1] - y[:, 0]))

        made: np.ndarray = self._made("edge_lengths", make)
        return made

    @property
    def circumcenters(self) -> np.ndarray:
        """(t, 2) float64: the centre of the circle through the corners of each triangle. Its error, relative to the
        radius, is that of the area, relative to the area; it is infinite or NaN where that is 0. (Those of `voronoi()`
        are rounded once, each written once, and clipped.)"""

        def make() -> np.ndarray:
            x, y = self._sides()
            squares = x * x + y * y
            with np.errstate(divide="ignore", invalid="ignore"):
                half = 0.5 / (x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0])
                from_first = np.stack(
                    (squares[:, 0] * y[:, 1] - squares[:, 1] * y[:, 0],
                     squares[:, 1] * x[:, 0] - squares[:, 0] * x[:, 1]), axis=1)  # fmt: skip
                return frozen(self.plane_points[self.triangles[:, 0], :2] + from_first * half[:, None])

        made: np.ndarray = self._made("circumcenters", make)
        return made

    def edit(self) -> Edit:
        """An `Edit` that begins with these points and segments: points come, go and move, and its `done` gives what
        `delaunay` gives of the rest. ValueError for one with loops, merged or added points, limits or a plane."""
        from ._edit import Edit

        return Edit._of(self)  # type: ignore[arg-type]

    def to_matplotlib(self, mask: Any = None) -> Any:
        """This triangulation for matplotlib's `tripcolor`, `tricontourf`, `CubicTriInterpolator`, ...

        The triangle of a place is found by this package, exactly: triangulations with slivers are valid, too, for which
        matplotlib's own finder says "Triangulation is invalid". `x` and `y` are those in the plane of the
        triangulation, values are one for each of `points`.

        Parameters
        ----------
        mask : (t,) array of bool, optional
            Triangles that are not shown; `set_mask` of the result changes it.

        Returns
        -------
        matplotlib.tri.Triangulation
            Of a class of its own, whose `get_trifinder` is exact.

        Raises
        ------
        ImportError
            There is no matplotlib.
        ValueError
            There are no triangles, or `mask` is of another length.
        """
        from ._matplotlib import Shown

        return Shown(self, mask)  # type: ignore[arg-type]
