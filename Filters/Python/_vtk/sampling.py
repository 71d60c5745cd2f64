# SPDX-License-Identifier: BSD-3-Clause
"""A triangulation to interpolate on, and the places: Filters/Sampling/."""

import types

import numpy

from .. import _library as engine
from . import cache
from .arrays import GHOSTS, bytes_to_convert, coordinates, ghost_marks, held, held_points, ids_of, view
from .columns import blocks_of
from .execution import SKIPPED, Execution, let_go
from .outputs import IDS_NAME, Surface
from .raster import box_of


def times_of(backend, triangulation):
    """When what says how to triangulate was changed last: the filter with the settings itself, and its transform. The
    later of the two alone would hide a change of the other."""
    transform = triangulation.GetTransform()
    return backend.vtkObject.GetMTime(triangulation), transform.GetMTime() if transform is not None else 0


CONSTRAINT_EDGES = "ConstraintEdges"


class GivenSurface:
    """A surface that vtkAdaptiveHilbertDelaunay2D made, whatever is done to its data set meanwhile: its triangles are
    to be had again. `added`: how many of its points, the last ones, were added there."""

    def __init__(self, backend, given):
        self.backend, self._cells = backend, backend.vtkCellArray()
        self._cells.ShallowCopy(given.GetPolys())
        self._edges, self._all_cells = given.GetCellData().GetArray(CONSTRAINT_EDGES), given.GetNumberOfCells()
        self._first = given.GetNumberOfVerts() + given.GetNumberOfLines()
        self.triangles, self.added = given.GetNumberOfPolys(), count_added(given)

    def arrays(self):
        """Its content besides the points."""
        return [self._cells.GetConnectivityArray(), self._edges]

    def bytes_to_convert(self):
        return bytes_to_convert(self.backend, self._cells)

    def corners(self):
        """(t, 3) ids of points."""
        return ids_of(self.backend, self._cells, "triangles of the surface")[1].reshape(-1, 3)

    def give(self, job):
        """Its triangles, and the edges of these that are constraints."""
        job.set_array("surface", self.corners())
        edges = self._edges
        fits = edges is not None and edges.IsA("vtkUnsignedCharArray") and (
            edges.GetNumberOfComponents() * edges.GetNumberOfTuples() == self._all_cells)
        end = self._first + self.triangles
        job.set_array("surface_edges", view(edges).reshape(-1)[self._first:end] if fits else None)


class SampledSurface:
    """A triangulation, which can be kept for the next execution. Its job reads the numbers of VTK's arrays where they
    lie: these arrays are held, and is_of() asks whether they still lie there and are the same. `triangulation`: the
    filter with the settings, `values` these settings."""

    is_lent = False  # for one execution, by the filter that made the surface

    def __init__(self, backend, job, triangulation, values, given, source, bytes_before, surface):
        self.backend, self.job, self.values, self.surface = backend, job, values, surface
        self.settings, self.known = times_of(backend, triangulation), None
        self.held = self.places = None
        self.given, self.source = held_points(backend, given), held(backend, source)
        asked = types.SimpleNamespace(_job=job, _values=values, _transform=triangulation.GetTransform())
        self.execution = Execution(backend, asked, self.given, self.source, bytes_before, surface)
        self.transform = self.execution.transform

    def make(self, progress, bytes_behind, is_kept):
        """Triangulates. `bytes_behind`: what interpolating will take. `is_kept`: may another execution use it?
        engine.EngineError."""
        self.held = cache.Inputs(self.given, self.source, self.surface) if is_kept else None
        self.known = self.held and self.held.fingerprints()
        self.places = self.known and self.held.places()
        self.execution.triangulate(progress, bytes_behind)

    def estimate(self, bytes_behind):
        """Bytes, as if it were made anew and so many more were taken."""
        self.execution.announce(bytes_behind)
        return self.job.estimate()

    def is_of(self, triangulation, given, source, surface):
        """Is it the surface of these, with these settings, and what its job reads still what it was?"""
        if self.known is None or self.execution.names_numbers or self.settings != times_of(self.backend, triangulation):
            return False
        if self.held.places() != self.places:
            return False
        now = cache.Inputs(given, source, surface)
        return now.fingerprints() == self.known and (
            now.are_the_same_arrays(self.held) or self.held.fingerprints() == self.known)

    def take_data(self, given, source):
        """The point data that interpolation is to work on from now on, of the same points."""
        self.given.GetPointData().ShallowCopy(given.GetPointData())
        if source is not None:
            self.source.GetPointData().ShallowCopy(source.GetPointData())

    def drop_data(self):
        """Lets go of all data of points and cells until take_data(): between executions what the triangulation was made
        of is held, and nothing else."""
        data = self.given.GetPointData()
        marks = data.GetAbstractArray(GHOSTS)
        data.Initialize()
        if marks is not None:
            data.AddArray(marks)
        if self.source is not None:
            self.source.GetPointData().Initialize()
            self.source.GetCellData().Initialize()

    def point_data(self):
        """With a value for each point, added ones included."""
        made = self.backend.vtkPolyData()
        Surface(self.backend, self.job, self.values, made).write_points(self.given, self.source)
        return made.GetPointData()

    def plane_points(self):
        """x, y in the plane of the triangulation and the height above it, of all points."""
        return self.job.array("plane_points")

    def heights(self):
        """Of each point above the plane of the triangulation, by DuplicatePolicy."""
        return self.job.array("heights")

    def bounds(self):
        """The box of all points that are finite and not left out, in the plane; None without any."""
        left_out = skipped_of(self.given, self.job.count("points"))
        if self.surface is not None:
            left_out[:] = True
            left_out[self.surface.corners()] = False
        return box_of(self.plane_points(), left_out)

    def places_in_plane(self, places):
        """x and y of the points of a vtkDataSet, in the plane: (k, 2)."""
        is_computed = not places.IsA("vtkPointSet")
        there = None if is_computed else coordinates(self.backend, places.GetPoints())
        xy = numpy.empty((places.GetNumberOfPoints(), 2))
        for part in blocks_of(len(xy)):
            rows = range(*part.indices(len(xy)))
            xyz = numpy.array([places.GetPoint(i) for i in rows] if is_computed else there[part], numpy.float64)
            self._move(xyz)
            xy[part] = xyz[:, :2]
        return xy

    def _move(self, xyz):
        """Moves points, in place, to their position in the plane."""
        if self.transform is not None:
            self.execution._project(xyz)
        elif self.execution.found.is_projected:
            self.job.to_plane(xyz)

    def give_back(self):
        """Lets go of the input. The job keeps its memory."""
        let_go(self.job)


def skipped_of(given, count):
    """Which of the first points, of so many, are left out."""
    marks, _ = ghost_marks(given)
    made = numpy.zeros(count, bool)
    if marks is not None:
        made[:len(marks)] = marks & SKIPPED != 0
    return made


def area_of(backend, triangulation, values, given, source, surface):
    """The box of all points that will be triangulated or are those of a surface, in the plane, found without
    triangulating; None without any. engine.EngineError, MemoryError."""
    asked = types.SimpleNamespace(_job=engine.Job(), _values=dict(values), _transform=triangulation.GetTransform())
    execution = Execution(backend, asked, given, source)
    adds = source is not None and values["SourceMode"] and source.GetNumberOfPoints()
    if not (execution.found.is_projected or execution.found.adds_bounding or adds):
        points = coordinates(backend, given.GetPoints())
        return box_of(points, skipped_of(given, len(points)))
    # Of what is done to the points, that alone which says where they are.
    asked._values.update(MemoryLimit=0, Tolerance=0.0, CrossingMode=0, SourceHeights=0, InsertionLimit=1,
                         MaximumError=0.0, MaximumNumberOfVertices=0)
    only_points = source and held_points(backend, source)
    execution = Execution(backend, asked, given, only_points)
    execution.unfitted = surface.added if surface else 0
    execution.triangulate(None, 0)
    return box_of(asked._job.array("plane_points"), skipped_of(given, asked._job.count("points")))


def _count(surface, name):
    """A count that the filter that made the surface has added to it; -1 if there is none."""
    array = surface.GetFieldData().GetAbstractArray(name)
    is_count = array is not None and array.IsA("vtkIdTypeArray") and array.GetNumberOfValues() == 1
    return array.GetValue(0) if is_count else -1


# of which each point is in one
COUNTS_BY_STATUS = ("NumberOfPointsInserted", "NumberOfPointsWithinError", "NumberOfPointsBeyondLimit",
                    "NumberOfDuplicates", "NumberOfMergedPoints", "NumberOfRejectedPoints", "NumberOfSkippedPoints")


def is_surface(backend, given):
    """Is it a surface that vtkAdaptiveHilbertDelaunay2D made?"""
    if not isinstance(given, backend.vtkPolyData) or not given.GetNumberOfPolys():
        return False
    cells = given.GetPolys()
    is_ours = given.GetFieldData().HasArray("NumberOfPointsInserted") and (
        _count(given, "NumberOfTriangles") == cells.GetNumberOfCells())
    return bool(is_ours and cells.GetMaxCellSize() == 3 and (
        cells.GetNumberOfConnectivityIds() == 3 * cells.GetNumberOfCells()))


def surface_of(merged):
    """The surface that the input is, whose triangles count unless there are constraints; None if it is none."""
    vtk, given = merged.backend, merged.given
    return GivenSurface(vtk, given) if merged.source is None and is_surface(vtk, given) else None


def count_added(surface):
    """How many of the last points of a surface were added where that was made."""
    added, count = _count(surface, "NumberOfAddedPoints"), surface.GetNumberOfPoints()
    of_all = sum(max(0, _count(surface, name)) for name in COUNTS_BY_STATUS)
    ids = surface.GetPointData().GetArray(IDS_NAME)
    if of_all > count and added > 0 and ids and ids.IsA("vtkIdTypeArray") and ids.GetNumberOfValues() == count:
        # a simplified surface has some of them, behind its other points
        added = count - int(numpy.searchsorted(view(ids).reshape(-1), of_all - added))
    return added if 0 < added < count else 0
