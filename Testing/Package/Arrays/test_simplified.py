# SPDX-License-Identifier: BSD-3-Clause
"""delaunay(maximum_error=...) and Triangulation.simplify(): against their definition, at all points."""

import pickle
import sys
import threading
import unittest
import warnings

import numpy as np
from adaptivehilbertdelaunay import DelaunayWarning, delaunay
from arraysupport import KeywordTest, cloud, lattice

BOUND = 0.02
TURNED = np.array([(0.8, -0.6, 0, 0), (0.6, 0.8, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)])


def hills(seed=1, count=3000):
    points = cloud(seed, count)
    return points, np.sin(6 * points[:, 0]) * np.cos(5 * points[:, 1])


def kept(made):
    return np.flatnonzero(made.point_status >= 0)


class SimplifiedTest(KeywordTest):
    def check(self, made, points, values, bound):
        """All points are within the bound, and the triangles are those of the kept points alone."""
        off = np.abs(made.interpolate(values, points[:, :2]) - values)
        self.assertLessEqual(off.max(), bound * (1 + 1e-9))
        self.assertAlmostEqual(off.max(), made.measures["largest_error"], delta=1e-12)
        left = kept(made)
        self.assertEqual(made.counts["within_error"], len(points) - len(left))
        self.assertTrue((made.point_status[made.point_status < 0] == -3).all())
        np.testing.assert_array_equal(made.triangles, left[delaunay(points[left]).triangles])
        np.testing.assert_array_equal(np.sort(made.point_of_vertex), left)
        self.assertLess(len(left), len(points) / 4)

    def test_maximum_error(self):
        points, z = hills()
        made = delaunay(np.column_stack((points, z)), maximum_error=BOUND, want="point_status")
        self.check(made, points, z, BOUND)
        self.assertLessEqual(set(delaunay(points).hull.tolist()), set(kept(made).tolist()))
        by_heights = delaunay(points, heights=z, maximum_error=BOUND)
        np.testing.assert_array_equal(by_heights.triangles, made.triangles)
        np.testing.assert_array_equal(by_heights.points, np.column_stack((points, z)))
        self.assertIn("within error: %d" % made.counts["within_error"], made._repr_html_())

    def test_maximum_vertices(self):
        points, z = hills()
        light = [delaunay(points, heights=z, maximum_vertices=count) for count in (100, 400)]
        for made, count in zip(light, (100, 400)):
            self.assertTrue(0.95 * count <= made.counts["inserted"] <= count, made.counts["inserted"])
        errors = [np.abs(made.interpolate(z, points) - z).max() for made in light]
        self.assertLess(errors[1], errors[0])
        self.assertAlmostEqual(light[1].measures["largest_error"], errors[1], delta=1e-12)
        both = delaunay(points, heights=z, maximum_vertices=2000, maximum_error=BOUND)
        self.check(both, points, z, BOUND)

    def test_second_pass(self):
        points, z = hills()
        once, twice = (delaunay(points, heights=z, maximum_error=BOUND, second_pass=again) for again in (False, True))
        self.check(twice, points, z, BOUND)
        self.assertLess(len(twice.triangles), len(once.triangles))

    def test_simplify_is_delaunay_of_the_same(self):
        points, z = hills(2)
        given = np.column_stack((points, z))
        chain = delaunay(points).locate([[0.2, 0.2], [0.5, 0.8], [0.8, 0.3]]).corners[:, 0]
        for more in ({}, {"segments": [chain[:2]], "rim": "trimmed"}, {"loops": [chain]}, {"tolerance": 0.005},
                     {"plane": TURNED}, {"source_points": [[0.1, 0.1, 0], [0.7, 0.6, 0]], "lines": [0, 1]},
                     {"skip": points[:, 0] > 0.7}, {"id_dtype": np.int64}):  # fmt: skip
            made, expected = delaunay(given, **more).simplify(BOUND), delaunay(given, maximum_error=BOUND, **more)
            self.assertGreater(made.counts["within_error"], 1000)
            np.testing.assert_array_equal(made.triangles, expected.triangles, str(more))
            np.testing.assert_array_equal(made.point_status, expected.point_status)
            self.assertEqual(made.triangles.dtype, expected.triangles.dtype)
            stay = chain[:2] if "segments" in more else chain if "loops" in more else []
            self.assertTrue((made.point_status[stay] == stay).all())

    def test_the_points_stay_the_callers(self):
        points, z = hills()
        given = np.column_stack((points, z))
        made = delaunay(given)
        light = made.simplify(BOUND)
        self.assertTrue(np.shares_memory(light.points, given))
        self.assertTrue(np.shares_memory(made.simplify(BOUND, values=-z).points, given))
        again = light.simplify(BOUND / 4)  # of all points
        np.testing.assert_array_equal(again.triangles, delaunay(given, maximum_error=BOUND / 4).triangles)
        given[5] = 7
        for changed in (made, light):
            with self.assertRaisesRegex(RuntimeError, "points were changed"):
                changed.simplify(BOUND)

    def test_values(self):
        """In place of z: as of points that have them as z, with what became of all."""
        points, z = hills()
        given = np.column_stack((points, np.random.default_rng(5).random(len(points))))
        for more in ({}, {"skip": points[:, 0] > 0.7}, {"loops": [delaunay(points).hull]}, {"rim": "trimmed"}):
            made = delaunay(given, **more).simplify(BOUND, values=z)
            expected = delaunay(points, heights=z, maximum_error=BOUND, **more)
            for copy in (made, pickle.loads(pickle.dumps(made))):
                np.testing.assert_array_equal(copy.triangles, expected.triangles)
                np.testing.assert_array_equal(copy.point_status, expected.point_status)
                for name in ("within_error", "skipped", "inserted", "triangles", "duplicates"):
                    self.assertEqual(copy.counts[name], expected.counts[name], name)
                self.assertEqual(copy.measures["largest_error"], expected.measures["largest_error"])
                np.testing.assert_array_equal(copy.points, given)
        crossing = delaunay(points).locate([[0.2, 0.2], [0.8, 0.8], [0.2, 0.8], [0.8, 0.2]]).corners[:, 0].reshape(2, 2)
        made = delaunay(points, segments=crossing, crossings="split").simplify(BOUND, values=z)
        expected = delaunay(points, heights=z, segments=crossing, crossings="split", maximum_error=BOUND)
        np.testing.assert_array_equal(made.triangles, expected.triangles)
        self.assertEqual(made.counts["added_points"], 1)

    def test_values_and_merged_points(self):
        """Those that go with the point they were merged into are merged still, not skipped."""
        points, z = hills()
        points, z = np.concatenate((points, points[:300] + 1e-6)), np.concatenate((z, z[:300]))
        made = delaunay(points, tolerance=1e-5).simplify(BOUND, values=z)
        expected = delaunay(points, heights=z, tolerance=1e-5, maximum_error=BOUND)
        np.testing.assert_array_equal(made.triangles, expected.triangles)
        for copy in (made, pickle.loads(pickle.dumps(made))):
            np.testing.assert_array_equal(copy.merged, expected.merged)
            for name in ("within_error", "skipped", "merged_points", "duplicates"):
                self.assertEqual(copy.counts[name], expected.counts[name], name)
        self.assertGreaterEqual(expected.counts["merged_points"], 300)

    def test_values_in_a_plane(self):
        """They count along its normal."""
        points, z = hills()
        wall = np.column_stack((points[:, 0], np.zeros(len(points)), points[:, 1]))
        made = delaunay(wall, plane="best_fit").simplify(BOUND, values=z)
        places = made.plane_points[:, :2]
        self.check(made, places, z, BOUND)
        np.testing.assert_array_equal(made.points, wall)

    def test_values_that_are_not_finite_stay(self):
        points, z = hills()
        z[:5] = np.nan, np.inf, -np.inf, np.nan, np.nan
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            made = delaunay(points).simplify(BOUND, values=z)
        self.assertEqual(made.point_status[:5].tolist(), [0, 1, 2, 3, 4])
        self.assertGreater(made.counts["within_error"], 1000)

    def test_values_of_source_points(self):
        """Theirs, or those of the surface where their heights are; without either they stay, with all around them."""
        points, z = hills()
        given = np.column_stack((points, z * 0))
        own = np.array([[0.1, 0.1, 0], [0.7, 0.6, 0]])
        made = delaunay(given, source_points=own, lines=[0, 1])
        both = np.concatenate((z, [0.3, 0.4]))
        every = np.column_stack((np.concatenate((points, own[:, :2])), both))
        expected = delaunay(every, lines=[3000, 3001], maximum_error=BOUND)
        light = made.simplify(BOUND, values=both)
        np.testing.assert_array_equal(light.triangles, expected.triangles)
        without = made.simplify(BOUND, values=z)
        around = np.unique(without.triangles[(without.triangles >= 3000).any(1)])
        self.assertFalse(np.isnan(without.errors[:3000]).any())
        self.assertTrue((without.errors[around] == 0).all())
        laid = delaunay(given, source_points=own, lines=[0, 1], source_heights="surface").simplify(BOUND, values=z)
        expected = delaunay(points, heights=z, source_points=own, lines=[0, 1], source_heights="surface",
                            lines_on_surface=True, maximum_error=BOUND)  # fmt: skip
        np.testing.assert_array_equal(laid.triangles, expected.triangles)

    def test_values_and_the_choice_among_duplicates(self):
        """z chooses, and the value of the chosen one counts."""
        points, z = hills()
        twice, rising = np.concatenate((points, points)), np.concatenate((z * 0, z * 0 + 1))
        made = delaunay(twice, heights=rising, duplicates="highest_z")
        light = made.simplify(BOUND, values=np.concatenate((z * 0, z)))
        np.testing.assert_array_equal(light.triangles, delaunay(points, heights=z).simplify(BOUND).triangles + 3000)

    def test_weights_and_keep(self):
        points, z = hills()
        weights, keep = np.where(points[:, 0] < 0.5, 5.0, 0.2), np.arange(3000) % 100 == 0
        weights[7:10] = np.nan, -1, np.inf
        made = delaunay(points, heights=z, weights=weights, keep=keep, maximum_error=BOUND)
        off = np.abs(made.interpolate(z, points) - z)
        out = made.point_status == -3
        self.assertLessEqual((off[out] * weights[out]).max(), BOUND * (1 + 1e-9))
        self.assertGreater(off[out].max(), 2 * BOUND)
        self.assertTrue((made.point_status[keep] >= 0).all() and (made.point_status[7:10] >= 0).all())
        for given in (points, np.column_stack((points, z))):
            values = z if given is points else None
            again = delaunay(given).simplify(BOUND, values=values, weights=weights, keep=keep.view(np.uint8))
            np.testing.assert_array_equal(again.triangles, made.triangles)
            np.testing.assert_array_equal(again.simplify(BOUND).triangles, made.triangles)  # of all points, with them
        plain = again.simplify(BOUND, weights=np.ones(3000), keep=np.zeros(3000, bool))
        np.testing.assert_array_equal(plain.triangles, delaunay(points, heights=z, maximum_error=BOUND).triangles)
        weights[:] = 0  # they are copied
        self.assertEqual(made.errors.max(), pickle.loads(pickle.dumps(made)).errors.max())
        for name, wrong in (("weights", z[:5]), ("keep", keep[:5]), ("values", z[:5]), ("weights", None)):
            kind = ValueError if wrong is not None else TypeError
            with self.assertRaisesRegex(kind, name):
                delaunay(points).simplify(BOUND, **{name: z.astype(str) if wrong is None else wrong})

    def test_errors(self):
        points, z = hills()
        for more in ({"maximum_error": BOUND}, {"maximum_vertices": 300, "second_pass": True},
                     {"insertion_limit": 900}):  # fmt: skip
            made = delaunay(points, heights=z, want="errors", **more)
            off = np.abs(made.interpolate(z, points) - z)
            np.testing.assert_array_equal(np.isnan(made.errors), np.isnan(off))
            np.testing.assert_allclose(made.errors, off, atol=1e-12)
            self.assertTrue((made.errors[made.point_status >= 0] == 0).all())
            if "insertion_limit" not in more:
                self.assertEqual(made.errors.max(), made.measures["largest_error"])
        ring = delaunay(points).locate([[0.2, 0.2], [0.8, 0.2], [0.5, 0.8]]).corners[:, 0]
        made = delaunay(points, heights=z, tolerance=0.01, loops=[ring], skip=points[:, 0] > 0.9)
        off = np.where(points[:, 0] > 0.9, np.nan, np.abs(made.interpolate(z, points) - z))
        self.assertTrue(0 < np.isnan(off).mean() < 1 and made.counts["merged_points"] > 100)
        np.testing.assert_allclose(made.errors, off, atol=1e-12)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            self.assertTrue(np.isnan(delaunay(points[:2]).errors).all())

    def test_errors_are_exact(self):
        """0 on the surface, however it rounds; the difference from z of others at one place; NaN of no value."""
        points = lattice(9) / 7 + 1e6
        z = 3 * points[:, 0] - points[:, 1]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            twice = np.concatenate((points, points[:2]))
            made = delaunay(twice, heights=np.r_[z, z[0] + 3, np.nan], maximum_error=1e-3)
        self.assertEqual(made.errors[-2], abs(made.points[-2, 2] - made.points[0, 2]))
        self.assertTrue(np.isnan(made.errors[-1]))
        self.assertLess(made.errors[:-2].max(), 1e-9)
        flat = delaunay(np.column_stack((lattice(9) * 0.1, np.full(81, 0.1)))).simplify(0)
        self.assertEqual((flat.counts["inserted"], flat.errors.max()), (4, 0))

    def test_zero(self):
        """The keyword of delaunay is off, that of simplify leaves out what is exactly on the surface."""
        points = lattice(9)
        made = delaunay(points, heights=points @ [1, 2], maximum_error=0)
        self.assertEqual((made.counts["within_error"], len(made.triangles)), (0, 128))
        self.assertEqual(made.simplify(0).counts["inserted"], 4)
        self.assertEqual(made.simplify(0.0, values=made.points[:, 2] ** 2 * 0).counts["inserted"], 4)

    def test_memory_and_interrupts(self):
        points, z = hills(3, 200000)
        made = delaunay(points, heights=z)
        for values in (None, z):
            with self.assertRaises(MemoryError):
                delaunay(points, heights=z, memory_limit="45 MB").simplify(1e-6, values=values)

            def stop(phase, fraction):
                raise KeyboardInterrupt

            with self.assertRaises(KeyboardInterrupt):
                made.simplify(1e-6, values=values, progress=stop)
            told = []
            made.simplify(0.01, values=values, progress=lambda phase, fraction: told.append((phase, fraction)))
            self.assertGreater(len(told), 10)
            self.assertTrue(all(0 <= fraction <= 1 for _, fraction in told))
        self.assertEqual(threading.active_count(), 1)
        made.release()
        self.assertGreater(made.simplify(0.01).counts["within_error"], 100000)

    def test_order_and_threads(self):
        points, z = hills()
        order = np.random.default_rng(4).permutation(len(points))
        made = delaunay(points, heights=z, maximum_error=BOUND, threads=1)
        other = delaunay(points[order], heights=z[order], maximum_error=BOUND, threads=2)
        self.assertEqual(set(kept(made).tolist()), set(order[kept(other)].tolist()))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
