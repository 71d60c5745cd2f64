# SPDX-License-Identifier: BSD-3-Clause
"""Arguments of progress functions, for every request: known phases, and fractions that only rise, nearly to 1.
"""

import sys
import unittest
import warnings

from adaptivehilbertdelaunay import DelaunayWarning, _library, delaunay
from arraysupport import cloud

POINTS = cloud(1, 30000, 3)
KEYWORDS = (
    {}, {"want": ("neighbors", "regions", "voronoi", "boxes", "order")}, {"threads": 1}, {"tolerance": 1e-4},
    {"plane": "best_fit"}, {"alpha": 0.02, "maximum_edge_length": 0.1}, {"duplicates": "mean_z", "rim": "trimmed"},
    {"segments": [[k, k + 1] for k in range(0, 60, 2)], "crossings": "split"},
    {"source_points": cloud(2, 500, 3), "lines": [list(range(500))], "source_heights": "surface", "crossings": "split"},
)  # fmt: skip


class ProgressTest(unittest.TestCase):
    def check(self, told, phases):
        self.assertGreater(len(told), 3)
        fractions = [done for _, done in told]
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(0 <= fractions[0] and fractions[-1] <= 1, told)
        self.assertTrue({phase for phase, _ in told} <= set(phases), told)
        self.assertGreater(fractions[-1], 0.8)

    def test_of_triangulations(self):
        for keywords in KEYWORDS:
            told = []
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DelaunayWarning)
                delaunay(POINTS, progress=lambda *now: told.append(now), **keywords)
            self.assertIn(told[0][0], ("merge", "read"))
            self.check(told, _library.PHASES)

    def test_of_values(self):
        made = delaunay(POINTS)
        places = cloud(3, 60000)
        for method in ("linear", "natural", "laplace", "nearest"):
            for outside in (0.0, "nearest"):
                told = []
                made.interpolate(POINTS[:, 2], places, method, outside=outside,
                                 progress=lambda *now: told.append(now))  # fmt: skip
                self.check(told, ("outputs",))

    def test_none_is_called_for_a_function_that_was_taken_away(self):
        """A callback takes the GIL, and about a microsecond."""
        calls, job = [], _library.Job()

        def see(frame, event, _):
            calls.extend([1] if event == "call" and frame.f_code.co_name == "_on_progress" else [])

        before = sys.getprofile()
        self.addCleanup(sys.setprofile, before)
        job.set_array("points", POINTS[:50])
        for progress, isCalled in ((None, False), (lambda *_: None, True), (None, False)):
            calls.clear()
            job.set_progress(progress)
            sys.setprofile(see)
            job.run()
            job.array("triangles")
            sys.setprofile(before)
            self.assertEqual(len(calls) > 0, isCalled)


if __name__ == "__main__":
    unittest.main()
