# SPDX-License-Identifier: BSD-3-Clause
"""Memory that features take at each door, and its estimates. Requires: CountedMemory before malloc."""

import collections
import ctypes
import functools
import gc
import importlib
import json
import warnings
from pathlib import Path

import numpy as np

import adaptivehilbertdelaunay
from adaptivehilbertdelaunay import delaunay
from adaptivehilbertdelaunay._keywords import WANTED
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData

COUNTED = ctypes.CDLL(None)
COUNTED.counted_held.restype = COUNTED.counted_most.restype = ctypes.c_long
COUNT = 60000  # so many points that the megabyte of each estimate is a small part
NAMES = "vtkAdaptiveHilbertDelaunay2D", "vtkAdaptiveHilbertInterpolation2D"

python_class = importlib.import_module("adaptivehilbertdelaunay._vtk").python_class
CLASSES = {
    "compiled": {name: getattr(adaptivehilbertdelaunay, name) for name in NAMES},
    "in Python": {name: python_class("vtkmodules", name) for name in NAMES}}

#: `estimate`, `most`: bytes. `said`: errors.
Taken = collections.namedtuple("Taken", "estimate most said")


def taken_by(work):
    """The most bytes held while it runs, beyond those before; and its result."""
    gc.collect()
    gc.disable()
    try:
        before = COUNTED.counted_held()
        COUNTED.counted_begin()
        made = work()
        return COUNTED.counted_most() - before, made
    finally:
        gc.enable()


# --- Inputs -------------------------------------------------------------------------------------------------


@functools.lru_cache(None)
def uniform():
    """In x and y; z is a plane's, nearly."""
    points = np.random.default_rng(1).random((COUNT, 3))
    points[:, 2] = 0.1 * points[:, 0] + 1e-4 * points[:, 2]
    return points


@functools.lru_cache(None)
def pairs():
    """Each place has two points."""
    return np.concatenate([uniform()[:COUNT // 2], uniform()[:COUNT // 2] + [0, 0, 1]])


def circle(count, radius=0.4):
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.c_[0.5 + radius * np.cos(angles), 0.5 + radius * np.sin(angles), 0 * angles]


@functools.lru_cache(None)
def curve():
    x = np.linspace(0, 1, COUNT // 4)
    return np.c_[x, 0.5 + 0.3 * np.sin(30 * x), 0 * x]


@functools.lru_cache(None)
def short_segments():
    """Of which some cross."""
    random = np.random.default_rng(2)
    ends = random.random((COUNT // 4, 3))
    ends[1::2] = ends[::2] + 0.02 * (random.random((COUNT // 8, 3)) - 0.5)
    return ends


def data_of(points, arrays=0):
    """`arrays`: how many of three doubles, or the types of such with one number."""
    made, data = vtkPoints(), vtkPolyData()
    made.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=1))
    data.SetPoints(made)
    for k, kind in enumerate(arrays * (None,) if isinstance(arrays, int) else arrays):
        numbers = 9 * np.random.default_rng(k).random((len(points), 1 if kind else 3))
        values = numpy_to_vtk(numbers.astype(kind or np.float64), deep=1)
        values.SetName("a%d" % k)
        data.GetPointData().AddArray(values)
    return data


def cells_of(chains):
    made = vtkCellArray()
    for chain in chains:
        made.InsertNextCell(len(chain))
        for point in chain:
            made.InsertCellPoint(point)
    return made


def source_of(points, lines=(), polygons=()):
    data = data_of(points)
    data.SetLines(cells_of(lines))
    data.SetPolys(cells_of(polygons))
    return data


#: A feature. `settings`: of the class. `keywords`: of `delaunay`, None where it has none of these; `asks`: its arrays.
#: `points`, `source` make the input: (points, lines, polygons). `most`: the estimate is at most so many times what is
#: taken: 1.5 for uniform points; 2 where the input is the worst, or decides how much of an output there is; 4 where
#: each point has a segment, as how many cross or leave their part of the mesh is not known before.
Feature = collections.namedtuple("Feature", "name settings keywords asks points arrays source most")


def feature(name, settings=None, keywords=None, asks=(), points=uniform, arrays=0, source=None, most=1.5):
    return Feature(name, settings or {}, keywords, asks, points, arrays, source, most)


TABLE = json.loads((Path(__file__).resolve().parents[2] / "Support" / "settings.json").read_text(encoding="utf-8"))


def all_outputs():
    return {name: True for name in TABLE["delaunay"]["settings"] if name.startswith("Generate")}


def other_arrays(known):
    """Features of the arrays for which there is none among `known`."""
    settings = [name for of in known for name in of.settings]
    return tuple(feature(row["job"].replace("_", " "), {row["setting"]: True}, {}, ["triangles", row["job"]])
                 for row in TABLE["arrays"].values() if row["setting"] and row["setting"] not in settings)


def line():
    return curve(), [range(len(curve()))], ()


def ring():
    return circle(1000), (), [range(1000)]


def segments():
    return short_segments(), [(k, k + 1) for k in range(0, len(short_segments()), 2)], ()


def on_circle():
    return circle(COUNT)


SIDE = int(COUNT**0.5)


def lattice():
    x, y = np.meshgrid(np.arange(SIDE), np.arange(SIDE))
    return np.c_[x.ravel(), y.ravel(), 0 * x.ravel()].astype(float)


def lattice_lines():
    """From side to side through all points: a region for each square, by few segments. Ids of the input."""
    last = SIDE - 1
    return (np.empty((0, 3)), [(SIDE * k, SIDE * k + last) for k in range(SIDE)] +
            [(k, SIDE * last + k) for k in range(SIDE)], ())


def along():
    """All points on one line, as contours have them."""
    x = np.linspace(0, 1, COUNT)
    return np.c_[x, 0.3 * np.sin(30 * x), 0 * x]


def line_through_all():
    return np.empty((0, 3)), [range(COUNT)], ()


SIZE = COUNT**-0.5  # the spacing of the points
SPLIT = dict(SourceMode=1, CrossingMode=1)

FEATURES = (
    feature("triangles", {}, {}, ["triangles"]),
    feature("of floats", {}, {}, ["triangles"], points=lambda: uniform().astype(np.float32)),
    feature("of whole numbers", points=lambda: (1e6 * uniform()).astype(np.int32)),
    feature("of points on a circle", {}, {}, ["triangles"], points=on_circle),
    feature("of pairs of points", {}, {}, ["triangles"], points=pairs, most=2),
    feature("neighbors", dict(GenerateNeighbors=True), {}, ["triangles", "neighbors"]),
    feature("region ids", dict(GenerateRegionIds=True), {}, ["triangles", "regions"]),
    feature("constraint edges", dict(GenerateConstraintEdges=True), {}, ["triangles"]),
    feature("point status", dict(GeneratePointStatus=True), {}, ["triangles", "point_status"]),
    feature("insertion rank", dict(GenerateInsertionRank=True), {}, ["triangles", "insertion_ranks"]),
    feature("insertion curve", dict(GenerateInsertionCurve=True)),
    feature("boxes", dict(GenerateBoxes=True)),
    feature("boxes, Nmax 1", dict(GenerateBoxes=True, Nmax=1)),
    feature("another order", dict(InsertionOrder=2), {"insertion_order": "regular_grid"}, ["triangles"]),
    feature("half of the points", dict(InsertionLimit=COUNT // 2), {"insertion_limit": COUNT // 2}, ["triangles"]),
    feature("Voronoi cells", dict(GenerateVoronoi=True), {}, ["triangles", "voronoi"]),
    feature("Voronoi cells, 4 arrays", dict(GenerateVoronoi=True), arrays=4),
    feature("Voronoi cells, circle", dict(GenerateVoronoi=True), points=on_circle),
    feature("Voronoi cells, polygon", dict(GenerateVoronoi=True, VoronoiClip=2, VoronoiPolygon="0 0, 1 0, 0 1"),
            {"voronoi_clip": [[0, 0], [1, 0], [0, 1]]}, ["triangles", "voronoi"], most=2),
    feature("best-fitting plane", dict(ProjectionPlaneMode=2), {"plane": "best_fit"}, ["triangles"]),
    feature("plane and Voronoi cells", dict(ProjectionPlaneMode=2, GenerateVoronoi=True)),
    feature("bounding triangulation", dict(BoundingTriangulation=True), {"bounding": True}, ["triangles"]),
    feature("bounding, 4 arrays", dict(BoundingTriangulation=True), arrays=4),
    feature("tolerance", dict(Tolerance=1e-5), {"tolerance": 1e-5}, ["triangles"]),
    feature("lowest z", dict(DuplicatePolicy=1), {"duplicates": "lowest_z"}, ["triangles"]),
    feature("lowest z of pairs", dict(DuplicatePolicy=1), {"duplicates": "lowest_z"}, ["triangles"], points=pairs,
            most=2),
    feature("mean z", dict(DuplicatePolicy=3), {"duplicates": "mean_z"}, ["triangles", "points"]),
    feature("mean z of pairs", dict(DuplicatePolicy=3), {"duplicates": "mean_z"}, ["triangles", "points"],
            points=pairs, most=2),
    feature("edge length", dict(MaximumEdgeLength=3 * SIZE), {"maximum_edge_length": 3 * SIZE}, ["triangles"]),
    feature("alpha, nearly all", dict(Alpha=3 * SIZE), {"alpha": 3 * SIZE}, ["triangles", "lines"], most=2),
    feature("alpha, half", dict(Alpha=0.6 * SIZE), {"alpha": 0.6 * SIZE}, ["triangles", "lines"], most=2),
    feature("line of n/4 points", dict(SourceMode=1), {}, ["triangles"], source=line),
    feature("line, 4 arrays", dict(SourceMode=1), arrays=4, source=line),
    feature("line on the surface", dict(SourceMode=1, SourceHeights=1), {"source_heights": "surface"}, ["triangles"],
            source=line),
    feature("mixed heights", dict(SourceMode=1, SourceHeights=2), {"source_heights": "mixed"}, ["triangles"],
            source=line),
    feature("line in short pieces", dict(SourceMode=1, MaximumSegmentLength=0.1 * SIZE),
            {"maximum_segment_length": 0.1 * SIZE}, ["triangles"], source=line),
    feature("loop", dict(SourceMode=1), {}, ["triangles"], source=ring),
    feature("loop and its regions", dict(SourceMode=1, GenerateRegionIds=True, GenerateConstraintEdges=True,
                                         GenerateNeighbors=True), {}, ["triangles", "regions"], source=ring, most=2),
    feature("regions of a lattice", dict(GenerateRegionIds=True), points=lattice, source=lattice_lines, most=2),
    feature("line through all points", points=along, source=line_through_all),
    feature("n/8 short segments", dict(SourceMode=1), {}, ["triangles"], source=segments),
    feature("of which some are split", SPLIT, {"crossings": "split"}, ["triangles"], source=segments, most=2))
FEATURES += other_arrays(FEATURES) + (
    feature("all outputs", all_outputs(), most=2),
    feature("all, of segments", dict(all_outputs(), **SPLIT), source=segments, most=2),
    feature("simplified, few left", dict(MaximumError=1e-2), {"maximum_error": 1e-2}, ["triangles"], most=3),
    feature("simplified, most left", dict(MaximumError=1e-6), {"maximum_error": 1e-6}, ["triangles"], most=2))


# --- Doors --------------------------------------------------------------------------------------------------


def listen(algorithm):
    said = []
    algorithm.AddObserver("ErrorEvent", lambda *_: said.append("error"))
    algorithm.AddObserver("WarningEvent", lambda *_: None)
    return said


def make_filter(of, door, limit=0):
    """The filter of a feature, and its messages."""
    algorithm = CLASSES[door][NAMES[0]]()
    said = listen(algorithm)
    for name, value in of.settings.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.SetNumberOfThreads(1)
    algorithm.SetMemoryLimit(limit)
    algorithm.SetInputData(data_of(of.points(), of.arrays))
    if of.source:
        algorithm.SetSourceData(source_of(*of.source()))
    return algorithm, said


def _taken_by_update(algorithm, said):
    most, _ = taken_by(algorithm.Update)
    return Taken(1024 * algorithm.GetMemoryEstimate(), most, said)


def of_class(of, door, limit=0):
    return _taken_by_update(*make_filter(of, door, limit))


def of_arrays(of):
    keywords, points = dict(of.keywords, want=[name for name in of.asks if name in WANTED]), of.points()
    if of.source:
        given, lines, polygons = of.source()
        keywords.update(source_points=given, lines=[list(chain) for chain in lines],
                        loops=[list(chain) for chain in polygons])
    adaptivehilbertdelaunay.release_memory()  # of the case before

    def work():
        made = delaunay(points, threads=1, **keywords)
        arrays = [getattr(made, name) for name in of.asks]
        return made, [array() if callable(array) else array for array in arrays]

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        most, (made, _) = taken_by(work)
    return Taken(made.counts["memory_estimate"], most, [])


# --- Interpolation ------------------------------------------------------------------------------------------

#: `places`: makes them, None for a raster of COUNT cells.
Sampling = collections.namedtuple("Sampling", "name settings triangulation places points arrays source most")


def sampling(name, settings=None, triangulation=None, places=None, points=uniform, arrays=0, source=None, most=1.5):
    return Sampling(name, settings or {}, triangulation or {}, places, points, arrays, source, most)


def scattered():
    return data_of(np.random.default_rng(3).random((COUNT, 3)))


def image():
    made = vtkImageData()
    made.SetDimensions(200, 300, 1)
    made.SetSpacing(0.005, 0.003, 1)
    return made


def in_blocks():
    made = vtkMultiBlockDataSet()
    for k in range(3):
        made.SetBlock(k, data_of(np.random.default_rng(k).random((COUNT // 3, 3))))
    return made


SMALL_TYPES = ("float32", "float32", "int16", "uint8")
SAMPLINGS = (
    sampling("linear"),
    sampling("linear, 4 arrays", arrays=4),
    sampling("linear, slopes", dict(GenerateGradients=True)),
    sampling("natural neighbors", dict(Method=1)),
    sampling("nearest", dict(Method=3)),
    sampling("nearest, 4 arrays", dict(Method=3), arrays=4),
    sampling("linear, smaller types", arrays=SMALL_TYPES),
    sampling("linear, slopes of these", dict(GenerateGradients=True), arrays=SMALL_TYPES),
    sampling("nearest, smaller types", dict(Method=3), arrays=SMALL_TYPES),
    sampling("nearest outside", dict(Outside=1), most=2),
    sampling("as a surface", dict(OutputType=1)),
    sampling("scattered places", places=scattered, most=2),
    sampling("scattered, 4 arrays", places=scattered, arrays=4),
    sampling("places of an image", places=image, most=2),
    sampling("places in blocks", places=in_blocks, most=2),
    sampling("of a transform", triangulation=dict(ProjectionPlaneMode=1, Transform=vtkTransform()), places=scattered,
             most=2),
    sampling("in a plane", triangulation=dict(ProjectionPlaneMode=2)),
    sampling("places in a plane", triangulation=dict(ProjectionPlaneMode=2), places=scattered, most=2),
    sampling("with a line", triangulation=dict(SourceMode=1), source=line),
    sampling("edge length", triangulation=dict(MaximumEdgeLength=3 * SIZE)),
    sampling("mean z of pairs", triangulation=dict(DuplicatePolicy=3), points=pairs, most=2))


def make_sampler(of, door, limit=0):
    algorithm = CLASSES[door][NAMES[1]]()
    algorithm.SetTriangulation(CLASSES[door][NAMES[0]]())
    said = listen(algorithm)
    for name, value in of.settings.items():
        getattr(algorithm, "Set" + name)(value)
    for name, value in of.triangulation.items():
        getattr(algorithm.GetTriangulation(), "Set" + name)(value)
    algorithm.GetTriangulation().SetNumberOfThreads(1)
    algorithm.GetTriangulation().SetMemoryLimit(limit)
    algorithm.SetDimensions(200, COUNT // 200)
    algorithm.SetInputData(data_of(of.points(), of.arrays))
    if of.places:
        algorithm.SetInputDataObject(1, of.places())
    if of.source:
        algorithm.SetSourceData(source_of(*of.source()))
    return algorithm, said


def of_sampler(of, door, limit=0):
    return _taken_by_update(*make_sampler(of, door, limit))


def warm():
    """Makes everything that is made once and kept: modules, tables of names."""
    small = Feature("", {}, {}, ["triangles"], lambda: uniform()[:100], 0, None, 0)
    for door in CLASSES:
        of_class(small, door)
        of_sampler(Sampling("", {}, {}, None, lambda: uniform()[:100], 0, None, 0), door)
    of_arrays(small)
