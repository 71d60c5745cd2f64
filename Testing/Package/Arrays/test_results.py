# SPDX-License-Identifier: BSD-3-Clause
"""delaunay: results, against definitions in exact arithmetic."""

import copy
import pickle
import unittest
import warnings
import weakref
from fractions import Fraction

import numpy as np
from adaptivehilbertdelaunay import DelaunayWarning, Kind, delaunay
from adaptivehilbertdelaunay._keywords import KEYWORDS, WANTED
from arraysupport import SQUARE, attributes, cloud, complaints, hull_of, integers, lattice, orient, twice_area


def point_sets():
    """Random ones, cocircular and collinear ones, of float32, with duplicates."""
    yield "random", cloud(1)
    yield "float32", cloud(2, 100, 3, np.float32)
    yield "lattice", lattice(9)
    yield "duplicates", np.repeat(cloud(3, 50), 3, axis=0)
    yield "small integers", np.random.default_rng(4).integers(0, 12, (150, 2)).astype(float)
    yield "far away", cloud(5) * 100 + [5e5, 4.5e6]


def area_of(corners):
    return sum(orient((0, 0), a, b) for a, b in zip(corners, [*corners[1:], *corners[:1]])) / 2


def corners_of(polygon):
    """In rational numbers, counterclockwise; of two corners a box."""
    found = [tuple(map(Fraction, corner)) for corner in polygon]
    if len(found) == 2:
        xs, ys = map(sorted, zip(*found))
        found = [(xs[0], ys[0]), (xs[1], ys[0]), (xs[1], ys[1]), (xs[0], ys[1])]
    return found if area_of(found) > 0 else found[::-1]


def nearest(polygon, vertex, vertices):
    """The part of the polygon that is nearer to the vertex than to any other."""
    for other in vertices:
        found = []
        for a, b in zip(polygon, [*polygon[1:], *polygon[:1]]):
            # how much farther the other one is
            at = [sum((p[k] - other[k]) ** 2 - (p[k] - vertex[k]) ** 2 for k in range(2)) for p in (a, b)]
            found += [a] * (at[0] >= 0)
            if at[0] * at[1] < 0:
                part = at[0] / (at[0] - at[1])
                found.append(tuple(a[k] + part * (b[k] - a[k]) for k in range(2)))
        polygon = found
    return polygon


class DelaunayTest(unittest.TestCase):
    def test_is_the_delaunay_triangulation_of_the_hull(self):
        for name, points in point_sets():
            with self.subTest(name):
                made, places = delaunay(points), integers(points)
                self.assertEqual(complaints(points, made.triangles, made.neighbors), [])
                hull = hull_of(places)
                around = twice_area(hull, [(0, k, k + 1) for k in range(1, len(hull) - 1)])
                self.assertEqual(twice_area(places, made.triangles.tolist()), around)
                vertices = len(set(places))
                self.assertEqual(len(made.triangles), 2 * vertices - 2 - len(hull))
                self.assertEqual(len({places[i] for i in made.triangles.ravel()}), vertices)
                self.assertEqual(made.counts["inserted"], vertices)

    def test_hull_and_boundary(self):
        for name, points in point_sets():
            with self.subTest(name):
                made, places = delaunay(points), integers(points)
                hull, found = hull_of(places), [places[i] for i in made.hull]
                turn = found.index(hull[0])
                self.assertEqual(found[turn:] + found[:turn], hull)
                edges = {tuple(edge) for edge in made.boundary.tolist()}
                self.assertEqual(edges, set(zip(made.hull.tolist(), np.roll(made.hull, -1).tolist())))

    def test_edges(self):
        made = delaunay(cloud(6))
        expected = {}  # by its ends: as it runs in the first triangle
        for t in made.triangles.tolist():
            for edge in zip(t, t[1:] + t[:1]):
                expected.setdefault(frozenset(edge), list(edge))
        self.assertEqual(made.edges.tolist(), list(expected.values()))
        outer = [list(e) for t in made.triangles.tolist() for e in zip(t, t[1:] + t[:1])]
        self.assertEqual(made.boundary.tolist(), [edge for edge in outer if edge[::-1] not in outer])

    def test_status_and_vertices_of_points(self):
        points = np.concatenate((cloud(7, 20), cloud(7, 20)[5:8], [[np.nan, 0]], cloud(8, 2)))
        with self.assertWarns(UserWarning):
            made = delaunay(points, skip=np.arange(26) == 25)
        self.assertEqual(made.point_status.tolist(), list(range(20)) + [5, 6, 7, -1, 24, -2])
        self.assertEqual(made.counts["duplicates"], 3)
        vertices = made.vertex_of_point
        self.assertEqual(sorted(set(vertices[:20].tolist())), [v for v in range(21) if v != vertices[24]])
        self.assertEqual(vertices[20:23].tolist(), vertices[5:8].tolist())
        self.assertEqual(vertices[[23, 25]].tolist(), [-1, -1])
        self.assertEqual(made.point_of_vertex[vertices[:20]].tolist(), list(range(20)))

    def test_locate(self):
        points = lattice(6)
        made, places = delaunay(points), cloud(9, 60) * 7 - 1
        places = np.concatenate((places, points[::5], points[:5] + [0.5, 0], [[np.nan, 1], [np.inf, 0]]))
        found = made.locate(places)
        for place, kind, triangle, corners in zip(places, *found):
            if not np.isfinite(place).all():
                self.assertEqual((kind, triangle), (Kind.NOWHERE, -1))
                continue
            scaled = integers(np.concatenate((points, [place])))
            if kind == Kind.OUTSIDE:
                self.assertTrue((place < 0).any() or (place > 5).any())
                self.assertEqual((triangle, set(corners)), (-1, {-1}))
                continue
            ids = made.triangles[triangle]
            sides = [orient(scaled[ids[k]], scaled[ids[(k + 1) % 3]], scaled[-1]) for k in range(3)]
            self.assertTrue(min(sides) >= 0, place)
            on = sum(side == 0 for side in sides)
            self.assertEqual(kind, (Kind.IN_TRIANGLE, Kind.ON_EDGE, Kind.ON_VERTEX)[on])
            named = set(corners[corners >= 0].tolist())
            self.assertEqual(len(named), 3 - on)
            self.assertLessEqual(named, set(ids.tolist()))
        turn = np.random.default_rng(19).permutation(len(places))
        for array, turned in zip(found, made.locate(places[turn])):
            np.testing.assert_array_equal(array[turn], turned)
        for place, kind in ([1e308, -1e308], 3), ([-1e308, 1e308], 3), ([2.5, 2.4], 0), ([5e-324, 0.5], 0):
            both = made.locate([place, [1e308, 1e308], place, [-1e308, 0]])
            self.assertEqual((both.kind[0], both.kind[2]), (kind, kind))
        self.assertEqual(made.locate(np.empty((0, 2))).corners.shape, (0, 3))
        with self.assertWarns(UserWarning):
            self.assertEqual(delaunay(SQUARE[:2]).locate([[0, 0]]).kind[0], Kind.NOWHERE)

    def test_voronoi(self):
        """Cells are convex, add up to the hull (or the box), and are nearest to their sites."""
        points = cloud(10, 80)
        made = delaunay(points)
        for clip in ("hull", "bounds"):
            diagram = made.voronoi(clip)
            self.assertIs(made.voronoi(clip), diagram)
            self.assertEqual(sorted(diagram.sites), list(range(80)))
            total = 0
            for site, cell in zip(diagram.sites, diagram):
                total += sum(orient((0, 0), cell[k - 1], cell[k]) for k in range(len(cell))) / 2
                middle = cell.mean(axis=0)
                self.assertEqual(np.argmin(((points - middle) ** 2).sum(axis=1)), site)
            whole = np.prod(np.ptp(points, axis=0))
            if clip == "hull":
                whole = twice_area(points.tolist(), made.triangles.tolist()) / 2
            self.assertAlmostEqual(total, whole, 12)
            self.assertEqual(len(diagram), 80)
            np.testing.assert_array_equal(diagram[-1], diagram[79])
        self.assertIs(made.voronoi(), made.voronoi("hull"))
        with self.assertRaises(IndexError):
            diagram[80]
        with self.assertRaises(ValueError):
            made.voronoi("box")

    def test_voronoi_in_a_polygon(self):
        """A cell for each vertex: the part of the polygon that is nearest to it, cut out in rational arithmetic."""
        points = np.round(cloud(11, 40) * 8) / 8  # ties
        made = delaunay(points)
        for corners in ([[0.25, 0.125], [0.75, 0.25], [0.5, 0.875]], [[-1, 0.5], [2, 0.5], [2, 3]], [[5, 5], [6, 7]],
                        [[0.875, 0.25], [0.5, 0.75]], [[0, 0], [0, 1], [1, 1], [1, 0], [0, 0]]):  # fmt: skip
            cells = made.voronoi(corners)
            self.assertIs(made.voronoi(np.array(corners)), cells)
            self.assertEqual(len(cells), made.counts["inserted"])
            vertices = [tuple(map(Fraction, point)) for point in points[cells.sites].tolist()]
            whole = corners_of(corners)
            areas = [Fraction(area_of(nearest(whole, vertex, vertices))) for vertex in vertices]
            self.assertEqual(sum(areas), area_of(whole))
            for cell, area in zip(cells, areas):
                self.assertEqual(len(cell) > 0, area > 0)
                self.assertAlmostEqual(area_of(cell), float(area), 12)
        first = weakref.ref(made.voronoi([[0, 0], [1, 1]]))
        last = weakref.ref(made.voronoi([[0, 0], [1, 2]]))
        self.assertEqual((first(), last() is None), (None, False), "as many would be kept as there are polygons")
        with self.assertRaisesRegex(ValueError, "^clip is not convex, but it must be two opposite corners of a box"):
            made.voronoi([[0, 0], [4, 0], [1, 1], [0, 4]])

    def test_fewer_than_three_points(self):
        for points in ([], [[1, 2]], [[1, 2], [3, 4]], [[1, 2], [1, 2], [1, 2]], np.empty((0, 3), np.float32)):
            if len(points):
                with self.assertWarnsRegex(UserWarning, "fewer than three distinct points"):
                    made = delaunay(points)
            else:
                made = delaunay(points)
            for name in ("triangles", "neighbors"):
                self.assertEqual(getattr(made, name).shape, (0, 3))
            for name in ("edges", "boundary", "constraint_edges", "lines", "merged"):
                self.assertEqual(getattr(made, name).shape, (0, 2), name)
            self.assertEqual((made.hull.shape, len(made.point_status)), ((0,), len(points)))
            self.assertEqual(len(made.voronoi()), 0)
            cells = made.voronoi([[0, 0], [4, 5]])
            self.assertEqual(len(cells), len({tuple(point) for point in points}))
            self.assertAlmostEqual(sum(area_of(cell) for cell in cells), 20.0 if len(points) else 0.0, 12)


class ObjectTest(unittest.TestCase):
    def every(self, made):
        found = {name: getattr(made, name) for name in attributes()}
        found.update(("boxes %d" % k, array) for k, array in enumerate(made.boxes))
        found.update(("voronoi " + name, array) for name, array in vars(made.voronoi()).items())
        return found

    def assert_same(self, one, two):
        for name, array in self.every(one).items():
            other = self.every(two)[name]
            self.assertEqual(array.dtype, other.dtype, name)
            np.testing.assert_array_equal(array, other, name)

    def test_nothing_can_be_written(self):
        made = delaunay(cloud(11))
        for name, array in self.every(made).items():
            with self.assertRaises(ValueError, msg=name):
                array[...] = 0
        with self.assertRaises(TypeError):
            made.counts["points"] = 1
        self.assertIs(made.triangles, made.triangles)
        self.assertIs(made.neighbors, made.neighbors)

    def test_wanted_is_what_is_made_later(self):
        points, loops = cloud(12), [[0, 1, 2, 3], [4, 5, 6]]
        later = delaunay(points, loops=loops, crossings="split", alpha=0.2)
        self.assert_same(delaunay(points, loops=loops, crossings="split", alpha=0.2, want=WANTED), later)
        for name in WANTED:
            self.assert_same(delaunay(points, loops=loops, crossings="split", alpha=0.2, want=name), later)

    def test_released_is_made_again(self):
        made, again = delaunay(cloud(13)), delaunay(cloud(13))
        self.every(made)
        again.release()
        self.assert_same(made, again)
        again.release()
        self.assert_same(made, again)

    def test_copies_and_pickles(self):
        points = cloud(14)
        made = delaunay(points, segments=[(0, 1), (0, 3)], plane="best_fit")
        self.assertIs(copy.copy(made), made)
        twins = [copy.deepcopy(made), pickle.loads(pickle.dumps(made))]
        self.every(made)
        twins += [copy.deepcopy(made), pickle.loads(pickle.dumps(made))]
        for twin in twins:
            self.assertFalse(np.may_share_memory(twin.points, points))
            self.assert_same(made, twin)
            self.assertEqual((twin.counts, twin.measures), (made.counts, made.measures))
        points[0] = 9
        self.assertEqual(len(twins[1].voronoi("bounds")), 200)

    @staticmethod
    def values_of(row):
        """Each word, both of a switch, of a range its lower end and more."""
        if row.words or row.least is None:
            return row.words or (False, True)
        return row.least, row.least + (0.3 if isinstance(row.least, float) else 7)

    def test_each_keyword_is_kept(self):
        """What is made later, of a copy too, is made with it."""
        points = cloud(20, 60, 3)
        given = {"segments": [(0, 1), (2, 3)], "loops": [[4, 5, 6, 7]], "source_points": cloud(21, 8, 3)}
        for name, row in KEYWORDS.items():
            for value in self.values_of(row) if name != "memory_limit" else (0, 1 << 24):
                with warnings.catch_warnings(), self.subTest(name=name, value=value):
                    warnings.simplefilter("ignore", DelaunayWarning)
                    made, again = (delaunay(points, **{name: value}, **given) for _ in range(2))
                    again.release()
                    self.assert_same(made, again)
                    self.assert_same(made, pickle.loads(pickle.dumps(again)))

    def test_points_that_were_changed_are_noticed(self):
        for view in (lambda points: points, lambda points: points[::2, ::-1], memoryview):
            points = cloud(15, 200000)
            made = delaunay(view(points), threads=1)
            triangles = made.triangles.copy()
            points[100000, 1] += 1e-9
            for ask in (lambda: made.neighbors, lambda: made.locate([[0.5, 0.5]]), made.voronoi, lambda: made.order):
                with self.assertRaisesRegex(RuntimeError, "points were changed"):
                    ask()
            np.testing.assert_array_equal(made.triangles, triangles)
            points[100000, 1] = cloud(15, 200000)[100000, 1]
            self.assertEqual(made.neighbors.shape, triangles.shape)

    def test_any_change_is_noticed(self):
        """One bit anywhere, rows that change places; in every layout and type."""
        shapes = ((3, 2, np.float64), (9001, 2, np.float32), (20000, 3, np.float32), (30000, 3, np.float64))
        for count, columns, dtype in shapes:
            points = cloud(18, count, columns, dtype)
            for view in (points, points[::-1, :2]):
                made = delaunay(view)
                for row in {0, count // 2, count - 1, min(count - 1, 8192)}:
                    for column in range(view.shape[1]):
                        before = view[row, column]
                        view[row, column] = np.nextafter(before, dtype(2))
                        self.assertRaises(RuntimeError, made._engine)
                        view[row, column] = before
                for other in {count - 1, min(count - 1, 8192)}:
                    view[[0, other]] = view[[other, 0]]
                    self.assertRaises(RuntimeError, made._engine)
                    view[[0, other]] = view[[other, 0]]
                self.assertEqual(made.neighbors.shape, made.triangles.shape)

    def test_located_goes_on_after_a_change(self):
        points = cloud(16)
        made = delaunay(points)
        before = made.locate(cloud(17))
        points[:] = 0
        for now, then in zip(made.locate(cloud(17)), before):
            np.testing.assert_array_equal(now, then)

    def test_repr(self):
        self.assertEqual(repr(delaunay(SQUARE)), "<Triangulation of 6 points: 6 triangles>")


if __name__ == "__main__":
    unittest.main()
