# SPDX-License-Identifier: BSD-3-Clause
"""A number that stands for no value of z, such as -9999: points that have it are left out, or noticed."""

import numpy

from pointfiles import InputError, thousands

FEWEST = 3  # points of one z that make it look so


def written(number):
    """In the fewest digits that are read as the same number."""
    return "%d" % number if float(number).is_integer() and abs(number) < 1e15 else repr(float(number))


def without(points, number):
    """The points whose z is another number. InputError if there is none."""
    z = points.xyz[:, 2]
    has = z == number if number == number else numpy.isnan(z)
    if has.all():
        raise InputError("--nodata %s: no point has another %s" % (written(number), points.names[2]))
    told = "%s points left out, as their %s is %s" % (thousands(int(has.sum())), points.names[2], written(number))
    return points._replace(xyz=points.xyz[~has], notes=points.notes + [told])


def notes(points):
    """What to tell of a z that several points have, and that is farther from all others than these lie apart."""
    z = points.xyz[:, 2]
    levels, counts = numpy.unique(z[numpy.isfinite(z)], return_counts=True)
    if len(levels) < 3:
        return []
    for odd, (low, high) in ((0, levels[[1, -1]]), (-1, levels[[0, -2]])):
        with numpy.errstate(over="ignore"):  # of the largest doubles
            away, extent = max(low - levels[odd], levels[odd] - high), high - low
        if counts[odd] >= FEWEST and away > extent:
            number = written(levels[odd])
            return ["%s points have a %s of %s, far from all others; --nodata %s leaves them out" % (
                thousands(int(counts[odd])), points.names[2], number, number)]  # fmt: skip
    return []
