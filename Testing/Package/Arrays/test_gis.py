# SPDX-License-Identifier: BSD-3-Clause
"""delaunay with the packages that others bring their geometries by: shapely, geopandas. Debian 12 has shapely 1.8, PyPI
2. Skipped (exit code 77) where one of them is missing, which is named.
"""

import importlib.util
import sys
import unittest
import warnings

import numpy as np
from adaptivehilbertdelaunay import delaunay
from arraysupport import KeywordTest, cloud
from test_geometry import area

NEEDED = ("geopandas", "shapely")
POINTS = 10 * cloud(62, 500)


class GeometryTest(KeywordTest):
    def setUp(self):
        super().setUp()
        warnings.filterwarnings("ignore", category=DeprecationWarning)  # of the packages themselves

    def test_shapely(self):
        from shapely import geometry, wkt

        ring = geometry.Point(5, 5).buffer(3).difference(geometry.Point(5, 5).buffer(1))
        corner = geometry.box(8.2, 8.2, 9, 9)
        for given in (ring, geometry.MultiPolygon([ring, corner]), [ring, corner], geometry.GeometryCollection([ring])):
            wanted = sum(one.area for one in given) if isinstance(given, list) else given.area
            made = delaunay(POINTS, constraints=given)
            self.assertAlmostEqual(area(made), wanted, places=6)
            values = made.interpolate(POINTS.sum(axis=1), [[5, 7.5], [5, 5]])
            np.testing.assert_allclose(values, [12.5, np.nan])
        made = delaunay(POINTS, constraints=wkt.loads("LINESTRING Z (1 1 5, 9 9 6)"))
        self.assertEqual(made.points[-2:].tolist(), [[1, 1, 5], [9, 9, 6]])
        made = delaunay(POINTS, constraints=geometry.LinearRing(corner.exterior.coords))
        self.assertAlmostEqual(area(made), corner.area, places=6)
        whole = delaunay(POINTS).triangles
        for empty in (geometry.Polygon(), geometry.MultiPolygon(), geometry.Point(), geometry.GeometryCollection()):
            np.testing.assert_array_equal(delaunay(POINTS, constraints=empty).triangles, whole)

    def test_a_union_is_kept_whole(self):
        """As the documentation advises for polygons that overlap."""
        from shapely import geometry, ops

        parts = [geometry.box(1, 1, 5, 5), geometry.box(3, 3, 8, 8)]
        self.assertAlmostEqual(area(delaunay(POINTS, constraints=ops.unary_union(parts))), 16 + 25 - 4, places=6)

    def test_geopandas(self):
        import geopandas
        from shapely import geometry

        shapes = [geometry.box(1, 1, 4, 4), geometry.box(4, 1, 6, 3), geometry.Polygon(), None]
        table = geopandas.GeoDataFrame({"name": list("abcd")}, geometry=shapes)
        for given in (table, table.geometry, table.geometry.values, table.geometry.tolist()):
            self.assertAlmostEqual(area(delaunay(POINTS, constraints=given)), 9 + 4, places=6)


if __name__ == "__main__":
    missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if missing:
        print("skipped: there is no %s here" % " and no ".join(missing))
        sys.exit(77)
    unittest.main()
