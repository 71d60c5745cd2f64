# SPDX-License-Identifier: BSD-3-Clause
"""Triangulation.refine(): angles and sizes are as wished, pieces of segments and data where they belong."""

import copy
import pickle
import unittest
import warnings

import numpy as np
from adaptivehilbertdelaunay import BadReason, DelaunayWarning, Mesh, _library as library, delaunay
from adaptivehilbertdelaunay._found import Found
from adaptivehilbertdelaunay._segments import Segments
from arraysupport import KeywordTest, cloud, complaints, in_a_process, lattice

SQUARES = np.array([(0, 0), (8, 0), (8, 8), (0, 8), (2, 2), (3, 2), (3, 3), (2, 3), (6, 5), (7.5, 7)], float)
LOOPS, LINE = [[0, 1, 2, 3], [4, 5, 6, 7]], [[8, 9]]

INTERRUPTED = """
import signal, threading
import numpy as np
from adaptivehilbertdelaunay import _library as library, delaunay

made = delaunay(np.random.default_rng(1).random((100000, 2)))
made.neighbors, made.plane_points, made.point_status

def interrupt():
    while not library._at_work:
        pass
    signal.raise_signal(signal.SIGINT)

for _ in range(20):
    thread = threading.Thread(target=interrupt, daemon=True)
    thread.start()
    try:
        made.refine(33)
    except KeyboardInterrupt:
        print("interrupted")
        break
    thread.join()
print(made.refine(5).points.shape[1])
"""


def sides(mesh):
    """(t, 3, 2): the vectors along the edges of the triangles, in the plane."""
    corners = mesh.triangulation.points[:, :2][mesh.triangles]
    return np.roll(corners, -1, axis=1) - corners


def lengths(mesh):
    return np.hypot(sides(mesh)[..., 0], sides(mesh)[..., 1])


def angles(mesh):
    """(t, 3), in degrees."""
    out, back = sides(mesh), -np.roll(sides(mesh), 1, axis=1)
    cross = out[..., 0] * back[..., 1] - out[..., 1] * back[..., 0]
    return np.degrees(np.arctan2(cross, (out * back).sum(axis=2)))


def of_squares(**keywords):
    return delaunay(SQUARES, loops=LOOPS, lines=LINE, **keywords)


class RefineTest(KeywordTest):
    def expect_mesh(self, made, mesh):
        """Whatever was wished."""
        run = mesh.triangulation
        self.assertEqual(complaints(run.points, mesh.triangles, run.neighbors, run.is_constraint), [])
        np.testing.assert_allclose(run.areas.sum(), made.areas.sum(), rtol=1e-12)
        count = len(made.points)
        np.testing.assert_array_equal(mesh.points[:count], made.points)
        self.assertEqual(mesh.is_added.tolist(), [k >= count for k in range(len(mesh.points))])
        pieces = {tuple(sorted(piece)) for piece in mesh.edges.tolist()}
        self.assertEqual(len(pieces), len(mesh.edges))
        self.assertEqual(pieces, {tuple(sorted(edge)) for edge in run.constraint_edges.tolist()})
        border = {tuple(edge) for edge in mesh.edges[mesh.on_boundary].tolist()}
        self.assertEqual(border, {tuple(edge) for edge in run.boundary.tolist()})
        self.assertTrue(((mesh.corners >= 0) & (mesh.corners < count) | (mesh.weights == 0)).all())
        given = made.plane_points[:, :2][: count - made.counts["added_points"] + made.counts["source_points"]]
        x = mesh.interpolate(given)
        np.testing.assert_allclose(x, run.points[:, :2], atol=1e-13 * (1 + np.nanmax(abs(run.points))))

    def expect_markers(self, mesh, ends):
        """`ends`: the places of the ends of each segment, by (chain, segment): its pieces cover it."""
        places = mesh.triangulation.points[:, :2]
        found = {tuple(marker) for marker in mesh.markers.tolist()} - {(-1, -1)}
        self.assertEqual(found, set(ends))
        for marker, (a, b) in ends.items():
            pieces = places[mesh.edges[(mesh.markers == marker).all(axis=1)]]
            way = np.subtract(b, a)
            off = pieces - a
            np.testing.assert_allclose(off[..., 0] * way[1] - off[..., 1] * way[0], 0, atol=1e-12 * (way @ way))
            self.assertAlmostEqual(np.hypot(*(pieces[:, 1] - pieces[:, 0]).T).sum(), np.hypot(*way), 10)

    def test_angles_areas_and_lengths(self):
        made = of_squares()
        for angle, area, length in ((20, None, None), (30, 0.5, None), (33, None, 0.9), (0, 0.3, 1.1)):
            mesh = made.refine(angle, maximum_area=area, maximum_length=length)
            self.expect_mesh(made, mesh)
            self.assertGreater(angles(mesh).min(), angle - 1e-9)
            self.assertLessEqual(mesh.triangulation.areas.max(), (area or 100) * (1 + 1e-12))
            self.assertLessEqual(lengths(mesh).max(), (length or 100) * (1 + 1e-12))
            self.assertEqual((len(mesh.bad), len(mesh.reasons), mesh.encroached_pieces), (0, 0, 0))
        self.assertEqual(len(made.refine().points), len(made.refine(20.0).points))

    def test_sizes(self):
        made = delaunay(lattice(5))
        wished = 0.1 + 0.2 * made.points[:, 0]
        by_points, by_function = made.refine(sizes=wished), made.refine(sizes=lambda xy: 0.1 + 0.2 * xy[:, 0])
        self.assertEqual(by_points.triangles.tobytes(), by_function.triangles.tobytes())
        self.expect_mesh(made, by_points)
        ends = by_points.triangulation.points[by_points.triangulation.edges]
        most = (0.1 + 0.2 * ends[..., 0]).mean(axis=1)
        longest = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
        self.assertLess((longest / most).max(), 1 + 1e-12)
        self.assertGreater(np.median(longest / most), 0.4)
        self.assertEqual(len(made.refine(size=wished).points), len(by_points.points))

    def test_sizes_of_the_points_alone(self):
        """As `interpolate` takes values: source points that lie on the surface have those of the surface."""
        points = np.column_stack((lattice(5), np.zeros(25)))
        made = delaunay(points, source_points=[[1, 1.5], [3, 2.5]], lines=[0, 1], source_heights="surface")
        mesh = made.refine(sizes=0.1 + 0.2 * points[:, 0])
        self.assertEqual(mesh.points.tobytes(), made.refine(sizes=lambda xy: 0.1 + 0.2 * xy[:, 0]).points.tobytes())
        with self.assertRaisesRegex(ValueError, "each of 27 points"):
            made.refine(sizes=np.ones(26))

    def test_markers_of_loops_and_lines(self):
        mesh = of_squares().refine(28, maximum_area=0.4)
        corners = SQUARES[:8].reshape(2, 4, 2)
        ends = {(1 + chain, k): (ring[k], ring[(k + 1) % 4]) for chain, ring in enumerate(corners) for k in range(4)}
        self.expect_markers(mesh, {**ends, (0, 0): SQUARES[8:]})
        self.assertEqual(mesh.on_boundary.tolist(), (mesh.markers[:, 0] > 0).tolist())

    def test_markers_of_segments_through_points(self):
        """Points on them, crossings that are split, segments that cover others; the rest of the hull has none."""
        points = np.array([(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (5, 5), (1, 8.3), (8, 0.7)])
        given = [[0, 2], [4, 5], [6, 7], [3, 1], [4, 4]]
        made = delaunay(points, segments=given, crossings="split")
        mesh = made.refine(25)
        self.expect_mesh(made, mesh)
        self.expect_markers(mesh, {(k, 0): points[given[k]] for k in (0, 2, 3)})
        self.assertEqual({tuple(row) for row in mesh.markers[mesh.on_boundary].tolist()}, {(-1, -1)})

    def test_markers_of_many_crossings(self):
        """On lattices and elsewhere, far from the origin too: pieces inside have one, and lie on that segment."""
        warnings.simplefilter("ignore", DelaunayWarning)
        for seed in range(20, 80):
            random = np.random.default_rng(seed)
            count, far = int(random.integers(4, 25)), random.choice([0, 5e6])
            points = (random.integers(0, 8, (count, 2)) if seed % 2 else random.random((count, 2)) * 8) + far
            segments = random.integers(0, count, (int(random.integers(1, 8)), 2))
            mesh = delaunay(points, segments=segments, crossings="split").refine(25, maximum_added=300)
            self.assertTrue((mesh.markers[~mesh.on_boundary, 0] >= 0).all(), seed)
            isMarked = mesh.markers[:, 0] >= 0
            start, end = np.moveaxis(points[segments[mesh.markers[isMarked, 0]]], 1, 0)
            off, way = mesh.points[mesh.edges[isMarked]] - start[:, None], (end - start)[:, None]
            across = abs(off[..., 0] * way[..., 1] - off[..., 1] * way[..., 0]) / np.hypot(way[..., 0], way[..., 1])
            self.assertLess(across.max(initial=0), 1e-14 * (8 + 8 * far), seed)

    def expect_inside_marked(self, mesh):
        self.assertTrue((mesh.markers[~mesh.on_boundary, 0] >= 0).all())

    def test_markers_of_crossings_at_nearly_one_place(self):
        """Two lines that differ by rounding cross a third: from one crossing to the other it does not go ahead."""
        warnings.simplefilter("ignore", DelaunayWarning)
        for seed in range(20):
            random = np.random.default_rng(seed)
            a, b = random.random((2, 2)) * 8
            middle, way = a + (b - a) * random.random(), random.random(2) - 0.5
            line = np.array([middle - 3 * way, middle + 3 * way])
            points = np.concatenate(([a, b], line, line + random.integers(-2, 3, (2, 2)) * np.spacing(8.0)))
            made = delaunay(points, segments=[[0, 1], [2, 3], [4, 5]], crossings="split")
            self.expect_inside_marked(made.refine(0, maximum_added=300))

    def test_markers_at_any_scale(self):
        points = np.array([(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (5, 5), (1, 8.3), (8, 0.7)])
        for scale in (1e-320, 1e-200, 1e-160, 1e160, 1e260):
            with np.errstate(all="raise", under="ignore"):
                made = delaunay(points * scale, segments=[[0, 2], [6, 7], [3, 1]], crossings="split")
                mesh = made.refine(0, maximum_added=50)
            self.expect_inside_marked(mesh)
            self.assertEqual({tuple(row) for row in mesh.markers.tolist()}, {(-1, -1), (0, 0), (1, 0), (2, 0)})

    def test_markers_of_points_as_line(self):
        made = delaunay(cloud(3, 20) * 8, source_points=SQUARES[:4], points_as_line=True)
        mesh = made.refine()
        self.expect_markers(mesh, {(0, k): SQUARES[k : k + 2] for k in range(3)})
        self.expect_inside_marked(mesh)

    def test_markers_of_divided_segments(self):
        """Of one that was divided, where it crosses the surface's edges, the part that crosses another is left out."""
        source = np.array([(4, 0), (4, 8), (0, 4.3), (8, 4.3)])
        with self.assertWarnsRegex(DelaunayWarning, "cross"):
            made = delaunay(np.column_stack((cloud(1, 12) * 8, cloud(2, 12)[:, 0])), source_points=source,
                            lines=[[0, 1], [2, 3]], source_heights="surface")  # fmt: skip
        mesh = made.refine(0)
        self.expect_mesh(made, mesh)
        self.expect_inside_marked(mesh)
        for chain, axis in ((0, 0), (1, 1)):
            places = mesh.points[mesh.edges[mesh.markers[:, 0] == chain]]
            self.assertEqual(set(places[..., axis].ravel().tolist()), {source[2 * chain, axis]})
            whole = np.ptp(places[..., 1 - axis])
            self.assertAlmostEqual(whole, 8)
            self.assertEqual(abs(np.diff(places[..., 1 - axis])).sum() < 7.9, chain == 1)

    def test_constraints_outside_of_the_triangles(self):
        """They have no pieces, but where one goes on inside it has its marker."""
        points = np.concatenate((SQUARES, [(-4, 1), (12, 1), (-4, 4), (-2, 9), (2.5, 2), (2.5, 3)]))
        made = delaunay(points, loops=LOOPS, lines=[[10, 11], [12, 13], [14, 15]], crossings="split")
        mesh = made.refine(0)
        self.expect_mesh(made, mesh)
        self.expect_inside_marked(mesh)
        self.assertEqual({chain for chain, _ in mesh.markers.tolist()}, {0, 3, 4})

    def test_markers_of_source_points(self):
        """A segment that is left out, as it crosses another, marks nothing. Ids are those of the source's points."""
        with self.assertWarnsRegex(DelaunayWarning, "cross"):
            made = delaunay(cloud(3, 20) * 4 + 2, source_points=SQUARES, loops=LOOPS,
                            lines=[[8, 9], [1, 3], [9, 6], [8, 8]])  # fmt: skip
        mesh = made.refine()
        self.expect_mesh(made, mesh)
        self.assertEqual(set(mesh.markers[:, 0].tolist()), {0, 1, 4, 5})
        self.assertEqual(mesh.interpolate(np.arange(30.0)).shape, (len(mesh.points),))

    def test_regions(self):
        for keywords in ({"lines": [[0, 2]]}, {"lines": [[0, 2], [1, 3]], "crossings": "split"}, {}):
            made = delaunay(np.concatenate((SQUARES[:4], cloud(5, 30) * 8)), **keywords)
            mesh = made.refine(27, maximum_length=1.5)
            self.expect_mesh(made, mesh)
            centres = mesh.triangulation.points[:, :2][mesh.triangles].mean(axis=1)
            np.testing.assert_array_equal(mesh.regions, made.regions[made.locate(centres).triangle])
            self.assertEqual(len(set(mesh.regions.tolist())), len(set(made.regions.tolist())))

    def test_heights_and_data(self):
        """z, and data with columns, are linear along segments and in the triangles of before."""
        points = cloud(7, 60, 3)
        points[:, 2] = 3 * points[:, 0] - points[:, 1] + 2
        made = delaunay(points, segments=[[0, 1]])
        mesh = made.refine(30)
        x, y, z = mesh.points.T
        np.testing.assert_allclose(z, 3 * x - y + 2, atol=1e-13)
        both = mesh.interpolate(np.column_stack((points[:, 0], points[:, 2])))
        np.testing.assert_allclose(both, np.column_stack((x, z)), atol=1e-13)
        self.assertTrue(np.isnan(mesh.interpolate(np.full(60, np.nan))).all())
        np.testing.assert_array_equal(mesh.triangulation.points, mesh.points)

    def test_in_a_plane(self):
        """A wall with a window, in space: new points are on the wall."""
        wall = np.array([(0, 0, 0), (8, 6, 0), (8, 6, 9), (0, 0, 9), (3, 2.25, 3), (6, 4.5, 3), (6, 4.5, 6),
                         (3, 2.25, 6)])  # fmt: skip
        made = delaunay(wall, plane="best_fit", loops=[[0, 1, 2, 3], [4, 5, 6, 7]])
        mesh = made.refine(30, maximum_area=2)
        self.assertEqual(mesh.points.shape[1], 3)
        np.testing.assert_allclose(mesh.points[:, 1], 0.75 * mesh.points[:, 0], atol=1e-12)
        self.assertAlmostEqual(mesh.triangulation.areas.sum(), 90 - 3.75 * 3, 9)
        self.assertEqual({chain for chain, _ in mesh.markers.tolist()}, {0, 1})

    def test_points_that_are_no_vertices(self):
        """Duplicates, skipped and merged ones, not finite ones, those within an error: no triangle has them."""
        points = np.concatenate((lattice(6), lattice(3), [[np.nan, 1], [2.5, 2.5], [1.001, 1]]))
        skip = np.arange(len(points)) == len(points) - 2
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            made = delaunay(points, skip=skip, tolerance=0.001)
            mesh = made.refine(maximum_length=0.8)
        self.assertTrue((mesh.triangles[mesh.triangles < len(points)] < 36).all())
        self.assertTrue(np.isnan(mesh.points[45, 0]))
        fresh = delaunay(lattice(6)).refine(maximum_length=0.8)
        self.assertEqual({tuple(p) for p in fresh.points[36:]}, {tuple(p) for p in mesh.points[len(points):]})
        light = delaunay(lattice(6), heights=np.zeros(36), maximum_error=0.1)
        self.assertEqual(len(np.unique(light.refine(maximum_length=9).triangles)), 4)

    def test_any_order_and_type(self):
        points = cloud(11, 400).astype(np.float32)
        found = []
        for seed, dtype in ((None, np.float64), (5, np.float64), (None, np.float32)):
            order = np.arange(400) if seed is None else np.random.default_rng(seed).permutation(400)
            mesh = delaunay(points[order].astype(dtype), id_dtype=np.int64, threads=1).refine(30)
            found.append(sorted(map(tuple, mesh.points.tolist())))
            for array in (mesh.triangles, mesh.edges, mesh.markers, mesh.corners, mesh.regions):
                self.assertEqual(array.dtype, np.int64)
        self.assertEqual(found[0], found[1])
        self.assertEqual(found[0], found[2])
        self.assertEqual(delaunay(points).refine().edges.dtype, np.int32)

    def test_bad_triangles(self):
        made = of_squares()
        mesh = made.refine(30, maximum_area=0.1, maximum_added=20)
        self.expect_mesh(made, mesh)
        self.assertEqual(len(mesh.corners), 20)
        self.assertEqual(set(mesh.reasons.tolist()), {BadReason.BUDGET})
        bad = (mesh.triangulation.areas > 0.1) | (angles(mesh).min(axis=1) < 30 - 1e-9)
        self.assertEqual(sorted(mesh.bad.tolist()), np.flatnonzero(bad).tolist())
        fan = delaunay([(0, 0), (10, 0), (10, 1), (5, 9)], segments=[[0, 1], [0, 2]]).refine(25)
        self.assertEqual(set(fan.reasons.tolist()), {BadReason.INPUT_ANGLE})
        self.assertEqual(sorted(fan.bad.tolist()), np.flatnonzero(angles(fan).min(axis=1) < 25).tolist())
        far = delaunay(lattice(3) * 1e-3 + 1e12).refine(maximum_length=1e-7)
        self.assertEqual(set(far.reasons.tolist()), {BadReason.RESOLUTION})
        self.assertEqual(len(made.refine(33, maximum_added=0).points), 10)

    def test_cells_of_pieces_are_chains(self):
        """The engine follows chains by exact predicates, `markers` looks for pieces on given segments."""
        random = np.random.default_rng(5)
        for trial in range(60):
            count = int(random.integers(5, 30))
            points = random.integers(0, 7, (count, 2)) if trial % 2 else random.random((count, 2))
            lines = [random.integers(0, count, random.integers(2, 6)) for _ in range(random.integers(0, 4))]
            loops = [random.integers(0, count, random.integers(3, 6)) for _ in range(random.integers(0, 2))]
            crossings = "split" if trial % 3 else "leave_out"
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DelaunayWarning)
                made = delaunay(points.astype(float), lines=lines, loops=loops, crossings=crossings)
                found = Found(made._engine(), library.RefineRequest(25, 0, 0, None, 200), None)
            ends = np.stack((found.offsets[:-1], found.offsets[1:] - 1), axis=1)[: found.report.lines]
            segments = Segments(made._request, made.point_status, made.plane_points)
            looked_for = segments.of(np.concatenate((found.edges, found.ids[ends])))[: len(found.edges)]
            np.testing.assert_array_equal(found.cells, looked_for[:, 0])

    def test_nothing_where_loops_leave_nothing(self):
        square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            mesh = delaunay(square, loops=[[0, 3, 2, 1]], fill_rule="orientation").refine()
        self.assertEqual([len(mesh.points), len(mesh.triangles), len(mesh.regions), len(mesh.edges)], [4, 0, 0, 0])

    def test_nothing(self):
        for points in ([], [[0, 0], [1, 1], [2, 2]]):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DelaunayWarning)
                mesh = delaunay(points).refine(30)
            self.assertEqual([len(array) for array in (mesh.points, mesh.triangles, mesh.edges, mesh.bad)],
                             [len(points), 0, 0, 0])

    def test_refused(self):
        """By the engine, too; all texts of Python's are in Refusals.json."""
        made = of_squares()
        for keywords, text in (
            ({"sizes": np.where(np.arange(10) == 7, -2.0, 1.0)}, "The size at point 7 is -2.0.*finite and above 0"),
            ({"sizes": np.where(np.arange(10) == 3, np.nan, 1.0)}, "The size at point 3 is nan"),
            ({"sizes": lambda xy: np.zeros(10)}, "The size at point 0 is 0"),
        ):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                made.refine(**keywords)
        for keywords in ({"max_area": 1, "maximum_area": 1}, {"area": 1}):
            with self.subTest(keywords), self.assertRaises(TypeError):
                made.refine(**keywords)
        for name, value in (("alpha", 9.0), ("maximum_edge_length", 9.0)):
            with self.assertRaisesRegex(ValueError, "with %s cannot be refined: give an outline as loops" % name):
                delaunay(SQUARES, **{name: value}).refine()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            self.assertRaisesRegex(ValueError, "insertion_limit", delaunay(SQUARES, insertion_limit=9).refine)
            self.assertRaisesRegex(ValueError, "point 0 is 2.900", delaunay(lattice(3)[1:] * 1e275).refine)

    def test_changed_points_memory_and_a_released_one(self):
        points = cloud(1, 3000)
        made = delaunay(points)
        mesh = made.refine(30)
        made.release()
        self.assertEqual(made.refine(30).triangles.tobytes(), mesh.triangles.tobytes())
        limited = delaunay(points, memory_limit="4 MB")
        with self.assertRaisesRegex(MemoryError, "Refining the triangles of 3000 points takes more than .*allows 4 MB"):
            limited.refine(30, maximum_area=1e-6)
        limited.refine()
        points[7] += 1
        self.assertRaisesRegex(RuntimeError, "points were changed", made.refine)
        self.assertEqual(len(mesh.triangulation.neighbors), len(mesh.triangles))  # which has its own

    def test_ctrl_c(self):
        done = in_a_process(INTERRUPTED)
        self.assertEqual(done.stdout, "interrupted\n2\n", done.stderr)

    def test_as_an_object(self):
        mesh = of_squares().refine(30)
        self.assertIsInstance(mesh, Mesh)
        for other in (mesh, pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh), copy.copy(mesh)):
            self.assertEqual(repr(other), repr(mesh))
            for name in ("points", "triangles", "regions", "edges", "markers", "on_boundary", "corners", "weights",
                         "bad", "reasons", "is_added"):  # fmt: skip
                self.assertEqual(getattr(other, name).tobytes(), getattr(mesh, name).tobytes())
                self.assertFalse(getattr(other, name).flags.writeable, name)
            self.assertEqual(other.interpolate(SQUARES[:, 0]).tobytes(), mesh.interpolate(SQUARES[:, 0]).tobytes())


if __name__ == "__main__":
    unittest.main()
