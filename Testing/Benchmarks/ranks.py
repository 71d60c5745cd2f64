# SPDX-License-Identifier: BSD-3-Clause
"""Medians and least times of RanksBenchmark's output, for ranks.sh.

ranks.py FILE    lines of JSON
"""

import json
import statistics
import sys

COLUMNS = ["seconds", "move", "rest", "own", "shared", "output", "bytesPerPoint"]


def read(path):
    """The runs of each way, by (ranks, threads)."""
    ways = {}
    with open(path) as file:
        for line in file:
            run = json.loads(line)
            run["rest"] = run["seconds"] - run["move"]
            ways.setdefault((run["ranks"], run["threads"]), []).append(run)
    return ways


def show(ways):
    print("%d points, %d triangles; seconds, median (least); move: points to their owners; rest: all else" % (
        ways[1, 1][0]["points"], ways[1, 1][0]["triangles"]))
    print("| ranks x threads | " + " | ".join(COLUMNS) + " |")
    print("|---" * (len(COLUMNS) + 1) + "|")
    for (ranks, threads), runs in sorted(ways.items()):
        cells = []
        for name in COLUMNS:
            values = [run[name] for run in runs]
            digits = 1 if name == "bytesPerPoint" else 3
            cells.append("%.*f (%.*f)" % (digits, statistics.median(values), digits, min(values)))
        print("| %d x %d | %s |" % (ranks, threads, " | ".join(cells)))
    for what, choose in (("medians", statistics.median), ("least times", min)):
        one = choose([run["seconds"] for run in ways[1, 1]])
        two = choose([run["rest"] for run in ways[2, 1]])
        whole = choose([run["seconds"] for run in ways[2, 1]])
        print("%s: two ranks %.2f times as fast as one, moving not counted; %.2f with it" % (
            what, one / two, one / whole))


all_ways = read(sys.argv[1])
counts = {run["triangles"] for runs in all_ways.values() for run in runs}
if len(counts) != 1:
    sys.exit("numbers of triangles differ: %r" % counts)
show(all_ways)
