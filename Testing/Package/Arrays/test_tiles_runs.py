# SPDX-License-Identifier: BSD-3-Clause
"""Runs of tiles that end early go on and give the same bytes; bad files, full disks and questions without a surface are
told, with exit codes, and nothing is left half written."""

import contextlib
import io
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import unittest
import unittest.mock

import numpy as np
from tilesupport import TilesTest, bytes_of, hash_of, kinds, needs_raster, raster_of, tiles

from adaptivehilbertdelaunay.tiles import _command, _points, _read, _store

POINTS = next(points for name, points in kinds(600) if name == "uniform")


def killed_at(commit, words, isBefore, by="SIGKILL", calls=("replace",)):
    """Runs the command in a child that gets a signal at this commit, one of these calls of `os`, just before or after.
    Returns whether it ended by that."""
    child = os.fork()
    if child == 0:
        left = [commit]

        def counted(call):
            def counts(*paths):
                left[0] -= 1
                if left[0] == 0 and isBefore:
                    os.kill(os.getpid(), getattr(signal, by))
                call(*paths)
                if left[0] == 0 and not isBefore:
                    os.kill(os.getpid(), getattr(signal, by))

            return counts

        for name in calls:
            setattr(os, name, counted(getattr(os, name)))
        sys.stdout, sys.stderr = io.StringIO(), io.StringIO()
        code = 99
        try:
            code = _command.main(words)
        finally:
            os._exit(code)
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return True
    assert os.WEXITSTATUS(status) in (0, 2, 130), status  # 2: it was killed when all was done, and results are there
    return os.WEXITSTATUS(status) == 130


class ResumeTest(TilesTest):
    def setUp(self):
        super().setUp()
        self.path = self.saved(POINTS)

    def words(self, *more):
        return [self.path, "--tin", self.at("a.pvtp"), "--leaf", "100", *more]

    def removed(self):
        shutil.rmtree(self.at("a"))
        os.remove(self.at("a.pvtp"))

    @unittest.skipUnless(hasattr(os, "fork"), "no fork()")
    def test_killed_at_every_commit(self):
        self.assertEqual(self.command(*self.words())[0], 0)
        want = bytes_of(self.at("a.pvtp"))
        with unittest.mock.patch.object(_points, "COMMIT", 100), unittest.mock.patch.object(_read, "ROWS", 100):
            for step, isBefore in ((1, True), (2, False), (4, False), (7, True)):
                self.removed()
                words, commits = self.words("--threads", "2"), 0
                while killed_at(step, words, isBefore):
                    words, commits = self.words("--resume"), commits + 1
                    step = max(3, step) if isBefore else step  # some tasks have two files
                    self.assertLess(commits, 200)
                self.assertGreater(commits, 1)
                self.assertEqual(bytes_of(self.at("a.pvtp")), want)
                self.assertEqual(sorted(os.listdir(self.folder)), ["a", "a.pvtp", "points.npy"])

    @unittest.skipUnless(hasattr(os, "fork"), "no fork()")
    def test_interrupted_at_every_commit(self):
        """Ctrl-C ends a run within the step that it is at, on whichever thread that is."""
        self.assertEqual(self.command(*self.words())[0], 0)
        want, all_ends = bytes_of(self.at("a.pvtp")), 0
        for threads in ("1", "2"):
            more, ends = ["--overwrite"], 0
            while killed_at(3, self.words("--threads", threads, *more), False, "SIGINT"):
                more, ends = ["--resume"], ends + 1
                self.assertLess(ends, 200)
            self.assertGreater(ends, 0)
            self.assertEqual(bytes_of(self.at("a.pvtp")), want)
            all_ends += ends
        self.assertGreater(all_ends, 3)  # one may be lost: Python ignores what is raised while it frees an object

    @needs_raster
    @unittest.skipUnless(hasattr(os, "fork"), "no fork()")
    def test_killed_with_a_raster(self):
        words = [self.path, "--raster", self.at("a.tif"), "--cell", "0.5", "--leaf", "100"]
        self.assertEqual(self.command(*words)[0], 0)
        want, more = bytes_of(self.at("a.tif")), ["--overwrite"]
        while killed_at(4, [*words, *more], False):
            more = ["--resume"]
        self.assertEqual(bytes_of(self.at("a.tif")), want)

    def test_killed_while_points_go_to_leaves(self):
        """Parts of files that no commit knows of are cut away."""
        self.assertEqual(self.command(*self.words())[0], 0)
        want, add = bytes_of(self.at("a.pvtp")), _points._commit
        self.removed()
        with unittest.mock.patch.object(_points, "COMMIT", 100), unittest.mock.patch.object(_read, "ROWS", 50):
            with unittest.mock.patch.object(_points, "_commit", side_effect=[None, None, KeyboardInterrupt]):
                code, said = self.command(*self.words())
            self.assertEqual((code, "--resume" in said), (130, True))
            calls = []

            def twice(*given):
                calls.append(add(*given))
                if len(calls) == 2:
                    with open(_points._leaf_file(given[0], 0), "ab") as file:
                        file.write(b"half a point")
                    raise KeyboardInterrupt

            with unittest.mock.patch.object(_points, "_commit", twice):
                self.assertEqual(self.command(*self.words("--resume"))[0], 130)
            self.assertEqual(self.command(*self.words("--resume"))[0], 0)
        self.assertEqual(bytes_of(self.at("a.pvtp")), want)

    def test_ended_while_the_work_is_removed(self):
        with unittest.mock.patch.object(_store.Store, "clear", side_effect=[None, KeyboardInterrupt]):
            self.assertEqual(self.command(*self.words())[0], 130)
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))
        code, said = self.command(*self.words("--resume"))
        self.assertEqual((code, "is there already" in said), (2, True))
        self.assertEqual(sorted(os.listdir(self.folder)), ["a", "a.pvtp", "points.npy"])

    def test_only_the_same_run_goes_on(self):
        with unittest.mock.patch.object(tiles._run.Run, "_visit", side_effect=KeyboardInterrupt):
            self.assertEqual(self.command(*self.words())[0], 130)
        code, said = self.command(*self.words())
        self.assertEqual((code, "go on with --resume" in said), (2, True))
        code, said = self.command(*self.words("--resume", "--duplicates", "first"))
        self.assertEqual((code, "other files" in said), (2, True))
        os.utime(self.path, ns=(0, 0))
        self.assertEqual(self.command(*self.words("--resume"))[0], 2)

    def test_pieces_of_another_run_are_not_taken(self):
        """What is left of one whose work folder was removed, or is another."""
        more = ["--piece", "100"]
        with unittest.mock.patch.object(tiles._run.Run, "_write", side_effect=KeyboardInterrupt):
            self.assertEqual(self.command(*self.words(*more))[0], 130)
        self.assertGreater(len(os.listdir(self.at("a.part"))), 3)
        moved = POINTS[:, [1, 0, 2]]
        path = self.saved(moved, "moved.npy")
        words = [path, *self.words("--work", self.at("other"), *more)[1:]]
        self.assertEqual(self.command(*words)[0], 0)
        self.assert_is_one_piece(moved, self.at("a.pvtp"))
        self.assertEqual(self.command(*self.words("--resume", *more))[0], 0)  # whose pieces are gone
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))
        self.assertNotIn("run", os.listdir(self.at("a")))

    def test_one_run_at_a_time(self):
        with _store.Store(self.at("a.pvtp.work")).held():
            code, said = self.command(*self.words())
        self.assertEqual((code, "another run is at work" in said), (2, True), said)
        self.assertEqual(os.listdir(self.folder), ["points.npy"])
        self.assertEqual(self.command(*self.words())[0], 0)

    def test_a_plan_does_not_allow_to_replace(self):
        with open(self.at("a.pvtp"), "wb") as file:
            file.write(b"before")
        self.assertEqual(self.command(*self.words("--plan"))[0], 0)
        code, said = self.command(*self.words("--resume"))
        self.assertEqual((code, "is there already" in said), (2, True))
        self.assertEqual(bytes_of(self.at("a.pvtp")), b"before")

    @needs_raster
    def test_the_place_of_a_raster_is_a_setting(self):
        words = [self.path, "--raster", "a.tif", "--cell", "1", "--work", self.at("work")]
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        with unittest.mock.patch.object(tiles._run.Run, "_visit", side_effect=KeyboardInterrupt):
            self.assertEqual(self.command(*words)[0], 130)
        os.mkdir("sub")
        os.chdir("sub")
        code, said = self.command(*words, "--resume")
        self.assertEqual((code, "other files" in said), (2, True))

    def test_a_plan_counts_and_stops(self):
        code, said = self.command(*self.words("--plan"))
        self.assertEqual(code, 0)
        self.assertRegex(said, r"points   600\nleaves   \d+\nmemory .*\ndisk .*\ntime ")
        self.assertFalse(os.path.exists(self.at("a.pvtp")))
        with unittest.mock.patch.object(tiles._run, "count", side_effect=AssertionError):  # it was
            self.assertEqual(self.command(*self.words())[0], 0)
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))

    def test_a_bar_on_a_terminal(self):
        """Of each step the beginning and the end, else no more often than can be read; gone at the end."""
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            _command.Bar()("visit", 0.0, None)
            self.assertEqual(said.getvalue(), "")  # no terminal
            said.isatty = lambda: True
            bar = _command.Bar()
            for now, fraction, left in (
                    (9.0, 0.0, None), (9.1, 0.2, 80), (9.3, 0.5, 40), (9.4, 0.7, 20), (9.41, 1.0, 0)):  # fmt: skip
                with unittest.mock.patch.object(_command.time, "monotonic", return_value=now):
                    bar("visit", fraction, left)
            bar.end()
        lines = said.getvalue().split("\r\033[K")
        self.assertEqual([(line[:8], line.count("#"), line[40:45]) for line in lines[1:-1]], [
            ("visit   ", 0, "  0 %"), ("visit   ", 15, " 50 %"), ("visit   ", 30, "100 %")])
        self.assertEqual((lines[0], lines[-1]), ("", ""))
        self.assertRegex(lines[2], r" 40 s left$")

    def test_progress(self):
        told = []
        made = tiles.make([self.path], tin=self.at("a.pvtp"), leaf=100, progress=lambda *words: told.append(words))
        steps = [step for step, fraction, _ in told if fraction == 1]
        self.assertEqual(list(dict.fromkeys(steps)), ["count", "scatter", "visit", "finish", "write"])
        self.assertEqual(list(made.steps), list(dict.fromkeys(steps)))
        self.assertTrue(0 < sum(made.steps.values()) < made.seconds)
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction, _ in told))
        self.assertTrue(all(left is None for step, _, left in told if step == "count"))
        self.assertTrue(all(left >= 0 for step, _, left in told if step != "count"))


class ErrorTest(TilesTest):
    def fails(self, code, said, *words):
        """The command ends so, and leaves nothing but its input."""
        before = sorted(os.listdir(self.folder))
        found, text = self.command(*words)
        self.assertEqual(found, code, text)
        self.assertIn(said, text)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def tin(self, *files):
        return (*files, "--tin", self.at("a.pvtp"))

    def test_files(self):
        good = self.saved(POINTS)
        with open(good, "rb") as file:
            octets = file.read()
        for name, data, said in (
            ("short.npy", octets[: len(octets) // 2], "cannot be read"), ("no.npy", b"text", "cannot be read"),
            ("no.csv", b"x;z\n1;2\n", "must have columns x and y"), ("letters.xyz", b"1 2 3\n4 five 6\n", "five"),
            ("short.csv", b"x,y,z\n1,2,3\n4,5\n", "cannot be read"), ("a.doc", b"", "is none of .npy"),
            ("folder.npy/x.doc", b"", "there are no files")):  # fmt: skip
            os.makedirs(os.path.dirname(self.at(name)), exist_ok=True)
            with open(self.at(name), "wb") as file:
                file.write(data)
            name = name.split("/")[0]
            self.fails(2 if "folder" in name else 3, said, *self.tin(self.at(name)))
            self.fails(2 if "folder" in name else 3, self.at(name), *self.tin(self.at(name)))
        self.fails(3, "there is no such file", *self.tin(good, self.at("missing.npy")))
        self.fails(3, "must be an array", *self.tin(self.saved(np.zeros((3, 7)), "wide.npy")))
        self.fails(2, "named twice", *self.tin(good, good))
        if hasattr(os, "fork"):  # elsewhere links are for few
            os.symlink(good, self.at("link.npy"))
            self.fails(2, "named twice", *self.tin(good, self.at("link.npy")))
        self.fails(3, "has no classes", *self.tin(good, "--class", "2"))

    def test_files_that_change_meanwhile(self):
        path = self.saved(POINTS)
        for points, kind in ((POINTS[:300], tiles.BadFile), (POINTS**2 / 100, tiles.BadOptions)):
            with self.assertRaisesRegex(kind, "says that it has 600 points, and has 300|were changed"):
                tiles.make([path], tin=self.at("a.pvtp"), leaf=100, work=self.at(str(len(points))),
                           show=lambda plan, now=points: np.save(path, now))  # fmt: skip
            np.save(path, POINTS)

    def test_nothing_of_others_is_replaced(self):
        """Neither files of points, nor what lies where pieces come, nor in a work folder."""
        os.makedirs(self.at("survey", "sub"))
        good, inside = self.saved(POINTS), self.saved(POINTS, os.path.join("survey", "0.npy"))
        for name in ("ended", "manifest.json", "notes.txt"):
            with open(self.at("survey", name), "w", encoding="ascii") as file:
                file.write('{"key": "mine"}')
        os.makedirs(self.at("vtk"))
        os.rename(self.saved(POINTS, "0.vtp.npy"), self.at("vtk", "0.vtp"))
        with open(self.at("file"), "wb"):
            pass
        for words, said in (
            ((self.at("survey"), "--tin", self.at("survey.pvtp")), inside + " would be replaced"),
            ((good, "--tin", self.at("survey.pvtp")), "has other files"),
            ((self.at("vtk", "0.vtp"), "--tin", self.at("vtk.pvtp")), "would be replaced"),
            ((good, "--tin", self.at("file.pvtp")), "has other files"),
            ((*self.tin(good), "--work", self.at("survey")), "is no folder of a run"),
            ((*self.tin(good), "--work", self.at("file")), "is no folder of a run"),
            ((*self.tin(good), "--work", self.at("a")), "must differ")):  # fmt: skip
            self.fails(2, said, *words, "--overwrite")
        self.assertEqual(sorted(os.listdir(self.at("survey"))), ["0.npy", "ended", "manifest.json", "notes.txt", "sub"])
        self.assertTrue(os.path.exists(self.at("vtk", "0.vtp")))

    @needs_raster
    def test_nothing_of_others_is_replaced_by_a_raster(self):
        good = self.saved(POINTS)
        before = bytes_of(good)
        os.makedirs(self.at("folder.tif"))
        for words, said in (((good, "--raster", good), "would be replaced"),
                            ((good, "--raster", self.at("folder.tif")), "is a folder"),
                            ((*self.tin(good), "--raster", self.at("a")), "must differ"),
                            ((*self.tin(good), "--raster", self.at("a.pvtp")), "must differ")):  # fmt: skip
            self.fails(2, said, *words, "--cell", "1", "--overwrite")
        self.assertEqual(bytes_of(good), before)

    def test_bad_files_are_left_out_on_request(self):
        good, bad = self.saved(POINTS), self.at("bad.xyz")
        with open(bad, "w", encoding="ascii") as file:
            file.write("1 2 3\n" * 50 + "half a")
        self.fails(3, bad, *self.tin(bad, good))
        code, said = self.command(*self.tin(bad, good, self.at("no.npy")), "--skip-bad")
        self.assertEqual((code, "left out: " + bad in said, "no.npy: there is no such file" in said), (0, True, True))
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))

    def test_no_surface(self):
        nan = np.full((4, 3), np.nan)
        line = np.outer(np.arange(500.0), (3, 1, 0))
        for points, said in ((nan, "there is no point"), (POINTS[:1], "there is one point"),
                             (line, "all 500 points lie on a line"), (POINTS[[0, 0, 0]], "at one place")):  # fmt: skip
            self.fails(4, said, *self.tin(self.saved(points, "few.npy")))
        line[400, 1] = np.nextafter(line[400, 1], 1e9)  # not quite
        self.assertEqual(self.command(*self.tin(self.saved(line, "few.npy")))[0], 0)
        self.assert_is_one_piece(line, self.at("a.pvtp"))

    def test_options(self):
        good = self.saved(POINTS)
        self.fails(2, "nothing is asked for", good)
        self.fails(2, "--raster and --cell go together", good, "--cell", "1")
        self.fails(2, "a TIN is a .pvtp", good, "--tin", self.at("a.vtp"))
        self.fails(2, "there is no such folder", good, "--tin", self.at("no", "a.pvtp"))
        for size in ("much", "inf", "1e999"):
            self.fails(2, "is no size", *self.tin(good), "--memory", size)
        self.fails(2, "threads must be", *self.tin(good), "--threads", "-3")
        self.fails(2, "in Unicode", good, "--tin", self.at("a\udcff.pvtp"))
        self.fails(2, "longest_edge", *self.tin(good), "--longest-edge", "-1")
        os.makedirs(self.at("full", "sub"))
        self.fails(2, "is not empty", *self.tin(good), "--work", self.at("full"))
        with open(self.at("a.pvtp"), "w", encoding="ascii"):
            pass
        self.fails(2, "is there already", *self.tin(good))

    @needs_raster
    def test_rasters(self):
        good = self.saved(POINTS * (0.001, 0.001, 1))
        raster = "--raster", self.at("a.tif"), "--cell"
        self.fails(2, "seem to be degrees", good, *raster, "1")
        degrees = "--crs", "EPSG:4326", "--bounds", "0", "9", "0", "9"
        self.fails(2, "larger than makes sense", good, *raster, "0.2", *degrees)
        self.fails(2, "crs: ", good, *raster, "0.001", "--crs", "EPSG:1")
        self.fails(2, "raster: ", good, *raster, "0")
        tiny = self.saved(POINTS * (1e-12, 1e-12, 1), "tiny.npy")  # of which there are few cells
        more = "--nodata", "-1e9", "--bounds", "-1e-11", "1e-10", "0", "6E-11"
        self.assertEqual(self.command(tiny, *raster, "1e-11", *more)[0], 0)
        self.assertEqual(raster_of(self.at("a.tif"))[0].min(), -1e9)
        os.remove(self.at("a.tif"))
        self.fails(3, "has no z", self.saved(POINTS[:, :2], "flat.npy"), *raster, "1")

    def test_leaves_of_a_circle_need_all_of_each_other(self):
        angle = np.random.default_rng(5).random(8000) * 2 * np.pi
        path = self.saved(np.column_stack((np.cos(angle), np.sin(angle), angle)))
        code, said = self.command(*self.tin(path), "--leaf", 40, "--memory", "170MB")
        self.assertEqual(code, 5)
        self.assertRegex(said, r"Merging borders of \d+ points takes \d+ MB of memory or more, and there are 170 MB")
        shutil.rmtree(self.at("a.pvtp.work"))
        self.assertEqual(self.command(*self.tin(path), "--leaf", 4000, "--memory", "170MB")[0], 0)

    def test_room(self):
        path = self.saved(POINTS)
        code, said = self.command(*self.tin(path), "--memory", "1MB")
        self.assertEqual((code, "1 MB are allowed" in said), (5, True))
        with unittest.mock.patch.object(tiles._plan.shutil, "disk_usage", return_value=unittest.mock.Mock(free=10**4)):
            code, said = self.command(*self.tin(path))
        self.assertEqual((code, "10 kB are free" in said), (5, True))
        self.assertEqual(self.command(*self.tin(path))[0], 0)

    def test_pieces_that_are_there_need_no_room(self):
        path = self.saved(POINTS)
        with unittest.mock.patch.object(tiles._run.Run, "_write", side_effect=KeyboardInterrupt):
            self.assertEqual(self.command(*self.tin(path))[0], 130)
        free = 32 * len(POINTS) - 1  # bytes
        with unittest.mock.patch.object(tiles._plan.shutil, "disk_usage", return_value=unittest.mock.Mock(free=free)):
            code, said = self.command(*self.tin(path), "--resume")
        self.assertEqual(code, 0, said)
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))

    @unittest.skipUnless(sys.platform == "linux" and os.geteuid() == 0, "who mounts a small disk must be root on Linux")
    def test_a_full_disk(self):
        """It is told; when there is room, the run goes on."""
        disk = self.at("disk")
        os.mkdir(disk)
        mount = ["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", disk]
        if subprocess.run(mount, check=False, stderr=subprocess.DEVNULL).returncode:
            self.skipTest("no disk can be mounted here")
        self.addCleanup(subprocess.run, ["umount", "-l", disk], check=True)
        words = [self.saved(POINTS), "--tin", os.path.join(disk, "a.pvtp"), "--leaf", "100"]
        with unittest.mock.patch.object(tiles._plan, "check"):  # which would have said so before
            for size in range(16, 2000, 16):  # kB
                subprocess.run(["mount", "-o", "remount,size=%dk" % size, disk], check=True)
                code, said = self.command(*words, "--resume")
                if code == 0:
                    break
                self.assertEqual((code, "No space left" in said), (6, True), said)
                self.assertFalse(os.path.exists(os.path.join(disk, "a.pvtp")))
        self.assertEqual(code, 0)
        self.assertGreater(size, 60)
        self.assert_is_one_piece(POINTS, os.path.join(disk, "a.pvtp"))

    @needs_raster
    def test_a_raster_that_cannot_be_written(self):
        """The file that was there stays."""
        with open(self.at("a.tif"), "wb") as file:
            file.write(b"before")
        words = self.saved(POINTS), "--raster", self.at("a.tif"), "--cell", "1", "--overwrite"
        with unittest.mock.patch.object(_store.os, "replace", wraps=os.replace) as replace:
            replace.side_effect = lambda *paths: _refuse(paths, self.at("a.tif"))
            code, said = self.command(*words)
        self.assertEqual((code, "cannot be written" in said), (6, True))
        self.assertEqual(bytes_of(self.at("a.tif")), b"before")
        self.assertEqual(self.command(*words, "--resume")[0], 0)
        self.assertEqual(raster_of(self.at("a.tif"))[0].shape, (60, 100))


REPLACE = os.replace


def _refuse(paths, path):
    if paths[1] == path:
        raise OSError(28, "No space left on device")
    return REPLACE(*paths)


class TextTest(TilesTest):
    def test_layouts(self):
        """The same points in each."""
        rows = ["%r %r %r" % tuple(row) for row in POINTS.tolist()]
        comma = [row.replace(" ", ",") for row in rows]
        swapped = ["%r;%r;7;%r" % (z, y, x) for x, y, z in POINTS.tolist()]
        found = set()
        for name, head, lines in (
            ("a.xyz", "", rows), ("b.csv", "x,y,z", comma), ("c.txt", "# made up\n", rows),
            ("d.csv", 'height;"Northing";n;EASTING', swapped), ("e.csv", "", comma),
            ("f.csv", "z;y;lon;x", swapped), ("g.csv", "z;y;height;x", swapped)):  # fmt: skip
            with open(self.at(name), "w", encoding="utf-8") as file:
                file.write("\n".join(([head] if head else []) + lines))
            tiles.make([self.at(name)], tin=self.at("a.pvtp"), leaf=100, overwrite=True)
            found.add(bytes_of(self.at("a.pvtp")))
        self.assertEqual(len(found), 1)
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))

    def test_arguments(self):
        """Paths and NumPy's numbers, one in place of several."""
        path = pathlib.Path(self.saved(POINTS))
        tiles.make(path, tin=pathlib.Path(self.at("a.pvtp")), leaf=np.int64(100), longest_edge=np.float32(99))
        self.assert_is_one_piece(POINTS, self.at("a.pvtp"))
        for classes in (2, [2, 3], np.array([2, 3])):
            with self.assertRaisesRegex(tiles.BadFile, "has no classes"):
                tiles.make(str(path), tin=self.at("b.pvtp"), classes=classes)
        for memory in ("much", 0, -1):
            with self.assertRaisesRegex(tiles.BadOptions, "is no size|more than 0"):
                tiles.make(path, tin=self.at("b.pvtp"), memory=memory)
        with self.assertRaisesRegex(tiles.BadFile, "lines.json: cannot be read"):
            tiles.make(path, tin=self.at("b.pvtp"), lines=self.at("lines.json"))

    def test_nobody_reads(self):
        """A pipe that is closed, or a coding that has not all letters: the results are there, the code is 0."""
        path, name = self.saved(POINTS), self.at("\u0416.pvtp")
        command = [sys.executable, "-m", "adaptivehilbertdelaunay", "tiles", path, "--overwrite", "--tin", name]
        for more in ([], ["--plan"]):
            read, write = os.pipe()
            os.close(read)
            with subprocess.Popen([*command, *more], stdout=write, stderr=subprocess.PIPE) as made:
                os.close(write)
                said = made.communicate()[1]
            self.assertEqual((made.returncode, b"Error" in said), (0, False), said)
        given = {**os.environ, "PYTHONIOENCODING": "cp1252"}
        self.assertIn(b"\\u0416.pvtp", subprocess.run(command, env=given, check=True, capture_output=True).stdout)

    def test_tables(self):
        table = np.zeros(len(POINTS), [("z", "f4"), ("x", "f8"), ("y", "f8"), ("classification", "i4")])
        table["x"], table["y"], table["classification"] = POINTS[:, 0], POINTS[:, 1], np.arange(len(POINTS)) % 3
        made = tiles.make([self.saved(table)], tin=self.at("a.pvtp"), leaf=100, classes=[1, 2])
        self.assertEqual((made.plan.points, made.plan.other_class), (400, 200))
        kept = POINTS.copy()
        kept[::3], kept[:, 2] = np.nan, 0
        self.assert_is_one_piece(kept, self.at("a.pvtp"))
        self.assertNotEqual(hash_of(kept), hash_of(POINTS))


if __name__ == "__main__":
    unittest.main()
