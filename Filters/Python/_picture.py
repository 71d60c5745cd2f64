# SPDX-License-Identifier: BSD-3-Clause
"""A small picture of triangles as SVG, of a few kilobytes however many they are."""

from __future__ import annotations

from typing import Iterator

import numpy as np

_WIDTH, _HEIGHT, _CELL = 240, 160, 3  # in pixels
_DRAWN = 200  # triangles, the largest; of others the cells in which they lie
_LOOKED_AT = 1 << 16


def svg(triangles: np.ndarray, xy: np.ndarray) -> str:
    """Of the ids of corners, and places by ids. Of many triangles some stand for all. Empty if there are none."""
    corners = xy[triangles[:: 1 + len(triangles) // _LOOKED_AT], :2].astype(np.float64)
    if not len(corners):
        return ""
    corners /= np.abs(corners).max() or 1.0  # so that no difference is infinite
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    scale = min(pixels / length for pixels, length in zip((_WIDTH, _HEIGHT), high - low) if length > 0)
    places = (corners - (low[0], high[1])) * (scale, -scale)
    width, height = (high - low) * scale
    first, second = places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]
    area = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    order = np.argsort(-area, kind="stable")
    drawn = _DRAWN if len(order) <= _DRAWN else min(_DRAWN, int(np.count_nonzero(area > 9 * _CELL**2)))
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="-1 -1 %.0f %.0f">'
        '<path fill="#9cf" d="%s"/><path fill="#9cf" stroke="#369" stroke-width="0.4" d="%s"/></svg>'
        % (_WIDTH, _HEIGHT, max(width, 1) + 2, max(height, 1) + 2, "".join(_runs(places[order[drawn:]].mean(axis=1))),
           "".join("M%.1f,%.1fL%.1f,%.1fL%.1f,%.1fZ" % tuple(three.ravel()) for three in places[order[:drawn]]))
    )  # fmt: skip


def _runs(places: np.ndarray) -> Iterator[str]:
    """Paths around the cells with places, those side by side in one."""
    cells = np.unique(np.floor(places / _CELL).astype(np.int64)[:, ::-1], axis=0)
    begins = np.ones(len(cells), bool)
    begins[1:] = (np.diff(cells, axis=0) != (0, 1)).any(axis=1)
    first = np.flatnonzero(begins)
    for (row, column), count in zip(cells[first].tolist(), np.diff(np.append(first, len(cells))).tolist()):
        yield "M%d,%dh%dv%dh%dz" % (column * _CELL, row * _CELL, count * _CELL, _CELL, -count * _CELL)
