#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The installed library beside another: in turns, on one processor, one thread, 10^6 uniform points.

    python measure_wheel.py OTHER_LIBRARY

Prints the CPU seconds of run and triangles: the least and the median of all turns, and by how much the
wheel's differ. Figures to be read, not a test.
"""

import os
import statistics
import subprocess
import sys

TURNS = 9

CHILD = """
import time
import numpy as np
from adaptivehilbertdelaunay import _library as library

points = np.random.default_rng(1).random((1000000, 2))
job = library.Job()
job.set(threads=1)
for _ in range(3):
    job.set_array("points", points)
    begin = time.process_time()
    job.run()
    job.array("triangles", np.int32)
    print(time.process_time() - begin)
"""


def seconds_of(path):
    environment = dict(os.environ, ADAPTIVEHILBERTDELAUNAY_LIBRARY=path, PYTHONDONTWRITEBYTECODE="1")
    ran = subprocess.run([sys.executable, "-c", CHILD], env=environment, check=True, stdout=subprocess.PIPE, text=True)
    return [float(line) for line in ran.stdout.split()]


def main():
    from adaptivehilbertdelaunay import _library as library

    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    paths = {"wheel": library.library_path(), "other": os.path.abspath(sys.argv[1])}
    found = {name: [] for name in paths}
    for turn in range(TURNS):
        for name in sorted(paths, reverse=turn % 2 == 0):
            found[name] += seconds_of(paths[name])
    for name, seconds in found.items():
        print("%s: least %.3f s, median %.3f s  %s" % (name, min(seconds), statistics.median(seconds), paths[name]))
    least, median = (100 * (of(found["wheel"]) / of(found["other"]) - 1) for of in (min, statistics.median))
    print("the wheel takes %+.1f %% (least), %+.1f %% (median)" % (least, median))


if __name__ == "__main__":
    main()
