# SPDX-License-Identifier: BSD-3-Clause
"""One call of another library for living.py, in a process of its own: a line of JSON, with the processor's seconds.

  living_peers.py triangle FILE.domain ANGLE SECONDS | pydelatin RASTER.bin BOUND SECONDS
                | quadric POINTS.bin TRIANGLES.bin COUNT | examples FOLDER | bound FILE.domain | versions
"""
import json
import os
import sys
import time

import numpy as np


def least_time(call, seconds):
    """The least time of several calls in so many seconds, and what the last one returned."""
    first, least = time.process_time(), float("inf")
    while True:
        begin = time.process_time()
        made = call()
        least = min(least, time.process_time() - begin)
        if time.process_time() - first >= seconds:
            return least, made


def read_domain(name):
    """Points, segments and places in holes of a .domain file."""
    with open(name, encoding="ascii") as file:
        words = file.read().split()
    points, segments, holes = (int(word) for word in words[:3])
    ends = 4 + 2 * points
    seeds = ends + 2 * segments
    return (np.array(words[4:ends], float).reshape(-1, 2), np.array(words[ends:seeds], int).reshape(-1, 2),
            np.array(words[seeds:seeds + 2 * holes], float).reshape(-1, 2))  # fmt: skip


def write_domain(name, points, segments, holes):
    """What Triangle keeps of a planar straight-line graph is bounded by loops, which are written with it."""
    import triangle

    given = {"vertices": points, "segments": segments}
    if len(holes):
        given["holes"] = holes
    made = triangle.triangulate(given, "p")
    if len(made["vertices"]) != len(points):
        raise ValueError("%s: segments cross" % name)
    corners = made["triangles"]
    edges = np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)]).astype(np.int64)
    keys = np.sort(edges, axis=1)
    _, first, counts = np.unique(keys, axis=0, return_index=True, return_counts=True)
    after = {}
    for a, b in edges[first[counts == 1]].tolist():
        after.setdefault(a, []).append(b)
    loops = []
    while after:
        begin = at = next(iter(after))
        loop = []
        while at != begin or not loop:
            loop.append(at)
            left = after[at]
            at = left.pop()
            if not left:
                del after[loop[-1]]
        loops.append(loop)
    with open(name, "w", encoding="ascii") as file:
        file.write("%d %d %d %d\n" % (len(points), len(segments), len(holes), len(loops)))
        for rows in (points, segments, holes):
            file.writelines("%r %r\n" % tuple(row) for row in np.asarray(rows).tolist())
        file.writelines("%d %s\n" % (len(loop), " ".join(map(str, loop))) for loop in loops)


def bound(name):
    """Gives a .domain file its loops."""
    write_domain(name, *read_domain(name))
    return {"made": name}


def of_poly(name):
    """Points, segments and holes of a .poly file."""
    with open(name, encoding="ascii") as file:
        words = iter(" ".join(line.split("#")[0] for line in file).split())
    count, _, attributes, markers = (int(next(words)) for _ in range(4))
    rows = [[float(next(words)) for _ in range(3 + attributes + markers)] for _ in range(count)]
    segments, markers = int(next(words)), int(next(words))
    ends = [[int(next(words)) for _ in range(3 + markers)] for _ in range(segments)]
    holes = [[float(next(words)) for _ in range(3)] for _ in range(int(next(words)))]
    first = int(rows[0][0])
    return (np.array(rows)[:, 1:3], np.array(ends)[:, 1:3] - first, np.array(holes).reshape(-1, 3)[:, 1:])


def examples(folder):
    """Those of the installed package, as .domain files; they are not part of this project."""
    import triangle

    data, made = os.path.join(os.path.dirname(triangle.__file__), "data"), []
    for name in ("A", "face", "la", "double_hex", "double_hex2", "square_circle_hole"):
        try:
            write_domain(os.path.join(folder, name + ".domain"), *of_poly(os.path.join(data, name + ".poly")))
            made.append(name)
        except (KeyError, OSError, ValueError) as error:
            print(name, repr(error), file=sys.stderr)
    return {"made": made}


def run_triangle(name, angle, seconds):
    import triangle

    points, segments, holes = read_domain(name)
    given = {"vertices": points, "segments": segments}
    if len(holes):
        given["holes"] = holes
    least, made = least_time(lambda: triangle.triangulate(given, "pq" + angle), float(seconds))
    return {"steiner": len(made["vertices"]) - len(points), "triangles": len(made["triangles"]), "seconds": least}


def run_pydelatin(name, bound, seconds):
    from pydelatin import Delatin

    heights = np.fromfile(name)[2::3].astype(np.float32)
    side = int(round(len(heights) ** 0.5))
    least, made = least_time(lambda: Delatin(heights.reshape(side, side), max_error=float(bound)), float(seconds))
    return {"vertices": len(made.vertices), "triangles": len(made.triangles), "seconds": least}


def run_quadric(points, triangles, count):
    """vtkQuadricDecimation to so many triangles; the largest vertical error at every tenth point below the result."""
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

    given, corners = np.fromfile(points).reshape(-1, 3), np.fromfile(triangles, np.int32)

    def surface(places, cells):
        made, held = vtk.vtkPolyData(), vtk.vtkPoints()
        held.SetData(numpy_to_vtk(places, deep=1))
        made.SetPoints(held)
        made.SetPolys(cells)
        return made

    cells = vtk.vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners.astype(np.int64), deep=1))
    work = vtk.vtkQuadricDecimation()
    work.SetInputData(surface(given, cells))
    work.SetTargetReduction(1.0 - float(count) / (len(corners) / 3))
    begin = time.process_time()
    work.Update()
    seconds, made = time.process_time() - begin, work.GetOutput()
    places = vtk_to_numpy(made.GetPoints().GetData()).astype(float)
    flat = surface(places * (1, 1, 0), made.GetPolys())
    heights = numpy_to_vtk(places[:, 2].copy(), deep=1)
    heights.SetName("z")
    flat.GetPointData().AddArray(heights)
    asked = given[::10]
    probe = vtk.vtkProbeFilter()
    probe.SetInputData(surface(asked * (1, 1, 0), vtk.vtkCellArray()))
    probe.SetSourceData(flat)
    probe.Update()
    data = probe.GetOutput().GetPointData()
    found = vtk_to_numpy(data.GetArray("vtkValidPointMask")) > 0
    errors = np.abs(vtk_to_numpy(data.GetArray("z")) - asked[:, 2])[found]
    return {"triangles": made.GetNumberOfPolys(), "error": float(errors.max()), "seconds": seconds}


def versions():
    from importlib import metadata

    return {name: metadata.version(name) for name in ("numpy", "vtk", "triangle", "pydelatin")}


if __name__ == "__main__":
    WORK = {"triangle": run_triangle, "pydelatin": run_pydelatin, "quadric": run_quadric, "examples": examples,
            "bound": bound, "versions": versions}  # fmt: skip
    print(json.dumps(WORK[sys.argv[1]](*sys.argv[2:])))
