# SPDX-License-Identifier: BSD-3-Clause
"""The engine's part of it (Filters/Engine/Interface/ahd_tiles.h), as Python has it: a plan of leaves and nodes, and
what is done with each. Each thread has a `Leaves` of its own; the same plan, bytes and points give the same bytes in
each."""

from __future__ import annotations

import ctypes
from typing import List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .._interface import FILL_EVEN_ODD, Bytes, Places, address_of, array_type, described
from .._library import Job
from .._raster import Raster
from ._lines import Chains


_CROSSING = 3  #: in tiles_constraints


class Plan(NamedTuple):
    """Where the leaves are, and which nodes join them."""

    saved: np.ndarray  #: uint8: for `load`
    counts: np.ndarray  #: (leaves,) points of each
    parents: np.ndarray  #: (leaves + nodes,) the node that joins the part; -1 of the last one
    bounds: np.ndarray  #: (2, 2) of all points

    @property
    def begins(self) -> np.ndarray:
        """(leaves + 1,) the number of the first point of each leaf, in the order of the leaves."""
        return np.concatenate(([0], np.cumsum(self.counts)))

    def above(self, part: int) -> List[int]:
        """The nodes above a part, the root last."""
        found = []
        while self.parents[part] >= 0:
            part = int(self.parents[part])
            found.append(part)
        return found


class Leaves(Job):
    """The calls of ahd_tiles.h."""

    # --- the plan ---

    def begin(self, bounds: Optional[np.ndarray]) -> None:
        """`bounds`: a guess of xmin, xmax, ymin, ymax, or None."""
        guess = None if bounds is None else np.ascontiguousarray(bounds, np.float64)
        self._call("ahd_tiles_begin", None if guess is None else address_of(guess))

    def count_points(self, points: np.ndarray) -> None:
        self._call("ahd_tiles_count", described("points", points), arrays=(points,))

    def end_pass(self, most: int, extent: Optional[Sequence[float]]) -> bool:
        """Is another pass over the points needed?"""
        again = ctypes.c_int32()
        area = None if extent is None else np.array(extent, np.float64)
        self._call("ahd_tiles_plan", most, None if area is None else address_of(area), again)
        return bool(again.value)

    def plan(self) -> Plan:
        return Plan(self.array("tiles_plan", np.uint8).ravel(), self.array("tiles_counts", np.int64),
                    self.array("tiles_parents", np.int64), self.array("tiles_bounds", np.float64))  # fmt: skip

    def set_lines(self, chains: Chains) -> None:
        """Lines and loops become part of the plan; loops keep the area inside an odd number of them."""
        xy, offsets = np.ascontiguousarray(chains.points[:, :2]), chains.offsets
        given = address_of(xy), address_of(offsets), chains.lines, len(offsets) - 1, FILL_EVEN_ODD
        self._call("ahd_tiles_lines", *given, arrays=(xy, offsets))

    def load(self, saved: np.ndarray) -> None:
        self._call("ahd_tiles_load", address_of(saved), saved.nbytes, arrays=(saved,))

    def leaf_of(self, points: np.ndarray) -> np.ndarray:
        made = np.empty(len(points), np.int32)
        self._call("ahd_tiles_leaf_of", described("points", points), address_of(made), arrays=(points, made))
        return made

    def cells(self, leaf: int, raster: Raster) -> Tuple[int, int, int, int]:
        """First row, first column, rows and columns of the cells that are the leaf's."""
        rows, columns = raster.shape
        at = Places(None, 0, raster.origin, raster.spacing, columns, rows)
        piece = array_type(ctypes.c_uint64, 4)()
        self._call("ahd_tiles_cells", leaf, at, piece)
        return piece[1], piece[0], piece[3], piece[2]

    # --- visits ---

    def visit(self, leaf: int, points: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
        """The border of a leaf with all of its points, (n, 3), and what `surface` needs of it."""
        self._call("ahd_tiles_visit", leaf, described("points", points), None, arrays=(points,))
        return self.array("tiles_border", np.uint8), self.array("tiles_own", np.uint8)

    def merge(self, node: int, borders: Sequence[np.ndarray]) -> Tuple[np.ndarray, np.ndarray]:
        """The border of a node, and what it shares with the leaves below."""
        self._call("ahd_tiles_merge", node, _bytes(borders), len(borders), arrays=borders)
        return self.array("tiles_border", np.uint8), self.array("tiles_share", np.uint8)

    def listed(self, leaf: int, shares: Sequence[np.ndarray]) -> np.ndarray:
        """The numbers of the points of other leaves that this one needs. `shares`: of the nodes above it."""
        self._call("ahd_tiles_list", leaf, _bytes(shares), len(shares), arrays=shares)
        return self.array("tiles_list_ids", np.int64)

    def segments_crossing(self, shares: Sequence[np.ndarray]) -> int:
        """How many segments of lines and loops are left out, as they cross an earlier one. There are lines or loops.
        `shares`: of the nodes above leaf 0."""
        self.listed(0, shares)
        return int(self.array("tiles_constraints", np.int64)[_CROSSING])

    def surface(self, leaf: int, points: np.ndarray, own: np.ndarray, shares: Sequence[np.ndarray], longest: float
                ) -> Tuple[np.ndarray, bool]:  # fmt: skip
        """The same with lines and loops, which also makes the next `triangulate` have the triangles that these and a
        longest edge leave: are there any?"""
        self.set(maximum_edge_length=longest)
        given = leaf, described("points", points), None, _bytes([own]), _bytes(shares), len(shares)
        self._call("ahd_tiles_surface", *given, arrays=(points, own, *shares))
        self.set(maximum_edge_length=0)
        triangles = self.array("tiles_surface", np.int64).reshape(-1, 3)
        self.set_array("surface", triangles)
        self.set_array("surface_edges", self.array("tiles_surface_edges", np.uint8))
        return self.array("tiles_list_ids", np.int64), len(triangles) > 0

    def triangulate(self, points: np.ndarray, bounds: np.ndarray) -> None:
        """A leaf's points and, behind them, those of its list, (n, 3). `bounds`: of all points."""
        self.set_array("points", points)
        self.set_array("rank_bounds", bounds)
        self.run()

    def values(self, raster: Raster, window: Tuple[int, int, int, int], z: np.ndarray, method: int) -> np.ndarray:
        """(rows, columns) of the cells of a window of a raster, after `triangulate`."""
        row, column, rows, columns = window
        self.set(sample_first_row=row, sample_first_column=column)
        piece = Raster(raster.origin, raster.spacing, (rows, columns))
        return self.sample(piece, [z], method=method, has_mask=False).values[0].reshape(rows, columns)


def _bytes(arrays: Sequence[np.ndarray]) -> ctypes.Array[Bytes]:
    made = array_type(Bytes, len(arrays))()
    for one, array in zip(made, arrays):
        one.data, one.size = address_of(array) if array.size else None, array.nbytes
    return made  # type: ignore[no-any-return]
