# SPDX-License-Identifier: BSD-3-Clause
"""delaunay: what keywords do that change how it runs and what it puts out, not which triangles there are. Others:
test_keywords.py."""

import inspect
import math
import pathlib
import pickle
import re
import unittest

import numpy as np
from adaptivehilbertdelaunay import DelaunayWarning, delaunay
from adaptivehilbertdelaunay import _library as library
from arraysupport import KeywordTest, cloud


class InsertionTest(KeywordTest):
    def test_no_setting_changes_a_triangle(self):
        points = cloud(31, 500)
        expected = delaunay(points)
        for settings in (
            {"insertion_order": "adaptive_hilbert", "control_points": "off"}, {"insertion_order": "multi_grid"},
            {"insertion_order": "regular_grid"}, {"insertion_order": "as_given"}, {"nmax": 1}, {"nmax": 2**31 - 1},
            {"control_points": "single_level", "gene_rotation": False}, {"count_work": True},
            {"threads": 1}, {"threads": 3}, {"insertion_limit": 500},
        ):  # fmt: skip
            made = delaunay(points, **settings)
            np.testing.assert_array_equal(made.triangles, expected.triangles, str(settings))

    def test_they_change_the_order(self):
        points = cloud(32, 500)
        orders = {name: delaunay(points, insertion_order=name).order.tolist()
                  for name in ("adaptive_hilbert", "multi_grid", "regular_grid", "as_given")}  # fmt: skip
        orders["off"] = delaunay(points, control_points="off").order.tolist()
        orders["no genes"] = delaunay(points, control_points="off", gene_rotation=False, nmax=3).order.tolist()
        orders["nmax"] = delaunay(points, control_points="off", nmax=3).order.tolist()
        self.assertEqual(orders["as_given"], list(range(500)))
        self.assertEqual(len(set(map(tuple, orders.values()))), len(orders))
        self.assertTrue(all(sorted(order) == list(range(500)) for order in orders.values()))

    def test_order_ranks_and_boxes(self):
        points = cloud(33, 500)
        made = delaunay(points)
        self.assertEqual(made.insertion_ranks[made.order].tolist(), list(range(500)))
        bounds, levels, counts = made.boxes
        self.assertEqual((counts.sum(), bounds.shape, levels.dtype), (500, (len(counts), 4), np.int32))
        self.assertGreater(len(counts), 4)
        self.assertGreater(len(delaunay(points, nmax=2).boxes.counts), len(counts))
        self.assertEqual(len(delaunay(points, insertion_order="as_given").boxes.counts), 0)

    def test_insertion_limit(self):
        points = cloud(34, 500)
        made = delaunay(points, insertion_limit=100)
        first = made.order
        self.assertEqual((len(first), made.counts["beyond_limit"]), (100, 400))
        alone = delaunay(points[np.sort(first)])
        found = {frozenset(triangle) for triangle in made.triangles.tolist()}
        self.assertEqual(found, {frozenset(triangle) for triangle in np.sort(first)[alone.triangles].tolist()})
        self.assertEqual((made.point_status == -2).sum(), 400)
        self.assertEqual(set(made.hull), set(np.sort(first)[alone.hull]))
        with self.assertWarnsRegex(DelaunayWarning, "no triangle yet"):
            delaunay(points, insertion_limit=2)

    def test_count_work(self):
        made = delaunay(cloud(35, 500), count_work=True)
        self.assertGreater(made.measures["np"], 1)
        self.assertGreater(made.measures["nr"], 1)
        self.assertEqual(delaunay(cloud(35, 500), count_work=False).measures["np"], -1)

    def test_threads(self):
        points = cloud(36, 60000)
        one, four = delaunay(points, threads=1), delaunay(points, threads=4)
        np.testing.assert_array_equal(one.triangles, four.triangles)
        self.assertEqual((one.counts["threads_used"], four.counts["threads_used"]), (1, 4))


class OutputTest(KeywordTest):
    def test_id_dtype(self):
        points = cloud(37)
        narrow, wide = delaunay(points, loops=[0, 1, 2]), delaunay(points, loops=[0, 1, 2], id_dtype=np.int64)
        for name in (
            "triangles", "neighbors", "edges", "boundary", "hull", "point_status", "vertex_of_point", "point_of_vertex",
            "regions", "order", "insertion_ranks", "constraint_edges", "merged", "left_out", "lines", "vertices",
        ):  # fmt: skip
            one, two = getattr(narrow, name), getattr(wide, name)
            self.assertEqual((one.dtype, two.dtype), (np.int32, np.int64), name)
            np.testing.assert_array_equal(one, two, name)
        self.assertEqual(wide.voronoi().sites.dtype, np.int64)
        self.assertEqual(wide.locate([[0.5, 0.5]]).triangle.dtype, np.int64)
        self.assertEqual(delaunay(points, id_dtype="int64").triangles.dtype, np.int64)

    def test_voronoi_clip(self):
        points = cloud(38)
        made = delaunay(points, voronoi_clip="bounds", want="voronoi")
        np.testing.assert_array_equal(made.voronoi().points, delaunay(points).voronoi("bounds").points)
        self.assertIs(made.voronoi(), made.voronoi("bounds"))
        np.testing.assert_array_equal(made.voronoi("hull").points, delaunay(points).voronoi().points)
        corners = np.array([[0.2, 0.1], [0.9, 0.4], [0.3, 0.8]])
        made, expected = delaunay(points, voronoi_clip=corners), delaunay(points).voronoi(corners).points
        corners[:] = 0  # they are copied
        other = delaunay(points, clip=[[0.2, 0.1], [0.9, 0.4], [0.3, 0.8]])
        for one in (made, other, pickle.loads(pickle.dumps(made))):
            np.testing.assert_array_equal(one.voronoi().points, expected)
            np.testing.assert_array_equal(one.voronoi("hull").points, delaunay(points).voronoi().points)

    def test_memory_limit(self):
        points = cloud(39, 10000)
        needed = delaunay(points).counts["memory_estimate"]
        self.assertGreater(needed, 10000 * 16)
        with self.assertRaisesRegex(MemoryError, str(needed)):
            delaunay(points, memory_limit=needed - 1)
        self.assertEqual(len(delaunay(points, memory_limit=needed).point_status), 10000)

    def test_what_triangulates_again(self):
        """Has the same threads and the same limit."""
        points = cloud(46, 2000)
        loop = [int(np.argmin(((points - place) ** 2).sum(axis=1))) for place in ((0.3, 0.3), (0.7, 0.3), (0.5, 0.7))]
        made = delaunay(points, loops=[loop], threads=1, memory_limit=60_000_000)
        seen, run = [], library.Job.run
        self.addCleanup(setattr, library.Job, "run", run)

        def look(job):
            seen.append((job.get("threads"), job.get("memory_limit")))
            run(job)

        library.Job.run = look
        self.assertEqual(len(made.hull), len(delaunay(points, threads=1, memory_limit=60_000_000).hull))
        made.voronoi("bounds"), made.order
        made.release()
        made.neighbors
        self.assertEqual(seen, [(1, 60_000_000)] * 5)
        made = delaunay(points, loops=[loop], threads=1)
        made._request.settings["memory_limit"] = 1000
        with self.assertRaisesRegex(MemoryError, "allows 1 KB"):
            made.hull

    def test_too_many_crossings(self):
        points = cloud(45, 4000)
        pairs = np.arange(4000).reshape(-1, 2)
        with self.assertRaisesRegex(MemoryError, "need points in more than [0-9]+ places"):
            delaunay(points, segments=pairs, crossings="split", memory_limit=30 << 20)
        with self.assertWarns(DelaunayWarning):
            delaunay(points, segments=pairs, memory_limit=30 << 20)

    def test_progress(self):
        told = []
        delaunay(cloud(40, 50000), loops=[0, 1, 2], want=["neighbors", "voronoi"],
                 progress=lambda phase, done: told.append((phase, done)))  # fmt: skip
        phases, fractions = zip(*told)
        self.assertEqual(fractions, tuple(sorted(fractions)))
        self.assertEqual(min(fractions) >= 0 and max(fractions) <= 1, True)
        self.assertLessEqual({"read", "sort", "insert", "constrain", "extract", "outputs"}, set(phases))
        self.assertGreater(len(told), 20)

    def test_all_keywords_are_here(self):
        """Each is in a test of this folder, and in the docstring with its default."""
        text = "".join(path.read_text(encoding="utf-8") for path in pathlib.Path(__file__).parent.glob("test_*.py"))
        documented = inspect.getdoc(delaunay)
        for name, parameter in list(inspect.signature(delaunay).parameters.items())[1:]:
            self.assertTrue(name + "=" in text or '"%s":' % name in text, name)
            said = re.search("^%s : .*?(?:, default (.*)|, optional)$" % name, documented, re.MULTILINE)
            self.assertTrue(said, name)
            if said.group(1):
                self.assertEqual(eval(said.group(1), {"numpy": np}), parameter.default, name)
            else:
                self.assertIn(parameter.default, (None, ()), name)

    def test_offset_of_a_point(self):
        """A single point has no diagonal."""
        with self.assertWarns(DelaunayWarning):
            made = delaunay([[3, 4]], bounding=True)
        self.assertTrue(np.isfinite(made.points).all())
        self.assertTrue(math.isfinite(made.measures["trimmed_area"]))


if __name__ == "__main__":
    unittest.main()
