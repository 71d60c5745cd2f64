# SPDX-License-Identifier: BSD-3-Clause
"""Piecewise cubic interpolation with continuous slopes on a triangulation.

Each triangle is divided at its centroid into three, on each of which the surface is a cubic polynomial (Clough and
Tocher 1965). Values and gradients at the corners leave one number open for each edge: the derivative across it is
linear along the edge, taken in the direction from centroid to centroid of the triangles on its two sides, at the rim
from the centroid to the middle of the edge (Farin 1985). So the surface follows any affine map of the plane.

Gradients are those of the minimum norm network (Nielson 1983): of all functions on the edges that are cubic on each and
have one gradient at each vertex, the one with the least sum of integrals of the squared second derivative along edges.
"""

from __future__ import annotations

from typing import Any, Callable, List, Tuple

import numpy as np

from ._measured import length, lists_of

#: As many places or edges at a time as the cache has room for.
BLOCK = 1 << 14


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of vectors in the last dimension."""
    made: np.ndarray = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return made


# --- Gradients ----------------------------------------------------------------------------------------------


class Network:
    """The edges of a triangulation, for the gradients at their ends. Vectors of the plane are complex numbers.

    With the slope s of an edge, its unit vector u, its length l and the gradients g, h at its ends the integral is
    4 / l ((u g - s)^2 + (u g - s)(u h - s) + (u h - s)^2), where u g is the inner product. It is least where at each
    vertex the sum over its edges of u / l (2 u g + u h - 3 s) is 0. As complex numbers u (u g) is (g + u^2 g*) / 2,
    with the conjugate g*.
    """

    def __init__(self, points: np.ndarray, edges: np.ndarray) -> None:
        self._count = len(points)
        ids = np.flatnonzero(np.bincount(edges.ravel(), minlength=self._count))
        self._ids = ids[points[ids, 0].argsort()]  # so that ends of edges are close to each other in memory
        rank = np.empty(self._count, np.intp)
        rank[self._ids] = np.arange(len(ids))
        ends = rank[np.concatenate((edges, edges[:, ::-1]))]
        self._offsets, self._others = lists_of(ends[:, 0], ends[:, 1], len(ids), len(ids), np.intp)
        corners = points[self._ids]
        self._unit = np.ptp(corners)  # so that no number is too large or too small
        places, counts = corners @ [1, 1j], np.diff(self._offsets)
        along = (places[self._others] - np.repeat(places, counts)) / self._unit
        lengths, size = abs(along), abs(corners).max(axis=1) / self._unit
        isShort = lengths <= 2.0**-40 * np.maximum(size[self._others], np.repeat(size, counts))
        self._directions, self._weights = along / lengths, np.where(isShort, 0, 1 / lengths)

    def _sum(self, terms: Callable[[slice, slice], np.ndarray]) -> np.ndarray:
        """For each vertex the sum of the terms of its edges, which are made for a block of vertices at a time."""
        made = np.empty(len(self._ids), np.complex128)
        most = BLOCK // 6  # vertices: each has six edges, nearly
        for begin in range(0, len(made), most):
            starts = self._offsets[begin : begin + most + 1]
            block, edges = slice(begin, begin + len(starts) - 1), slice(starts[0], starts[-1])
            made[block] = np.add.reduceat(terms(block, edges), starts[:-1] - starts[0])
        return made

    def gradients(self, values: np.ndarray, maxiter: int, tol: float) -> Tuple[np.ndarray, bool]:
        """The gradient at each point, (n, 2), for one value each; and did steps, at most `maxiter`, end with changes
        below `tol`, relative to gradients above 1? Left out are points whose value is not finite, and edges so short,
        1e-12 of the coordinates, that rounding takes their slope.

        Of the system, divided by its blocks of 2 x 2 on the diagonal, all eigenvalues are in [1/2, 3/2], as for each
        edge the mixed term is at most half of the others. Chebyshev's iteration for this interval takes the error down
        to 27 % in each step, for any triangulation.
        """
        heights, u, others, counts = values[self._ids], self._directions, self._others, np.diff(self._offsets)
        isKnown = np.isfinite(heights)
        weights = self._weights if isKnown.all() else self._weights * (isKnown[others] & np.repeat(isKnown, counts))
        heights = np.where(isKnown, heights, 0)

        def rises(block: slice, edges: slice) -> np.ndarray:
            rise = heights[others[edges]] - np.repeat(heights[block], counts[block])
            made: np.ndarray = 3 * rise * u[edges] * weights[edges] ** 2
            return made

        def coupled(block: slice, edges: slice) -> np.ndarray:
            across = found[others[edges]]
            made: np.ndarray = (across + u[edges] ** 2 * across.conj()) * (0.5 * weights[edges])
            return made

        wanted = self._sum(rises)
        # Of the blocks: D g = whole g + turned g*. Added is the rounding of these sums, so that a vertex with edges in
        # one direction alone has no slope across it.
        whole = self._sum(lambda block, edges: weights[edges] + 0j).real * (1 + 64 * np.finfo(float).eps)
        turned = self._sum(lambda block, edges: weights[edges] * u[edges] ** 2)
        determinant = (whole - abs(turned)) * (whole + abs(turned))
        determinant[determinant == 0] = np.inf  # all of its edges are left out
        found, step, factor, rho = np.zeros_like(wanted), np.zeros_like(wanted), 1.0, 0.5
        changes: List[float] = []
        while len(changes) < maxiter and not _is_at_rest(changes, tol / 8):  # mostly as close as scipy's
            lacking = wanted - whole * found - turned * found.conj() - self._sum(coupled)
            step = (factor - 1) * step + factor / determinant * (whole * lacking - turned * lacking.conj())
            found = found + step
            factor, rho = 4 / (4 - rho), 1 / (4 - rho)
            changes.append(float(np.max(_largest(step) / np.maximum(self._unit, _largest(found)), initial=0)))
        made = np.zeros((self._count, 2))
        made[self._ids] = np.stack((found.real, found.imag), axis=1) / self._unit
        return made, bool(changes) and changes[-1] < tol


def _is_at_rest(changes: List[float], tol: float) -> bool:
    """Are steps with these changes enough? Also if those of the last eight are the roundings of the others."""
    return bool(changes) and (changes[-1] < tol or min(changes[-8:]) > min(changes[:-8], default=np.inf) / 2)


def _largest(vectors: np.ndarray) -> np.ndarray:
    """The larger coordinate of each, without its sign."""
    made: np.ndarray = np.maximum(abs(vectors.real), abs(vectors.imag))
    return made


# --- Patches ------------------------------------------------------------------------------------------------


def crossings(points: np.ndarray, triangles: np.ndarray, neighbors: np.ndarray) -> np.ndarray:
    """(t, 3): where the direction across the edge from corner k to the next one meets it: the weight of corner k in
    this place."""
    corners = points[triangles]
    centroids = corners.mean(axis=1)
    made = np.full(triangles.shape, 0.5)
    for k in range(3):
        rows = np.flatnonzero(neighbors[:, k] >= 0)
        a, b, centroid = corners[rows, k], corners[rows, (k + 1) % 3], centroids[rows]
        across = centroids[neighbors[rows, k]] - centroid
        with np.errstate(divide="ignore", invalid="ignore"):
            found = cross(b - centroid, across) / cross(b - a, across)
        made[rows, k] = np.where(np.isfinite(found), found, 0.5)
    return made


def weights_in(x: np.ndarray, y: np.ndarray, places: np.ndarray) -> np.ndarray:
    """(3, k): the weights of the corners at x and y, (3, k), at one place each; NaN in slivers, where rounding takes
    more than the tenth digit of them."""
    first_x, first_y, second_x, second_y = x[1] - x[0], y[1] - y[0], x[2] - x[0], y[2] - y[0]
    to_x, to_y = places[:, 0] - x[0], places[:, 1] - y[0]
    area = first_x * second_y - first_y * second_x
    area[abs(area) <= 1e-6 * length(first_x, first_y) * length(second_x, second_y)] = np.nan
    one, two = (to_x * second_y - to_y * second_x) / area, (first_x * to_y - first_y * to_x) / area
    return np.stack((1 - one - two, one, two))


#: By the corner with the least weight: the corners of the third that has the place, and that one.
_ORDERS = np.array([[1, 2, 0], [2, 0, 1], [0, 1, 2]])


class Patches:
    """The surface on the triangles of a triangulation."""

    def __init__(self, points: np.ndarray, triangles: np.ndarray, neighbors: np.ndarray) -> None:
        self._x, self._y = points.T.copy()
        self._corners, self._shares = triangles.ravel(), crossings(points, triangles, neighbors).ravel()

    def at(
        self,
        rows: np.ndarray,
        places: np.ndarray,
        exact: Callable[[np.ndarray, np.ndarray], np.ndarray],
        values: np.ndarray,
        gradients: np.ndarray,
    ) -> np.ndarray:
        """(k, columns): at places, (k, 2), by their triangles, of values (n, columns) and gradients (n, columns, 2).
        `exact` gives the weights, (3, .), at places in slivers by triangle and place."""
        made = np.empty((len(rows), values.shape[1]), values.dtype)
        for begin in range(0, len(rows), BLOCK):
            block = slice(begin, begin + BLOCK)
            first = 3 * rows[block].astype(np.intp)
            ids = self._corners.take(first + np.arange(3)[:, None])
            x, y = self._x.take(ids), self._y.take(ids)
            weights = weights_in(x, y, places[block])
            lost = np.flatnonzero(np.isnan(weights[0]))
            if len(lost):
                weights[:, lost] = exact(rows[block][lost], places[block][lost])
            order = _ORDERS.take(weights.argmin(axis=0), axis=1)
            chosen = order * len(first) + np.arange(len(first))
            weights, ids, x, y = (array.ravel().take(chosen) for array in (weights, ids, x, y))
            shares = self._shares.take(first + order)
            for column in range(values.shape[1]):
                heights, slopes = values[:, column][ids], (gradients[:, column, k][ids] for k in range(2))
                made[block, column] = _cubic(weights, x, y, heights, slopes, shares)
        return made


def _cubic(weights: Any, x: Any, y: Any, heights: Any, slopes: Any, shares: Any) -> Any:
    """The value by Bézier's ordinates: on the third between the corners a and b and the centroid, of the triangle a, b,
    c. All arguments are of a, b, c, or of the edges ab, bc, ca; slopes are two arrays, d/dx and d/dy."""
    gx, gy = slopes
    at: Any = [[None] * 3 for _ in range(3)]  # at[i][j]: a third of the way from corner i to corner j
    for i, j in ((0, 1), (1, 2), (2, 0)):
        step_x, step_y = (x[j] - x[i]) / 3, (y[j] - y[i]) / 3
        at[i][j] = heights[i] + gx[i] * step_x + gy[i] * step_y
        at[j][i] = heights[j] - gx[j] * step_x - gy[j] * step_y
    inner = [(heights[i] + at[i][i - 2] + at[i][i - 1]) / 3 for i in range(3)]  # towards the centroid
    middle = []  # beside the middle of each edge
    for i in range(3):
        j, share = (i + 1) % 3, shares[i]
        bends = heights[i] - 2 * at[i][j] + at[j][i], at[i][j] - 2 * at[j][i] + heights[j]
        middle.append((inner[i] + inner[j] - share * bends[0] - (1 - share) * bends[1]) / 2)
    near = [(inner[i] + middle[i] + middle[i - 1]) / 3 for i in range(3)]
    c = 3 * weights[2]
    a, b = weights[0] - weights[2], weights[1] - weights[2]
    return (
        a * a * (a * heights[0] + 3 * (b * at[0][1] + c * inner[0]))
        + b * b * (b * heights[1] + 3 * (a * at[1][0] + c * inner[1]))
        + c * c * (c * (near[0] + near[1] + near[2]) / 3 + 3 * (a * near[0] + b * near[1]))
        + 6 * a * b * c * middle[0]
    )
