#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Write survey.csv, the demo's sample: soundings of a sea that exists nowhere.

    python3 Data/make_survey.py [FILE]          (default: survey.csv beside this script)

What a hydrographer would find in it:
  * 59 survey lines about 900 m apart, a sounding every 220 m, ends ragged, lines wavering
  * 5 cross lines; where one crosses a line, both log the very same position (a duplicate)
  * a station where the ship lay still: 25 soundings in one place (24 duplicates)
  * a closed area nobody may enter, and a dense diagonal patch over a seamount
  * relief worth looking at: shelf, slope cut by a canyon, seamount, fault scarp, small knolls

Positions are made in kilometres and written in metres, east and north of a corner of the area, to
0.1, as elevations are. The same bytes come out every time: the random numbers are SplitMix64,
written out below.
"""

import math
import os
import sys

EAST, NORTH = 80.0, 54.0  # size of the area in km
CLOSED = (15.0, 10.5, 3.4)  # closed area: centre x, y and radius in km
SEAMOUNT = (60.0, 37.0)


class SplitMix64:
    """The generator of Steele, Lea and Flood (2014); 64 bits of state."""

    MASK = (1 << 64) - 1

    def __init__(self, seed):
        self.state = seed & self.MASK

    def bits(self):
        self.state = (self.state + 0x9E3779B97F4A7C15) & self.MASK
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & self.MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & self.MASK
        return z ^ (z >> 31)

    def uniform(self, low=0.0, high=1.0):
        return low + (high - low) * (self.bits() >> 11) / float(1 << 53)

    def bell(self):
        """Mean 0, deviation 1, never beyond 4.9: a sum of eight uniforms."""
        return (sum(self.uniform() for _ in range(8)) - 4.0) / math.sqrt(8.0 / 12.0)


def lattice_noise(ix, iy, seed):
    """A fixed random number in [-1, 1] for a lattice point."""
    return SplitMix64(ix * 0x1F123BB5 ^ iy * 0x5F356495 ^ seed * 0x2545F491).uniform(-1.0, 1.0)


def smooth_noise(x, y, seed):
    """Lattice noise, smoothly interpolated; one bump is about one unit wide."""
    ix, iy = math.floor(x), math.floor(y)
    fx, fy = x - ix, y - iy
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
    low = lattice_noise(ix, iy, seed) * (1 - fx) + lattice_noise(ix + 1, iy, seed) * fx
    high = lattice_noise(ix, iy + 1, seed) * (1 - fx) + lattice_noise(ix + 1, iy + 1, seed) * fx
    return low * (1 - fy) + high * fy


def make_knolls(random):
    """Small cones on the deep floor: x, y, height in m, radius in km."""
    return [
        (random.uniform(45, 79), random.uniform(2, 26), random.uniform(60, 330), random.uniform(0.7, 1.9))
        for _ in range(16)
    ]


def slope(x, y):
    """Shelf at -130 m, slope, deep floor at -3300 m. Also how far down the slope: 0 to 1."""
    edge = 29.0 + 3.5 * math.sin(y / 8.0) + 1.5 * math.sin(y / 3.1 + 1.0)
    down = 1.0 / (1.0 + math.exp(-(x - edge) / 3.6))
    return -130.0 - 2.2 * x - 3000.0 * down, down


def canyon(x, y, down):
    """How many metres the canyon and its two side arms are cut into the slope."""
    total = 0.0
    for start, end, middle, swing, depth, width in (
        (15.0, 66.0, 25.0, 4.0, 1150.0, 1.3),
        (22.0, 44.0, 31.0, 2.0, 520.0, 0.8),
        (23.0, 42.0, 17.5, -2.0, 430.0, 0.7),
    ):
        # the arms run into the main canyon, which wanders more the deeper it gets
        line = middle + swing * math.sin((x - 14.0) / 6.5)
        if middle != 25.0:
            main = 25.0 + 4.0 * math.sin((x - 14.0) / 6.5)
            share = min(1.0, max(0.0, (x - start) / (end - start)))
            line = line * (1 - share) + main * share
        along = min(1.0, max(0.0, (x - start) / 14.0)) * min(1.0, max(0.0, (end - x) / 22.0))
        across = (y - line) / (width * (0.6 + down))
        total = max(total, depth * along / (1.0 + across * across) ** 1.5)
    return total


def seamount(x, y):
    """A volcano of 2450 m with three ridges, a flat top and a small crater."""
    dx, dy = x - SEAMOUNT[0], y - SEAMOUNT[1]
    distance = math.hypot(dx, dy)
    ridge = 1.0 + 0.22 * math.cos(3.0 * math.atan2(dy, dx) + 0.7) * min(1.0, distance / 2.0)
    height = 2650.0 * math.exp(-((distance / (4.6 * ridge)) ** 1.5))
    return min(height, 2450.0) - 160.0 * math.exp(-((distance / 0.5) ** 2))


def elevation(x, y, knolls):
    """Elevation of the sea floor in metres at x, y in km."""
    z, down = slope(x, y)
    z -= canyon(x, y, down)
    z += seamount(x, y)
    z += 260.0 * down / (1.0 + math.exp(-(0.35 * x - y - 7.0) / 0.12))  # fault scarp
    for kx, ky, height, radius in knolls:
        z += height * math.exp(-((x - kx) ** 2 + (y - ky) ** 2) / radius**2)
    for octave in range(4):
        size = 6.0 / 2**octave
        z += (4.0 + 62.0 * down) / 1.9**octave * smooth_noise(x / size, y / size, 11 + octave)
    return z


class Survey:
    """Sails the lines and keeps the log."""

    def __init__(self):
        self.random = SplitMix64(20160229)
        self.knolls = make_knolls(SplitMix64(54))
        self.rows = []

    def sound(self, x, y):
        """Log a sounding, unless the place is closed. An echo sounder errs by 0.15 % of depth."""
        if math.hypot(x - CLOSED[0], y - CLOSED[1]) < CLOSED[2]:
            return
        z = elevation(x, y, self.knolls) * (1.0 + 0.0015 * self.random.bell())
        self.rows.append("%.1f,%.1f,%.1f" % (1000 * x, 1000 * y, z))

    @staticmethod
    def line_north(line, x):
        """North of survey line number `line` at x; it wavers by some 100 m."""
        return 0.45 + 0.9 * line + 0.16 * smooth_noise(x / 9.0, line * 7.3, 31)

    @staticmethod
    def cross_east(cross, y):
        """East of cross line number `cross` at y."""
        return 8.0 + 16.0 * cross + 0.25 * smooth_noise(y / 9.0, cross * 3.7, 47)

    def crossing(self, line, cross):
        """Where the two meet. Both waver gently, so going back and forth settles quickly."""
        y = 0.45 + 0.9 * line
        for _ in range(40):
            x = self.cross_east(cross, y)
            y = self.line_north(line, x)
        return x, y

    def sail_line(self, line):
        start, end = self.random.uniform(0.0, 1.6), EAST - self.random.uniform(0.0, 1.6)
        stops = [self.crossing(line, cross) for cross in range(5)]
        x = start
        while x < end:
            stops.append((x, self.line_north(line, x)))
            x += 0.22 * self.random.uniform(0.9, 1.1)
        for x, y in sorted(stops, reverse=line % 2 == 1):  # there and back again
            self.sound(x, y)

    def sail_cross(self, cross):
        stops = [self.crossing(line, cross) for line in range(59)]
        y = self.random.uniform(-1.5, 0.0)
        while y < NORTH:
            stops.append((self.cross_east(cross, y), y))
            y += 0.22 * self.random.uniform(0.9, 1.1)
        for x, y in sorted(stops, key=lambda stop: stop[1]):
            self.sound(x, y)

    def sail_patch(self):
        """Diagonal lines 300 m apart over the seamount."""
        for number in range(-20, 21):
            across, along = 0.3 * number, -6.0
            while along < 6.0:
                if math.hypot(across, along) < 6.0:
                    east = SEAMOUNT[0] + (along - across) / math.sqrt(2)
                    self.sound(east, SEAMOUNT[1] + (along + across) / math.sqrt(2))
                along += 0.13 * self.random.uniform(0.9, 1.1)

    def sail(self):
        for line in range(59):
            self.sail_line(line)
        for cross in range(5):
            self.sail_cross(cross)
        self.sail_patch()
        for _ in range(25):
            self.sound(70.3, 8.7)  # on station
        return self.rows


def main():
    default = os.path.join(os.path.dirname(os.path.abspath(__file__)), "survey.csv")
    path = sys.argv[1] if len(sys.argv) > 1 else default
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write("x,y,elevation\n" + "\n".join(Survey().sail()) + "\n")


if __name__ == "__main__":
    main()
