# SPDX-License-Identifier: BSD-3-Clause
"""What a refinement of the library found, for NumPy and for the class over VTK."""

from __future__ import annotations

import operator
from typing import Any, Dict, Optional, Tuple

import numpy as np

from . import _library as library
from ._input import real_of
from ._segments import Segments


class Found:
    """What the library found for a request."""

    def __init__(
        self,
        job: library.Job,
        request: library.RefineRequest,
        wished: Optional[np.ndarray],
        report: Optional[library.RefineReport] = None,
    ) -> None:
        """What became of it goes to `report`, also where it fails."""
        self.report = report = library.RefineReport() if report is None else report
        with job._with_memory(0 if wished is None else wished.nbytes):
            job._call("ahd_refine", request, report, arrays=() if wished is None else (wished,))
        points, pieces = report.points, report.pieces
        self.places, self.corners, self.weights = np.empty((points, 2)), _ids(points, 3), np.empty((points, 3))
        self.ids, self.offsets, self.reasons = _ids(report.ids), _ids(report.chains + 1), np.empty(report.bad, np.int32)
        self.pieces, self.edges, self.cells = _ids(pieces, 2), _ids(pieces, 2), _ids(pieces)
        arrays = (self.places, self.corners, self.weights, self.ids, self.offsets, None, self.reasons, self.pieces,
                  self.edges, self.cells)  # fmt: skip
        written = [array for array in arrays if array is not None]
        to = library.Refined(*(None if array is None else library.address_of(array) for array in arrays))
        job._call("ahd_refine_write", to, arrays=written)

    def chains(self) -> Dict[str, Tuple[np.ndarray, np.ndarray]]:
        """The lines and the loops of a run with the new points: ids and offsets."""
        lines = self.report.lines
        first = self.offsets[lines]
        return {"line": (self.ids[:first], self.offsets[: lines + 1]),
                "loop": (self.ids[first:], self.offsets[lines:] - first)}  # fmt: skip

    def marked(self, segments: Segments) -> np.ndarray:
        """(e, 2): chain and segment of each piece. Segments may go on outside of the triangles."""
        ends = np.stack((self.offsets[:-1], self.offsets[1:] - 1), axis=1)[: self.report.lines]
        return segments.within(np.concatenate((self.edges, self.ids[ends])), self.cells)

    def described(
        self, job: library.Job, triangles: np.ndarray, regions: np.ndarray
    ) -> Tuple[np.ndarray, np.ndarray, float]:
        """Of the triangles of that run and their regions: the regions of before, the rows of those that are not as
        wished, and the least angle in degrees."""
        corners, numbers = np.ascontiguousarray(triangles, np.int32), regions.astype(np.int64)
        arrays = corners, numbers, bad = corners, numbers, _ids(self.report.bad)
        at = [library.address_of(array) for array in arrays]
        to = library.RefinedTriangles(at[0], len(corners), at[1], at[2])
        job._call("ahd_refine_triangles", to, arrays=arrays)
        return numbers, bad, to.least_angle


def _ids(*shape: int) -> np.ndarray:
    return np.empty(shape, np.int64)


def spread(values: np.ndarray, corners: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Sums of rows of `values` times weights, always in the same order."""
    at = np.where(corners < 0, corners[:, :1], corners)
    shape = (-1,) + (1,) * (values.ndim - 1)
    with np.errstate(over="ignore", under="ignore", invalid="ignore"):  # infinite and huge values
        parts = [values[at[:, k]] * weights[:, k].reshape(shape) for k in range(3)]
        made: np.ndarray = parts[0] + parts[1] + parts[2]
    return made


def limit_of(name: str, value: Any) -> float:
    """0 for None: no limit. TypeError, ValueError."""
    text = "%s must be a finite number greater than 0, not %r" % (name, value)
    try:
        number = 0.0 if value is None else real_of(name, value, (0.0, np.inf))
    except (TypeError, ValueError) as error:
        raise type(error)(text) from None
    if value is not None and not 0 < number < np.inf:
        raise ValueError(text)
    return number


def count_of(name: str, value: Any) -> int:
    """As many as it takes for None. TypeError, ValueError."""
    text = "%s must be a whole number, 0 or more, not %r" % (name, value)
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(text)
    try:
        number = library.REFINE_ALL if value is None else operator.index(value)
    except TypeError:
        raise TypeError(text) from None
    if number < 0:
        raise ValueError(text)
    return min(number, library.REFINE_ALL)
