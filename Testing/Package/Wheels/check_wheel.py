#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Run in a venv with nothing but the wheel: is it complete, and are the triangles those of Data/Hashes?

    python check_wheel.py DATA
"""

import importlib.metadata
import math
import os
import sys

import numpy as np

import adaptivehilbertdelaunay
from adaptivehilbertdelaunay import _library as library

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from numbered import Hash  # noqa: E402

DATA = sys.argv[1]


def read_points(path):
    with open(path, encoding="utf-8") as lines:
        rows = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    return np.array([[float.fromhex(word) for word in row] for row in rows], dtype=float).reshape(-1, 2)


def hash_of(points):
    job = library.Job()
    job.set_array("points", points)
    job.run()
    made = Hash()
    made.add(0, 0, 0, 0)  # the status of each call
    made.add(*(job.count(name) for name in ("inserted", "beyond_limit", "duplicates", "not_finite", "skipped")))
    made.add(job.count("kept_triangles"))
    for name in ("triangles", "point_status", "neighbors"):
        array = job.array(name, np.int64)
        made.add(array.size, *array.ravel().tolist())
    return made.text()


def check_hashes():
    expected = {}
    with open(os.path.join(DATA, "Hashes", "Engine.txt"), encoding="utf-8") as lines:
        for line in lines:
            if not line.startswith("#"):
                value, name = line.split()
                expected[name] = value
    checked = 0
    for name in sorted(os.listdir(os.path.join(DATA, "Corpus"))):
        if "corpus/" + name in expected:
            found = hash_of(read_points(os.path.join(DATA, "Corpus", name)))
            assert found == expected["corpus/" + name], "%s: %s, not %s" % (name, found, expected["corpus/" + name])
            checked += 1
    assert checked >= 40, "only %d files" % checked
    print("%d hashes are those of Data/Hashes/Engine.txt" % checked)


def check_example():
    grid = np.stack(np.meshgrid(np.arange(5.0), np.arange(4.0)), axis=-1).reshape(-1, 2)
    made = adaptivehilbertdelaunay.delaunay(grid)
    assert made.triangles.shape == (24, 3), made.triangles.shape
    a, b, c = (grid[made.triangles[:, k]] for k in range(3))
    area = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    assert (area > 0).all() and math.isclose(area.sum(), 12.0)


def main():
    found = importlib.metadata.version("adaptivehilbertdelaunay")
    assert library.version() == found, (library.version(), found)
    folders = [os.path.abspath(folder) for folder in adaptivehilbertdelaunay.__path__]
    assert os.path.dirname(library.library_path()) in folders, library.library_path()
    assert "vtkmodules" not in sys.modules
    check_example()
    check_hashes()
    print("adaptivehilbertdelaunay %s on Python %s, NumPy %s" % (found, sys.version.split()[0], np.__version__))


if __name__ == "__main__":
    main()
