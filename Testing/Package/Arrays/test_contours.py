# SPDX-License-Identifier: BSD-3-Clause
"""Triangulation.contours() by its definition, in fractions; alpha_shape() is what delaunay(alpha=...) leaves; Voronoi
cells as GeoJSON."""

import json
import tracemalloc
import unittest
import unittest.mock
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
from adaptivehilbertdelaunay import _contours, delaunay
from arraysupport import KeywordTest, cloud, in_a_process, lattice, orient

LEVELS = [0, 0.25, 0.5, 1, 1.5, 2]  # crossings of edges from 0 to 1, 1 to 2, 0 to 2 are no rounded numbers
INFINITE = [-np.inf, *LEVELS, np.inf]


def twice_area(ring):
    places = [[Fraction(number) for number in place[:2]] for place in ring]
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(places, [*places[1:], *places[:1]]))


def clipped(polygon, level, sign):
    """The part of a polygon of (x, y, value) where the value is above the level, or below it with the sign -1."""
    made = []
    for p, q in zip(polygon, [*polygon[1:], *polygon[:1]]):
        here, there = sign * (p[2] - level), sign * (q[2] - level)
        if here >= 0:
            made.append(p)
        if here * there < 0:
            made.append(tuple(a + (b - a) * here / (here - there) for a, b in zip(p, q)))
    return made


def areas_by_definition(made, values, levels, isClosed=True):
    """Twice the area of each band, triangle by triangle."""
    areas = [Fraction(0)] * (len(levels) - 1)
    for triangle in made.triangles.tolist():
        corners = [(*map(Fraction, made.points[i, :2].tolist()), values[i]) for i in triangle]
        if not np.isfinite([corner[2] for corner in corners]).all():
            continue
        corners = [(x, y, Fraction(value)) for x, y, value in corners]
        heights = [corner[2] for corner in corners]
        for k, (low, high) in enumerate(zip(levels, levels[1:])):
            if len(set(heights)) == 1:
                isIn = low < heights[0] <= high or (isClosed and k == 0 and heights[0] == low)
                areas[k] += twice_area(corners) if isIn else 0
                continue
            part = corners if low == -np.inf else clipped(corners, Fraction(low), 1)
            part = part if high == np.inf else clipped(part, Fraction(high), -1)
            areas[k] += twice_area(part)
    return areas


def edges_of(outline):
    """Pairs of nodes."""
    edges = Counter()
    for begin, end in zip(outline.rings, outline.rings[1:]):
        ring = outline.corners[begin:end].tolist()
        edges.update(zip(ring, ring[1:] + ring[:1]))
    return edges


def edges_of_lines(lines):
    edges = Counter()
    for begin, end in zip(lines.offsets, lines.offsets[1:]):
        line = lines.corners[begin:end].tolist()
        edges.update(zip(line, line[1:]))
    return edges


def cases():
    """Surfaces on lattices and on points in general position: with plains, with holes, with points without a value."""
    for seed in range(12):
        random = np.random.default_rng(seed)
        points = lattice(9) if seed % 2 else np.round(cloud(seed, 120) * 30)
        loops = [[0, 8, 80, 72], [20, 24, 60, 56]] if seed == 3 else []
        made = delaunay(points, loops=loops)
        values = random.integers(0, 3, len(points)).astype(float)
        if seed % 3 == 0:
            values = np.floor(points.sum(axis=1) / points.sum(axis=1).max() * 2.9)
        if seed > 6:
            values[random.integers(0, len(points), 6)] = np.nan
        yield made, values


class ContoursTest(KeywordTest):
    def expect_rings(self, outline):
        """Simple ones, the outer one of each polygon first."""
        for i in range(len(outline)):
            for r in range(outline.polygons[i], outline.polygons[i + 1]):
                ring = outline.corners[outline.rings[r]:outline.rings[r + 1]]
                self.assertEqual(len(set(ring.tolist())), len(ring))
                self.assertEqual(twice_area(outline.points[ring].tolist()) > 0, r == outline.polygons[i])

    def test_areas(self):
        for made, values in cases():
            for levels in (LEVELS, INFINITE, [0.25, 1, 7], [1, 1.5], [-3, -1], [5, np.inf]):
                bands = made.contours(values, levels, filled=True)
                self.assertEqual(len(bands), len(levels) - 1)
                areas = [sum(twice_area(ring.tolist()) for polygon in band for ring in polygon) for band in bands]
                self.assertEqual(areas, areas_by_definition(made, values, levels))
                for band in bands:
                    self.expect_rings(band)

    def test_bands_cover_the_surface(self):
        """Each edge of a ring is that of another band, the other way, or of the border of the surface."""
        for made, values in cases():
            bands = made.contours(values, INFINITE, filled=True)
            edges = sum((edges_of(band) for band in bands), Counter())
            self.assertEqual(max(edges.values()), 1)
            border = {edge for edge in edges if edge[::-1] not in edges}
            isFinite = np.isfinite(values)[made.triangles].all(axis=1)
            whole = made._outline_of(np.where(isFinite, 0.0, np.nan))
            places = bands[0].points
            self.assertEqual(sum(orient((0, 0), *(places[i] for i in edge)) for edge in border),
                             sum(twice_area(ring.tolist()) for polygon in whole for ring in polygon))  # fmt: skip

    def test_lines_are_the_common_borders_of_bands(self):
        for made, values in cases():
            bands, lines = made.contours(values, INFINITE, filled=True), made.contours(values, LEVELS)
            all_edges = sum((edges_of(band) for band in bands), Counter())
            for k, level in enumerate(LEVELS):
                above = sum((edges_of(band) for band in bands[k + 1 :]), Counter())
                below = sum((edges_of(band) for band in bands[: k + 1]), Counter())
                found = edges_of_lines(lines[k])
                self.assertEqual(found, Counter(set(found)))
                at_the_border = {edge for edge in found if edge[::-1] not in all_edges}
                self.assertEqual(set(found) - at_the_border, {edge for edge in above if edge[::-1] in below})
                for edge in at_the_border:
                    self.assertEqual([values[i] for i in edge], [level, level])
                    self.assertIn(edge, above)
                for line in lines[k]:
                    self.assertGreaterEqual(len(line), 2)

    def test_lines_end_at_the_border(self):
        """Else they are closed: in random noise, which is at no level."""
        made = delaunay(cloud(5, 2000))
        lines = made.contours(cloud(6, 2000, 1)[:, 0], [0.3, 0.5, 0.7])
        border = set(map(tuple, map(sorted, made.boundary.tolist())))
        rim = set(np.ravel(list(border)).tolist())
        ends, closed = 0, 0
        for line in (line for each in lines for line in each):
            if (line[0] == line[-1]).all():
                closed += 1
                self.assertGreater(len(line), 3)
            else:
                ends += 2
                for place in (line[0], line[-1]):
                    distances = [abs(orient(place, *made.points[list(edge)])) for edge in border]
                    self.assertLess(min(distances), 1e-15)
        self.assertGreater(min(ends, closed, len(rim)), 10)

    def test_figures(self):
        """A hill of four triangles with a plain beside it."""
        made = delaunay([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2], [8, 0], [8, 4]])
        values = np.array([0, 0, 0, 0, 2, 0, 0.0])
        line, = made.contours(values, [1])[0]
        self.assertEqual(line.tolist(), [[1, 1], [3, 1], [3, 3], [1, 3], [1, 1]])  # higher on its left
        band, top = made.contours(values, [0, 1, 2], filled=True)
        self.assertEqual([ring.tolist() for ring in band[0]], [
            [[0, 0], [4, 0], [8, 0], [8, 4], [4, 4], [0, 4]], [[1, 1], [1, 3], [3, 3], [3, 1]]])  # fmt: skip
        self.assertEqual([len(polygon) for polygon in top], [1])
        foot, = made.contours(values, [0])[0]
        self.assertEqual(foot.tolist(), [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]])
        bands = made.contours(values, [-1, 0, 1], filled=True)  # the plain is in the band that ends with it
        self.assertEqual([ring.tolist() for ring in bands[0][0]], [[[4, 0], [8, 0], [8, 4], [4, 4]]])
        self.assertEqual(len(made.contours(-values, [0])[0]), 0)
        self.assertEqual([len(each) for each in made.contours(values, [-5, 1, 2, 9])], [0, 1, 0, 0])

    def test_a_saddle_at_a_level(self):
        made = delaunay([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2]])
        values = [1, -1, 1, -1, 0]
        lines, = made.contours(values, [0])
        self.assertEqual(edges_of_lines(lines), Counter(set(edges_of_lines(lines))))
        self.assertEqual(sum(len(line) - 1 for line in lines), 4)
        low, high = made.contours(values, [-1, 0, 1], filled=True)
        self.assertEqual([len(low), len(high)], [2, 2])  # which touch in the middle

    def test_levels_between_which_rounding_leaves_no_width(self):
        """The outer ring is that of topology. Nodes at one place are several."""
        points = np.concatenate((lattice(5), [[1.5, 1.5]])) + 1e6
        values = np.where(np.arange(26) == 25, 1, -1.0)
        low = 0.3
        levels = [low, np.nextafter(low, 1), np.nextafter(low, -1)]
        bands = delaunay(points).contours(values, levels, filled=True)
        for band in bands:
            self.assertEqual([len(polygon) for polygon in band], [2])
            outer, hole = (twice_area((ring - 1e6).tolist()) for ring in band[0])
            self.assertGreater(outer, 0)
            self.assertLess(hole, 0)

    def test_a_level_that_rounding_lays_on_points(self):
        """0.1 * 3 is more than 0.3: crossings of edges lie at the corners of the surface, several at each."""
        square = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1], [0.5, 0.25], [-0.5, -0.25], [0.25, -0.5], [-0.25, 0.5]])
        for turn in range(8):
            points = 100 + square[:, :: (-1) ** turn] * [1 - 2 * (turn // 4), 1 - turn // 2 % 2 * 2]
            bands = delaunay(points).contours([0.3] * 4 + [1] * 4, [0, 0.1 * 3, 1], filled=True)
            self.assertEqual([[len(polygon) for polygon in band] for band in bands], [[2], [1]])
            outer, hole = (twice_area(ring.tolist()) for ring in bands[0][0])
            self.assertEqual((outer, hole), (8, -8))

    def test_any_scale(self):
        square = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
        for scale in (2.0**-1000, 2.0**1023):
            for height in (2.0**-1030, 2.0**1023):
                made = delaunay((2 * square - 1) * scale)
                line, = made.contours((square[:, 0] - 0.5) * 2 * height, [0.5 * height])[0]
                self.assertEqual((line / scale).tolist(), [[0.5, 1], [0.5, -0.5], [0.5, -1]])
                bands = made.contours((square[:, 0] - 0.5) * 2 * height, [-height, 0.5 * height, height], True)
                self.assertEqual([len(band) for band in bands], [1, 1])
        made = delaunay((square + [0, 0.25]) * 1e-310)
        with np.errstate(all="raise"):  # nothing of that is the caller's
            line, = made.contours(square[:, 0], [0.3])[0]
        self.assertEqual(len(line), 3)

    def test_places_lie_between_the_ends(self):
        random = np.random.default_rng(1)
        begin, end = (random.random((1000, 2)) * 2.0 ** random.integers(-60, 60, (1000, 2)) for _ in range(2))
        for fraction in (random.random((1000, 1)), np.ones((1000, 1)), np.full((1000, 1), np.nextafter(1, 0))):
            made = _contours.between(begin, end, fraction)
            self.assertTrue(((made >= np.minimum(begin, end)) & (made <= np.maximum(begin, end))).all())
            error = abs(made - (begin * (1 - fraction) + end * fraction))
            self.assertTrue((error <= 2.0**-51 * np.maximum(begin, end)).all())

    def test_neither_order_nor_type_matters(self):
        points, levels = cloud(1, 300), np.linspace(0, 1, 7)
        values = np.sin(9 * points[:, 0]) * points[:, 1]
        order = np.random.default_rng(1).permutation(300)
        for filled in (False, True):
            shown = delaunay(points).contours(values, levels, filled).__geo_interface__
            again = delaunay(points[order]).contours(values[order], [*levels[::-1], levels[3]], filled)
            self.assertEqual(again.__geo_interface__, shown)
            wide = delaunay(points, id_dtype=np.int64).contours(values, levels, filled)
            self.assertEqual(wide[3].corners.dtype, np.int64)
            self.assertEqual(wide.__geo_interface__, shown)
            with unittest.mock.patch.object(_contours, "BLOCK", 7):
                self.assertEqual(delaunay(points).contours(values, levels, filled).__geo_interface__, shown)

    def test_geo_interface(self):
        made = delaunay([[0, 0], [4, 0], [4, 4], [0, 4]])
        lines = made.contours([0, 4, 4, 0], [1, 9]).__geo_interface__
        self.assertEqual(lines["type"], "FeatureCollection")
        self.assertEqual([one["properties"] for one in lines["features"]], [{"level": 1.0}, {"level": 9.0}])
        self.assertEqual([one["geometry"]["type"] for one in lines["features"]], ["MultiLineString"] * 2)
        self.assertEqual([len(one["geometry"]["coordinates"]) for one in lines["features"]], [1, 0])
        bands = made.contours([0, 4, 4, 0], [-np.inf, 1, 4], filled=True)
        first, second = bands.__geo_interface__["features"]
        self.assertEqual(first["properties"], {"lower": None, "upper": 1.0})
        self.assertIn('{"lower": null, "upper": 1.0}', json.dumps(bands.__geo_interface__, allow_nan=False))
        self.assertEqual(second["geometry"], bands[1].__geo_interface__)
        self.assertEqual(second["geometry"]["type"], "MultiPolygon")
        ring = second["geometry"]["coordinates"][0][0]
        self.assertEqual((ring[0], ring[0] == ring[-1]), ((1.0, 0.0), True))

    def test_in_a_plane_and_with_points_added(self):
        """Of a wall, in space; values for the soundings alone."""
        wall = np.array([(0, 5, 0), (4, 5, 0), (4, 5, 4), (0, 5, 4)], float)
        made = delaunay(wall, plane="best_fit")
        line, = made.contours([0, 4, 4, 0], [1])[0]
        self.assertEqual({tuple(place[:2]) for place in line}, {(1, 5)})
        self.assertEqual(sorted(place[2] for place in line)[::2], [0, 4])
        band, = made.contours([0, 4, 4, 0], [0, 1], filled=True)
        self.assertEqual(band[0][0].shape[1], 3)
        soundings = cloud(2, 300) * 10
        made = delaunay(soundings, constraints=np.array([(1, 1), (9, 1), (9, 9), (1, 9)], float))
        bands = made.contours(soundings[:, 0], [0, 5, 10], filled=True)
        areas = [sum(twice_area(ring.tolist()) for polygon in band for ring in polygon) for band in bands]
        np.testing.assert_allclose(np.array(areas, float), [64, 64])

    def test_refusals(self):
        made = delaunay(cloud(1, 30))
        values = made.points[:, 0]
        for levels, said in ((7, "sequence of numbers"), (0.5, "sequence"), ([[1]], "sequence"), ("ab", "real")):
            with self.assertRaisesRegex(TypeError, said):
                made.contours(values, levels)
        for levels, filled, said in (([1, np.nan], False, "level 1 is NaN"), ([1, 1], True, "two different levels"),
                                     ([], False, "a level"), ([], True, "two different")):  # fmt: skip
            with self.assertRaisesRegex(ValueError, said):
                made.contours(values, levels, filled)
        self.assertRaisesRegex(ValueError, "a row for each of 30", made.contours, values[1:], [1])
        self.assertRaisesRegex(ValueError, "one number for each point", made.contours, made.points, [1])
        points = cloud(4, 500)
        made = delaunay(points)
        points[7] += 1
        self.assertRaisesRegex(RuntimeError, "changed", made.contours, points[:, 0], [0.5])

    def test_nothing(self):
        made = delaunay(cloud(3, 50), alpha=1e-9)
        for filled in (False, True):
            for values in (np.zeros(50), np.full(50, np.nan)):
                self.assertEqual([len(each) for each in made.contours(values, [0, 1], filled)], [0] * (2 - filled))

    def test_memory(self):
        """What NumPy holds is within the estimate; that and the engine's are within the limit, or refused."""
        points = cloud(1, 20000)
        noise = cloud(2, 20000, 1)[:, 0]
        wall = np.stack((points[:, 0], noise / 100, points[:, 1]), axis=1)
        few = delaunay(points, alpha=0.001), delaunay(wall, plane="best_fit", alpha=0.001)
        self.assertLess(max(len(made.triangles) for made in few), 5000)
        small = delaunay(points[:300])  # in one block
        for made, values, levels in (
                (delaunay(points), points[:, 0], [0.2, 0.5]), (delaunay(points), noise, np.linspace(0, 1, 9)),
                (delaunay(points), noise, [3, 4]), (small, np.ones(300), [1, 2]), (few[0], noise, [0.2, 0.5]),
                (few[1], noise, [0.2, 0.5])):  # fmt: skip
            made.contours(values, levels)
            tracemalloc.start()
            made.contours(values, levels)
            most = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            needed = _contours.Cut(made.triangles, values, np.array(levels), 0).bytes
            self.assertLess(most, needed)
            self.assertLess(needed, 3 * most)
            made._request.settings["memory_limit"] = needed - 1
            with self.assertRaisesRegex(MemoryError, "outline of .* may take"):
                made.contours(values, levels)
            made._request.settings["memory_limit"] = needed + 1000  # nothing for the engine
            with self.assertRaisesRegex(MemoryError, "outline of .* may take"):
                made.contours(values, levels)

    def test_in_several_threads(self):
        points = cloud(1, 3000)
        made = delaunay(points)
        wanted = made.contours(points[:, 0], [0.3, 0.6]).__geo_interface__
        with ThreadPoolExecutor(4) as pool:
            for found in pool.map(lambda k: made.contours(points[:, 0], [0.3, 0.6]), range(12)):
                self.assertEqual(found.__geo_interface__, wanted)

    def test_control_c(self):
        done = in_a_process(INTERRUPTED)
        self.assertEqual((done.stdout.split(), done.stderr), (["contours", "alpha_shape", "631"], ""))


INTERRUPTED = """
import signal, threading, numpy as np
from adaptivehilbertdelaunay import _library as library, delaunay

side = np.arange(316.0)
points = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
made = delaunay(points)

def interrupt():
    while not library._at_work:
        pass
    signal.raise_signal(signal.SIGINT)

for name, arguments in (("contours", (points[:, 0] % 7, [2, 4])), ("alpha_shape", (1,))):
    while True:
        if threading.active_count() == 1:
            threading.Thread(target=interrupt, daemon=True).start()
        try:
            getattr(made, name)(*arguments)
        except KeyboardInterrupt:
            print(name)
            break
print(len(made.contours(points[:, 0], [4.5])[0][0]))
"""


class AlphaShapeTest(KeywordTest):
    def expect_the_same(self, made, radius, wanted):
        shape, outline = made.alpha_shape(radius), wanted.outline()
        for name in ("points", "corners", "rings", "polygons"):
            np.testing.assert_array_equal(getattr(shape, name), getattr(outline, name))
        return len(shape.corners)

    def test_as_the_setting_leaves_them(self):
        hills = cloud(7, 400, 3) * [10, 10, 2]
        lattices = np.concatenate((lattice(12), lattice(7) + 20.5))  # many radii are at the limit
        twice = np.concatenate((hills, hills[:50] + [0, 0, 1]))
        corners = 0
        for points, settings in ((hills, {}), (hills[:, :2], {"id_dtype": np.int64}), (hills.astype(np.float32), {}),
                                 (hills, {"plane": "best_fit", "rim": "convex_hull"}), (lattices, {}),
                                 (twice, {"duplicates": "mean_z"}),
                                 (hills, {"loops": [[0, 1, 2], [3, 4, 5]], "crossings": "split"})):  # fmt: skip
            made = delaunay(points, **settings)
            for radius in (0.4, np.sqrt(0.5), 1.1, 2, np.inf):
                most = radius if radius < np.inf else 1e300
                corners += self.expect_the_same(made, radius, delaunay(points, alpha=most, **settings))
        self.assertGreater(corners, 1000)

    def test_of_what_is_left(self):
        points = cloud(8, 300)
        made = delaunay(points, maximum_edge_length=0.1)
        self.expect_the_same(made, 0.05, delaunay(points, maximum_edge_length=0.1, alpha=0.05))
        made = delaunay(points, alpha=0.05)
        self.expect_the_same(made, 0.08, made)
        self.assertEqual(len(made.alpha_shape(1e-9)), 0)

    def test_refusals(self):
        points = cloud(9, 30)
        made = delaunay(points, memory_limit=10**7)
        for radius in (0, -1, np.nan):
            self.assertRaisesRegex(ValueError, "radius must be greater than 0", made.alpha_shape, radius)
        for radius in ("1", None, [1, 2]):
            self.assertRaises(TypeError, made.alpha_shape, radius)
        made._request.settings["memory_limit"] = 1000
        self.assertRaisesRegex(MemoryError, "outline of", made.alpha_shape, 1)
        made._request.settings["memory_limit"] = 10**7
        points[3] += 1
        self.assertRaisesRegex(RuntimeError, "changed", made.alpha_shape, 1)


class VoronoiTest(KeywordTest):
    def test_geo_interface(self):
        made = delaunay(np.round(cloud(3, 60) * 40))
        for clip in ("hull", "bounds", [[10, 10], [30, 10], [30, 20]]):
            diagram = made.voronoi(clip)
            geo = diagram.__geo_interface__
            self.assertEqual(geo["type"], "FeatureCollection")
            there = [i for i in range(len(diagram)) if len(diagram[i])]
            self.assertEqual([one["properties"] for one in geo["features"]],
                             [{"site": int(diagram.sites[i])} for i in there])  # fmt: skip
            for i, feature in zip(there, geo["features"]):
                (ring,) = feature["geometry"]["coordinates"]
                self.assertEqual(feature["geometry"]["type"], "Polygon")
                self.assertEqual([list(place) for place in ring], [*diagram[i].tolist(), diagram[i][0].tolist()])
                self.assertGreater(twice_area(ring[:-1]), 0)
        self.assertLess(len(there), len(diagram))


if __name__ == "__main__":
    unittest.main()
