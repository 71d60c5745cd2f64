# SPDX-License-Identifier: BSD-3-Clause
"""The cells of a raster: Filters/Sampling/vtkAHDRaster.cxx, bit for bit."""

import math

import numpy

MOST_CELLS = 2147483647.0  # along an axis, as VTK counts them by int
PRECISION = 2.0**-50  # of coordinates that were written in decimal

# Why there is no raster.
NO_AREA, CELL_SIZE, BOUNDS, TOO_MANY = "no area", "cell size", "bounds", "too many"
TOO_WIDE, OUT_OF_NUMBERS = "too wide", "out of numbers"


class Fault(Exception):
    """Why there is no raster. `wished`: columns and rows, where these are known."""

    def __init__(self, kind, wished=(0.0, 0.0)):
        super().__init__(kind)
        self.kind, self.wished = kind, wished


class Raster:
    """Cells, by their centres."""

    def __init__(self, origin, spacing, columns, rows):
        self.origin, self.spacing, self.columns, self.rows = origin, spacing, columns, rows

    def count(self):
        return self.columns * self.rows

    def box(self):
        """(xmin, xmax, ymin, ymax) of the centres."""
        last = [self.origin[k] + (count - 1) * self.spacing[k] for k, count in enumerate((self.columns, self.rows))]
        return self.origin[0], last[0], self.origin[1], last[1]

    def axis(self, k):
        """The coordinates of the centres along x or y."""
        return self.origin[k] + numpy.arange((self.columns, self.rows)[k], dtype=float) * self.spacing[k]


NONE = Raster((0.0, 0.0), (1.0, 1.0), 0, 0)


def _rounded(number):
    """As std::round does, halves away from 0."""
    whole = math.floor(abs(number))
    return math.copysign(whole + (abs(number) - whole >= 0.5), number)


def _whole_below(quotient, slack):
    if not math.isfinite(quotient):
        return quotient
    nearest = _rounded(quotient)
    return nearest if abs(quotient - nearest) <= slack else float(math.floor(quotient))


def _whole_above(quotient, slack):
    return -_whole_below(-quotient, slack)


def _length_in(low, high, size):
    """(high - low) / size, where only the quotient may be a number, too."""
    length = high - low
    return length / size if math.isfinite(length) else high / size - low / size


def _by_size(low, high, size, align):
    """(first centre, spacing, count) along an axis."""
    slack = PRECISION * max(abs(low), abs(high)) / size
    if align:
        first = _whole_below(low / size, slack)
        count = max(1.0, _whole_above(high / size, slack) - first)
        return (first + 0.5) * size, size, count
    origin = low + 0.5 * size if low < high else low  # one row runs through what has no length
    return origin, size, max(1.0, _whole_above(_length_in(low, high, size), slack))


def _by_count(low, high, count):
    spacing = _length_in(low, high, count)
    return low + 0.5 * spacing, spacing, float(count)


def _one_row(at, width):
    return at, width if width > 0.0 else 1.0, 1.0


def _is_too_wide(origin, spacing, count):
    """Is what it is computed from, or the last centre, beyond the largest number?"""
    return not (math.isfinite(spacing) and math.isfinite(origin + (count - 1.0) * spacing))


def _are_apart(origin, spacing, count):
    """Are the centres of neighbours different numbers?"""
    last = origin + (count - 1.0) * spacing
    return spacing > 0.0 and (
        count == 1.0 or (origin + spacing > origin and last - spacing < last))


def make_raster(values, area):
    """Of this area, (xmin, xmax, ymin, ymax) or None, with settings of the filter. Fault."""
    by_size, sizes = values["RasterSize"] == 1, values["CellSize"]
    if by_size and not all(0.0 < size < math.inf for size in sizes):
        raise Fault(CELL_SIZE)
    if area is None:
        raise Fault(NO_AREA)
    if by_size:
        x, y = (_by_size(*area[2 * k:2 * k + 2], sizes[k], values["AlignToCellSize"]) for k in range(2))
    else:
        x, y = (_by_count(*area[2 * k:2 * k + 2], values["Dimensions"][k]) for k in range(2))
        width, height = x[1], y[1]
        x = x if width > 0.0 else _one_row(area[0], height)
        y = y if height > 0.0 else _one_row(area[2], width)
    if not (x[2] <= MOST_CELLS and y[2] <= MOST_CELLS):
        raise Fault(TOO_MANY, (x[2], y[2]))
    if _is_too_wide(*x) or _is_too_wide(*y):
        raise Fault(TOO_WIDE)
    if not (_are_apart(*x) and _are_apart(*y)):
        raise Fault(OUT_OF_NUMBERS, (x[2], y[2]))
    return Raster((x[0], y[0]), (x[1], y[1]), int(x[2]), int(y[2]))


def make_raster_within(values, bounds):
    """The same for an area that was asked for."""
    if not all(map(math.isfinite, bounds)) or not (bounds[0] < bounds[1] and bounds[2] < bounds[3]):
        raise Fault(BOUNDS)
    return make_raster(values, bounds)


def box_of(xy, skipped=None):
    """(xmin, xmax, ymin, ymax) of the finite places that are not skipped; None without any."""
    counted = numpy.isfinite(xy[:, 0]) & numpy.isfinite(xy[:, 1])
    if skipped is not None:
        counted &= skipped == 0
    if not counted.any():
        return None
    found = [float(end(xy[:, k], where=counted, initial=start)) for k in range(2)
             for end, start in ((numpy.min, math.inf), (numpy.max, -math.inf))]
    return tuple(number + 0.0 for number in found)  # of zeros of both signs it is chance which one comes first
