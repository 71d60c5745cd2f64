#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The command `adaptivehilbertdelaunay tiles` on many .laz files: a TIN and a raster of the ground, and whether both
are without a seam. With the Python that has the package ('.[tiles]').

  tiles_laz.py LIDAR.csv [--files 25] [--windows 100] [--cell 1] [--threads N] [--work FOLDER] [--keep]

LIDAR.csv has lines x,y,z, and names in the first. Its rectangle is laid side by side, its points moved by up to 0.3
each time, with made-up classes: six of ten are ground. A file has some 10^6 points. One line of JSON is printed. The
exit code is 1 unless, in exact arithmetic,
  - every triangle is counterclockwise,
  - every edge has another triangle on its other side, in the same piece or another, or is one of the hull's: as many
    triangles as Euler says, 2 n - 2 - hull, and the hull is convex,
  - no end of two triangles in different pieces is within the circle of the other,
  - as many random windows of the raster have the bytes of runs of the points around them.
"""

import argparse
import json
import shutil
import sys
from pathlib import Path

import laspy
import numpy as np
import tiles
from tiles import tilesupport

STEP, MOVED, GROUND = 0.01, 0.3, 0.6  # of coordinates; of points at the most; ground of all
MANY = 10**6  # points of a file


class LazSurvey:
    """A square of files, each a square of copies of a rectangle of lidar."""

    def __init__(self, source, folder, files):
        self.source = np.loadtxt(source, delimiter=",", skiprows=1)
        self.low = self.source.min(axis=0)
        self.size = np.ceil(np.ptp(self.source[:, :2], axis=0)) + 1
        self.side, self.copies = round(files**0.5), max(1, round((MANY / len(self.source)) ** 0.5))
        self.paths = [folder / ("f%04d.laz" % k) for k in range(self.side**2)]
        self._read = {}

    def make(self):
        for k, path in enumerate(self.paths):
            if not path.exists():
                self._write(k, path)

    def _write(self, k, path):
        rng, parts = np.random.default_rng(k), []
        first = np.array([k % self.side, k // self.side]) * self.copies
        for column in range(self.copies):
            for row in range(self.copies):
                moved = self.source + rng.uniform(-MOVED, MOVED, self.source.shape)
                moved[:, :2] += (first + (column, row)) * self.size
                parts.append(moved)
        header = laspy.LasHeader(point_format=6, version="1.4")
        header.scales, header.offsets = np.full(3, STEP), np.floor(self.low)
        made = laspy.LasData(header)
        made.x, made.y, made.z = np.concatenate(parts).T
        made.classification = np.where(rng.random(len(made.x)) < GROUND, 2, rng.integers(3, 7, len(made.x)))
        made.intensity = rng.integers(0, 1000, len(made.x))
        made.write(path)

    def ground(self, k):
        """(n, 3) of a file."""
        if k not in self._read:
            if len(self._read) > 8:
                self._read.pop(next(iter(self._read)))
            file = laspy.read(self.paths[k])
            xyz = np.stack([np.asarray(axis) for axis in (file.x, file.y, file.z)], axis=1)
            self._read[k] = xyz[np.asarray(file.classification) == 2]
        return self._read[k]

    def bounds(self):
        """((xmin, xmax), (ymin, ymax)) of the ground."""
        ends = [(one.min(axis=0), one.max(axis=0)) for one in map(self.ground, range(len(self.paths)))]
        low, high = np.min([low for low, _ in ends], axis=0), np.max([high for _, high in ends], axis=0)
        return np.array([low[:2], high[:2]]).T.copy()

    def around(self, low, high):
        """The ground within a box, in the order of the files."""
        wide, found = self.size * self.copies, []
        ends = [np.clip((at - self.low[:2] + margin) // wide, 0, self.side - 1).astype(int)
                for at, margin in ((low, -2 * MOVED), (high, 2 * MOVED))]  # fmt: skip
        for row in range(ends[0][1], ends[1][1] + 1):
            for column in range(ends[0][0], ends[1][0] + 1):
                some = self.ground(row * self.side + column)
                found.append(some[(some[:, :2] >= low).all(axis=1) & (some[:, :2] <= high).all(axis=1)])
        return np.concatenate(found)


# --- In exact arithmetic ------------------------------------------------------------------------------------


def integers(places):
    """Rows of Python's integers: coordinates times the same power of two, so that no bit is lost."""
    return [[int(x * 2.0**52) for x in row] for row in places.tolist()]  # of coordinates of 2**-20 and more


def left_of(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def is_in_circle(a, b, c, d):
    """Is d within the circle of a, b, c, which are counterclockwise?"""
    rows = [(p[0] - d[0], p[1] - d[1], (p[0] - d[0]) ** 2 + (p[1] - d[1]) ** 2) for p in (a, b, c)]
    (ax, ay, aa), (bx, by, bb), (cx, cy, cc) = rows
    return ax * (by * cc - bb * cy) - ay * (bx * cc - bb * cx) + aa * (bx * cy - by * cx) > 0


def count_clockwise(xy, triangles):
    """Of those that are not counterclockwise: floating point where its error cannot change the sign."""
    a, b, c = xy[triangles].transpose(1, 2, 0)
    one, other = (b[0] - a[0]) * (c[1] - a[1]), (b[1] - a[1]) * (c[0] - a[0])
    unsure = np.flatnonzero(~(one - other > 4e-16 * (abs(one) + abs(other))))
    return sum(left_of(*integers(xy[triangles[k]])) <= 0 for k in unsure.tolist())


class Seams:
    """The edges of pieces that have no triangle on their other side within the piece."""

    def __init__(self):
        self.open, self.between, self.within_circle, self.triangles, self.clockwise = {}, 0, 0, 0, 0
        self.wrong, self.corners = 0, []

    def add(self, places, ids, triangles):
        """A piece: places of points, their global ids."""
        self.triangles += len(triangles)
        self.clockwise += count_clockwise(places[:, :2], triangles)
        self.corners.append(np.unique(ids[triangles]))
        edges = np.concatenate([triangles[:, [k, (k + 1) % 3, (k + 2) % 3]] for k in range(3)]).astype(np.int64)
        keys, back = (edges[:, i] * len(places) + edges[:, j] for i, j in ((0, 1), (1, 0)))
        self.wrong += len(keys) - len(np.unique(keys))
        lone = edges[~np.isin(keys, back)]
        for (a, b, _), corners in zip(ids[lone].tolist(), places[lone][:, :, :2]):
            other = self.open.pop((b, a), None)
            if other is None:
                self.wrong += (a, b) in self.open
                self.open[a, b] = corners
            else:
                self.between += 1
                found = integers(np.concatenate((corners, other[2:])))
                self.within_circle += found[0] == found[1] or is_in_circle(*found)

    def is_hull_convex(self):
        """Are the edges that are left one ring that never turns right?"""
        after = {a: b for a, b in self.open}
        places = {a: integers(corners[:1])[0] for (a, _), corners in self.open.items()}
        at, ring = next(iter(after)), []
        while at in after:
            ring.append(at)
            at = after.pop(at)
        turns = (left_of(*(places[ring[(k + i) % len(ring)]] for i in range(3))) for k in range(len(ring)))
        return not after and len(ring) == len(self.open) and min(turns) >= 0

    def row(self):
        """What was found, and whether it is right."""
        corners, hull = len(np.unique(np.concatenate(self.corners))), len(self.open)
        row = {"triangles": self.triangles, "euler": 2 * corners - 2 - hull, "clockwise": int(self.clockwise),
               "edges between pieces": self.between, "not Delaunay": self.within_circle, "edges of two": self.wrong,
               "hull": hull, "convex": self.is_hull_convex()}  # fmt: skip
        bad = row["clockwise"] + row["not Delaunay"] + row["edges of two"]
        return row, bad == 0 and row["triangles"] == row["euler"] and row["convex"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lidar", type=Path)
    parser.add_argument("--files", type=int, default=25, help="a square number")
    parser.add_argument("--windows", type=int, default=100)
    parser.add_argument("--cell", type=float, default=1.0)
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--memory", default="4GB")
    parser.add_argument("--work", type=Path, default=Path("build/tiles_laz"))
    parser.add_argument("--keep", action="store_true", help="files and results stay")
    chosen = parser.parse_args()
    chosen.work.mkdir(parents=True, exist_ok=True)
    survey = LazSurvey(chosen.lidar, chosen.work, chosen.files)
    survey.make()
    tin, raster = chosen.work / "made.pvtp", chosen.work / "made.tif"
    words = {"threads": chosen.threads, "memory": chosen.memory, "tin": str(tin), "classes": [2],
             "raster": {"path": str(raster), "cell": chosen.cell}}  # fmt: skip
    row = {"files": len(survey.paths), "bytes": sum(path.stat().st_size for path in survey.paths),
           **tiles.run(survey, tin, words)}  # fmt: skip
    seams = Seams()
    for piece in tilesupport.pieces_of(str(tin)):
        places, data, triangles = tilesupport.read_piece(piece)
        seams.add(places, data["GlobalPointIds"], triangles)
    found, isRight = seams.row()
    wrong, judged = tiles.wrong_windows(survey, raster, chosen.windows, chosen.cell, survey.bounds())
    print(json.dumps({**row, **found, "windows": judged, "wrong windows": wrong}, default=str), flush=True)
    if not chosen.keep:
        shutil.rmtree(chosen.work)
    return int(not isRight or wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
