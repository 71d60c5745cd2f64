#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One peer with a Python interface, triangulating one file of points in this process.

    peer_process.py PEER POINTS TRIANGLES VERTICES
    peer_process.py PEER --version

Each function below is one peer. It takes the points, an array (n, 2) of doubles, brings them into the peer's
own form, and returns two functions: `call`, which is timed and leaves the triangles in the peer's own form,
and `result`, which afterwards gives (triples, vertices): ids of the points and None, or ids of `vertices`
where the peer has vertices of its own. Protocol and figures are those of PeerFiles.h, timeCall.

Runs in the peer's own Python: it may import nothing of the other files here.
"""
import importlib
import json
import os
import sys
import time

import numpy as np


def vtk_points(points):
    """A vtkPolyData with these points, z = 0."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    coordinates = np.zeros((len(points), 3))
    coordinates[:, :2] = points
    holder = vtkPoints()
    holder.SetDataTypeToDouble()
    holder.SetData(numpy_to_vtk(coordinates, deep=1))
    data = vtkPolyData()
    data.SetPoints(holder)
    return data


def vtk_result(output, points):
    """The triangles of a vtkPolyData, and its points unless they are the input's."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    polys = output.GetPolys()
    offsets = vtk_to_numpy(polys.GetOffsetsArray())
    if len(offsets) > 1 and not np.all(np.diff(offsets) == 3):
        raise RuntimeError("the output has polygons that are no triangles")
    triples = vtk_to_numpy(polys.GetConnectivityArray())
    coordinates = np.empty((0, 2))
    if output.GetNumberOfPoints():
        coordinates = vtk_to_numpy(output.GetPoints().GetData())[:, :2].astype(float)
    return triples, None if np.array_equal(coordinates, points) else coordinates


def limit_vtk_threads(threads):
    """1, or more by VTK's STDThread; 0: one per processor."""
    from vtkmodules.vtkCommonCore import vtkSMPTools

    if threads == 1:
        vtkSMPTools.SetBackend("Sequential")
    else:
        vtkSMPTools.SetBackend("STDThread")
        vtkSMPTools.Initialize(threads or len(os.sched_getaffinity(0)))


def delaunay2d(points, tolerance=None, hilbert=False):
    from vtkmodules.vtkFiltersCore import vtkDelaunay2D

    limit_vtk_threads(1)
    peer = vtkDelaunay2D()
    if tolerance is not None:
        peer.SetTolerance(tolerance)
    if hilbert:
        peer.UseHilbertSorterOn()
    peer.SetInputData(vtk_points(points))
    return peer.Update, lambda: vtk_result(peer.GetOutput(), points)


def flower2d(points, threads=1, careful=False):
    from vtkmodules.vtkFiltersMeshing import vtkVoronoiFlower2D

    limit_vtk_threads(threads)
    peer = vtkVoronoiFlower2D()
    peer.SetOutputTypeToDelaunay()
    if careful:
        peer.SetPadding(peer.GetPaddingMaxValue())
        peer.ValidateOn()
    peer.SetInputData(vtk_points(points))
    return peer.Update, lambda: vtk_result(peer.GetOutput(1), points)


def scipy(points):
    from scipy.spatial import Delaunay

    made = []
    return lambda: made.append(Delaunay(points).simplices), lambda: (made[0], None)


def geos(points):
    import shapely

    multipoint = shapely.multipoints(points)
    made = []

    def result():
        corners = shapely.get_coordinates(made[0]).reshape(-1, 4, 2)[:, :3]  # closed rings
        return np.arange(3 * len(corners)), corners.reshape(-1, 2)

    return lambda: made.append(shapely.delaunay_triangles(multipoint)), result


def startinpy(points, snap=None, jump=False):
    from startinpy import DT

    coordinates = np.zeros((len(points), 3))
    coordinates[:, :2] = points
    peer = DT()
    if snap is not None:
        peer.snap_tolerance = snap
    peer.jump_and_walk = jump
    made = []

    def call():
        peer.insert(coordinates)
        made.append(peer.triangles)

    return call, lambda: (made[0], np.asarray(peer.points)[:, :2].astype(float))


def triangle(points):
    from triangle import delaunay

    made = []
    return lambda: made.append(delaunay(points)), lambda: (made[0], None)


def dylaunator(points):
    from dylaunator import Delaunator

    flat = points.ravel().tolist()
    made = []
    return lambda: made.append(Delaunator(flat).triangles), lambda: (np.array(made[0]), None)


def cdt(points):
    import pythoncdt

    peer = pythoncdt.Triangulation(
        pythoncdt.VertexInsertionOrder.AUTO, pythoncdt.IntersectingConstraintEdges.NOT_ALLOWED, 0.0)

    def call():
        peer.insert_vertices(points)
        peer.erase_super_triangle()

    return call, lambda: (np.ascontiguousarray(peer.triangles_array()["vertices"]), None)


PEERS = {
    "vtk91": delaunay2d,
    "paraview": delaunay2d,
    "vtk97": delaunay2d,
    "vtk97-hilbert": lambda points: delaunay2d(points, hilbert=True),
    "vtk97-hilbert-tolerance0": lambda points: delaunay2d(points, tolerance=0.0, hilbert=True),
    "vtk97-flower": flower2d,
    "vtk97-flower-careful": lambda points: flower2d(points, careful=True),
    "vtk97-flower-threads": lambda points: flower2d(points, threads=0),
    "scipy": scipy,
    "geos": geos,
    "startinpy": startinpy,
    "startinpy-nosnap": lambda points: startinpy(points, snap=1e-300, jump=True),
    "triangle": triangle,
    "dylaunator": dylaunator,
    "cdt": cdt,
}


def version(peer):
    """The running version, by its own report, and VTK's library; an exception if it is missing."""
    if peer.startswith(("vtk", "paraview")):
        from vtkmodules.vtkCommonCore import vtkVersion

        name = "vtkFiltersMeshing" if "flower" in peer else "vtkFiltersCore"
        importlib.import_module("vtkmodules." + name)
        with open("/proc/self/maps", encoding="utf-8") as maps:
            library = next((line.split()[-1] for line in maps if "/lib" + name in line), "")
        return {"version": "VTK " + vtkVersion.GetVTKVersion(), "library": library}
    if peer == "geos":
        import shapely

        return {"version": "GEOS {}.{}.{}, shapely ".format(*shapely.geos_version) + shapely.__version__}
    module = {"startinpy-nosnap": "startinpy", "cdt": "pythoncdt"}.get(peer, peer)
    importlib.import_module("scipy.spatial" if module == "scipy" else module)
    from importlib.metadata import version as version_of

    return {"version": f"{module} {version_of(module)}"}


def memory(name):
    """A line of /proc/self/status, in bytes."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next((1024 * int(line.split()[1]) for line in status if line.startswith(name)), 0)


def forget_peak():
    try:
        with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
            file.write("5")
    except OSError:
        pass


def say(word):
    print(word, flush=True)


def main():
    peer, *files = sys.argv[1:]
    if files == ["--version"]:
        say(json.dumps(version(peer)))
        return
    points = np.fromfile(files[0]).reshape(-1, 2)
    call, result = PEERS[peer](points)
    figures = {"peakBefore": memory("VmHWM:")}
    forget_peak()
    figures["held"] = memory("VmRSS:")
    say("call")
    wall = time.perf_counter()
    cpu = time.process_time()
    call()
    figures["cpu"] = time.process_time() - cpu
    figures["wall"] = time.perf_counter() - wall
    figures["peak"] = memory("VmHWM:")
    say("called")
    triples, vertices = result()
    triples = np.asarray(triples).reshape(-1)
    limits = np.iinfo(np.int32)
    np.clip(triples, -1, limits.max, dtype=np.int64, casting="unsafe").astype(np.int32).tofile(files[1])
    if vertices is not None:
        vertices.tofile(files[2])
    say("done " + json.dumps(figures))


if __name__ == "__main__":
    main()
