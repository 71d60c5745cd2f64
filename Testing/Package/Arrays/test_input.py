# SPDX-License-Identifier: BSD-3-Clause
"""delaunay: inputs, without unneeded copies, and refusals that name the argument."""

import collections
import re
import tracemalloc
import unittest
import warnings

import numpy as np
from adaptivehilbertdelaunay import LinearInterpolator, delaunay
from arraysupport import SQUARE, cloud


class Spoiled:
    """Not a number."""

    def __repr__(self):
        return "<spoiled>"


class PointsTest(unittest.TestCase):
    def ways(self, points):
        """The same numbers, laid out in every way."""
        count, columns = points.shape
        wide = np.full((2 * count, columns + 3), 9, points.dtype)
        wide[::2, 1 : 1 + columns] = points
        yield "columns of a wider array", wide[::2, 1 : 1 + columns]
        yield "backwards", points[::-1].copy()[::-1]
        yield "columns backwards", points[:, ::-1].copy()[:, ::-1]
        yield "Fortran's order", np.asfortranarray(points)
        record = np.zeros(count, [("id", "i2"), ("place", points.dtype, (columns,))])
        record["place"] = points
        yield "unaligned", record["place"]
        yield "the other byte order", points.astype(points.dtype.newbyteorder())
        frozen = points.copy()
        frozen.flags.writeable = False
        yield "read-only", frozen
        yield "a list", points.tolist()
        yield "read by the buffer protocol", memoryview(points)

    def test_any_layout(self):
        for dtype in (np.float64, np.float32):
            for columns in (2, 3):
                points = cloud(41, 300, columns, dtype)
                expected = delaunay(points)
                for name, same in self.ways(points):
                    made = delaunay(same)
                    np.testing.assert_array_equal(made.triangles, expected.triangles, name)
                    np.testing.assert_array_equal(made.points, expected.points, name)
                    np.testing.assert_array_equal(
                        made.locate(cloud(42, 9)).triangle, expected.locate(cloud(42, 9)).triangle
                    )

    def test_any_real_type(self):
        whole = np.random.default_rng(43).integers(0, 100, (50, 2))
        expected = delaunay(whole.astype(float))
        for dtype in (np.int8, np.uint8, np.int16, np.uint32, np.int64, np.uint64, np.float16, np.longdouble):
            np.testing.assert_array_equal(delaunay(whole.astype(dtype)).triangles, expected.triangles)
        self.assertEqual(len(delaunay(np.eye(3)[:, :2].astype(bool)).triangles), 1)
        repeated = np.broadcast_to(np.array([1.0, 2.0]), (4, 2))
        with self.assertWarns(UserWarning):
            self.assertEqual(delaunay(repeated).counts["duplicates"], 3)

    def test_points_are_not_copied(self):
        wide = cloud(44, 200, 7)
        for dtype in (np.float32, np.float64):
            points = wide.astype(dtype)
            for given in (points[:, :2], points[:, 3:6], points[::2, 1:3], points[::-1, :2], points[:, :2].copy()):
                made = delaunay(given)
                self.assertEqual(made.points.ctypes.data, given.ctypes.data)
                self.assertEqual(made.points.strides, given.strides)
                self.assertTrue(given.flags.writeable)

    def test_memory_in_python(self):
        """Nothing but the triangles is as large as the points, during the call or after it."""
        count = 200000
        wide = cloud(45, count, 5)
        for points in (wide[:, :2], wide[:, 1:4], wide[:, :2].copy(), wide.astype(np.float32)[:, 2:5]):
            tracemalloc.start()
            try:
                made = delaunay(points)
                held, peak = tracemalloc.get_traced_memory()
            finally:
                tracemalloc.stop()
            spare = points.itemsize * count  # half of the points
            self.assertLess(peak, made.triangles.nbytes + spare)
            self.assertLess(held, made.triangles.nbytes + spare / 8)

    def test_ids_are_not_copied(self):
        count = 400000
        points, pairs = cloud(46, count), np.stack((np.arange(count), np.arange(count)), axis=1)
        for ids in (pairs, pairs.astype(np.int32)):
            tracemalloc.start()
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    made = delaunay(points, segments=ids)
                _, peak = tracemalloc.get_traced_memory()
            finally:
                tracemalloc.stop()
            self.assertEqual(made.counts["segments_of_no_length"], count)
            self.assertLess(peak, made.triangles.nbytes + ids.nbytes / 2)


    def test_what_makes_arrays_is_asked_once(self):
        """It may read a file for that; its memory may be its own, which can change."""

        class Shows:
            def __init__(self, array):
                self.array, self.asked = array, 0

            def __array__(self, dtype=None, copy=None):
                self.asked += 1
                return self.array

        points, ids, marks = Shows(cloud(3)), Shows(np.array([[0, 1]])), Shows(np.zeros(200, bool))
        made = delaunay(points, segments=ids, skip=marks)
        self.assertEqual([one.asked for one in (points, ids, marks)], [1, 1, 1])
        for one, value in ((points, 7), (ids, 5), (marks, True)):
            made = delaunay(points, segments=ids, skip=marks)
            one.array[-1] = value
            self.assertRaises(RuntimeError, lambda made=made: made.neighbors)

    def test_masked_arrays_with_nothing_masked(self):
        points = cloud(47, 100, 3)
        chains, marks = np.arange(4), np.arange(100) % 7 == 6
        wanted = delaunay(points, lines=chains, skip=marks, source_points=points[:4])
        unmasked = np.ma.array(marks, mask=np.zeros(100, bool))
        made = delaunay(np.ma.array(points), lines=np.ma.array(chains), skip=unmasked,
                        source_points=np.ma.masked_equal(points[:4], 7))  # fmt: skip
        np.testing.assert_array_equal(made.triangles, wanted.triangles)
        np.testing.assert_array_equal(made.points, wanted.points)
        made = delaunay(np.ma.array(points))
        self.assertEqual(made.points.ctypes.data, points.ctypes.data)
        masked = np.ma.masked_less(points, 0.1)
        made = delaunay(masked.data, skip=masked.mask.any(axis=1))  # as the refusal says
        self.assertEqual(made.counts["skipped"], np.count_nonzero((points < 0.1).any(axis=1)))

    def test_columns_by_their_names(self):
        """Of structured arrays; of data frames: with_gis.py."""
        points = cloud(48, 60, 3)
        table = np.zeros(60, [("z", "f4"), ("y", "f8"), ("class", "i2"), ("x", "f8")])
        for k, name in enumerate("xyz"):
            table[name] = points[:, k].astype(np.float32)
        made = delaunay(table)
        np.testing.assert_array_equal(made.points, points.astype(np.float32))
        np.testing.assert_array_equal(delaunay(table[["y", "x"]]).points, points[:, :2].astype(np.float32))
        both = np.zeros(60, [("x", "f8"), ("y", "f8"), ("X", "i8"), ("Y", "i8")])
        both["x"], both["y"] = points[:, 0], points[:, 1]
        np.testing.assert_array_equal(delaunay(both).points, points[:, :2], "of two, the small one")
        places = table[["y", "x"]][:5]
        np.testing.assert_array_equal(made.interpolate(table["z"], places), table["z"][:5])
        np.testing.assert_array_equal(made.locate(places).kind, made.locate(made.points[:5, :2]).kind)
        np.testing.assert_array_equal(LinearInterpolator(table[["y", "x"]], table["z"])(places), table["z"][:5])

    def test_chains_of_any_kind(self):
        """Of any iterables, of different lengths too."""
        chains = [[0, 1], [2, 3, 4], [5, 1, 0]]
        expected = delaunay(SQUARE, lines=chains, crossings="split").constraint_edges
        for given in (tuple(chains), collections.deque(chains), iter(chains), dict(enumerate(chains)).values(),
                      [np.array(chain, np.int8) for chain in chains], np.array([*chains, []], object)[:3]):  # fmt: skip
            np.testing.assert_array_equal(delaunay(SQUARE, lines=given, crossings="split").constraint_edges, expected)
        loop = collections.deque([[0, 1, 2], [0, 2, 3, 3]])
        self.assertEqual(len(delaunay(SQUARE, loops=loop).regions), len(delaunay(SQUARE, loops=list(loop)).regions))


class RefusedTest(unittest.TestCase):
    """Each wrong value: the exception, and its text."""

    POINTS = (
        (ValueError, np.zeros(4), "points .* not \\(4,\\)"),
        (ValueError, np.zeros((4, 1)), "points .* not \\(4, 1\\)"),
        (ValueError, np.zeros((4, 4)), "points .* \\(n, 2\\) or \\(n, 3\\)"),
        (ValueError, np.zeros((4, 2, 1)), "points"),
        (ValueError, 7, "points"),
        (ValueError, [[1, 2], [3]], ""),
        (TypeError, [[1j, 2]], "points .* complex"),
        (TypeError, [["1", "2"]], "points .* real numbers"),
        (TypeError, [[None, Spoiled()]], "points .* object"),
        (TypeError, np.zeros((3, 2), "M8[s]"), "points .* datetime64"),
        (TypeError, np.ma.masked_invalid([[0, np.nan]]), r"give points.data, and skip=points.mask.any\(axis=1\)"),
    )
    KEYWORDS = (
        (ValueError, "segments", [(0, 6)], "segments\\[0\\] names point 6, but there are 6"),
        (ValueError, "segments", [(0, 1), (-1, 2)], "segments\\[1\\] names point -1"),
        (ValueError, "segments", [(0, 1, 2)], "segments .*\\(1, 3\\)"),
        (ValueError, "segments", [0, 1], "segments"),
        (TypeError, "segments", [(0.0, 1.0)], "segments .* float64"),
        (TypeError, "segments", "01", "segments"),
        (TypeError, "segments", [(True, False)], "segments .* bool"),
        (ValueError, "lines", [[0, 1], [2, 3, 9]], "lines\\[1\\] names point 9"),
        (ValueError, "lines", [[0, 1], [], [2, 99, 1]], "lines\\[2\\] names point 99"),
        (TypeError, "lines", [[0, 1], [0.5, 2, 3]], "lines\\[1\\] .* float64"),
        (TypeError, "lines", 0.5, "lines"),
        (ValueError, "lines", np.zeros((1, 2, 3), int), "lines"),
        (TypeError, "lines", np.ma.masked_equal([0, 1], 1), "lines"),
        (ValueError, "loops", [0, 1, 6], "loops\\[0\\] names point 6"),
        (TypeError, "loops", [[0, 1, 2**63]], "loops"),
        (ValueError, "loops", np.array([[0, 1, 2**64 - 1]], np.uint64), "loops: 18446744073709551615"),
        (ValueError, "source_points", [1, 2], "source_points"),
        (TypeError, "source_points", [[1j, 2]], "source_points"),
        (ValueError, "skip", [True], "skip .* 6 points, not the shape \\(1,\\)"),
        (TypeError, "skip", np.zeros(6, np.int64), "skip .* int64"),
        (TypeError, "skip", [0.5] * 6, "skip .* float64"),
        (TypeError, "skip", np.ma.masked_equal(np.zeros(6, bool), False), "skip"),
        (ValueError, "crossings", "both", "crossings .* 'leave_out', 'split', not 'both'"),
        (TypeError, "crossings", 1, "crossings"),
        (ValueError, "fill_rule", "", "fill_rule"),
        (TypeError, "closed_lines_are_loops", 1, "closed_lines_are_loops .* True or False, not 1"),
        (ValueError, "source_heights", "surface", "source_heights='surface' .* source_points"),
        (ValueError, "source_heights", "mine", "source_heights"),
        (ValueError, "points_as_line", True, "points_as_line needs source_points"),
        (ValueError, "plane", "xz", "plane .* 'xz'"),
        (ValueError, "plane", np.eye(3), "plane"),
        (ValueError, "plane", None, "plane"),
        (ValueError, "plane", np.eye(4) * np.nan, "plane: .* not finite"),
        (ValueError, "rim", "none", "rim"),
        (ValueError, "duplicates", "last", "duplicates"),
        (ValueError, "tolerance", -0.1, "tolerance .* from 0 to 1, not -0.1"),
        (ValueError, "tolerance", np.nan, "tolerance .* nan"),
        (TypeError, "tolerance", "0.1", "tolerance"),
        (TypeError, "tolerance", Spoiled(), "tolerance .* <spoiled>"),
        (TypeError, "tolerance", True, "tolerance"),
        (ValueError, "alpha", -1, "alpha"),
        (ValueError, "alpha", 10**400, "alpha"),
        (ValueError, "maximum_edge_length", np.nan, "maximum_edge_length"),
        (TypeError, "bounding", "yes", "bounding"),
        (ValueError, "offset", 0.7, "offset .* from 0.75"),
        (ValueError, "insertion_order", "random", "insertion_order"),
        (ValueError, "nmax", 0, "nmax .* from 1 to 2147483647, not 0"),
        (TypeError, "nmax", 2.5, "nmax"),
        (ValueError, "nmax", 2**31, "nmax"),
        (ValueError, "control_points", "all", "control_points"),
        (TypeError, "gene_rotation", None, "gene_rotation"),
        (ValueError, "insertion_limit", -1, "insertion_limit"),
        (TypeError, "count_work", 0, "count_work"),
        (ValueError, "voronoi_clip", "box", "voronoi_clip"),
        (TypeError, "id_dtype", np.int16, "id_dtype"),
        (TypeError, "id_dtype", np.float64, "id_dtype"),
        (TypeError, "id_dtype", ">i4", "id_dtype"),
        (ValueError, "want", "triangle", "want: 'triangle' is not one of 'point_status'"),
        (ValueError, "want", ["order", "x"], "want: 'x'"),
        (ValueError, "threads", 1025, "threads .* 1024"),
        (TypeError, "threads", True, "threads"),
        (ValueError, "memory_limit", -1, "memory_limit"),
        (MemoryError, "memory_limit", 1, "memory"),
        (TypeError, "progress", 1, "progress"),
        (TypeError, "no_such", 1, "no_such"),
    )

    def refuse(self, kind, words, points, **keywords):
        with self.assertRaises(kind) as caught:
            delaunay(points, **keywords)
        message = str(caught.exception)
        self.assertTrue(re.search(words, message, re.DOTALL), "%r is not in: %s" % (words, message))
        self.assertLess(len(message), 300)

    def test_points(self):
        for kind, points, words in self.POINTS:
            with self.subTest(words):
                self.refuse(kind, words, points)

    def test_keywords(self):
        for kind, name, value, words in self.KEYWORDS:
            with self.subTest("%s=%r" % (name, value)):
                self.refuse(kind, words, SQUARE, **{name: value})

    def test_what_does_not_go_together(self):
        self.refuse(ValueError, "bounding .* 'xy'", SQUARE, bounding=True, plane="best_fit")
        self.refuse(ValueError, "lines\\[0\\] names point 3, but there are 3 points in source_points", SQUARE,
                    source_points=SQUARE[:3], lines=[0, 3])  # fmt: skip
        with self.assertRaises(TypeError):
            delaunay(SQUARE, [(0, 1)])

    def test_a_plane_that_fails(self):
        self.refuse(ZeroDivisionError, "", SQUARE, plane=lambda xyz: 1 / 0)
        self.refuse(ValueError, "plane: .* shape \\(2,\\)", SQUARE, plane=lambda xyz: [1, 2])

    def test_too_many_points(self):
        many = np.broadcast_to(np.zeros(2), (2**28, 2))
        self.refuse(ValueError, "268435456", many)

    def test_other_questions(self):
        made = delaunay(SQUARE)
        for kind, ask in (
            (ValueError, lambda: made.locate([1, 2])), (ValueError, lambda: made.locate([[1, 2, 3]])),
            (TypeError, lambda: made.locate([["a", "b"]])), (ValueError, lambda: made.interpolate([1, 2])),
            (TypeError, lambda: made.interpolate(["a"] * 6)),
            (ValueError, lambda: made.interpolate(np.zeros(()))),
            (ValueError, lambda: made.voronoi("all")),
        ):  # fmt: skip
            self.assertRaises(kind, ask)

    def test_warnings_may_be_errors(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(UserWarning, "fewer than three"):
                delaunay(SQUARE[:2])


class NamesTest(unittest.TestCase):
    def test_other_names(self):
        """Those of mesh.adaptive are accepted as synonyms, and never both."""
        heights, points = np.array([[0, 0, 5], [1, 0, 1], [0, 1, 1], [1, 1, 2], [0, 0, 3]], float), cloud(31)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for given, other, name, value, own in (
                (points, "max_edge_length", "maximum_edge_length", 0.1, 0.1),
                (points, "bound", "bounding", True, True),
                (points, "tol", "tolerance", 0.05, 0.05),
                (points, "clip", "voronoi_clip", "bounds", "bounds"),
                (points, "rim", "rim", "hull", "convex_hull"),
                (points, "rim", "rim", "auto", "automatic"),
                (heights, "duplicates", "duplicates", "lowest", "lowest_z"),
                (heights, "duplicates", "duplicates", "highest", "highest_z"),
                (heights, "duplicates", "duplicates", "mean", "mean_z"),
                (heights, "plane", "plane", "fit", "best_fit"),
            ):
                made, expected = delaunay(given, **{other: value}), delaunay(given, **{name: own})
                np.testing.assert_array_equal(made.triangles, expected.triangles, other)
                np.testing.assert_array_equal(made.points, expected.points, other)
                np.testing.assert_array_equal(made.voronoi().points, expected.voronoi().points, other)
                if other != name:
                    text = r"delaunay\(\) got %s and %s, which are two names" % (name, other)
                    with self.assertRaisesRegex(TypeError, text):
                        delaunay(given, **{name: own, other: value})
        own = delaunay(points, source_points=[[0.5, 0.5, 3]], heights="surface")
        self.assertEqual(own.points.shape, (201, 3))
        with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'edges'"):
            delaunay(points, edges=1)
        with self.assertRaisesRegex(ValueError, "maximum_edge_length must be a number from 0 to inf, not -1"):
            delaunay(points, max_edge_length=-1)


if __name__ == "__main__":
    unittest.main()
