# SPDX-License-Identifier: BSD-3-Clause
"""A triangulation to interpolate on, and the places: Filters/Sampling/."""

import types

import numpy

from .. import _library as engine
from . import cache
from .arrays import coordinates, ghost_marks, held, held_points
from .columns import blocks_of
from .execution import SKIPPED, Execution, let_go
from .outputs import Surface
from .raster import box_of


def times_of(backend, triangulation):
    """When what says how to triangulate was changed last: the filter with the settings itself, and its transform. The
    later of the two alone would hide a change of the other."""
    transform = triangulation.GetTransform()
    return backend.vtkObject.GetMTime(triangulation), transform.GetMTime() if transform is not None else 0


class SampledSurface:
    """A triangulation, which can be kept for the next execution. Its job reads the numbers of VTK's arrays where they
    lie: these arrays are held, and is_of() asks whether they still lie there and are the same. `triangulation`: the
    filter with the settings, `values` these settings."""

    def __init__(self, backend, job, triangulation, values, given, source, bytes_before):
        self.backend, self.job, self.values = backend, job, values
        self.settings, self.known = times_of(backend, triangulation), None
        self.held = self.places = None
        self.given, self.source = held_points(backend, given), held(backend, source)
        asked = types.SimpleNamespace(_job=job, _values=values, _transform=triangulation.GetTransform())
        self.execution = Execution(backend, asked, self.given, self.source, bytes_before)
        self.transform = self.execution.transform

    def make(self, progress, bytes_behind, is_kept):
        """Triangulates. `bytes_behind`: what interpolating will take. `is_kept`: may another execution use it?
        engine.EngineError."""
        self.held = cache.Inputs(self.given, self.source) if is_kept else None
        self.known = self.held and self.held.fingerprints()
        self.places = self.known and self.held.places()
        self.execution.triangulate(progress, bytes_behind)

    def estimate(self, bytes_behind):
        """Bytes, as if it were made anew and so many more were taken."""
        self.execution.announce(bytes_behind)
        return self.job.estimate()

    def is_of(self, triangulation, given, source):
        """Is it the surface of these, with these settings, and what its job reads still what it was?"""
        if self.known is None or self.settings != times_of(self.backend, triangulation):
            return False
        if self.held.places() != self.places:
            return False
        now = cache.Inputs(given, source)
        return now.fingerprints() == self.known and (
            now.are_the_same_arrays(self.held) or self.held.fingerprints() == self.known)

    def take_data(self, given, source):
        """The point data that interpolation is to work on from now on, of the same points."""
        self.given.GetPointData().ShallowCopy(given.GetPointData())
        if source is not None:
            self.source.GetPointData().ShallowCopy(source.GetPointData())

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
        """The box of all points that are finite and not skipped, in the plane; None without any."""
        return box_of(self.plane_points(), skipped_of(self.given, self.job.count("points")))

    def places_in_plane(self, places):
        """x and y of the points of a vtkDataSet, where they lie in the plane: (k, 2)."""
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
        """Points, in place to where they lie in the plane."""
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


def area_of(backend, triangulation, values, given, source):
    """The box of all points that will be triangulated, in the plane, found without triangulating; None without any.
    engine.EngineError, MemoryError."""
    asked = types.SimpleNamespace(_job=engine.Job(), _values=dict(values), _transform=triangulation.GetTransform())
    execution = Execution(backend, asked, given, source)
    adds = source is not None and values["SourceMode"] and source.GetNumberOfPoints()
    if not (execution.found.is_projected or execution.found.adds_bounding or adds):
        points = coordinates(backend, given.GetPoints())
        return box_of(points, skipped_of(given, len(points)))
    # Of what is done to the points, that alone which says where they are.
    asked._values.update(MemoryLimit=0, Tolerance=0.0, CrossingMode=0, SourceHeights=0, InsertionLimit=1)
    only_points = source and held_points(backend, source)
    execution = Execution(backend, asked, given, only_points)
    execution.triangulate(None, 0)
    return box_of(asked._job.array("plane_points"), skipped_of(given, asked._job.count("points")))


def is_surface(backend, given):
    """Is it a surface that vtkAdaptiveHilbertDelaunay2D made?"""
    if not isinstance(given, backend.vtkPolyData) or not given.GetNumberOfPolys():
        return False
    count = given.GetFieldData().GetAbstractArray("NumberOfTriangles")
    return bool(count is not None and given.GetFieldData().HasArray("NumberOfPointsInserted") and (
        count.GetNumberOfValues() == 1 and count.GetValue(0) == given.GetNumberOfPolys()))


def count_added(backend, given):
    """How many of the last points of a surface were added where that was made; 0 of what is none."""
    if not is_surface(backend, given):
        return 0
    array = given.GetFieldData().GetAbstractArray("NumberOfAddedPoints")
    added = array.GetValue(0) if array is not None and array.GetNumberOfValues() == 1 else 0
    return added if 0 < added < given.GetNumberOfPoints() else 0
