# SPDX-License-Identifier: BSD-3-Clause
"""What a run of tiles keeps on the disk: no point whose leaf is done with, no field that no file has; pieces of a TIN
are the same whoever compresses them; plans say what was measured."""

import contextlib
import errno
import os
import shutil
import unittest
import unittest.mock

import numpy as np
from test_tiles_runs import killed_at
from tilesupport import TilesTest, bytes_of, kinds, needs_raster, pieces_of, read_piece, tiles

from adaptivehilbertdelaunay.tiles import _finish, _needs, _plan, _points, _pvtp, _read, _run, _store

POINTS = next(points for name, points in kinds(600) if name == "uniform")


class RemovalTest(TilesTest):
    """Files of leaves are removed one by one, not with a million points."""

    def setUp(self):
        super().setUp()
        self.path = self.saved(POINTS)
        patch = unittest.mock.patch.object(_finish, "BATCH", 1)
        patch.start()
        self.addCleanup(patch.stop)

    def words(self, *more):
        return [self.path, "--tin", self.at("a.pvtp"), "--leaf", "60", "--piece", "100", *more]

    def leaves(self):
        """How many have their file."""
        return len(os.listdir(self.at("a.pvtp.work", "leaf")))

    def test_at_no_time_all_is_there(self):
        told = []
        tiles.make([self.path], tin=self.at("a.pvtp"), leaf=60, piece=100, threads=1,
                   progress=lambda step, *_: told.append(self.leaves()) if step == "finish" else None)  # fmt: skip
        self.assertEqual(told, sorted(told, reverse=True))
        self.assertGreater(len(set(told)), 4)
        self.assertLess(told[-1], 0.6 * told[0])
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))

    def killed(self, words, out, step):
        """Of runs that are killed at each such commit or removal, just after or before: the same bytes. `step`: more
        than a run has that gets nowhere, as the removal of its lock."""
        self.assertEqual(self.command(*words)[0], 0)
        want = [bytes_of(path) for path in out]
        for at, isBefore in ((step, False), (step + 3, True)):
            shutil.rmtree(self.at("a"))
            for path in out:
                os.remove(path)
            more, kills = [], 0
            while killed_at(at, [*words, *more], isBefore, calls=("replace", "remove")):
                more, kills = ["--resume"], kills + 1
                self.assertLess(kills, 400)
            self.assertGreater(kills, 5)
            self.assertEqual([bytes_of(path) for path in out], want)
            self.assertFalse(os.path.exists(self.at("a.pvtp.work")))

    @unittest.skipUnless(hasattr(os, "fork"), "no fork()")
    def test_killed_at_every_commit_and_removal(self):
        self.killed(self.words("--threads", "2"), [self.at("a.pvtp")], 2)

    @needs_raster
    @unittest.skipUnless(hasattr(os, "fork"), "no fork()")
    def test_killed_with_a_raster_beside(self):
        words = self.words("--raster", self.at("a.tif"), "--cell", "2")
        self.killed(words, [self.at("a.pvtp"), self.at("a.tif")], 4)  # which all write the raster

    def test_pieces_that_somebody_removed(self):
        """All points are read once more."""
        with unittest.mock.patch.object(_run.Run, "_write", side_effect=KeyboardInterrupt):
            self.assertEqual(self.command(*self.words())[0], 130)
        self.assertEqual(self.leaves(), 0)
        for name in os.listdir(self.at("a.part")):
            os.remove(self.at("a.part", name))
        with unittest.mock.patch.object(_points, "COMMIT", 100), unittest.mock.patch.object(_read, "ROWS", 100):
            with unittest.mock.patch.object(_points, "_commit", side_effect=[None, KeyboardInterrupt]):
                self.assertEqual(self.command(*self.words("--resume"))[0], 130)
            self.assertEqual(self.command(*self.words("--resume"))[0], 0)
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))

    def test_some_pieces_that_somebody_removed(self):
        """Of a run that is at its end: before the folder has its name, and after."""
        for method, name in (("_write", "a.part"), ("_write_tin", "a.part"), (None, "a")):
            patch = unittest.mock.patch.object(_pvtp, "write_list", side_effect=KeyboardInterrupt) if not method else \
                unittest.mock.patch.object(_run.Run, method, side_effect=KeyboardInterrupt)  # fmt: skip
            with patch:
                self.assertEqual(self.command(*self.words("--overwrite"))[0], 130)
            pieces = sorted(one for one in os.listdir(self.at(name)) if one.endswith(".vtp"))
            for one in pieces[1:3]:
                os.remove(self.at(name, one))
            self.assertEqual(self.command(*self.words("--resume"))[0], 0)
            self.assert_is_one_piece(POINTS, self.at("a.pvtp"))
            self.assertEqual(sorted(os.listdir(self.folder)), ["a", "a.pvtp", "points.npy"])

    def test_all_is_on_the_disk_before_it_is_said(self):
        """That only the list is missing: a power cut may take back what no folder was synced for."""
        line, said = {"type": "LineString", "coordinates": [(5, 5, 1), (90, 50, 2)]}, []
        sync, replace = _finish.sync, os.replace

        def told(call):
            return lambda *given: (said.append(os.path.basename(str(given[-1]))), call(*given))

        for lines in ([], [line]):
            with unittest.mock.patch.object(_finish, "BATCH", 1 << 20), \
                    unittest.mock.patch.object(_finish, "sync", told(sync)), \
                    unittest.mock.patch.object(_store.os, "replace", told(replace)):  # fmt: skip
                tiles.make([self.path], tin=self.at("a.pvtp"), leaf=60, piece=100, lines=lines, overwrite=True)
            last = max(k for k, name in enumerate(said) if name.endswith(".vtp"))
            self.assertIn("a.part", said[last : said.index("finished.json", last)])

    def test_what_is_done_is_on_the_disk_first(self):
        """A power cut may take a piece back that was renamed, not one whose folder was synced."""
        said = []
        sync, remove, replace = _finish.sync, _needs.remove_records, os.replace

        def told(what, call):
            return lambda *given: (said.append((what, os.path.basename(str(given[-1])))), call(*given))

        with unittest.mock.patch.object(_finish, "sync", told("sync", sync)), \
                unittest.mock.patch.object(_needs, "remove_records", told("remove", remove)), \
                unittest.mock.patch.object(_store.os, "replace", told("replace", replace)):  # fmt: skip
            self.assertEqual(self.command(*self.words())[0], 0)
        removals = [k for k, (what, _) in enumerate(said) if what == "remove"]
        self.assertGreater(len(removals), 15)
        for k in removals:
            pieces = [j for j in range(k) if said[j][0] == "replace" and said[j][1].endswith(".vtp")]
            syncs = [j for j in range(k) if said[j] == ("sync", "a.part")]
            self.assertGreater(syncs[-1], pieces[-1])

    @needs_raster
    @unittest.skipUnless(os.path.exists("/proc/self/maps"), "no list of mapped files")
    def test_no_file_is_mapped_when_it_is_removed(self):
        """Windows would not remove it."""
        remove, mapped, removed = os.remove, [], []

        def looked(path):
            with open("/proc/self/maps", encoding="utf-8") as file:
                mapped.extend(line for line in file if str(path) in line)
            removed.append(path)
            remove(path)

        raster = tiles.GeoTiff(self.at("a.tif"), 2)
        for words in ({"tin": self.at("a.pvtp")}, {"raster": raster}):
            for threads in (1, 2):
                with unittest.mock.patch.object(os, "remove", looked):
                    tiles.make([self.path], leaf=60, piece=100, threads=threads, overwrite=True, **words)
        self.assertEqual((mapped, len(removed) > 60), ([], True))

    def test_lines_keep_all(self):
        kept = []
        line = {"type": "LineString", "coordinates": [(5, 5, 1), (90, 50, 2)]}
        tiles.make([self.path], tin=self.at("a.pvtp"), leaf=60, piece=100, lines=[line],
                   progress=lambda step, *_: kept.append(self.leaves()) if step == "finish" else None)  # fmt: skip
        self.assertEqual(len(set(kept)), 1)

    def test_a_plan_of_what_is_left(self):
        plans, done = [], []

        def interrupt(group):
            done.append(group)
            if len(done) == 4:
                raise KeyboardInterrupt

        with unittest.mock.patch.object(_needs.Needs, "end", side_effect=interrupt):
            self.assertEqual(self.command(*self.words("--threads", "1"))[0], 130)
        with unittest.mock.patch.object(_run.Run, "_write", side_effect=KeyboardInterrupt):
            with contextlib.suppress(KeyboardInterrupt):
                tiles.make([self.path], tin=self.at("a.pvtp"), leaf=60, piece=100, resume=True, show=plans.append)
        made = tiles.make([self.path], tin=self.at("a.pvtp"), leaf=60, piece=100, resume=True, show=plans.append)
        self.assertEqual(plans[0].disk - plans[1].disk, 32 * len(POINTS))
        self.assertEqual(plans[1], made.plan)

    def test_a_plan_of_points_that_come_anew(self):
        """As those of leaves whose pieces somebody removed."""
        plans = []
        with unittest.mock.patch.object(_run.Run, "_write", side_effect=KeyboardInterrupt):
            for _ in range(2):
                with contextlib.suppress(KeyboardInterrupt):
                    tiles.make([self.path], tin=self.at("a.pvtp"), leaf=60, piece=100, resume=True, show=plans.append)
                self.assertEqual(self.leaves(), 0)
                shutil.rmtree(self.at("a.part"))
        self.assertEqual(plans[0].disk, plans[1].disk)


class WritingTest(TilesTest):
    """The disk refuses a file, or a folder its name."""

    @needs_raster
    def test_each_that_cannot_be_written(self):
        """The run ends and names it; what was done before is kept."""
        words = [self.saved(POINTS), "--tin", self.at("a.pvtp"), "--raster", self.at("a.tif"), "--cell", "2",
                 "--leaf", "200", "--piece", "300", "--threads", "1"]  # fmt: skip
        replace, made = os.replace, []
        with unittest.mock.patch.object(os, "replace", lambda *paths: (made.append(paths[1]), replace(*paths))):
            self.assertEqual(self.command(*words)[0], 0)
        want = bytes_of(self.at("a.pvtp")), bytes_of(self.at("a.tif"))
        made = list(dict.fromkeys(made))
        self.assertGreater(len(made), 15)
        for path in made:
            shutil.rmtree(self.at("a"))
            os.remove(self.at("a.pvtp"))
            os.remove(self.at("a.tif"))
            with unittest.mock.patch.object(os, "replace", lambda *paths: refused(replace, path, paths)):
                code, said = self.command(*words)
            with self.subTest(path=os.path.relpath(path, self.folder)):
                self.assertEqual((code, path in said, "cannot be written" in said), (6, True, True), said)
                self.assertEqual(self.command(*words, "--resume")[0], 0)
                self.assertEqual((bytes_of(self.at("a.pvtp")), bytes_of(self.at("a.tif"))), want)


def refused(replace, path, paths):
    """os.replace() of two paths, but to this one."""
    if paths[1] == path:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    replace(*paths)


class PlanTest(unittest.TestCase):
    def test_what_was_measured(self):
        """In Filters/Python/Tiles.md: 10^8 points, one for each cell, and a TIN, about. That time has the
        counting, which comes before a plan; a pass over .npy takes 10 ns a point."""
        count, leaves = 10**8, 1024
        counted = _points.Counted(count, 0, 0, (0, 1e4, 0, 1e4), 2, [])
        for cells, threads, seconds, memory, disk in (
                ((10**4, 10**4), 1, 76, 0.19e9, 2.56e9), ((10**4, 10**4), 2, 46, 0.41e9, 2.56e9),
                (None, 2, 79, 0.7e9, 3.5e9)):  # fmt: skip
            record = 24 if cells else 32
            kind = _plan.Kind("linear", "float32", record, record * count, 0 if cells else 10**6, False)
            plan = _plan.planned(counted, np.full(leaves, count // leaves), cells, kind, 1e-8 * count, threads)
            for what, found, measured in (("seconds", plan.seconds, seconds), ("memory", plan.memory, memory),
                                          ("disk", plan.both, disk)):  # fmt: skip
                with self.subTest(cells=cells, threads=threads, what=what):
                    self.assertTrue(0.7 * measured < found < 1.3 * measured, (found, measured))


class RecordTest(TilesTest):
    def test_fields_that_no_file_has_take_no_room(self):
        kind = [("x", "f8"), ("y", "f8"), ("z", "f8")]
        for more, size in (([], 32), ([("classification", "u1")], 33), ([("intensity", "u2")], 34),
                           ([("classification", "u1"), ("intensity", "u2")], 35)):  # fmt: skip
            table = np.zeros(len(POINTS), kind + more)
            table["x"], table["y"], table["z"] = POINTS.T
            for name, _ in more:
                table[name] = np.arange(len(POINTS)) % 200
            files = [self.saved(table), self.saved(POINTS + 1, "plain.npy")]
            with unittest.mock.patch.object(_run.Run, "_visit", side_effect=KeyboardInterrupt):
                with contextlib.suppress(KeyboardInterrupt):
                    tiles.make(files, tin=self.at("a.pvtp"), leaf=100)
            folder = self.at("a.pvtp.work", "leaf")
            found = sum(os.path.getsize(os.path.join(folder, name)) for name in os.listdir(folder))
            self.assertEqual(found, 2 * size * len(POINTS))
            tiles.make(files, tin=self.at("a.pvtp"), leaf=100, resume=True)
            for piece in pieces_of(self.at("a.pvtp")):
                _, data, _ = read_piece(piece)
                self.assertEqual(data.keys() - {"z", "GlobalPointIds"}, {name for name, _ in more})
                ids = data["GlobalPointIds"]
                for name, _ in more:
                    want = np.where(ids < len(POINTS), ids % 200, 0)
                    np.testing.assert_array_equal(data[name], want)
            os.remove(self.at("a.pvtp"))
            shutil.rmtree(self.at("a"))


class CompressionTest(TilesTest):
    def pieces(self):
        path = self.saved(POINTS)
        tiles.make([path], tin=self.at("a.pvtp"), leaf=100, piece=300, overwrite=True)
        return [read_piece(piece) for piece in pieces_of(self.at("a.pvtp"))]

    def assert_same(self, found, want):
        for (xyz, data, triangles), (xyz_, data_, triangles_) in zip(found, want):
            self.assertEqual(data.keys(), data_.keys())
            for one, other in ((xyz, xyz_), (triangles, triangles_), *((data[name], data_[name]) for name in data)):
                np.testing.assert_array_equal(one, other)
        self.assertEqual(len(found), len(want))

    def test_blocks_of_offsets(self):
        """read_piece() compares the offsets."""
        want = self.pieces()
        for size in (1, 7, len(want[0][2]), 10**6):
            _pvtp._offsets_block.cache_clear()
            with unittest.mock.patch.object(_pvtp, "_OFFSETS", size):
                self.assert_same(self.pieces(), want)


if __name__ == "__main__":
    unittest.main()
