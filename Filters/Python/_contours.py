# SPDX-License-Identifier: BSD-3-Clause
"""A linear surface over triangles, cut at levels.

Its nodes are the points, and the places where edges cross levels: each is one node, found by its edge and level, with
coordinates that are computed once. Which parts there are and where they meet is decided by comparing values alone.
"""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from . import _library as library
from ._interface import MEMORY_LIMIT, SAY_REFUSAL, WORDS_OF_NUMPY, OutOfMemory, available_memory, say
from ._made import frozen
from ._raster import real_numbers
from ._results import Contours, Lines, Outline

#: As many triangles at a time as the cache has room for.
BLOCK = 1 << 14
# Upper bounds of what is held at once, the engine's own apart: for a point, a triangle, a triangle of a block, a node
# that is no point, a part. Their corners are ids of 4 or 8 bytes, and held twice while they are put together.
_POINT_BYTES, _TRIANGLE_BYTES, _BLOCK_BYTES, _NODE_BYTES, _PART_BYTES = 88, 80, 100, 180, 32


def levels_of(given: Any, filled: bool) -> np.ndarray:
    """Ascending, each once. TypeError, ValueError."""
    levels = real_numbers("levels", given)
    if levels.ndim != 1:
        raise TypeError("levels must be a sequence of numbers, such as numpy.linspace(0, 100, 11), not %r" % (given,))
    if np.isnan(levels).any():
        raise ValueError("levels must be numbers, but level %d is NaN" % np.flatnonzero(np.isnan(levels))[0])
    made: np.ndarray = np.unique(levels)
    if len(made) < 1 + filled:
        raise ValueError(
            "there must be two different levels or more, with bands between them" if filled else
            "there must be a level"
        )  # fmt: skip
    return made


def fractions(level: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Where the level is on the way from `low` to `high`, which are finite: from 0 to 1."""
    with np.errstate(over="ignore", under="ignore"):
        scale = np.where(np.isinf(high - low), 0.5, 1.0)
        made: np.ndarray = (level * scale - low * scale) / (high * scale - low * scale)
    return made


def between(begin: np.ndarray, end: np.ndarray, fraction: np.ndarray) -> np.ndarray:
    """The place at this fraction of the way, within the box of both ends."""
    with np.errstate(over="ignore", under="ignore", invalid="ignore"):
        made = begin + fraction * (end - begin)
        made = np.where(np.isfinite(made), made, begin * (1 - fraction) + end * fraction)
    clipped: np.ndarray = np.clip(made, np.minimum(begin, end), np.maximum(begin, end))
    return clipped


def starts_of(counts: Any) -> np.ndarray:
    """Where each begins in a list of so many for each, and its end."""
    made = np.zeros(len(counts) + 1, np.int64)
    np.cumsum(counts, out=made[1:])
    return made


class Cut:
    """The parts of triangles between levels, in bands: those of band k are above k levels, up to the next one with it.
    A triangle that is at a level all over belongs to the band below.

    Triangles with a corner whose value is not finite are left out. `heights`: one for each point; `levels`: ascending.
    """

    def __init__(self, triangles: np.ndarray, heights: np.ndarray, levels: np.ndarray, limit: int) -> None:
        self.heights, self.levels = heights, levels
        self.below = np.searchsorted(levels, heights, "left")  # so many levels are lower than the point
        self.within = np.searchsorted(levels, heights, "right")  # and so many are not higher
        self._find_nodes(triangles, limit)

    def _find_nodes(self, triangles: np.ndarray, limit: int) -> None:
        """Of an edge that crosses levels those with them are numbered one after the other."""
        count, isFinite = len(self.heights), np.isfinite(self.heights)
        found: List[Tuple[np.ndarray, ...]] = []
        begins = range(0, max(len(triangles), 1), BLOCK)
        for block in (triangles[begin : begin + BLOCK] for begin in begins):
            found.append(self._crossing(block[isFinite[block].all(axis=1)]))
        #: The lowest corner comes first.
        self.triangles, self.parts, keys, crossed = (np.concatenate(arrays) for arrays in zip(*found))
        crossed += 3 * np.repeat(starts_of([len(each[0]) for each in found])[:-1], [len(each[3]) for each in found])
        del found
        keys, edges = np.unique(keys, return_inverse=True)
        self.lows, self.highs = np.divmod(keys, max(count, 1))
        self.counts = self.below[self.highs] - self.within[self.lows]
        starts = starts_of(self.counts)
        self.nodes = count + int(starts[-1])
        self.dtype = np.dtype(np.int32 if self.nodes < 1 << 31 else np.int64)
        parts = int(self.parts.sum())
        self.bytes = (_POINT_BYTES * count + _TRIANGLE_BYTES * len(self.triangles) + _NODE_BYTES * int(starts[-1])
                      + _BLOCK_BYTES * min(len(self.triangles), BLOCK)
                      + (_PART_BYTES + 8 * self.dtype.itemsize) * parts)  # fmt: skip
        self._check_memory(limit, parts)
        #: What makes the number of a level that of the node on the edge from each corner to the next.
        self.bases: np.ndarray = np.zeros((len(self.triangles), 3), np.int64)
        self.bases.ravel()[crossed] = (count + starts[:-1] - self.within[self.lows])[edges.ravel()]

    def _crossing(self, triangles: np.ndarray) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Of some triangles: the corners, from the lowest on; how many parts each has; the edges that cross levels, by
        their lower and higher end, and their numbers among the edges from each corner to the next."""
        first = self.heights[triangles].argmin(axis=1)
        triangles = np.take_along_axis(triangles, (first[:, None] + np.arange(3)) % 3, axis=1)
        ends = triangles[:, [1, 2, 0]]
        isUp = self.heights[triangles] <= self.heights[ends]
        low, high = np.where(isUp, triangles, ends).ravel(), np.where(isUp, ends, triangles).ravel()
        crossed = np.flatnonzero(self.below[high] > self.within[low])
        keys = low[crossed].astype(np.int64) * len(self.heights) + high[crossed]
        # of those below the highest corner
        parts = np.maximum(self.below[triangles].max(axis=1) - self.within[triangles[:, 0]], 0) + 1
        return triangles, parts, keys, crossed

    def _check_memory(self, limit: int, parts: int) -> None:
        allowed = limit or available_memory()
        if self.bytes > allowed:
            facts: Dict[str, Any] = {"reason": MEMORY_LIMIT, "doing": "outlining", "polygons": parts,
                                     "memory_limit": limit, "memory_estimate": self.bytes,
                                     "memory_allowed": allowed}  # fmt: skip
            raise OutOfMemory(next(iter(say(SAY_REFUSAL, WORDS_OF_NUMPY, facts).values())), MEMORY_LIMIT)

    def levels_of_nodes(self) -> np.ndarray:
        """The number of the level that each node is at; -1: none."""
        return np.concatenate((np.where(self.within > self.below, self.below, -1), self._crossed()[1]))

    def _crossed(self) -> Tuple[np.ndarray, np.ndarray]:
        """The edge and level of each node that is no point."""
        starts = starts_of(self.counts)
        edges = np.repeat(np.arange(len(self.counts)), self.counts)
        return edges, np.arange(starts[-1]) - (starts[:-1] - self.within[self.lows])[edges]

    def places(self, points: np.ndarray) -> np.ndarray:
        """Those of all nodes, for points in the plane or in space. An edge is followed from its lower end."""
        edges, numbers = self._crossed()
        low, high = self.lows[edges], self.highs[edges]
        there = fractions(self.levels[numbers], self.heights[low], self.heights[high])
        made: np.ndarray = np.concatenate((
            np.asarray(points, np.float64),
            between(points[low].astype(np.float64), points[high].astype(np.float64), there[:, None])))  # fmt: skip
        return made

    def cells(self, lowest: int, highest: int, atLowest: int) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The parts of these bands, the last one with them, as polygons: the nodes at their corners, counterclockwise
        and one after the other, the offset where each begins, and their bands. `atLowest`: the band of triangles that
        are at the lowest level all over."""
        corners: List[np.ndarray] = [np.zeros(0, self.dtype)]
        sizes: List[np.ndarray] = [np.zeros(0, np.int64)]
        bands: List[np.ndarray] = [np.zeros(0)]
        for begin in range(0, len(self.triangles), BLOCK):
            slots, band = self._parts(slice(begin, begin + BLOCK), lowest, highest, atLowest)
            isThere = slots >= 0
            corners.append(slots[isThere].astype(self.dtype))
            sizes.append(isThere.sum(axis=1))
            bands.append(band.astype(np.float64))
        return np.concatenate(corners), starts_of(np.concatenate(sizes)), np.concatenate(bands)

    def _parts(self, block: slice, lowest: int, highest: int, atLowest: int) -> Tuple[np.ndarray, np.ndarray]:
        """The corners of the parts of some triangles, (p, 5), -1 where there is none, and the bands.

        From the lowest corner to the highest one there is an edge, which crosses all levels between them, and there are
        two edges with the middle corner between. A part lies between its lower and its upper level, which end at both
        ways; the first has the lowest corner in place of a level, the last the highest.

        Those on the way of one edge come first: counterclockwise, if the highest corner is the second one.
        """
        triangles, bases, parts = self.triangles[block], self.bases[block], self.parts[block]
        rows = np.arange(len(triangles))
        isThird = self.heights[triangles[:, 2]] > self.heights[triangles[:, 1]]  # is the highest corner
        highestCorner, middle = triangles[rows, 1 + isThird], triangles[rows, 2 - isThird]
        isFlat = self.heights[highestCorner] == self.heights[triangles[:, 0]]
        of = np.repeat(rows, parts)
        upper = np.arange(len(of)) - starts_of(parts)[of] + self.within[triangles[:, 0]][of]
        band = np.where(isFlat[of], self.below[triangles[:, 0]][of], upper)
        band[isFlat[of] & (band == 0) & (upper == 1)] = atLowest
        wanted = np.flatnonzero((band >= lowest) & (band <= highest))
        of, upper, band = of[wanted], upper[wanted], band[wanted]
        lower, isThird = upper - 1, isThird[of]
        isFirst = upper == self.within[triangles[of, 0]]
        isLast = isFlat[of] | (upper == self.below[highestCorner[of]])
        middleBelow, middleWithin = self.below[middle][of], self.within[middle][of]

        def straight(level: np.ndarray) -> np.ndarray:
            made: np.ndarray = bases[of, np.where(isThird, 2, 0)] + level
            return made

        def bent(level: np.ndarray) -> np.ndarray:
            edge = np.where(level >= middleWithin, 1, np.where(isThird, 0, 2))
            isAtMiddle = (level >= middleBelow) & (level < middleWithin)
            made: np.ndarray = np.where(isAtMiddle, middle[of], bases[of, edge] + level)
            return made

        isMiddleIn = (isFirst | (lower < middleBelow)) & (isLast | (upper >= middleWithin))
        slots = np.stack((
            np.where(isFirst, triangles[of, 0], straight(lower)),
            np.where(isLast, highestCorner[of], straight(upper)),
            np.where(isLast, -1, bent(upper)),
            np.where(isMiddleIn, middle[of], -1),
            np.where(isFirst, -1, bent(lower))), axis=1)  # fmt: skip
        slots[isThird] = slots[isThird, ::-1]
        return slots, band


class Rings:
    """The rings of the parts, by band: polygons of joined parts. `job`: with its limit of memory; it is used up."""

    def __init__(self, cut: Cut, cells: Tuple[np.ndarray, np.ndarray, np.ndarray], places: np.ndarray, job: library.Job,
                 dtype: np.dtype[Any]) -> None:  # fmt: skip
        corners, offsets, bands = cells
        job.set(other_memory=cut.bytes)
        for name, array in (("points", places), ("cells", corners), ("cell_offsets", offsets), ("cell_groups", bands)):
            job.set_array(name, array)
        job.outline(directed=True)
        names = ("outline_points", "outline_rings", "outline_polygons")
        dtype = np.dtype(np.result_type(dtype, cut.dtype))
        self.corners, self.rings, self.polygons = (job.array(name, dtype) for name in names)
        self.bands = bands[job.array("outline_cells", np.int64)]  # of each polygon, ascending
        library.give_back(job)

    def _of_band(self, band: int) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Its corners, rings and polygons."""
        begin, end = np.searchsorted(self.bands, (band, band + 1))
        polygons = self.polygons[begin : end + 1]
        rings = self.rings[polygons[0] : polygons[-1] + 1]
        return self.corners[rings[0] : rings[-1]], rings - rings[0], polygons - polygons[0]

    def band(self, band: int, points: np.ndarray) -> Outline:
        return Outline(points, *(frozen(array) for array in self._of_band(band)))

    def lines(self, band: int, points: np.ndarray, levels: np.ndarray) -> Lines:
        """Where the rings of the band run along its lower level. `levels`: those of the nodes."""
        corners, rings, _ = self._of_band(band)
        ring = np.repeat(np.arange(len(rings) - 1), np.diff(rings))
        begin, end = rings[ring], rings[ring + 1]

        def after(k: np.ndarray) -> np.ndarray:
            return np.where(k + 1 == end, begin, k + 1)

        here = np.arange(len(corners), dtype=rings.dtype)
        isAt = levels[corners] == band - 1
        isOn = isAt & isAt[after(here)]  # the edge from each corner
        # each ring from behind its first edge that is none, so that no line goes across where it begins
        firstOff = np.minimum.reduceat(np.where(isOn, len(corners), here), rings[:-1]) if len(corners) else rings[:0]
        isClosed = firstOff == len(corners)
        shift = np.where(isClosed, 0, firstOff + 1 - rings[:-1])[ring]
        order = begin + (here - begin + shift) % (end - begin)
        corners, isOn = corners[order], isOn[order]
        edges = np.flatnonzero(isOn)
        # a line ends where the next edge is none, or of another ring
        isEnd = np.ones(len(edges), bool)
        isEnd[:-1] = (np.diff(edges) != 1) | (np.diff(ring[edges]) != 0)
        ends = corners[after(here)[edges[isEnd]]]
        made = np.insert(corners[edges], np.flatnonzero(isEnd) + 1, ends)
        offsets = np.concatenate((np.zeros(1, rings.dtype), np.flatnonzero(isEnd) + 1 + np.arange(1, len(ends) + 1)))
        return Lines(points, frozen(made), frozen(offsets.astype(rings.dtype)))


def contours(cut: Cut, places: np.ndarray, plane: Optional[np.ndarray], job: library.Job, filled: bool, dtype: Any
             ) -> Contours:  # fmt: skip
    """`places`: of the points, as results have them; `plane`: in the plane, if that is not the same; `job`: see
    Rings."""
    levels = cut.levels
    last = len(levels) - 1 if filled else len(levels)
    points = frozen(cut.places(places))
    cells = cut.cells(1, last, 1 if filled else 0)
    rings = Rings(cut, cells, points if plane is None else cut.places(plane), job, np.dtype(dtype))
    if filled:
        return Contours(frozen(levels), tuple(rings.band(k, points) for k in range(1, last + 1)))
    at = cut.levels_of_nodes()
    return Contours(frozen(levels), tuple(rings.lines(k, points, at) for k in range(1, last + 1)))
