# SPDX-License-Identifier: BSD-3-Clause
"""What progress functions are told: phases in their order, fractions that go up, about each hundredth of the whole and
no more, whatever is asked for.
"""

import time
import unittest
import warnings

from adaptivehilbertdelaunay import DelaunayWarning, _library, delaunay
from arraysupport import cloud

POINTS = cloud(1, 30000, 3)
STEP, SILENCE = 0.01, 1 / 12  # JobProgress.cxx: it speaks after either,
BEGINNINGS = 25  # and where a phase or a part of one begins
KEYWORDS = (
    {}, {"want": ("neighbors", "regions", "voronoi", "boxes", "order")}, {"threads": 1}, {"tolerance": 1e-4},
    {"plane": "best_fit"}, {"alpha": 0.02, "maximum_edge_length": 0.1}, {"duplicates": "mean_z", "rim": "trimmed"},
    {"segments": [[k, k + 1] for k in range(0, 60, 2)], "crossings": "split"},
    {"source_points": cloud(2, 500, 3), "lines": [list(range(500))], "source_heights": "surface", "crossings": "split"},
)  # fmt: skip


class ProgressTest(unittest.TestCase):
    def check(self, told, phases):
        self.assertGreater(len(told), 3)
        for (_, done, _), (_, more, _) in zip(told, told[1:]):
            self.assertLessEqual(done, more)
        seconds = told[-1][2] - told[0][2]
        self.assertLess(len(told), 1 / STEP + seconds / SILENCE + BEGINNINGS)
        self.assertTrue(all(0 <= done <= 1 for _, done, _ in told))
        self.assertTrue({phase for phase, _, _ in told} <= set(phases), told)
        return max(done for _, done, _ in told)

    def test_of_triangulations(self):
        for keywords in KEYWORDS:
            told = []
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DelaunayWarning)
                delaunay(POINTS, progress=lambda *now: told.append((*now, time.monotonic())), **keywords)
            order = list(dict.fromkeys(phase for phase, _, _ in told))
            self.assertIn(order[0], ("merge", "read"))
            self.assertGreater(self.check(told, _library.PHASES), 0.9, keywords)

    def test_of_values(self):
        made = delaunay(POINTS)
        places = cloud(3, 60000)  # 64 steps each
        for method in ("linear", "natural", "laplace", "nearest"):
            for outside in (0.0, "nearest"):
                told = []
                made.interpolate(POINTS[:, 2], places, method, outside=outside,
                                 progress=lambda *now: told.append((*now, time.monotonic())))  # fmt: skip
                self.assertGreater(self.check(told, ("outputs",)), 0.9, (method, outside))


if __name__ == "__main__":
    unittest.main()
