#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The command `adaptivehilbertdelaunay tiles` on made-up surveys: what it takes beside what it planned, and whether its
result is that of one piece. With the Python that has the package ('.[tiles]').

  tiles.py [--points 1e8] [--threads N] [--tin] [--cell 1] [--windows 1000] [--whole] [--work FOLDER] [--keep]

Points are in strips, a .npy of float32 for each, as lines of flight are: one for each square metre. The disk must hold
12 bytes a point of these, and what the plan says. One line of JSON is printed. The exit code is 1 if a result is wrong,
77 where there is no rasterio to read a raster:
  --windows N   N random windows of 32 x 32 cells are compared with runs of the points around them, to the byte
  --tin         a TIN; its number of triangles is compared with Euler's, 2 n - 2 - hull
  --whole       triangles' SHA-256 (--tin) or all cells are compared with those of one run of all points (84 bytes a
                point of memory, and 150 a cell)
"""

import argparse
import contextlib
import hashlib
import importlib.util
import json
import resource
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
from adaptivehilbertdelaunay import Raster, delaunay
from adaptivehilbertdelaunay._library import Job

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Package" / "Arrays"))
import tilesupport  # noqa: E402

STRIP = 10**7  # points of a file
WINDOW, AROUND, MOST_AROUND = 32, 6.0, 48.0  # cells; metres


class Survey:
    """Strips of points over hills, side by side."""

    def __init__(self, folder, count):
        self.count, self.side = count, float(count) ** 0.5
        self.strips = max(1, round(count / STRIP))
        self.paths = [folder / ("strip%04d.npy" % k) for k in range(self.strips)]

    def make(self):
        for k, path in enumerate(self.paths):
            count = self.count * (k + 1) // self.strips - self.count * k // self.strips
            if path.exists():
                continue
            rng, made = np.random.default_rng(k), np.empty((count, 3), np.float32)
            made[:, 0] = (k + rng.random(count, np.float32)) * (self.side / self.strips)
            made[:, 1] = np.sort((np.arange(count) + rng.random(count)) * (self.side / count))
            made[:, 2] = 40 * np.sin(made[:, 0] / 700) * np.cos(made[:, 1] / 900) + rng.random(count, np.float32)
            np.save(path, made)

    def bounds(self):
        """((xmin, xmax), (ymin, ymax))."""
        ends = [(one.min(axis=0), one.max(axis=0)) for one in (np.load(path)[:, :2] for path in self.paths)]
        low, high = np.min([low for low, _ in ends], axis=0), np.max([high for _, high in ends], axis=0)
        return np.array([low, high], float).T.copy()

    def around(self, low, high):
        """The points within a box, in the order of the files."""
        width, found = self.side / self.strips, []
        for k in range(max(0, int(low[0] / width) - 1), min(self.strips, int(high[0] / width) + 2)):
            strip = np.load(self.paths[k], mmap_mode="r")
            begin, end = np.searchsorted(strip[:, 1], (np.float32(low[1]), np.float32(high[1])))
            some = np.array(strip[begin:end], float)
            found.append(some[(some[:, :2] >= low).all(axis=1) & (some[:, :2] <= high).all(axis=1)])
        return np.concatenate(found)

    def all(self):
        return np.concatenate([np.load(path) for path in self.paths]).astype(float)


class Watch(threading.Thread):
    """The most bytes that lie under a name and what begins with it, looked at each second, and the most memory of a
    process: of its own, not of the one that started it."""

    def __init__(self, begin, process):
        super().__init__(daemon=True)
        self.begin, self.process, self.disk, self.memory = Path(begin), process, 0, 0

    def run(self):
        while self.process.poll() is None:
            there = list(self.begin.parent.glob(self.begin.name + "*"))
            found = there and subprocess.run(["du", "-sbc", *there], capture_output=True, text=True).stdout
            self.disk = max(self.disk, int((found or "0").splitlines()[-1].split()[0]))
            with contextlib.suppress(OSError, ValueError, StopIteration):
                status = Path("/proc/%d/status" % self.process.pid).read_text().splitlines()
                self.memory = max(self.memory, next(int(one.split()[1]) for one in status if one.startswith("VmHWM")))
            time.sleep(1.0)


PROGRAM = """
import json, sys
from adaptivehilbertdelaunay import tiles
files, words = json.loads(sys.argv[1])
raster = words.pop("raster", None)
made = tiles.make(files, raster=raster and tiles.GeoTiff(**raster), overwrite=True, **words)
print(json.dumps({"seconds": made.seconds, "steps": made.steps, "plan": vars(made.plan)}))
"""


def run(survey, result, words):
    """What a run says and takes, in a process of its own."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [sys.executable, "-c", PROGRAM, json.dumps([list(map(str, survey.paths)), words])]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        watch = Watch(result.with_suffix(""), process)
        watch.start()
        said = process.stdout.read()
    watch.join()
    if process.returncode:
        sys.exit("exit code %d: %s" % (process.returncode, words))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    made = json.loads(said)
    plan = {name: made["plan"][name] for name in ("leaves", "memory", "disk", "output", "both", "seconds", "steps")}
    return {"wall s": made["seconds"], "cpu s": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
            "steps s": made["steps"], "memory": 1024 * watch.memory, "disk": watch.disk, "plan": plan}  # fmt: skip


# --- Is it right? -------------------------------------------------------------------------------------------


def values_of_one_piece(points, bounds, cells):
    """At the cells of a Raster, south first, and whether a circle of a triangle in their box may hold other points."""
    job = Job()
    job.set(duplicates=tilesupport.tiles._options.DUPLICATES["lowest"], threads=1)
    job.set_array("points", points)
    job.set_array("rank_bounds", bounds)  # cocircular points do not need it; the order of a triangle's corners does
    job.run()
    return job.sample(cells, [np.ascontiguousarray(points[:, 2])], has_mask=False).values[0].reshape(cells.shape)


def is_enough(points, low, high, margin):
    """Are the circles of all triangles that meet the window inside what is `margin` around it?"""
    a, b, c = (points[:, :2] - low)[delaunay(points, duplicates="lowest_z").triangles].transpose(1, 0, 2)
    corners = np.stack((a, b, c))
    isNear = ((corners.min(axis=0) <= high - low) & (corners.max(axis=0) >= 0)).all(axis=1)
    a, b, c = a[isNear], b[isNear] - a[isNear], c[isNear] - a[isNear]
    twice = 2 * (b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0])
    bb, cc = (b**2).sum(axis=1), (c**2).sum(axis=1)
    centre = np.stack((c[:, 1] * bb - b[:, 1] * cc, b[:, 0] * cc - c[:, 0] * bb), axis=1) / twice[:, None]
    radius = 1.001 * np.hypot(*centre.T)[:, None]
    centre += a
    return bool((centre - radius > -margin).all() and (centre + radius < high - low + margin).all())


def wrong_windows(survey, path, count, cell, bounds):
    """How many of so many windows differ, and how many were judged."""
    rng, wrong, judged = np.random.default_rng(1), 0, 0
    import rasterio

    with rasterio.open(path) as file:
        left, top = file.transform.c, file.transform.f
        for _ in range(count):
            row, column = (int(rng.integers(0, size - WINDOW)) for size in (file.height, file.width))
            low = np.array([left + column * cell, top - (row + WINDOW) * cell])
            cells = Raster((low[0] + cell / 2, low[1] + cell / 2), (cell, cell), (WINDOW, WINDOW))
            margin, found = AROUND, None
            while found is None and margin <= MOST_AROUND:
                points = survey.around(low - margin, low + WINDOW * cell + margin)
                values = values_of_one_piece(points, bounds, cells).astype(np.float32)
                if not np.isnan(values).any() and is_enough(points, low, low + WINDOW * cell, margin):
                    found = values  # of triangles that are those of all points; in a hole there may be none at first
                margin *= 2
            if found is None:  # at the rim
                continue
            there = file.read(1, window=((row, row + WINDOW), (column, column + WINDOW)))
            judged += 1
            wrong += not np.array_equal(found[::-1], there, equal_nan=True)
    return wrong, judged


def tin_counts(survey, path):
    """Triangles, corners, and the SHA-256 of the triangles, in their order, of global ids."""
    sha, triangles, isCorner = hashlib.sha256(), 0, np.zeros(survey.count, bool)
    for piece in tilesupport.pieces_of(str(path)):
        _, data, corners = tilesupport.read_piece(piece)
        made = data["GlobalPointIds"][corners]
        sha.update(made.tobytes())
        triangles += len(made)
        isCorner[made] = True
    return triangles, int(isCorner.sum()), sha.hexdigest()


def hull_of(survey):
    """How many points are on the hull, also on its edges: by way of the hulls of the strips."""
    rims = []
    for path in survey.paths:
        xy = np.load(path)[:, :2].astype(float)
        rims.append(xy[np.unique(delaunay(xy).hull)])
    return len(delaunay(np.unique(np.concatenate(rims), axis=0)).hull)


def check(survey, chosen, result, row):
    """Adds to the row what was compared."""
    wrong = 0
    if chosen.tin:
        row["triangles"], corners, sha = tin_counts(survey, result)
        row["duplicates"], row["euler"] = survey.count - corners, 2 * corners - 2 - hull_of(survey)
        wrong += row["triangles"] != row["euler"]
    elif chosen.windows:
        wrong_, row["windows"] = wrong_windows(survey, result, chosen.windows, chosen.cell, survey.bounds())
        row["wrong windows"] = wrong_
        wrong += row["wrong windows"]
    if chosen.whole:
        points = survey.all()
        begin, cpu = time.monotonic(), time.process_time()
        made = delaunay(points, duplicates="lowest_z", threads=chosen.threads)
        row["one piece wall s"] = round(time.monotonic() - begin, 1)
        if chosen.tin:
            row["is one piece"] = sha == tilesupport.hash_of(made.triangles.astype(np.int64))
        else:
            there, place = tilesupport.raster_of(str(result))
            raster = Raster((place[0] + place[1] / 2, place[3] - place[1] / 2 - (len(there) - 1) * place[1]),
                            (place[1], place[1]), there.shape)  # fmt: skip
            values = made.interpolate(np.ascontiguousarray(points[:, 2]), raster)
            row["is one piece"] = bool(np.array_equal(there, values.astype(np.float32)[::-1], equal_nan=True))
        row["one piece cpu s"] = round(time.process_time() - cpu, 1)
        wrong += not row["is one piece"]
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=float, default=1e8)
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--tin", action="store_true")
    parser.add_argument("--cell", type=float, default=1.0)
    parser.add_argument("--windows", type=int, default=1000)
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--work", type=Path, default=Path("build/tiles"))
    parser.add_argument("--keep", action="store_true", help="points and result stay")
    parser.add_argument("--memory", default="4GB")
    chosen = parser.parse_args()
    if not chosen.tin and not importlib.util.find_spec("rasterio"):
        print("skipped: there is no rasterio")
        return 77
    folder = chosen.work / ("%.0e" % chosen.points)
    folder.mkdir(parents=True, exist_ok=True)
    survey = Survey(folder, int(chosen.points))
    survey.make()
    result = folder / ("made.pvtp" if chosen.tin else "made.tif")
    words = {"threads": chosen.threads, "memory": chosen.memory}
    words.update({"tin": str(result)} if chosen.tin else {"raster": {"path": str(result), "cell": chosen.cell}})
    row = {"points": survey.count, "threads": chosen.threads, "kind": "tin" if chosen.tin else "raster"}
    row.update(run(survey, result, words))
    wrong = check(survey, chosen, result, row)
    print(json.dumps(row, default=str), flush=True)
    if not chosen.keep:
        shutil.rmtree(folder)
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
