# SPDX-License-Identifier: BSD-3-Clause
"""Downstream filters of a surface over several ranks give the results of one rank, and so does drawing it.

    RunBehind.py RANKS MPIEXEC...    mpiexec and what goes before the program, such as mpiexec -n 4
"""

import json
import os
import sys

import numpy
from PIL import Image

from pluginsupport import SCRATCH, check, check_equal, run
from RunClientServer import read_log, start_server, stop_server

RANKS, MPIEXEC = int(sys.argv[1]), sys.argv[2:]
SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "BehindScript.py")
PVBATCH = [os.environ["AHD_PVBATCH"], "--dr"]


def results(name, start):
    """The numbers and pictures of one way to run the script; start(variables) returns status and output."""
    folder = os.path.join(SCRATCH, name)
    os.makedirs(folder, exist_ok=True)
    status, printed = start({"AHD_SCRATCH": folder})
    check_equal(status, 0, "exit status of " + name)
    check("ERR|" not in printed and "ERROR:" not in printed, name + " says that something failed")
    with open(os.path.join(folder, "numbers.json")) as file:
        numbers = json.load(file)
    pictures = {}
    for kind in ("surface", "edges"):
        with Image.open(os.path.join(folder, kind + ".png")) as picture:
            pictures[kind] = numpy.asarray(picture.convert("RGB"), int)
    return numbers, pictures


def on_server(variables):
    server, port = start_server(MPIEXEC + [os.environ["AHD_PVSERVER"]])
    try:
        return run([os.environ["AHD_PVPYTHON"], "--dr", SCRIPT, port], **variables)
    finally:
        stop_server(server)
        print(read_log())


def compare(name, found, expected):
    numbers, pictures = found
    wanted, drawn = expected
    check_equal(numbers.pop("ranks"), RANKS, "ranks of " + name)
    # A rank also has points of others: so each has its own.
    check(numbers.pop("points") >= POINTS + 10 * RANKS, name + ": the ranks do not share the surface")
    check_equal(set(numbers), set(wanted), "numbers of " + name)
    for what, value in wanted.items():
        check(abs(numbers[what] - value) <= 1e-9 * abs(value), "%s: %s is %r, with one rank %r" % (
            name, what, numbers[what], value))
    for kind, picture in drawn.items():
        off = abs(pictures[kind] - picture).max(axis=2) > 40
        check(off.mean() < 0.002, "%s, %s: %.2f %% of the picture differ" % (name, kind, 100 * off.mean()))
    blue = [(picture == [0, 0, 255]).all(axis=2).sum() for picture in (pictures["surface"], drawn["surface"])]
    check(abs(blue[0] - blue[1]) <= 20, "%s: %d background pixels, with one rank %d" % (name, *blue))


alone = results("alone", lambda variables: run(PVBATCH + [SCRIPT], **variables))
numbers = alone[0]
check_equal(numbers.pop("ranks"), 1, "ranks")
POINTS = numbers.pop("points")
for what in ("cells", "extracted cells", "redistributed cells"):
    check_equal(numbers[what], numbers["triangles"], what)
check(numbers["contour"] > 1 and numbers["slice"] > 1 and numbers["area"] > 0.9, "no contour, slice or area")
compare("batch", results("batch", lambda variables: run(MPIEXEC + PVBATCH + [SCRIPT], **variables)), alone)
compare("server", results("server", on_server), alone)
print("passed: behind")
