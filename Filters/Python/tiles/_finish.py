# SPDX-License-Identifier: BSD-3-Clause
"""What is done with each leaf when all borders are merged: its cells of the raster, and its triangles."""

from __future__ import annotations

import os
from typing import Any, Dict, List, NamedTuple, Optional, Set, Tuple

import numpy as np

from .._raster import Raster
from . import _pvtp
from ._leaves import Leaves, Plan
from ._points import records_of
from ._store import Store, sync, written
from ._tiff import Window

CELLS = 1 << 22  #: that are sampled at a time
BATCH = 1 << 20  #: points of groups that are done before files of leaves are removed, as that waits for the disk


class Wanted(NamedTuple):
    """Of a run."""

    raster: Optional[Raster]
    windows: List[Window]  #: of the leaves
    method: int
    dtype: str
    pieces: Optional[str]  #: the folder of a TIN
    names: Tuple[str, ...]  #: point data of a TIN that the files have
    hasLines: bool
    longest: float  #: edge; 0: no limit


def groups_of(plan: Plan, piece: int) -> List[range]:
    """Leaves that are done together: those of a piece of a TIN, about so many points in each; 0: each alone."""
    count, leaves = len(plan.counts), np.arange(len(plan.counts))
    if piece == 0:
        return [range(leaf, leaf + 1) for leaf in range(count)]
    pieces = max(1, round(int(plan.counts.sum()) / piece))
    of = (plan.begins[:-1] + plan.counts // 2) * pieces // max(1, int(plan.counts.sum()))
    cuts = [0, *(leaves[1:][np.diff(of) > 0]).tolist(), count]
    return [range(begin, end) for begin, end in zip(cuts, cuts[1:])]


class Finish:
    """Of one group. What it makes depends on the files of the store alone."""

    def __init__(self, store: Store, plan: Plan, kind: np.dtype, wanted: Wanted) -> None:
        self.store, self.plan, self.kind, self.wanted = store, plan, kind, wanted
        self.begins = plan.begins

    def piece(self, group: range, folder: Optional[str] = None) -> str:
        """`folder`: which the pieces have moved to."""
        return "%s/%d.vtp" % (folder or self.wanted.pieces, group[0])

    def cells(self, leaf: int) -> str:
        return self.store.path("cells", "%d.npy" % leaf)

    def kinds(self) -> Dict[str, Any]:
        """The types of point data of a TIN by name."""
        return {"z": "<f8", **{name: self.kind[name] for name in self.wanted.names}, _pvtp.IDS: "<i8"}

    def is_done(self, group: range) -> bool:
        hasPiece = self.wanted.pieces is None or os.path.exists(self.piece(group))
        return hasPiece and all(os.path.exists(self.cells(leaf)) for leaf in group if self._has_cells(leaf))

    def shares(self, leaf: int) -> List[np.ndarray]:
        """Of the nodes above it."""
        return [self.store.load_bytes("share", str(node)) for node in self.plan.above(leaf)]

    def _has_cells(self, leaf: int) -> bool:
        return self.wanted.raster is not None and min(self.wanted.windows[leaf][2:]) > 0

    def sync(self) -> None:
        """What is done, and what the first visits made, is on the disk."""
        for folder in ("border", "share", "cells"):
            sync(self.store.path(folder))
        if self.wanted.pieces is not None:
            sync(self.wanted.pieces)

    def needed(self, leaves: Leaves, group: range) -> Set[int]:
        """The leaves whose points a group without lines needs."""
        lists = [leaves.listed(leaf, self.shares(leaf)) for leaf in group]
        return set(group).union(*(np.unique(self._leaf_of(numbers)).tolist() for numbers in lists))

    def _leaf_of(self, numbers: np.ndarray) -> np.ndarray:
        """Of points."""
        return np.searchsorted(self.begins, numbers, "right") - 1

    def work(self, leaves: Leaves, group: range) -> None:
        pieces = [self._leaf(leaves, leaf) for leaf in group]
        if self.wanted.pieces is not None:
            triangles = np.concatenate(pieces)
            _pvtp.write_piece(self.piece(group), self._piece(group, triangles))

    def _leaf(self, leaves: Leaves, leaf: int) -> np.ndarray:
        """Writes its cells. Returns its triangles, of numbers of points in the order of the leaves."""
        own = records_of(self.store, leaf, self.kind)["xyz"]
        shares, isThere = self.shares(leaf), True
        if self.wanted.hasLines:
            given = np.ascontiguousarray(own), self.store.load_bytes("own", str(leaf)), shares
            numbers, isThere = leaves.surface(leaf, *given, self.wanted.longest)
        else:
            numbers = leaves.listed(leaf, shares)
        points = np.empty((len(own) + len(numbers), 3))
        points[: len(own)] = own
        points[len(own) :] = self._records(numbers)["xyz"]
        if isThere:
            leaves.triangulate(points, self.plan.bounds)
        if self._has_cells(leaf):
            self._sample(leaves, leaf, points if isThere else None)
        if self.wanted.pieces is None or not isThere:
            return np.empty((0, 3), np.int64)
        triangles = leaves.array("triangles").reshape(-1, 3)
        triangles = triangles.compress(triangles[:, 0] < len(own), axis=0)
        return np.concatenate((self.begins[leaf] + np.arange(len(own)), numbers)).take(triangles)

    def _records(self, numbers: np.ndarray) -> np.ndarray:
        """Of points of any leaves."""
        made = np.empty(len(numbers), self.kind)
        leaf_of = self._leaf_of(numbers)
        for leaf in np.unique(leaf_of).tolist():
            isHere = leaf_of == leaf
            made[isHere] = records_of(self.store, leaf, self.kind).take(numbers[isHere] - self.begins[leaf])
        return made

    def _sample(self, leaves: Leaves, leaf: int, points: Optional[np.ndarray]) -> None:
        """`points`: of the triangles; None: there are none."""
        raster, (row, column, rows, columns) = self.wanted.raster, self.wanted.windows[leaf]
        assert raster is not None
        z, step = None if points is None else np.ascontiguousarray(points[:, 2]), max(1, CELLS // columns)
        with written(self.cells(leaf)) as file:
            header = {"descr": np.dtype(self.wanted.dtype).str, "fortran_order": False, "shape": (rows, columns)}
            np.lib.format.write_array_header_1_0(file, header)
            for begin in range(0, rows, step):
                window = row + begin, column, min(step, rows - begin), columns
                values = np.full(window[2:], np.nan) if z is None else \
                    leaves.values(raster, window, z, self.wanted.method)  # fmt: skip
                file.write(values.astype(self.wanted.dtype).tobytes())

    def _piece(self, group: range, triangles: np.ndarray) -> _pvtp.Piece:
        """Corners of the triangles become the points of a piece: those of its leaves, then others, both in the order of
        their numbers."""
        begin, size = self.begins[group[0]], self.begins[group[-1] + 1] - self.begins[group[0]]
        corners = triangles.ravel() - begin
        far = np.flatnonzero((corners < 0) | (corners >= size))
        others, places = np.unique(corners[far] + begin, return_inverse=True)
        corners[far] = size
        isUsed = np.zeros(size + 1, bool)
        isUsed[corners] = True
        own = np.flatnonzero(isUsed[:size])
        corners = (np.cumsum(isUsed, dtype=np.int32) - np.int32(1)).take(corners)
        corners[far] = len(own) + places.ravel()
        parts = [records_of(self.store, leaf, self.kind) for leaf in group]
        records = np.concatenate((np.concatenate(parts).take(own), self._records(others)))
        columns: Dict[str, np.ndarray] = {"z": np.ascontiguousarray(records["xyz"][:, 2])}
        columns.update((name, np.ascontiguousarray(records[name])) for name in self.wanted.names)
        columns[_pvtp.IDS] = np.ascontiguousarray(records["id"])
        return _pvtp.Piece(np.ascontiguousarray(records["xyz"]), columns, corners.reshape(-1, 3))
