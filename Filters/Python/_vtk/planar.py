# SPDX-License-Identifier: BSD-3-Clause
"""The points of vtkPlanarPointSource: Filters/Distributions/, bit for bit, for many points at once."""

import math

import numpy

UNIFORM, LINE, CROSS, CIRCLE, SPIRAL, MIXED, LATTICE = range(7)

BAND = 0.01  # deviation of bands and clusters
CIRCLE_RADIUS, SPIRAL_TURNS, SPIRAL_PITCH = 0.4, 3.0, 0.15
CLUSTERS = 20
BELL = 12  # numbers that one of a bell curve takes
# Random numbers that a point takes; of MIXED in the square, or in a cluster.
DRAWS = {UNIFORM: 2, LINE: 1 + BELL, CROSS: 2 + BELL, CIRCLE: 1 + BELL, SPIRAL: 1 + BELL}
DRAWS_OF_MIXED = (2 + 2 * BELL, 3)

_U = numpy.uint64
_STEP = _U(0x9E3779B97F4A7C15)


def bits(seed, first, count):
    """The numbers `first`, ... of the generator (splitmix64) with this seed, of 64 bits."""
    z = _U(seed) + (numpy.arange(first + 1, first + 1 + count, dtype=_U)) * _STEP
    z = (z ^ (z >> _U(30))) * _U(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> _U(27))) * _U(0x94D049BB133111EB)
    return z ^ (z >> _U(31))


def unit(random):
    """In [0, 1), of 64 bits each."""
    return (random >> _U(11)).astype(numpy.float64) * 2.0**-53


def toss(random):
    return (random >> _U(63)).astype(bool)


def bell(random):
    """Of rows of BELL numbers: mean 0, deviation 1."""
    total = numpy.full(len(random), -6.0)
    for column in unit(random).T:
        total += column
    return total


def _series(first, b):
    total = numpy.zeros_like(b)
    for k in range(first, 1, -2):
        total = (total + 1.0) * b / float(k * (k - 1))
    return total + 1.0


def on_unit_circle(turns):
    """x and y; turns in [0, 1)."""
    half = ((turns * 8.0).astype(numpy.int64) + 1) // 2
    a = (turns - half * 0.25) * (2.0 * math.pi)
    b = -a * a
    c, s = _series(20, b), a * _series(19, b)
    quarter = half % 4
    return (numpy.choose(quarter, (c, -s, -c, s)), numpy.choose(quarter, (s, c, -s, -c)))


def on_ray(turns, radius):
    x, y = on_unit_circle(turns)
    return 0.5 + radius * x, 0.5 + radius * y


def place_of_set(of_set, k):
    numbers = unit(bits((of_set ^ (0x5851F42D4C957F2D * (k + 1))) % 2**64, 0, 2))
    return numbers[0], numbers[1]


class PlanarPoints:
    """Makes `count` points one after the other. The seed is any int."""

    def __init__(self, distribution, count, seed):
        self.distribution, self.seed, self.made, self.drawn = distribution, seed % 2**64, 0, 0
        side = int(math.sqrt(float(count)))
        self.side = side + 1 if side * side < count else side
        self.centers = numpy.array([place_of_set(self.seed, k) for k in range(CLUSTERS)])

    def hills_at(self, x, y):
        """Their height over points of the set; Filters/Distributions/PlanarPoints.h has the formula."""
        width = float(self.side) if self.distribution == LATTICE else 1.0
        u, v = x / width, y / width

        def at(turns):
            return on_unit_circle(turns - numpy.floor(turns))

        return width * (0.5 + 0.3 * (at(0.8 * u)[1] * at(0.65 * v)[0]) + 0.2 * at(1.3 * u - 0.9 * v)[0])

    def next(self, count):
        """x and y of so many more."""
        first = self.made
        self.made += count
        if self.distribution == LATTICE:
            i = numpy.arange(first, first + count)
            return (i % self.side).astype(float), (i // self.side).astype(float)
        if self.distribution == MIXED:
            return self._mixed(count)
        width = DRAWS[self.distribution]
        random = bits(self.seed, self.drawn, width * count).reshape(count, width)
        self.drawn += width * count
        along = unit(random[:, 0])
        if self.distribution == UNIFORM:
            return along, unit(random[:, 1])
        across = BAND * bell(random[:, 1:1 + BELL])
        if self.distribution == CIRCLE:
            return on_ray(along, CIRCLE_RADIUS + across)
        if self.distribution == SPIRAL:
            turns = SPIRAL_TURNS * numpy.sqrt(along)
            return on_ray(turns - numpy.floor(turns), SPIRAL_PITCH * turns + across)
        x, y = along, along + across
        return (x, numpy.where(toss(random[:, -1]), y, 1.0 - y)) if self.distribution == CROSS else (x, y)

    def _mixed(self, count):
        """How many numbers a point takes depends on its first: where each begins is found in turn."""
        random = bits(self.seed, self.drawn, DRAWS_OF_MIXED[0] * count)
        even = toss(random).tolist()
        begins, at = [], 0
        for _ in range(count):
            begins.append(at)
            at += DRAWS_OF_MIXED[even[at]]
        self.drawn += at
        begins = numpy.array(begins)
        in_square = toss(random[begins])
        x, y = unit(random[begins + 1]), unit(random[begins + 2])
        rows = begins[~in_square]
        centers = self.centers[(random[rows + 1] % _U(CLUSTERS)).astype(int)]
        columns = rows[:, None] + 2 + numpy.arange(2 * BELL)
        x[~in_square] = centers[:, 0] + BAND * bell(random[columns[:, :BELL]])
        y[~in_square] = centers[:, 1] + BAND * bell(random[columns[:, BELL:]])
        return x, y
