# SPDX-License-Identifier: BSD-3-Clause
"""Which segment of the constraints an edge of a triangulation lies on."""

from __future__ import annotations

from typing import Dict, List

import numpy as np

from ._input import Request
from ._measured import length


def rows_with(triangles: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """For each directed edge the row of the triangle on its left, or -1."""
    froms, to = triangles.astype(np.int64), np.roll(triangles, -1, axis=1).astype(np.int64)
    keys = (froms << 32 | to).ravel()
    order = np.argsort(keys, kind="stable")
    wanted = edges[:, 0].astype(np.int64) << 32 | edges[:, 1]
    return _found(keys[order], wanted, order // 3)


def _found(ascending: np.ndarray, wanted: np.ndarray, values: np.ndarray) -> np.ndarray:
    """The value of each wanted key, -1 where there is no such key."""
    if not len(ascending):
        return np.full(len(wanted), -1)
    at = np.minimum(np.searchsorted(ascending, wanted), len(ascending) - 1)
    return np.where(ascending[at] == wanted, values[at], -1)


def _first(keys: np.ndarray, values: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Of each wanted key the value at its first place, -1 where it is not among the keys."""
    ascending, firsts = np.unique(keys, return_index=True)
    return _found(ascending, wanted, values[firsts])


def _undirected(pairs: np.ndarray) -> np.ndarray:
    ends = np.sort(pairs, axis=1).astype(np.int64)
    keys: np.ndarray = ends[:, 0] << 32 | ends[:, 1]
    return keys


class Segments:
    """The segments of a request's chains: ids of the vertices at their ends, and the numbers of chain and segment."""

    def __init__(self, request: Request, status: np.ndarray, places: np.ndarray) -> None:
        arrays = request.arrays
        first = len(request.points) if "source_points" in arrays else 0
        parts = [np.empty((0, 4), np.int64)]
        chains = 0
        for kind in ("line", "loop"):
            if kind + "_ids" in arrays:
                ids, offsets = arrays[kind + "_ids"], arrays.get(kind + "_offsets")
                if offsets is None:
                    width = ids.shape[1] if ids.ndim == 2 else ids.size
                    offsets = np.arange(0, ids.size + 1, width)
                parts.append(_numbered(ids.ravel() + first, offsets.astype(np.int64), kind == "loop"))
                parts[-1][:, 2] += chains
                chains += len(offsets) - 1
        rows = np.concatenate(parts)
        pairs = status[rows[:, :2]].astype(np.int64)
        isSegment = (pairs >= 0).all(axis=1) & (pairs[:, 0] != pairs[:, 1])
        self._pairs, self._numbers, self._places = pairs[isSegment], rows[isSegment, 2:], places

    def of(self, edges: np.ndarray) -> np.ndarray:
        """(e, 2): chain and segment that each edge lies on, the first if there are more; -1: none."""
        own, keys = _undirected(self._pairs), _undirected(edges)
        rows = _first(own, np.arange(len(own)), keys)
        others = np.flatnonzero(~np.isin(own, keys))
        if len(others) and len(edges):
            through = self._through(others, np.unique(edges, axis=0))
            found = _first(through[:, 0], through[:, 1], keys)
            rows = np.where((found >= 0) & ((rows < 0) | (found < rows)), found, rows)
        made: np.ndarray = np.append(self._numbers, [[-1, -1]], axis=0)[rows]
        return made

    def _through(self, rows: np.ndarray, edges: np.ndarray) -> np.ndarray:
        """(k, 2): of those of these segments that are made of several edges the keys of these, and the row of each."""
        beside: Dict[int, List[int]] = {}
        for a, b in edges.tolist():
            beside.setdefault(a, []).append(b)
            beside.setdefault(b, []).append(a)
        made = [np.empty((0, 2), np.int64)]
        for row in rows.tolist():
            path = self._path(int(self._pairs[row, 0]), int(self._pairs[row, 1]), beside)
            keys = _undirected(np.stack((path[:-1], path[1:]), axis=1))
            made.append(np.stack((keys, np.full_like(keys, row)), axis=1))
        return np.concatenate(made)

    def _path(self, at: int, end: int, beside: Dict[int, List[int]]) -> np.ndarray:
        """The ids along the edges from a point straight to another, from its end; one alone if there are none such.
        Crossings are rounded: a unit in the last place from the line, so several ways may lead along it."""
        origin = self._places[at, :2]
        way = self._places[end, :2] - origin
        most = 4 * np.finfo(float).eps * np.abs(self._places[[at, end], :2]).max() * length(way[:1], way[1:])
        came, reached = {at: at}, [(at, 0.0)]
        while reached and end not in came:
            before, done = reached.pop()
            near = np.array(beside.get(before, []), np.int64)
            to = self._places[near, :2] - origin
            along = to @ way
            isAhead = (np.abs(to[:, 0] * way[1] - to[:, 1] * way[0]) <= most) & (along > done)
            for next_, far in zip(near[isAhead].tolist(), along[isAhead].tolist()):
                if next_ not in came:
                    came[next_] = before
                    reached.append((next_, far))
        path = [end if end in came else at]
        while path[-1] != at:
            path.append(came[path[-1]])
        return np.array(path)


def _numbered(ids: np.ndarray, offsets: np.ndarray, isClosed: bool) -> np.ndarray:
    """(k, 4): the ends of the segments of chains, the number of the chain and that of the segment within it."""
    sizes = np.diff(offsets)
    chain = np.repeat(np.arange(len(sizes)), sizes)
    within = np.arange(len(chain)) - offsets[chain]
    to = np.append(ids[1:], 0)[: len(ids)]
    isLast = within == sizes[chain] - 1
    to[isLast] = ids[offsets[chain[isLast]]]
    rows = np.stack((ids, to, chain, within), axis=1)
    return rows if isClosed else rows[~isLast]
