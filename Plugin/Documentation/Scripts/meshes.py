# SPDX-License-Identifier: BSD-3-Clause
"""The filter's surface and insertion order as arrays, and what the figures show of them."""

import collections

import numpy
from paraview import simple
from paraview.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

# xy: all points, n × 2 · triangles: ids of corners, t × 3 · order: ids of the points inserted, in the order
# of insertion · boxes: corners, b × 4 × 2, as visited · levels, counts: of the boxes · np, nr: per point
Run = collections.namedtuple("Run", "xy triangles order boxes levels counts np nr")

LONG = 4.0  # a triangle with a larger aspect ratio is drawn as a long one


# --- from the filter ----------------------------------------------------------------------------


def source(distribution, count, seed=1):
    """A proxy of points: a Planar Point Source."""
    return simple.PlanarPointSource(Distribution=distribution, NumberOfPoints=count, Seed=seed)


def triangulate(points, limit=0, **settings):
    """Runs the filter on a proxy of points, as far as the limit-th point, and fetches a Run."""
    proxy = simple.AdaptiveHilbertDelaunay2D(
        Input=points, InsertionLimit=limit, GenerateInsertionCurve=1, GenerateBoxes=1, CountWork=1, **settings
    )
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    outputs = proxy.GetClientSideObject()
    surface, order = (outputs.GetOutputDataObject(port) for port in (0, 1))
    xy = coordinates(surface)
    ids = vtk_to_numpy(order.GetPointData().GetArray("OriginalPointIds"))
    levels = vtk_to_numpy(order.GetCellData().GetArray("Level"))
    counts = vtk_to_numpy(order.GetCellData().GetArray("Count"))
    boxes = polygons(order.GetPolys(), 4)
    run = Run(
        xy, polygons(surface.GetPolys(), 3), ids[ids >= 0].copy(), coordinates(order)[boxes],
        levels[levels >= 0].copy(), counts[levels >= 0].copy(),
        proxy.GetPropertyValue("NP"), proxy.GetPropertyValue("NR"))  # fmt: skip
    simple.Delete(proxy)
    return run


def count_work(points, **settings):
    """(NP, NR) of the filter on a proxy of points."""
    proxy = simple.AdaptiveHilbertDelaunay2D(Input=points, CountWork=1, **settings)
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    counts = proxy.GetPropertyValue("NP"), proxy.GetPropertyValue("NR")
    simple.Delete(proxy)
    return counts


def coordinates(data):
    return vtk_to_numpy(data.GetPoints().GetData())[:, :2].astype(float)


def polygons(cells, corners):
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, corners).copy()


# --- to VTK -------------------------------------------------------------------------------------


def polydata(points, lines=None, faces=None, vertices=False, values=None):
    """A vtkPolyData of points (n × 3), lines (lists of ids), faces (ids, f × corners), a vertex for each
    point; values become the point array "value"."""
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=float), deep=1))
    data.SetPoints(places)
    if lines is not None:
        data.SetLines(cell_array(lines))
    if faces is not None:
        data.SetPolys(equal_cells(faces))
    if vertices:
        data.SetVerts(equal_cells(numpy.arange(len(points)).reshape(-1, 1)))
    if values is not None:
        array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=float), deep=1)
        array.SetName("value")
        data.GetPointData().AddArray(array)
    return data


def equal_cells(ids):
    cells = vtkCellArray()
    flat = numpy.ascontiguousarray(ids, dtype=numpy.int64).ravel()
    cells.SetData(len(ids[0]), numpy_to_vtk(flat, deep=1, array_type=VTK_ID_TYPE))
    return cells


def cell_array(lines):
    cells = vtkCellArray()
    for line in lines:
        cells.InsertNextCell(len(line))
        for point in line:
            cells.InsertCellPoint(int(point))
    return cells


def producer(data):
    proxy = simple.TrivialProducer()
    proxy.GetClientSideObject().SetOutput(data)
    return proxy


# --- geometry -----------------------------------------------------------------------------------


def aspect_ratios(xy, triangles):
    """The aspect ratio of ParaView's filter Mesh Quality: 1 for an equilateral triangle."""
    a, b, c = (xy[triangles[:, k]] for k in range(3))
    sides = numpy.stack([numpy.hypot(*(q - p).T) for p, q in ((a, b), (b, c), (c, a))])
    area = 0.5 * numpy.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    return sides.max(axis=0) * sides.sum(axis=0) / numpy.maximum(4.0 * numpy.sqrt(3.0) * area, 1e-300)


def without(triangles, others):
    """Which triangles (as a mask) are not among the others, whatever corner they begin with."""
    both = numpy.sort(numpy.vstack([triangles, others]), axis=1).astype(numpy.int64)
    most = both.max(initial=0) + 1
    keys = (both[:, 0] * most + both[:, 1]) * most + both[:, 2]
    return ~numpy.isin(keys[: len(triangles)], keys[len(triangles) :])


def walked(xy, triangles, start, goal):
    """Which triangles (as a mask) the straight way between two places crosses."""
    way = goal - start
    along = (xy - start) @ way / (way @ way)  # 0 at the start, 1 at the goal
    side = (xy - start) @ numpy.array([-way[1], way[0]])
    first, last = numpy.full(len(triangles), numpy.inf), numpy.full(len(triangles), -numpy.inf)
    for p, q in ((triangles[:, k], triangles[:, (k + 1) % 3]) for k in range(3)):
        crossed = side[p] * side[q] < 0
        share = side[p] / numpy.where(crossed, side[p] - side[q], 1.0)
        meeting = along[p] + share * (along[q] - along[p])
        first = numpy.where(crossed, numpy.minimum(first, meeting), first)
        last = numpy.where(crossed, numpy.maximum(last, meeting), last)
    return (last > 0) & (first < 1)


def jumps(boxes):
    """Which steps from box to box (as a mask) lead to a box that does not touch it along an edge."""
    low, high = boxes.min(axis=1), boxes.max(axis=1)
    shared = numpy.minimum(high[1:], high[:-1]) - numpy.maximum(low[1:], low[:-1])
    tiny = 1e-9 * (high.max(axis=0) - low.min(axis=0))
    return (shared < -tiny).any(axis=1) | (shared < tiny).all(axis=1)


def circumcircle(corners):
    """Centre and radius of the circle through three places."""
    a, b, c = corners
    matrix = 2.0 * numpy.array([b - a, c - a])
    centre = numpy.linalg.solve(matrix, numpy.array([b @ b - a @ a, c @ c - a @ a]))
    return centre, float(numpy.hypot(*(a - centre)))
