# SPDX-License-Identifier: BSD-3-Clause
"""delaunay: geometries as constraints, GeoJSON and arrays of coordinates. Those of other packages: with_gis.py."""

import inspect
import unittest

import numpy as np
from adaptivehilbertdelaunay import DelaunayWarning, LinearInterpolator, delaunay
from arraysupport import KeywordTest, cloud, integers, lattice, twice_area

POINTS = 10 * cloud(61, 400)
HIGH = np.column_stack((POINTS, POINTS.sum(axis=1) + 300))  # on a plane


def box(x, y, side, closed=True):
    return [[x, y], [x + side, y], [x + side, y + side], [x, y + side]] + [[x, y]] * closed


def polygon(*rings):
    return {"type": "Polygon", "coordinates": list(rings)}


def line(*places):
    return {"type": "LineString", "coordinates": places}


def collection(*geometries):
    return {"type": "GeometryCollection", "geometries": geometries}


class Shows:
    """Has a geometry, and perhaps measures, as shapely's."""

    def __init__(self, geometry, has_m=False):
        self.__geo_interface__, self.has_m = geometry, has_m


def area(made):
    return twice_area(integers(np.rint(np.asarray(made.points) * 2**30)), made.triangles.tolist()) / 2**61


class GeometryTest(KeywordTest):
    def check(self, constraints, wanted, points=POINTS, **more):
        made = delaunay(points, constraints=constraints, **more)
        self.assertAlmostEqual(area(made), wanted, places=6)
        return made

    def test_polygons(self):
        outline, hole = box(1, 1, 8), box(3, 3, 2)
        for rings, wanted in (((outline,), 64), ((outline, hole), 60), ((outline[::-1], hole), 60),
                              ((box(1, 1, 8, False), box(3, 3, 2, False)), 60)):  # fmt: skip
            made = self.check(polygon(*rings), wanted)
            self.assertEqual(made.counts["source_points"], 4 * len(rings))
            np.testing.assert_array_equal(made.points[400:404], rings[0][:4])
        many = {"type": "MultiPolygon", "coordinates": [[box(1, 1, 6), hole], [box(8, 8, 1)]]}
        self.check(many, 33)

    def test_in_every_wrapping(self):
        """The same bytes."""
        rings = polygon(box(1, 1, 8), box(3, 3, 2))
        feature = {"type": "Feature", "properties": {"name": "field"}, "geometry": rings}
        wanted = delaunay(POINTS, constraints=rings)
        for same in (
            Shows(rings), feature, Shows(feature), {"type": "FeatureCollection", "features": [feature]}, [rings],
            collection(rings), collection(collection(rings), collection()), (None, rings), iter([Shows(rings)]),
            rings["coordinates"], [np.array(ring) for ring in rings["coordinates"]], np.array(rings["coordinates"]),
            [tuple(map(tuple, ring)) for ring in rings["coordinates"]], np.array(rings["coordinates"], np.float32),
        ):  # fmt: skip
            made = delaunay(POINTS, constraints=same)
            for name in ("triangles", "points", "constraint_edges"):
                np.testing.assert_array_equal(getattr(made, name), getattr(wanted, name), name)
        ring = np.array(box(1, 1, 8), int)
        for one in (ring, ring.tolist(), ring[:-1], list(map(tuple, ring.tolist())), list(ring)):
            self.check(one, 64)

    def test_that_look_at_the_calling_functions(self):
        """As a debugger does: their variables stay apart from the keywords."""
        class Looks(Shows):
            def __getattribute__(self, name):
                [frame.frame.f_locals for frame in inspect.stack(0)]
                return super().__getattribute__(name)

        self.check(Looks(polygon(box(1, 1, 8))), 64)

    def test_lines_and_points(self):
        places = [[1, 1], [5, 6], [9, 2]]
        made = self.check(line(*places), area(delaunay(POINTS)))
        wanted = delaunay(POINTS, source_points=places, lines=[[0, 1, 2]], source_heights="surface")
        np.testing.assert_array_equal(made.triangles, wanted.triangles)
        np.testing.assert_array_equal(made.constraint_edges, wanted.constraint_edges)
        made = delaunay(POINTS, constraints=[
            line(*places), {"type": "MultiLineString", "coordinates": [[[1, 8], [2, 9]], [[2, 2], [3, 1]]]},
            {"type": "Point", "coordinates": [4, 4]}, {"type": "MultiPoint", "coordinates": [[5, 5], [6, 6]]},
            {"type": "LinearRing", "coordinates": box(0.5, 0.5, 9)}])  # fmt: skip
        self.assertEqual(made.counts["source_points"], 3 + 4 + 3 + 4)
        np.testing.assert_array_equal(made.points[407:410], [[4, 4], [5, 5], [6, 6]])
        self.assertAlmostEqual(area(made), 81, places=6)
        with self.assertWarnsRegex(DelaunayWarning, "constrain nothing"):
            self.assertEqual(len(delaunay(POINTS, constraints={"type": "Point", "coordinates": [4, 4]}).points), 401)
        ring = line(*box(1, 1, 8))
        self.check(ring, area(delaunay(POINTS)))
        self.check(ring, 64, closed_lines_are_loops=True)

    def test_nothing(self):
        """Empty geometries are no constraints."""
        wanted = delaunay(POINTS)
        for empty in (None, [], (), [None], polygon(), polygon([]), line(), collection(), np.zeros((0, 2)), [[]],
                      {"type": "Feature", "geometry": None}, {"type": "FeatureCollection", "features": []},
                      {"type": "Point", "coordinates": []}, {"type": "MultiPolygon", "coordinates": None}):  # fmt: skip
            made = delaunay(POINTS, constraints=empty)
            np.testing.assert_array_equal(made.triangles, wanted.triangles, repr(empty))
            self.assertEqual(made.counts["source_points"], 0)
        for setting in ({"source_heights": "surface"}, {"points_as_line": True}):
            np.testing.assert_array_equal(delaunay(POINTS, constraints=[], **setting).triangles, wanted.triangles)

    def test_polygons_beside_in_and_over_each_other(self):
        """As documented: all rings count alike, and one that comes twice counts once."""
        self.check([polygon(box(1, 1, 4)), polygon(box(5, 1, 4)), polygon(box(5, 5, 2))], 16 + 16 + 4)
        self.check([polygon(box(1, 1, 8)), polygon(box(2, 2, 3))], 64 - 9)
        over = [polygon(box(1, 1, 4)), polygon(box(3, 3, 4))]
        self.check(over, 16 + 16 - 2 * 4, crossings="split")
        with self.assertWarnsRegex(DelaunayWarning, "1 loop bounds nothing"):
            self.check(over, 16)
        self.check([polygon(box(1, 1, 4))] * 2, 16)  # the same ring counts once
        bow = polygon([[1, 1], [5, 5], [5, 1], [1, 5], [1, 1]])
        self.check(bow, 8, crossings="split")
        with self.assertWarnsRegex(DelaunayWarning, "1 loop bounds nothing"):
            delaunay(POINTS, constraints=bow)


    def test_as_a_clip_of_voronoi_cells(self):
        square = [[1, 1], [9, 1], [9, 9], [1, 9]]
        wanted = delaunay(POINTS).voronoi(square).points
        for given in (polygon(box(1, 1, 8)), Shows(polygon(box(1, 1, 8)[::-1])), collection(polygon(square)),
                      polygon([[x, y, 7] for x, y in square])):  # fmt: skip
            self.assertEqual(set(map(tuple, delaunay(POINTS).voronoi(given).points)), set(map(tuple, wanted)))
        made = delaunay(POINTS, voronoi_clip=polygon(square)).voronoi()
        np.testing.assert_array_equal(made.points, wanted)


class HeightsTest(KeywordTest):
    def test_own(self):
        ridge = line([2, 2, 50], [8, 7, 60])
        for points in (HIGH, POINTS):
            self.assertEqual(delaunay(points, constraints=ridge).points[400:].tolist(), [[2, 2, 50], [8, 7, 60]])
        made = delaunay(HIGH, constraints=ridge, source_heights="surface")
        np.testing.assert_allclose(made.points[400:402, 2], [304, 315])
        with self.assertRaisesRegex(ValueError, "402 points, the last 2 of which are those of the constraints"):
            delaunay(HIGH, constraints=ridge).interpolate(HIGH[:, 2], [[5, 5]])

    def test_of_the_surface(self):
        """Where geometries have none: the z, and values given for the points alone."""
        field = polygon(box(1, 1, 8), box(3, 3, 2))
        made = delaunay(HIGH, constraints=field)
        np.testing.assert_allclose(made.points[400:, 2], made.points[400:, :2].sum(axis=1) + 300)
        places = np.array([[1.1, 1.1], [8.9, 1.5], [2.9, 4], [4, 4], [0.5, 5]])
        wanted = np.where([True, True, True, False, False], places.sum(axis=1) + 300, np.nan)
        for one in (made, delaunay(POINTS, constraints=field)):
            for values in (HIGH[:, 2], HIGH[:, 2].tolist(), np.append(HIGH[:, 2], [0] * 8)):
                np.testing.assert_allclose(one.interpolate(values, places), wanted)
                np.testing.assert_allclose(LinearInterpolator(one, values)(places), wanted)
            np.testing.assert_allclose(one.interpolate(np.c_[HIGH[:, 2], POINTS] + 1j, places)[:, 0], wanted + 1j)
            self.assertEqual(len(one.interpolate(np.arange(400))), 408 + one.counts["points_added_to_lines"])
            self.assertGreater(one.counts["points_added_to_lines"], 0, "along the lines")
            for count in (399, 401, 409):
                self.assertRaisesRegex(ValueError, "408 points", one.interpolate, np.zeros(count), places)

    def test_beyond_the_points(self):
        """There is no height, rather than 0."""
        with self.assertWarns(DelaunayWarning):
            made = delaunay(HIGH, constraints=polygon(box(-2, -2, 7)))
        np.testing.assert_array_equal(np.isnan(made.points[400:404, 2]), [True, True, False, True])
        np.testing.assert_allclose(made.interpolate(HIGH[:, 2], [[4, 4], [-1, -1]]), [308, np.nan])

    def test_some(self):
        """Those without a z lie on the surface of the points and of those with one."""
        some = [line([2, 2, 50], [8, 7, 60]), line([1, 8], [3, 9]), {"type": "Point", "coordinates": [5, 4.5]}]
        made = delaunay(HIGH, constraints=some)
        np.testing.assert_allclose(made.points[400:405, 2], [50, 60, 309, 312, 55])
        low = delaunay(HIGH, constraints=some, source_heights="surface")
        np.testing.assert_allclose(low.points[400:405, 2], [304, 315, 309, 312, 309.5])

    def test_means(self):
        """Heights of the points are those that duplicates='mean_z' makes."""
        points = np.array([[x, y, z] for x, y in lattice(4).tolist() for z in (x, x + 2)])
        made = delaunay(points, constraints=polygon(box(0.5, 0.5, 2)), duplicates="mean_z")
        np.testing.assert_allclose(made.interpolate(points[:, 2], [[1.5, 1.5], [0.75, 2]]), [2.5, 1.75])


# Each wrong value: the exception, and its text.
WRONG = (
    (TypeError, "POLYGON ((0 0, 1 0, 1 1, 0 0))", "constraints must be a geometry .* not str: shapely.from_wkt"),
    (TypeError, 5, "constraints must be a geometry .* not int"),
    (TypeError, [polygon(box(1, 1, 8)), object()], r"constraints\[1\] must be a geometry .* not object"),
    (TypeError, np.array(5.0), "constraints must be a geometry .* not ndarray"),
    (ValueError, {"type": "Topology"}, "constraints must be .* not a mapping of type 'Topology'"),
    (ValueError, {}, "constraints must be .* not a mapping of type None"),
    (ValueError, polygon([[0, 0], [1, 0], [1, np.nan], [0, 0]]), "constraints, a Polygon: point 2 is at .1, nan."),
    (ValueError, collection(None, line([0, 0], [1, -np.inf])), r"constraints\[1\], a LineString: point 1 .* -inf"),
    (ValueError, [box(1, 1, 8), [[np.nan, 0], [1, 1], [2, 2]]], r"constraints\[1\]: point 0 is at .nan, 0."),
    (ValueError, line([0, 0]), "constraints, a LineString: a line must have two points or more, not 1"),
    (ValueError, polygon([[0, 0], [1, 1], [0, 0]]), "constraints, a Polygon: a ring must have three points .* not 2"),
    (ValueError, polygon([[0, 0, 1], [1, 1], [2, 0]]), "constraints, a Polygon: its points .* of unlike counts"),
    (ValueError, line([0, 0, 0, 0.5], [1] * 4), "constraints, a LineString: its points .*, 4. of type float"),
    (ValueError, np.zeros(4), "constraints: its points must all have two numbers"),
    (ValueError, {"type": "Polygon", "coordinates": 5}, "constraints, a Polygon: its coordinates are of type int"),
    (TypeError, {"type": "FeatureCollection", "features": 5}, "constraints must be a geometry .* not int"),
    (ValueError, [Shows(line([0, 0, 5], [1, 1, 6]), True)], r"constraints\[0\] has measures .M., which are no z"),
    (ValueError, Shows(line([0, 0, 5], [1, 1, 6]), np.array([False, True])), "constraints has measures"),
    (ValueError, line("ab", "cd"), "a LineString: its points .* of type <U2"),
    (TypeError, np.ma.masked_less(box(1, 1, 8), 2), "constraints: a masked array"),
)


class RefusedTest(unittest.TestCase):
    def test_they_are_named(self):
        for kind, given, words in WRONG:
            with self.subTest(words), self.assertRaisesRegex(kind, words):
                delaunay(POINTS, constraints=given)

    def test_with_other_constraints(self):
        for name, value in (("segments", [(0, 1)]), ("lines", [[0, 1]]), ("loops", [0, 1, 2]), ("source_points", HIGH)):
            with self.assertRaisesRegex(ValueError, "points of their own: give either these or %s" % name):
                delaunay(POINTS, constraints=box(1, 1, 8), **{name: value})


if __name__ == "__main__":
    unittest.main()
