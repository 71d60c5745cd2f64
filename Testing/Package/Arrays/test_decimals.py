# SPDX-License-Identifier: BSD-3-Clause
"""Rasters over bounds and of cells that were written in decimal, against rational arithmetic: rounding of decimals to
float64 neither adds a row nor drops one, and nothing else is rounded away.
"""

import math
import unittest
from fractions import Fraction

import numpy as np

from adaptivehilbertdelaunay._raster import raster_over

SIZES = ("0.1", "0.2", "0.3", "0.7", "1.1", "0.01", "0.025", "1e-3", "3", "30", "1e5", "0.333")
ORIGINS = ("0", "0.1", "-0.3", "1.7", "-1234.5", "448000.1", "-5411000.7")


def shape(low, high, size, align=False):
    made = raster_over((low, high, 0.0, 1.0), size, align=align)
    return made.shape[1], made


class DecimalsTest(unittest.TestCase):
    def test_whole_numbers_of_cells(self):
        for size in map(Fraction, SIZES):
            for low in map(Fraction, ORIGINS):
                for count in (1, 2, 3, 6, 7, 11, 29, 100, 999):
                    columns, made = shape(float(low), float(low + count * size), (float(size), 1.0))
                    self.assertEqual(columns, count, (low, size))
                    self.assertEqual(made.spacing[0], float(size))
                    self.assertAlmostEqual(made.origin[0], float(low + size / 2), delta=1e-15 * max(1, abs(low)))

    def test_parts_of_cells_have_a_cell(self):
        for size in map(Fraction, SIZES):
            for low in map(Fraction, ORIGINS):
                for count in (0, 1, 5, 64):
                    for part in (Fraction(1, 1000), Fraction(1, 2), Fraction(999, 1000)):
                        columns, _ = shape(float(low), float(low + (count + part) * size), (float(size), 1.0))
                        self.assertEqual(columns, count + 1, (low, size, part))

    def test_aligned_borders(self):
        for size in map(Fraction, SIZES):
            for first in (-1000, -7, -1, 0, 1, 3, 110):
                for low_part, high_part in ((0, 0), (Fraction(1, 3), 0), (0, Fraction(2, 3)), (Fraction(1, 2),) * 2):
                    low, high = (first + low_part) * size, (first + 5 + high_part) * size
                    columns, made = shape(float(low), float(high), (float(size), 1.0), align=True)
                    self.assertEqual(columns, 5 + math.ceil(high_part), (first, size, low_part, high_part))
                    self.assertAlmostEqual(made.origin[0], float((first + Fraction(1, 2)) * size),
                                           delta=1e-15 * max(1, float(abs(first * size))))

    def test_doubles_that_are_no_decimals(self):
        """Exact quotients at least a thousandth of a cell off a whole number: rounded up, nothing else."""
        numbers = np.random.default_rng(11)
        for _ in range(3000):
            low, size = numbers.normal() * 10.0 ** numbers.integers(-3, 4), 10.0 ** numbers.uniform(-2, 2)
            high = low + size * numbers.uniform(0, 300)
            cells = (Fraction(high) - Fraction(low)) / Fraction(size)
            if abs(cells - round(cells)) > Fraction(1, 1000):
                self.assertEqual(shape(low, high, (size, 1.0))[0], max(1, math.ceil(cells)), (low, high, size))


if __name__ == "__main__":
    unittest.main()
