# SPDX-License-Identifier: BSD-3-Clause
"""The cells of a raster: Filters/Sampling/vtkAHDRaster.cxx, bit for bit."""

import math

import numpy

from .._raster import MOST, axes_by_count, axes_by_size, chosen_size

# Why there is no raster.
NO_AREA, CELL_SIZE, BOUNDS, TOO_MANY = "no_area", "cell_size", "bounds", "too_many"
TOO_WIDE, OUT_OF_NUMBERS = "too_wide", "out_of_numbers"


class Fault(Exception):
    """Why there is no raster. `wished`: columns and rows, where these are known."""

    def __init__(self, kind, wished=(0.0, 0.0)):
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


def is_chosen(values):
    """Is the size of the cells chosen from the points?"""
    return not any(values["CellSize"]) if values["RasterSize"] == 1 else not all(values["Dimensions"])


def make_raster(values, area, points):
    """Of this area, (xmin, xmax, ymin, ymax) or None, with settings of the filter. `points`: how many the input has.
    Fault."""
    by_size, chosen, sizes = values["RasterSize"] == 1, is_chosen(values), values["CellSize"]
    if by_size and not chosen and not all(0.0 < size < math.inf for size in sizes):
        raise Fault(CELL_SIZE)
    if area is None:
        raise Fault(NO_AREA)
    if by_size or chosen:
        sizes = (chosen_size(area, points),) * 2 if chosen else sizes
        x, y = axes_by_size(area, sizes, by_size and values["AlignToCellSize"])
    else:
        x, y = axes_by_count(area, values["Dimensions"])
    if not (x.count <= MOST and y.count <= MOST):
        raise Fault(TOO_MANY, (x.count, y.count))
    if x.is_too_wide() or y.is_too_wide():
        raise Fault(TOO_WIDE)
    if not (x.is_apart() and y.is_apart()):
        raise Fault(OUT_OF_NUMBERS, (x.count, y.count))
    return Raster((x.origin, y.origin), (x.spacing, y.spacing), int(x.count), int(y.count))


def make_raster_within(values, bounds, points):
    """The same for an area that was asked for."""
    if not all(map(math.isfinite, bounds)) or not (bounds[0] < bounds[1] and bounds[2] < bounds[3]):
        raise Fault(BOUNDS)
    return make_raster(values, bounds, points)


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
