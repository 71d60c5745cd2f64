# SPDX-License-Identifier: BSD-3-Clause
"""Tiles give the bytes of one piece: triangles, rasters of every method, whatever the leaves, the threads, the memory
and, for rasters, the order of the files."""

import importlib
import json
import os
import threading
import time
import unittest
import unittest.mock
import warnings

import numpy as np
from adaptivehilbertdelaunay import Raster, _exchange
from tilesupport import (
    TilesTest, bytes_of, hash_of, kinds, needs_raster, one_piece, pieces_of, raster_of, read_piece, tiles,
    triangles_of,
)  # fmt: skip

from adaptivehilbertdelaunay._interface import Cancelled
from adaptivehilbertdelaunay.tiles import _leaves, _visits, _work

COUNT, MANY = 1500, 10**5


class TriangleTest(TilesTest):
    def test_are_those_of_one_piece(self):
        for name, points in kinds(COUNT):
            path = self.saved(points)
            for leaf, threads in ((10**6, 1), (300, 1), (300, 2), (16 if name == "uniform" else 100, 2)):
                with self.subTest(points=name, leaf=leaf, threads=threads):
                    tiles.make([path], tin=self.at("tin.pvtp"), leaf=leaf, threads=threads, overwrite=True)
                    self.assert_is_one_piece(points, self.at("tin.pvtp"))

    def test_pieces_are_one_surface(self):
        """Merged by global ids all edges have two triangles, but for the hull's; places and data go with the ids."""
        points = next(points for name, points in kinds(COUNT) if name == "rounded")
        tiles.make([self.saved(points)], tin=self.at("tin.pvtp"), leaf=100, piece=200)
        self.assertGreater(len(pieces_of(self.at("tin.pvtp"))), 5)
        for piece in pieces_of(self.at("tin.pvtp")):
            places, data, _ = read_piece(piece)
            np.testing.assert_array_equal(places, points[data["GlobalPointIds"]])
            np.testing.assert_array_equal(data["z"], places[:, 2])
            self.assertEqual(len(set(data["GlobalPointIds"].tolist())), len(places))
        triangles = triangles_of(self.at("tin.pvtp"))
        edges = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
        _, counts = np.unique(edges, axis=0, return_counts=True)
        self.assertEqual(int((counts == 1).sum()), len(one_piece(points).hull))
        self.assertLessEqual(counts.max(), 2)
        self.assert_is_one_piece(points, self.at("tin.pvtp"))

    def test_files_in_another_order(self):
        """The same triangles; ids are those of the files as they come."""
        points = next(points for name, points in kinds(COUNT) if name == "uniform")
        halves = points[:700], points[700:]
        found = []
        for order in ((0, 1), (1, 0)):
            files = [self.saved(halves[k], "%d.npy" % k) for k in order]
            tiles.make(files, tin=self.at("tin.pvtp"), leaf=100, overwrite=True)
            given = np.concatenate([halves[k] for k in order])
            found.append(given[triangles_of(self.at("tin.pvtp"))])
        np.testing.assert_array_equal(*found)

    def test_ids_count_points_that_are_left_out(self):
        points = next(points for name, points in kinds(COUNT) if name == "uniform")
        points[::7, 0], points[3::70, 2] = np.nan, np.inf
        made = tiles.make([self.saved(points)], tin=self.at("tin.pvtp"), leaf=100)
        isBad = ~np.isfinite(points).all(axis=1)
        self.assertEqual((made.plan.points, made.plan.not_finite), (int((~isBad).sum()), int(isBad.sum())))
        points[isBad] = np.nan
        self.assert_is_one_piece(points, self.at("tin.pvtp"))


@needs_raster
class RasterTest(TilesTest):
    def setUp(self):
        super().setUp()
        self.points = next(points for name, points in kinds(COUNT) if name == "uniform")
        self.points[50:90, :2] = self.points[:40, :2]  # the lowest counts
        self.path = self.saved(self.points)

    def one_piece(self, raster, method="linear", points=None, **settings):
        points = self.points if points is None else points
        made = one_piece(points, **settings)
        cells = raster if isinstance(raster, Raster) else made.raster(raster)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of points nearly on a line, where no cell is
            return made.interpolate(points[:, 2], cells, method)[::-1]

    def test_no_byte_differs(self):
        for method in ("linear", "natural", "laplace", "nearest"):
            for longest in (0.0, 4.0) if method != "nearest" else (0.0,):
                want = self.one_piece(1.3, method, maximum_edge_length=longest)
                for leaf, threads in ((10**6, 1), (150, 2)):
                    with self.subTest(method=method, longest=longest, leaf=leaf):
                        tiles.make([self.path], raster=tiles.GeoTiff(self.at("a.tif"), 1.3, method, dtype="float64"),
                                   leaf=leaf, threads=threads, longest_edge=longest, overwrite=True)  # fmt: skip
                        values, _ = raster_of(self.at("a.tif"))
                        self.assertEqual(hash_of(values), hash_of(want))

    def test_of_all_kinds_of_points(self):
        for name, points in kinds(COUNT):
            with self.subTest(points=name):
                cell = float(points[:, :2].ptp(axis=0).max() if hasattr(points, "ptp") else
                             np.ptp(points[:, :2], axis=0).max()) / 50  # fmt: skip
                path = self.saved(points, "kind.npy")
                tiles.make([path], raster=tiles.GeoTiff(self.at("a.tif"), cell), leaf=100, overwrite=True)
                want = self.one_piece(cell, points=points).astype(np.float32)
                self.assertEqual(hash_of(raster_of(self.at("a.tif"))[0]), hash_of(want))

    def test_the_same_file_whatever_leaves_threads_memory_and_order(self):
        halves = [self.saved(self.points[:700], "a.npy"), self.saved(self.points[700:], "b.npy")]
        found = set()
        for files, leaf, threads, memory in (
            ([self.path], 10**6, 1, None), ([self.path], 100, 2, "2 GB"), (halves, 333, 2, None),
            (halves[::-1], 64, 1, "1.5e9")):  # fmt: skip
            tiles.make(files, raster=tiles.GeoTiff(self.at("a.tif"), 0.1), leaf=leaf, threads=threads, memory=memory,
                       overwrite=True)  # fmt: skip
            found.add(bytes_of(self.at("a.tif")))
        self.assertEqual(len(found), 1)

    def test_place_values_and_kind_of_the_file(self):
        given = tiles.GeoTiff(self.at("a.tif"), (2, 3), bounds=(-11, 120, -5, 50), align=True, nodata=-9999,
                              crs="EPSG:25832")  # fmt: skip
        tiles.make([self.path], raster=given, leaf=200)
        values, place = raster_of(self.at("a.tif"))
        cells = Raster((-11, -4.5), (2, 3), (19, 66))  # centres of cells at multiples of 2 and 3
        want = self.one_piece(cells)
        self.assertEqual(place, (-12, 2, 0, 51, 0, -3))
        np.testing.assert_array_equal(values, np.where(np.isnan(want), -9999, want).astype(np.float32))
        with open(self.at("a.tif"), "rb") as file:
            self.assertEqual(file.read(4), b"II+\0")  # BigTIFF

    def test_by_either_package(self):
        """rasterio and GDAL write the same values, to the same place."""
        found = []
        for name in ("rasterio", "osgeo.gdal"):
            try:
                package = importlib.import_module(name)
            except ImportError:
                continue
            with unittest.mock.patch.object(_exchange, "writer", return_value=package):
                raster = tiles.GeoTiff(self.at("a.tif"), 0.7, nodata=-1, crs="EPSG:25832")
                tiles.make([self.path], raster=raster, leaf=200, overwrite=True)
            values, place = raster_of(self.at("a.tif"))
            found.append((hash_of(values), place))
        self.assertEqual(len(set(found)), 1)

    def test_beside_a_tin(self):
        tiles.make([self.path], raster=tiles.GeoTiff(self.at("a.tif"), 1.0), tin=self.at("a.pvtp"), leaf=100)
        self.assertEqual(hash_of(raster_of(self.at("a.tif"))[0]), hash_of(self.one_piece(1.0).astype(np.float32)))
        self.assert_is_one_piece(self.points, self.at("a.pvtp"))


class LinesTest(TilesTest):
    """Breaklines, some of which cross, and loops."""

    def setUp(self):
        super().setUp()
        self.points = next(points for name, points in kinds(COUNT) if name == "uniform")
        rng = np.random.default_rng(3)
        self.chains = [np.column_stack((np.cumsum(rng.random((k, 2)) * 20 - 6, axis=0) + (20, 10), rng.random(k)))
                       for k in (2, 9, 30, 5)]  # fmt: skip
        around = np.array([(2, 3, 1), (97, 5, 2), (90, 57, 3), (50, 40, 4), (5, 55, 5)], float)
        hole = np.array([(60, 10, 9), (75, 12, 9), (68, 30, 9)], float)
        self.rings = [around, hole]

    def written(self, name, kind, coordinates):
        with open(self.at(name), "w", encoding="utf-8") as file:
            json.dump({"type": kind, "coordinates": coordinates}, file)
        return self.at(name)

    def files(self):
        """Arguments of make() for lines and loops."""
        lines = self.written("lines.json", "MultiLineString", [chain.tolist() for chain in self.chains])
        closed = [np.concatenate((ring, ring[:1])).tolist() for ring in self.rings]
        return {"lines": [lines], "loops": [self.written("loops.json", "Polygon", closed)]}

    def whole(self, **given):
        """Of one piece: points, corners, ids of the chains."""
        parts = [*(self.chains if "lines" in given else ()), *(self.rings if "loops" in given else ())]
        ends = len(self.points) + np.cumsum([0, *map(len, parts)])
        ids = [np.arange(begin, end) for begin, end in zip(ends, ends[1:])]
        count = len(self.chains) if "lines" in given else 0
        return np.concatenate((self.points, *parts)), {"lines": ids[:count], "loops": ids[count:]}

    def test_triangles(self):
        given = self.files()
        for chosen in (given, {"lines": given["lines"]}, {"loops": given["loops"]}):
            points, chains = self.whole(**chosen)
            whole = one_piece(points, **chains)
            want = whole.triangles.astype(np.int64)
            for leaf, threads in ((10**6, 1), (300, 2), (60, 1)):
                with self.subTest(chains=sorted(chosen), leaf=leaf):
                    made = tiles.make([self.saved(self.points)], tin=self.at("a.pvtp"), leaf=leaf, threads=threads,
                                      overwrite=True, **chosen)  # fmt: skip
                    self.assertEqual(hash_of(triangles_of(self.at("a.pvtp"))), hash_of(want))
                    self.assertEqual(made.segments_crossing, whole.counts["segments_crossing"])

    def test_segments_that_cross_are_counted(self):
        rng = np.random.default_rng(4)
        self.chains = [np.column_stack((rng.random((k, 2)) * (100, 60), rng.random(k))) for k in (2,) * 20 + (9, 9)]
        points, chains = self.whole(lines=1)
        count = one_piece(points, **chains).counts["segments_crossing"]
        self.assertGreater(count, 10)
        lines = self.files()["lines"]
        for leaf in (10**6, 100):
            code, said = self.command(self.saved(self.points), "--tin", self.at("a.pvtp"), "--lines", *lines, "--leaf",
                                      leaf, "--overwrite")  # fmt: skip
            self.assertEqual(code, 0)
            self.assertIn("left out: %d segments of lines and loops that cross earlier ones\n" % count, said)

    @needs_raster
    def test_rasters(self):
        points, chains = self.whole(lines=1, loops=1)
        made = one_piece(points, **chains)
        limited = one_piece(points, maximum_edge_length=4.0, **chains)
        for method, longest in (("linear", 0.0), ("natural", 0.0), ("laplace", 0.0), ("natural", 4.0), ("linear", 4.0)):
            whole = limited if longest else made
            want = whole.interpolate(points[:, 2], made.raster(0.9), method)[::-1]
            for leaf in (10**6, 200):
                with self.subTest(method=method, leaf=leaf, longest=longest):
                    raster = tiles.GeoTiff(self.at("a.tif"), 0.9, method, dtype="float64")
                    tiles.make([self.saved(self.points)], raster=raster, tin=self.at("a.pvtp"), leaf=leaf,
                               longest_edge=longest, overwrite=True, **self.files())  # fmt: skip
                    self.assertEqual(hash_of(raster_of(self.at("a.tif"))[0]), hash_of(want))
                    want_triangles = hash_of(whole.triangles.astype(np.int64))
                    self.assertEqual(hash_of(triangles_of(self.at("a.pvtp"))), want_triangles)

    @needs_raster
    def test_a_loop_that_most_leaves_are_outside_of(self):
        self.rings = [np.array([(70, 30, 1), (90, 32, 2), (80, 50, 3)], float)]
        points, chains = self.whole(loops=1)
        made = one_piece(points, **chains)
        want = made.interpolate(points[:, 2], Raster((0.5, 0.5), (1, 1), (60, 100)))[::-1].astype(np.float32)
        raster = tiles.GeoTiff(self.at("a.tif"), 1, bounds=(0, 100, 0, 60))
        tiles.make([self.saved(self.points)], raster=raster, leaf=60, loops=self.files()["loops"])
        self.assertEqual(hash_of(raster_of(self.at("a.tif"))[0]), hash_of(want))

    def test_a_power_cut_that_takes_one_of_two_files(self):
        points, chains = self.whole(lines=1, loops=1)
        words = {"tin": self.at("a.pvtp"), "leaf": 100, "threads": 1, **self.files()}
        with unittest.mock.patch.object(_visits.Visits, "_ended", side_effect=KeyboardInterrupt):
            with self.assertRaises(KeyboardInterrupt):
                tiles.make([self.saved(self.points)], **words)
        os.remove(self.at("a.pvtp.work", "own", "0"))
        tiles.make([self.at("points.npy")], resume=True, **words)
        want = one_piece(points, **chains).triangles.astype(np.int64)
        self.assertEqual(hash_of(triangles_of(self.at("a.pvtp"))), hash_of(want))

    def test_refused(self):
        flat = self.written("flat.json", "LineString", [(1, 2), (3, 4)])
        open_ = self.written("open.json", "LineString", [(1, 2, 3), (3, 4, 5), (9, 9, 9)])
        path = self.saved(self.points)
        for chosen, said in (({"lines": [flat]}, "without z"), ({"loops": [open_]}, "not closed"),
                             ({"lines": [self.at("no.json")]}, "cannot be read")):  # fmt: skip
            with self.assertRaisesRegex(tiles.BadFile, said):
                tiles.make([path], tin=self.at("a.pvtp"), **chosen)
        with self.assertRaisesRegex(tiles.BadOptions, "nearest takes neither"):
            tiles.make([path], raster=tiles.GeoTiff(self.at("a.tif"), 1, "nearest"), **self.files())


class ThreadsTest(unittest.TestCase):
    POINTS = next(points for name, points in kinds(COUNT) if name == "uniform")

    def workers(self, count):
        leaves = _leaves.Leaves()
        leaves.begin(None)
        again = True
        while again:
            leaves.count_points(self.POINTS)
            again = leaves.end_pass(100, None)
        return _work.Workers(count, leaves.plan().saved, {})

    def test_what_is_made_is_in_order(self):
        def slowly(leaves, item):
            time.sleep(0.02 * (item % 3 == 0))
            return item, leaves.leaf_of(self.POINTS[item : item + 1])[0], threading.get_ident()

        want = [one[:2] for one in self.workers(1).in_order(range(50), slowly)]
        for count in (2, 3, 9):
            made = list(self.workers(count).in_order(iter(range(50)), slowly))
            self.assertEqual([one[:2] for one in made], want)
            self.assertTrue(1 < len({one[2] for one in made}) <= min(count, _work.IN_ORDER))

    def test_few_are_begun_before_they_are_asked_for(self):
        begun, made = [], self.workers(2).in_order(iter(range(50)), lambda leaves, item: begun.append(item))
        next(made)
        self.assertTrue(1 <= len(begun) <= 3)
        made.close()
        self.assertTrue(len(begun) <= 3)

    def test_what_is_raised_ends_all(self):
        def fail(leaves, item):
            if item == 7:
                raise LookupError(item)
            return item

        for count in (1, 2):
            made, found = self.workers(count).in_order(iter(range(50)), fail), []
            with self.assertRaisesRegex(LookupError, "7"):
                for one in made:
                    found.append(one)
            self.assertEqual(found, list(range(7)))

    def test_what_is_raised_ends_what_others_do(self):
        """In the middle of it."""
        bounds = np.array([(0.0, 100.0), (0.0, 60.0)])

        def work(leaves, item):
            if item == 0:
                begun.wait()
                raise LookupError(item)
            begun.set()
            try:
                for _ in range(MANY):
                    leaves.triangulate(self.POINTS, bounds)
            except Cancelled:
                ended.append(item)

        for way in (lambda workers: workers.run(range(2), work, lambda task: ()),
                    lambda workers: list(workers.in_order(range(2), work))):  # fmt: skip
            begun, ended = threading.Event(), []
            with self.assertRaisesRegex(LookupError, "0"):
                way(self.workers(2))
            self.assertEqual(ended, [1])

    def test_ctrl_c_while_a_thread_begins(self):
        """It ends; the program would wait for it for ever."""
        begun = []

        class Interrupted(threading.Thread):
            def start(self):
                self.daemon = True
                super().start()
                begun.append(self)
                raise KeyboardInterrupt

        with unittest.mock.patch.object(_work.threading, "Thread", Interrupted):
            with self.assertRaises(KeyboardInterrupt):
                next(_work.ahead(range(50)))
        self.assertFalse(begun[0].is_alive())


class OptionsTest(TilesTest):
    def assert_refused(self, said, raster=None, **words):
        """Before a file is read: there is none."""
        raster = raster and tiles.GeoTiff(self.at("a.tif"), 1.0, **raster)
        with self.assertRaisesRegex(tiles.BadOptions, said):
            tiles.make([self.at("none.npy")], tin=self.at("a.pvtp"), raster=raster, **words)
        self.assertEqual(os.listdir(self.at("")), [])

    def test_those_that_are_none(self):
        self.assert_refused("method must be one of linear, .*, not 'cubic'", raster={"method": "cubic"})
        self.assert_refused("dtype must be float32 or float64, not 'int32'", raster={"dtype": "int32"})
        self.assert_refused("duplicates must be one of lowest, highest, first, not 'mean_z'", duplicates="mean_z")
        for words in ({"leaf": 0}, {"leaf": (1 << 26) + 1}, {"piece": 0}, {"piece": (1 << 28) + 1}):
            self.assert_refused("leaf must be from 1 to 67108864, and piece to 268435456", **words)

    def test_a_raster_that_nothing_can_write(self):
        with unittest.mock.patch.object(_exchange, "writer", lambda: None):
            self.assert_refused("needs rasterio or GDAL, and Python finds neither", raster={"method": "linear"})


if __name__ == "__main__":
    unittest.main()
