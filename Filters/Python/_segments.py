# SPDX-License-Identifier: BSD-3-Clause
"""Which segment of the constraints an edge of a triangulation lies on."""

from __future__ import annotations

from typing import Callable, Dict, Iterator, List, Tuple

import numpy as np

from ._input import Request


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
        source = request.arrays.get("source_points")
        first = 0 if source is None else len(request.points)
        self._given = len(request.points) if source is None else first + len(source)
        parts = [np.empty((0, 4), np.int64)]
        chains = 0
        for ids, offsets, isClosed in _chains_of(request):
            parts.append(_numbered(ids + first, offsets, isClosed))
            parts[-1][:, 2] += chains
            chains += len(offsets) - 1
        rows = np.concatenate(parts)
        pairs = status[rows[:, :2]].astype(np.int64)
        isSegment = (pairs >= 0).all(axis=1) & (pairs[:, 0] != pairs[:, 1])
        self._pairs, self._numbers, self._places = pairs[isSegment], rows[isSegment, 2:], places[:, :2]

    def of(self, edges: np.ndarray) -> np.ndarray:
        """(e, 2): chain and segment that each edge lies on, the first if there are more; -1: none."""
        own, keys = _undirected(self._pairs), _undirected(edges)
        rows = _first(own, np.arange(len(own)), keys)
        others = np.flatnonzero(~np.isin(own, keys))
        if len(others) and len(edges):
            through, broken = self._through(others, np.unique(edges, axis=0))
            found = _first(through[:, 0], through[:, 1], keys)
            rows = np.where((found >= 0) & ((rows < 0) | (found < rows)), found, rows)
            self._take_parts(broken, edges, rows)
        made: np.ndarray = np.append(self._numbers, [[-1, -1]], axis=0)[rows]
        return made

    def within(self, edges: np.ndarray, chains: np.ndarray) -> np.ndarray:
        """The same, where the chain is known. Points that were added are rounded: of several chains along them, the
        one that passes them."""
        made = self.of(edges)[: len(chains)]
        for edge in np.flatnonzero(made[:, 0] != chains).tolist():
            rows = np.flatnonzero(self._numbers[:, 0] == chains[edge]).tolist()
            row = next((row for row in rows if self._test_of(row)(edges[edge]).all()), -1)
            made[edge] = self._numbers[row] if row >= 0 else (chains[edge], -1) if rows else -1
        return made

    def _through(self, rows: np.ndarray, edges: np.ndarray) -> Tuple[np.ndarray, List[int]]:
        """(k, 2): of those of these segments that are made of several edges the keys of these, and the row of each.
        And the rows of the other segments, of which at most parts are edges."""
        beside: Dict[int, List[int]] = {}
        for a, b in edges.tolist():
            beside.setdefault(a, []).append(b)
            beside.setdefault(b, []).append(a)
        made, broken = [np.empty((0, 2), np.int64)], []
        for row in rows.tolist():
            found = self._edges_along(row, beside)
            if not len(found):
                broken.append(row)
            made.append(np.stack((_undirected(found), np.full(len(found), row)), axis=1))
        return np.concatenate(made), broken

    def _edges_along(self, row: int, beside: Dict[int, List[int]]) -> np.ndarray:
        """The edges along a segment, (k, 2), if they lead from its one end to the other; else none."""
        at, end = self._pairs[row].tolist()
        areOn, made, reached, waiting = self._test_of(row), [], {at}, [at]
        while waiting:
            before = waiting.pop()
            near = np.array(beside.get(before, []), np.int64)
            for next_ in near[areOn(near)].tolist():
                made.append((before, next_))
                if next_ not in reached:
                    reached.add(next_)
                    waiting.append(next_)
        return np.array(made if end in reached else [], np.int64).reshape(-1, 2)

    def _take_parts(self, rows: List[int], edges: np.ndarray, found: np.ndarray) -> None:
        """Of segments that were divided some parts may cross others, and be left out. Sets `found` for the rest: edges
        that have none yet, and an end that was added."""
        left = np.flatnonzero((found < 0) & (edges >= self._given).any(axis=1))
        for row in rows if len(left) else ():
            isOn = self._test_of(row)(edges[left]).all(axis=1)
            found[left[isOn]] = row
            left = left[~isOn]

    def _test_of(self, row: int) -> Callable[[np.ndarray], np.ndarray]:
        """A function of ids: do the points lie on the segment? Those that were added are rounded: a unit in the last
        place from it. Of coordinates of any scale."""
        start, end = self._places[self._pairs[row]]
        unit = np.spacing(np.abs((start, end)).max())  # a power of two
        toX, toY = (end - start) / unit
        square = toX * toX + toY * toY
        most = 8 * np.sqrt(square)

        def areOn(ids: np.ndarray) -> np.ndarray:
            with np.errstate(over="ignore", invalid="ignore"):  # of points far away
                x, y = np.moveaxis((self._places[ids] - start) / unit, -1, 0)
                along = x * toX + y * toY
                made: np.ndarray = (abs(x * toY - y * toX) <= most) & (0 <= along) & (along <= square)
            return made

        return areOn


def _chains_of(request: Request) -> Iterator[Tuple[np.ndarray, np.ndarray, bool]]:
    """Ids and offsets of lines and of loops, which are closed."""
    arrays = request.arrays
    for kind in ("line", "loop"):
        if kind + "_ids" in arrays:
            ids, offsets = arrays[kind + "_ids"], arrays.get(kind + "_offsets")
            if offsets is None:
                width = ids.shape[1] if ids.ndim == 2 else ids.size
                offsets = np.arange(0, ids.size + 1, width)
            yield ids.ravel(), offsets.astype(np.int64), kind == "loop"
    if request.settings["points_as_line"] and not {"line_ids", "loop_ids"} & arrays.keys():
        count = len(arrays["source_points"])
        yield np.arange(count), np.array([0, count]), False


def pairs_of(request: Request) -> np.ndarray:
    """The ends of the segments of all chains, (m, 2), as they are given."""
    pairs = [_numbered(*chain)[:, :2] for chain in _chains_of(request)]
    return np.concatenate([np.empty((0, 2), np.int64), *pairs])


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
