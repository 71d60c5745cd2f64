# SPDX-License-Identifier: BSD-3-Clause
"""delaunay: what keywords of constraints, planes, points and limits do. Others: test_runs.py."""

import subprocess
import sys
import unittest
import warnings

import numpy as np
from adaptivehilbertdelaunay import DelaunayWarning, LinearInterpolator, delaunay
from arraysupport import SQUARE, KeywordTest, cloud, complaints, integers, lattice, twice_area

RING = [0, 1, 2, 3]  # around SQUARE and lattices of corners(), counterclockwise


def corners(side):
    """A lattice whose corners are its first four points, counterclockwise."""
    points = lattice(side)
    ends = [0, side - 1, side * side - 1, side * (side - 1)]
    return np.concatenate((points[ends], np.delete(points, ends, axis=0)))


def area(made):
    return twice_area(integers(made.points), made.triangles.tolist()) / 2


def edges(made):
    return {frozenset(edge) for edge in made.constraint_edges.tolist()}


class ConstraintTest(KeywordTest):
    def test_segments_lines_loops(self):
        points = cloud(21)
        hull = delaunay(points).hull
        made = delaunay(
            points,
            segments=[hull[[0, 2]]],
            lines=[hull[2:5], hull[4:]],
            loops=[hull[[1, 4, 7]]],
            fill_rule="even_odd",
            crossings="split",
        )
        places = made.points
        self.assertEqual(complaints(places, made.triangles, made.neighbors, made.is_constraint), [])
        self.assertEqual(len(edges(made)) > 5, True)
        self.assertGreater(made.counts["split_crossings"], 0)

    def test_a_segment_becomes_its_edge(self):
        free = delaunay(SQUARE)
        made = delaunay(SQUARE, segments=np.array([[0, 2]], np.int32))
        self.assertNotIn(frozenset((0, 2)), {frozenset(edge) for edge in free.edges.tolist()})
        self.assertEqual(edges(made), {frozenset((0, 2))})
        self.assertEqual(complaints(SQUARE, made.triangles, made.neighbors, made.is_constraint), [])
        self.assertEqual(made.counts["constraint_edges"], 1)

    def test_a_segment_through_points_becomes_several(self):
        points = lattice(5)
        made = delaunay(points, lines=[0, 24])
        self.assertEqual(edges(made), {frozenset((6 * k, 6 * k + 6)) for k in range(4)})

    def test_every_form_of_chains(self):
        points = cloud(22)
        hull = delaunay(points).hull.tolist()
        chain, other = hull[:4], hull[4:7]
        expected = edges(delaunay(points, segments=[chain[k : k + 2] for k in range(3)]))
        self.assertEqual(len(expected), 3)
        for form in (
            chain, tuple(chain), [chain], np.array(chain), np.array([chain], np.int32), np.array(chain, np.uint16),
            [np.array(chain, np.int16)], iter([chain]), np.array(chain, ">i8"), np.array(chain + [0])[:4], [chain, []],
            np.array([[id, 0] for id in chain])[:, 0],
        ):  # fmt: skip
            self.assertEqual(edges(delaunay(points, lines=form)), expected, form)
        both = edges(delaunay(points, lines=[chain, other]))
        self.assertEqual(both, expected | {frozenset(other[k : k + 2]) for k in range(2)})
        mixed = np.empty(2, object)
        mixed[:] = [chain, other]
        self.assertEqual(edges(delaunay(points, lines=mixed)), both)
        self.assertEqual(edges(delaunay(points, segments=[other[:2], other[1:]], lines=[chain])), both)
        for nothing in ([], [[]], (), np.empty((0, 2), int), np.empty(0)):
            self.assertEqual(edges(delaunay(points, lines=nothing, segments=np.empty((0, 2)), loops=nothing)), set())

    def test_loops_bound_and_holes(self):
        points = corners(9)
        inner = [[k for k, p in enumerate(points.tolist()) if p == q][0] for q in ([2, 2], [6, 2], [6, 6], [2, 6])]
        self.assertEqual(area(delaunay(points, loops=[inner])), 16)
        for hole in (inner, inner[::-1], inner + inner[:1]):
            made = delaunay(points, loops=[RING, hole])
            self.assertEqual(area(made), 64 - 16, hole)
            self.assertEqual(len(made.hull), 32)
            self.assertEqual(len(made.boundary), 32 + 16)

    def test_fill_rule(self):
        points = corners(9)
        inner = [[k for k, p in enumerate(points.tolist()) if p == q][0] for q in ([2, 2], [6, 2], [6, 6], [2, 6])]
        for chain, by_orientation in ((inner, 16), (inner[::-1], 48)):
            self.assertEqual(area(delaunay(points, loops=chain, fill_rule="orientation")), by_orientation)
            self.assertEqual(area(delaunay(points, loops=chain, fill_rule="even_odd")), 16)
        self.assertEqual(area(delaunay(points, loops=[RING, inner], fill_rule="orientation")), 16)

    def test_closed_lines_are_loops(self):
        ring = [4, 1, 5, 4]
        self.assertEqual(len(delaunay(SQUARE, lines=[ring], closed_lines_are_loops=False).triangles), 6)
        self.assertEqual(len(delaunay(SQUARE, lines=[ring], closed_lines_are_loops=True).triangles), 1)

    def test_lines_that_meet_are_loops(self):
        points = lattice(9)
        pieces = [(20, 24), (60, 24), (56, 60), (56, 20)]  # around 4 x 4 squares, in any direction
        self.assertEqual(area(delaunay(points, segments=pieces)), 64)
        self.assertEqual(area(delaunay(points, segments=pieces, closed_lines_are_loops=True)), 16)
        made = delaunay(points, segments=pieces, lines=[[10, 11]], loops=[RING], closed_lines_are_loops=True)
        self.assertEqual(made.counts["lines_unclosed"], 0)
        with self.assertWarnsRegex(DelaunayWarning, "None of the lines is closed.*closed_lines_are_loops"):
            made = delaunay(points, segments=pieces[:3], closed_lines_are_loops=True)
        self.assertEqual((area(made), made.counts["lines_unclosed"]), (64, 1))

    def test_equal_loops_count_once(self):
        points = lattice(9)
        outer, hole = [0, 8, 80, 72], [20, 24, 60, 56]
        for again in (hole, hole[::-1], hole[2:] + hole[:2], [20, 22, 24, 60, 56, 20]):
            self.assertEqual(area(delaunay(points, loops=[outer, hole, again])), 48)
            self.assertEqual(area(delaunay(points, loops=[outer, hole], lines=[again + again[:1]],
                                           closed_lines_are_loops=True)), 48)  # fmt: skip
        self.assertEqual(area(delaunay(points, loops=[outer, outer, outer])), 64)

    def test_points_as_line(self):
        shore = np.array([(1, 1), (5, 1), (5, 5), (1, 5), (1, 1)])
        with self.assertWarnsRegex(DelaunayWarning, "constrain nothing.*points_as_line"):
            self.assertEqual(len(edges(delaunay(lattice(9), source_points=shore))), 0)
        made = delaunay(lattice(9), source_points=shore[:-1], points_as_line=True)
        self.assertEqual((len(edges(made)) >= 3, area(made)), (True, 64))
        made = delaunay(lattice(9), source_points=shore, points_as_line=True, closed_lines_are_loops=True)
        self.assertEqual(area(made), 16)
        made = delaunay(lattice(9), source_points=shore, points_as_line=True, loops=[[1, 2, 3]])
        self.assertEqual(area(made), 8)

    def test_a_source_elsewhere(self):
        points = lattice(9)
        for name in ("segments", "lines", "loops"):
            with self.assertWarnsRegex(DelaunayWarning, "does not overlap.*x 20 to 22, y 1 to 3; points: x 0 to 8, y"):
                made = delaunay(points, source_points=[(20, 1), (22, 1), (20, 3)], **{name: [(0, 1), (1, 2), (2, 0)]})
            self.assertEqual(made.counts["source_apart"], 1)
        with self.assertWarnsRegex(DelaunayWarning, "None of the points lies inside the loops"):
            delaunay(points, source_points=[(1.2, 1.2), (1.8, 1.2), (1.5, 1.8)], loops=[0, 1, 2])
        inside = np.array([(1.2, 1.2), (1.8, 1.2), (1.5, 1.8)])
        made = delaunay(points, source_points=inside, loops=[0, 1, 2], source_heights="surface")
        self.assertEqual(made.counts["loops_miss_input"], 0, "it has the heights of the points")
        made = delaunay(SQUARE + 1e-7, source_points=SQUARE, loops=[0, 1, 2, 3], tolerance=1e-3)
        self.assertEqual((len(made.merged), made.counts["loops_miss_input"]), (6, 0), "the points are its corners")

    def test_a_source_without_heights(self):
        points = np.c_[lattice(9), np.full(81, 7.5)]
        road = np.array([(0.5, 0.5), (7.5, 6.5)])
        with self.assertWarnsRegex(DelaunayWarning, "1 line or polygon .* z = 0, .* from 7.5 to 7.5.*zero_is_missing"):
            made = delaunay(points, source_points=road, lines=[0, 1])
        self.assertEqual(made.counts["lines_at_zero"], 1)
        wall = [[1, 0, 0, 0], [0, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1]]
        along = np.c_[road[:, 0], [0, 0], road[:, 1]]
        made = delaunay(points[:, [0, 2, 1]], source_points=along, lines=[0, 1], plane=wall)
        self.assertEqual(made.counts["lines_at_zero"], 0, "not z is 0")
        for given, heights in ((points, "surface"), (points - (0, 0, 7.5), "own"), (points[:, :2], "own")):
            self.assertEqual(
                delaunay(given, source_points=road, lines=[0, 1], source_heights=heights).counts["lines_at_zero"], 0)

    def test_crossings_left_out(self):
        with self.assertWarnsRegex(DelaunayWarning, "1 of 2 segments were left out.*chain 1 and crosses chain 0"):
            made = delaunay(SQUARE, segments=[(0, 2), (1, 3)], crossings="leave_out")
        self.assertEqual(edges(made), {frozenset((0, 2))})
        self.assertEqual(made.left_out.tolist(), [[1, 0, 0, 0]])
        with self.assertWarnsRegex(DelaunayWarning, "1 loop bounds nothing"):
            delaunay(SQUARE, segments=[(0, 2)], loops=[(1, 3, 4)])

    def test_crossings_split(self):
        points = np.column_stack((SQUARE, [0, 4, 8, 2, 0, 0]))
        made = delaunay(points, segments=[(0, 2), (1, 3)], crossings="split")
        self.assertEqual(made.points[-1].tolist(), [2, 2, 0.5 * 4 + 0.5 * 3])
        self.assertEqual(made.points.dtype, np.float64)
        self.assertEqual(made.points.shape, (7, 3))
        self.assertEqual(edges(made), {frozenset((end, 6)) for end in range(4)})
        self.assertEqual([set(pair) for pair in made.crossing_ends.reshape(2, 2).tolist()], [{0, 2}, {1, 3}])
        self.assertEqual(made.crossing_fractions.tolist(), [[0.5, 0.5]])
        np.testing.assert_array_equal(made.interpolate(points[:, 2]), made.points[:, 2])
        np.testing.assert_array_equal(made.interpolate(points), made.points)
        flat = delaunay(SQUARE, segments=[(0, 2), (1, 3)], crossings="split")
        self.assertEqual(flat.points.shape, (7, 2))
        np.testing.assert_array_equal(flat.points[:6], SQUARE)

    def test_segments_that_bend_are_told(self):
        points = cloud(31, 40) * [1, 1e-15] + [0, 1]  # some doubles high
        with self.assertWarnsRegex(DelaunayWarning, "by rounding, through a point that is not exactly on") as told:
            made = delaunay(points, segments=np.arange(40).reshape(-1, 2), crossings="split")
        self.assertTrue(str(told.warning).startswith("%d segment" % made.counts["bent_segments"]))

    def test_source_points(self):
        points = np.array([[0, 0, 0], [8, 0, 8], [8, 8, 8], [0, 8, 0]], np.float32)
        places = np.array([[2, 1, 50], [6, 1, 50], [4, 7, 50]], float)
        with self.assertWarnsRegex(DelaunayWarning, "None of the points lies inside the loops"):
            made = delaunay(points, source_points=places, loops=[0, 1, 2])
        np.testing.assert_array_equal(made.points, np.concatenate((points, places)))
        self.assertEqual(made.triangles.tolist(), [[4, 5, 6]])
        self.assertEqual(made.counts["added_points"], 3)
        on = delaunay(
            points, source_points=places, lines=[0, 1, 2], source_heights="surface", lines_on_surface=False)
        self.assertEqual(on.points[4:].tolist(), [[2, 1, 2], [6, 1, 6], [4, 7, 4]])
        values = on.interpolate(np.array([0, 800, 800, 0, -1, -1, -1]))
        self.assertEqual(values.tolist(), [0, 800, 800, 0, 200, 600, 400])
        with self.assertWarnsRegex(DelaunayWarning, "1 of 3 source points lie outside"):
            delaunay(points, source_points=places * [2, 1, 1], source_heights="surface")

    def test_lines_on_the_surface(self):
        points = np.array([[0, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0], [4, 4, 8]], float)
        ends = np.array([[1, 3, np.nan], [7, 3, np.nan]])
        made = delaunay(points, source_points=ends, segments=[(0, 1)], source_heights="surface")
        line = made.points[5:]
        self.assertEqual(made.counts["points_added_to_lines"], 2)
        self.assertEqual(line.tolist(), [[1, 3, 2], [7, 3, 2], [3, 3, 6], [5, 3, 6]])
        np.testing.assert_array_equal(made.interpolate(np.r_[points, ends * 1]), made.points)
        straight = delaunay(
            points, source_points=ends, segments=[(0, 1)], source_heights="surface", lines_on_surface=False)
        self.assertEqual(straight.points[5:].tolist(), [[1, 3, 2], [7, 3, 2]])
        parts = delaunay(
            points, source_points=ends, segments=[(0, 1)], source_heights="surface", maximum_segment_length=1)
        self.assertEqual(sorted(parts.points[5:].tolist()), [
            [x, 3, z] for x, z in ((1, 2), (2, 4), (3, 6), (4, 6), (5, 6), (6, 4), (7, 2))])
        own = delaunay(points, segments=[(0, 2)], maximum_segment_length=6)
        self.assertEqual(own.points[5:].tolist(), [[4, 4, 0]])

    def test_mixed_heights(self):
        points = np.array([[0, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0]], float)
        source = np.array([[4, 1, 6], [4, 7, 6], [1, 4, np.nan], [7, 4, np.nan], [4, 4.5, 6], [9, 9, np.nan]], float)
        lines = [[0, 1], [2, 3]]
        with self.assertWarnsRegex(DelaunayWarning, "1 of 6 source points lie outside"):
            made = delaunay(points, source_points=source, segments=lines, source_heights="mixed")
        np.testing.assert_array_equal(made.points[4:6], source[:2])
        self.assertEqual(made.points[6:9, 2].tolist(), [1.5, 1.5, 6])
        self.assertTrue(np.isnan(made.points[9, 2]))
        self.assertIn([4, 4, 6], made.points[10:].tolist())
        source[4, 2] = 0
        with self.assertWarnsRegex(DelaunayWarning, "1 of 6 source points lie outside"):
            made = delaunay(points, source_points=source, segments=lines, source_heights="mixed", zero_is_missing=True)
        self.assertEqual(made.points[8].tolist(), [4, 4.5, 6])

    def test_regions(self):
        points = corners(5)
        middle = [[k for k, p in enumerate(points.tolist()) if p == q][0] for q in ([2, 0], [2, 4])]
        made = delaunay(points, lines=[middle])
        left = points[made.triangles].mean(axis=1)[:, 0] < 2
        self.assertEqual(set(made.regions[left]), {0} if left[0] else {1})
        self.assertEqual(len(set(made.regions)), 2)
        self.assertEqual(len(set(made.regions[left])), 1)
        self.assertEqual(len(set(made.regions[~left])), 1)


class PlaneTest(KeywordTest):
    def test_best_fit(self):
        flat = cloud(23)
        wall = np.column_stack((flat[:, 0], np.full(200, 7.0), flat[:, 1]))
        made = delaunay(wall, plane="best_fit", rim="convex_hull")
        self.assertEqual(len(made.triangles), len(delaunay(flat).triangles))
        np.testing.assert_array_equal(made.points, wall)
        self.assertEqual(np.abs(made.plane_points[:, 2]).max(), 0)
        homogeneous = np.column_stack((wall, np.ones(200)))
        np.testing.assert_allclose(homogeneous @ made.plane_matrix.T[:, :3], made.plane_points, atol=1e-12)

    def test_points_of_one_z_x_or_y_are_their_own_plane(self):
        flat = cloud(22, 2000) + [5e5, 6e6]
        whole = delaunay(flat)
        for k in range(3):
            points = np.insert(flat, k, 0.1, axis=1)
            made = delaunay(points, plane="best_fit")
            np.testing.assert_array_equal(made.plane_points, np.insert(points[:, [k - 2, k - 1]], 2, 0, axis=1))
            self.assertEqual(len(made.triangles), len(whole.triangles))
            self.assertGreater(delaunay(points, plane="best_fit", rim="trimmed").counts["trimmed_triangles"], 0)

    def test_matrix(self):
        points = cloud(24, 100, 3)
        swap = np.array([[0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
        made = delaunay(points, plane=swap)
        np.testing.assert_array_equal(made.plane_points, points[:, [1, 2, 0]])
        whole = delaunay(points[:, 1:], rim="trimmed")
        np.testing.assert_array_equal(made.triangles, whole.triangles)
        np.testing.assert_array_equal(made.plane_matrix, swap)

    def test_function(self):
        points = cloud(25, 40000, 3)
        swap = np.array([[0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
        expected, sizes = delaunay(points, plane=swap), []

        def inplace(xyz):
            sizes.append(len(xyz))
            xyz[:] = xyz[:, [1, 2, 0]]

        for function in (inplace, lambda xyz: xyz[:, [1, 2, 0]], lambda xyz: xyz[:, [1, 2, 0]].tolist()):
            made = delaunay(points, plane=function)
            np.testing.assert_array_equal(made.triangles, expected.triangles)
            np.testing.assert_array_equal(made.plane_points, expected.plane_points)
        self.assertEqual((sum(sizes), max(sizes)), (40000, 2**14))
        with self.assertRaises(RuntimeError):
            made.plane_matrix
        flat = delaunay(points[:, :2], plane=lambda xyz: xyz * [1, 1, 0])
        self.assertEqual(flat.points.shape, (40000, 2))

    def test_rim(self):
        points = lattice(6) + cloud(26, 36) * 1e-9
        whole, trimmed = (delaunay(points, rim=rim) for rim in ("convex_hull", "trimmed"))
        self.assertEqual(len(trimmed.triangles), 50)
        self.assertEqual(trimmed.counts["trimmed_triangles"], len(whole.triangles) - 50)
        self.assertGreater(len(whole.triangles), 50)
        np.testing.assert_array_equal(delaunay(points, rim="automatic").triangles, whole.triangles)
        np.testing.assert_array_equal(trimmed.hull, whole.hull)
        with self.assertWarnsRegex(DelaunayWarning, "trimming the rim removed all .* rim='convex_hull' to keep"):
            delaunay([[0, 0], [1, 0.1], [2, 0]], rim="trimmed")

    def test_bounding(self):
        points = cloud(27)
        made = delaunay(points, bounding=True, offset=3.0)
        self.assertEqual(made.points.shape, (208, 2))
        middle = (points.max(axis=0) + points.min(axis=0)) / 2
        far = np.hypot(*(made.points[200:] - middle).T)
        np.testing.assert_allclose(far, 3 * np.hypot(*np.ptp(points, axis=0)))
        self.assertEqual(set(made.hull), set(range(200, 208)))
        self.assertTrue(np.isnan(made.interpolate(np.ones(200))[200:]).all())


class PointTest(KeywordTest):
    HEIGHTS = np.array([[0, 0, 5], [1, 0, 1], [0, 1, 1], [0, 0, 3], [0, 0, 9], [0, 0, np.nan]], float)

    def test_duplicates(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for rule, vertex, height in (
                ("first", 0, 5),
                ("lowest_z", 3, 3),
                ("highest_z", 4, 9),
                ("mean_z", 0, 17 / 3),
            ):
                made = delaunay(self.HEIGHTS, duplicates=rule)
                self.assertEqual(set(made.triangles[0]), {vertex, 1, 2}, rule)
                self.assertEqual(made.points[vertex, 2], height)
                self.assertEqual(made.interpolate(self.HEIGHTS[:, 2], [[0, 0]]), height)
                self.assertEqual(made.point_status.tolist(), [vertex, 1, 2] + [vertex] * 3)

    def test_tolerance(self):
        points = np.array([[0, 0], [3, 4], [0, 4], [3, 0.05], [0.04, 0]])
        self.assertEqual(delaunay(points, tolerance=0.0).counts["inserted"], 5)
        made = delaunay(points, tolerance=0.009)
        self.assertEqual(made.merged.tolist(), [[4, 0]])
        self.assertEqual(made.point_status[4], 0)
        self.assertEqual(delaunay(points, tolerance=0.007).merged.tolist(), [])

    def test_skip(self):
        points = cloud(28)
        some = np.arange(200) % 3 == 0
        for marks in (some, some.astype(np.uint8) * 32, np.repeat(some, 2)[::2]):
            made = delaunay(points, skip=marks)
            self.assertEqual(set(made.triangles.ravel()), set(np.flatnonzero(~some)))
            self.assertEqual(made.counts["skipped"], 67)

    def test_alpha(self):
        points = np.array([[0, 0], [1, 0], [0, 1], [5, 0], [5, 1.5], [9, 9], [0, 0]], float)
        made = delaunay(points, alpha=1.0)
        self.assertEqual([set(t) for t in made.triangles.tolist()], [{0, 1, 2}])
        self.assertEqual([set(line) for line in made.lines.tolist()], [{3, 4}])
        self.assertEqual(made.vertices.tolist(), [5, 6])
        self.assertEqual(made.neighbors.tolist(), [[-1, -1, -1]])
        self.assertEqual(made.regions.tolist(), [0])
        self.assertEqual(made.locate([[0.25, 0.25], [2, 1]]).triangle.tolist(), [0, -1])
        self.assertEqual(made.edges.shape, (3, 2))
        self.assertEqual(len(delaunay(points, alpha=0.0).lines), 0)
        many = delaunay(cloud(29, 400), alpha=0.06)
        self.assertGreater(len(many.lines) + len(many.vertices), 0)
        whole = {frozenset(t): k for k, t in enumerate(many.triangles.tolist())}
        for t, beyond in zip(many.triangles.tolist(), many.neighbors.tolist()):
            for k, other in enumerate(beyond):
                edge = {t[k], t[(k + 1) % 3]}
                sharing = [n for s, n in whole.items() if edge <= s and s != frozenset(t)]
                self.assertEqual(sharing, [] if other < 0 else [other])

    def test_maximum_edge_length(self):
        points = cloud(30)
        whole, made = delaunay(points), delaunay(points, maximum_edge_length=0.1)
        corner = points[whole.triangles]
        longest = np.hypot(*(corner - np.roll(corner, -1, axis=1)).transpose(2, 0, 1)).max(axis=1)
        np.testing.assert_array_equal(made.triangles, whole.triangles[longest <= 0.1])
        with self.assertWarnsRegex(DelaunayWarning, " keep none of"):
            self.assertEqual(len(delaunay(points, maximum_edge_length=1e-9).triangles), 0)

    def test_not_finite(self):
        points = np.concatenate((SQUARE, [[np.nan, 1], [np.inf, 0]]))
        with self.assertWarnsRegex(DelaunayWarning, "2 of 8 points were rejected.* first is point 6"):
            made = delaunay(points)
        np.testing.assert_array_equal(made.triangles, delaunay(SQUARE).triangles)
        with self.assertWarnsRegex(DelaunayWarning, "1 of 6 points have a z that is NaN"):
            delaunay(np.column_stack((SQUARE, [0, 0, np.nan, 0, 0, 0])))
        with self.assertWarnsRegex(DelaunayWarning, "1 of 1 segments were left out"):
            with warnings.catch_warnings():
                warnings.filterwarnings("ignore", "2 of 8 points")
                delaunay(points, segments=[(0, 6)])

    def test_collinear(self):
        with self.assertWarnsRegex(DelaunayWarning, "collinear: 3 distinct points among 3"):
            made = delaunay([[0, 0], [1, 1], [2, 2]])
        self.assertEqual((made.triangles.shape, made.hull.shape, made.edges.shape), ((0, 3), (0,), (0, 2)))
        with self.assertWarnsRegex(DelaunayWarning, "not collinear in space. To .* a wall, set plane='best_fit'"):
            delaunay([[0, 0, 0], [1, 1, 0], [2, 2, 1]])
        with self.assertWarnsRegex(DelaunayWarning, "loops keep none"):
            delaunay(SQUARE, loops=RING[::-1], fill_rule="orientation")

    def test_the_warning_names_the_caller(self):
        with self.assertWarns(DelaunayWarning) as caught:
            delaunay([[0, 0], [1, 1]])
        self.assertEqual(caught.filename, __file__)
        with self.assertWarns(DelaunayWarning) as caught:
            LinearInterpolator([[0, 0], [1, 1]], [1, 2])
        self.assertEqual(caught.filename, __file__)

    @unittest.skipIf(sys.platform == "win32", "POSIX only: a folder can be deleted that is somebody's")
    def test_a_warning_in_a_deleted_folder(self):
        script = (
            "import os, sys, tempfile\nfrom adaptivehilbertdelaunay import delaunay\n"
            "folder = tempfile.mkdtemp()\nos.chdir(folder)\nos.rmdir(folder)\n"
            "print(len(delaunay([[0, 0], [1, 1]]).points))\n"
        )
        done = subprocess.run([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              check=False)  # fmt: skip
        self.assertEqual((done.stdout, done.returncode), ("2\n", 0), done.stderr)
        self.assertRegex(done.stderr, "^<string>:6: DelaunayWarning: There is no triangle")


if __name__ == "__main__":
    unittest.main()
