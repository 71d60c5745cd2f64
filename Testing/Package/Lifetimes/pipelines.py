# SPDX-License-Identifier: BSD-3-Clause
"""The world of a program with VTK's pipelines: see worlds.py. One filter that triangulates, one that interpolates and
one that makes quality meshes live through the whole sequence; after any operations, they give the results of new
ones."""

import contextlib
import gc
import importlib
import random
import threading

import numpy as np
from pipelinedata import (
    Delaunay, Interpolation, Source, copy_of, doubles, dump, expect_close, lend, lying_cells, make_input,
    make_source, named, part_of, points_of, random_of,
)  # fmt: skip
from pipelineevents import WhileItWorks
from pipelinemesh import WithMesh
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from worlds import Mismatch, Rubbish, World, expect_same, fork, step

CONSUMERS = (("vtkFiltersCore", "vtkContourFilter"), ("vtkFiltersGeometry", "vtkImageDataGeometryFilter"),
             ("vtkImagingCore", "vtkImageShiftScale"), ("vtkFiltersCore", "vtkThreshold"))

# Settings of both filters and their values.
SURFACE = {"SourceMode": (0, 1), "CrossingMode": (0, 1), "FillRule": (0, 1), "ProjectionPlaneMode": (0, 2),
           "Tolerance": (0.0, 0.01), "KeepTriangulation": (True, True, False), "GenerateRegionIds": (False, True),
           "GenerateNeighbors": (False, True), "GenerateFate": (False, True), "DuplicatePolicy": (0, 1, 3),
           "NumberOfThreads": (1, 2), "GenerateVoronoi": (False, True)}
NUMBERS = {"MaximumError": (0.0, 0.02, 0.1, 0.4), "MaximumNumberOfVertices": (0, 0, 20), "SecondPass": (False, True),
           "KeptPointsOnly": (True, True, False), "GenerateErrors": (False, False, True), "ValueArrayName": ("", "h"),
           "WeightArrayName": ("", "", "k"), "KeepArrayName": ("", "", "vtkGhostType")}
RASTER = {"Method": (0, 1, 3), "Outside": (0, 1), "GenerateGradients": (False, True), "OutputType": (0, 0, 1)}


class Pipelines(WhileItWorks, WithMesh, World):
    """Three filters, their connections, and all operations on them."""

    def __init__(self):
        super().__init__()
        self.surface, self.raster = Delaunay(), Interpolation()
        # without the edges a copied or passed-on surface has less information than its triangulation
        self.settings, self.wishes = {"NumberOfThreads": 1, "GenerateConstraintEdges": True}, {"Dimensions": (9, 7)}
        self.held, self.consumers, self.outputs = [], [], []
        self.source = self.data = self.stream = self.transform = None
        self.time, self.route, self.isCurrent = 0.0, "data", False
        self._give(make_input(random.Random(0)))
        self._apply()

    # --- inputs and settings ---

    def _give(self, data):
        self.data = data
        self._connect()

    def _connect(self):
        self._connect_inputs()
        self._connect_mesh()

    def _connect_inputs(self):
        self.isCurrent = False
        if self.route == "stream":
            self.stream = self.stream or Source()
            self.surface.SetInputConnection(0, self.stream.GetOutputPort())
            self.raster.SetInputConnection(0, self.stream.GetOutputPort())
            return
        self.surface.SetInputDataObject(0, self.data)
        if self.route == "data":
            self.raster.SetInputDataObject(0, self.data)
        else:
            self.raster.SetInputConnection(0, self.surface.GetOutputPort(0))

    def _apply(self):
        self._set(self.surface, self.raster)
        self.surface.SetSourceData(self.source)
        self.raster.SetSourceData(self.source if self.route != "surface" else None)
        self._apply_mesh()

    def _set(self, surface, raster):
        self._set_triangulation(surface)
        self._set_triangulation(raster.GetTriangulation())
        for name, value in self.wishes.items():
            getattr(raster, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
        if self.route == "surface" and self.source is not None:
            raster.SetMethod(0)  # the others depend on constraints, of which a surface's own triangles tell less

    def _set_triangulation(self, filter):
        for name, value in self.settings.items():
            getattr(filter, "Set" + name)(value)
        filter.SetTransform(self.transform)

    def _now(self):
        """A copy of the current input."""
        return Source.whole(self.time) if self.route == "stream" else copy_of(self.data)

    def _new(self):
        """New filters with the same settings and copies of the inputs."""
        surface, raster, given = Delaunay(), Interpolation(), self._now()
        self._set(surface, raster)
        surface.SetInputDataObject(0, given)
        if self.source is not None:
            surface.SetSourceData(copy_of(self.source))
            if self.route != "surface":
                raster.SetSourceData(copy_of(self.source))
        if self.route == "surface":
            raster.SetInputConnection(0, surface.GetOutputPort(0))
        else:
            raster.SetInputDataObject(0, given)
        return surface, raster

    # --- comparing ---

    def _check_surface(self):
        new = self._new()[0]
        new.Update()
        for port in range(3):
            found, wanted = self.surface.GetOutputDataObject(port), new.GetOutputDataObject(port)
            expect_same("port %d" % port, dump(found), dump(wanted))
        self.isCurrent = True

    def _check_raster(self, isWhole):
        new = self._new()[1]
        new.Update()
        found, wanted = self.raster.GetOutputDataObject(0), new.GetOutputDataObject(0)
        if isWhole and self.route == "surface":
            expect_close("raster behind the surface", found, wanted)
        elif isWhole or found.GetExtent() == wanted.GetExtent():
            expect_same("raster", dump(found), dump(wanted))
        elif isinstance(found, vtkImageData):
            expect_same("origin", (found.GetOrigin(), found.GetSpacing()), (wanted.GetOrigin(), wanted.GetSpacing()))
            expect_same("piece", part_of(found, found.GetExtent()), part_of(wanted, found.GetExtent()))

    @step(8)
    def update_surface(self, rng):
        for _ in range(rng.choice((1, 1, 2, 3))):
            if self.route != "stream" and rng.random() < 0.7:
                self.data.Modified()
            self._bring_up_to_date(self.surface, rng)
            self._check_surface()
        if rng.random() < 0.3:
            self._hold(self.surface.GetOutput())

    @step(8)
    def update_raster(self, rng):
        if rng.random() < 0.5:
            self.raster.Modified()
        self._bring_up_to_date(self.raster, rng)
        self._check_raster(True)
        if rng.random() < 0.3:
            self._hold(self.raster.GetOutputDataObject(0))

    def _bring_up_to_date(self, filter, rng):
        if self.route == "stream":
            filter.UpdateTimeStep(self.time)
        filter.UpdateWholeExtent()
        if self.route == "stream" or rng.random() < 0.5:
            filter.Update()

    def _hold(self, data):
        """As a program that keeps an output: its arrays stay as they are."""
        held = data.NewInstance()
        held.ShallowCopy(data)
        for array in [held.GetPointData().GetArray(k) for k in range(held.GetPointData().GetNumberOfArrays())]:
            if array is not None and array.GetNumberOfTuples() and not self._is_given(array):
                self.kept.add("an array of an output", vtk_to_numpy(array))
        if isinstance(held, vtkPolyData) and held.GetNumberOfPolys():
            self.kept.add("triangles", vtk_to_numpy(held.GetPolys().GetConnectivityArray()))
        self.outputs.append(held)
        del self.outputs[:-3]

    def _is_given(self, array):
        data = self.data.GetPointData()
        return any(data.GetArray(k) is array for k in range(data.GetNumberOfArrays()))

    @step(3)
    def update_pieces(self, rng):
        """A raster in pieces, as writers of pieces request it."""
        count = rng.choice((2, 3))
        for piece in range(count):
            self.raster.UpdatePiece(piece, count, 0)
            if self.route != "stream" or self.time == 0.0:
                self._check_raster(False)
        self.raster.UpdateWholeExtent()

    @step(2)
    def update_downstream(self, rng):
        for consumer in self.consumers:
            consumer.Modified()
            with contextlib.suppress(AttributeError):
                consumer.UpdateTimeStep(self.time) if self.route == "stream" else consumer.Update()

    @step(3)
    def interpolate_on_output(self, rng):
        """A new filter on the current surface, which may find the triangulation of the surface."""
        if not self.isCurrent or self.route == "stream":
            return
        found, new = [], self._new()[0]
        new.Update()
        for data in (self.surface.GetOutput(), new.GetOutput()):
            filter = Interpolation()
            filter.SetDimensions(9, 7)
            filter.SetInputDataObject(0, data)
            filter.Update()
            found.append(filter.GetOutputDataObject(0))
        expect_close("raster on an output", *found)

    # --- changing settings and connections ---

    @step(4)
    def set_surface(self, rng):
        name = rng.choice(list(SURFACE))
        self.settings[name] = rng.choice(SURFACE[name])
        self.isCurrent = False
        self._apply()

    @step(3)
    def set_numbers(self, rng):
        """Which points the surface has. Means of heights exclude that it has fewer."""
        for name in ("MaximumError", rng.choice(list(NUMBERS))):
            self.settings[name] = rng.choice(NUMBERS[name])
        if rng.random() < 0.8:
            self.settings["DuplicatePolicy"] = 0
        self.isCurrent = False
        self._apply()

    @step(3)
    def set_raster(self, rng):
        name = rng.choice(list(RASTER))
        self.wishes[name] = rng.choice(RASTER[name])
        if rng.random() < 0.3:
            self.wishes.update(UseBounds=rng.random() < 0.5, Bounds=(0.1, 0.8, 0.2, 0.9))
        self._apply()

    @step(2)
    def set_transform(self, rng):
        self.transform = rng.choice((None, vtkTransform()))
        if self.transform is not None:
            self.transform.RotateZ(rng.randrange(90))
        self.settings["ProjectionPlaneMode"] = 0 if self.transform is None else 1
        self.isCurrent = False
        self._apply()

    @step(3)
    def connect(self, rng):
        self.route = rng.choice(("data", "surface", "stream", "stream"))
        self._connect()
        self._apply()

    @step(4)
    def give_time(self, rng):
        self.time = float(rng.randrange(4))
        self.isCurrent = False
        if self.route == "stream":
            with contextlib.suppress(Mismatch):
                self.update_time(rng)

    def update_time(self, rng):
        self.raster.UpdateTimeStep(self.time)

    @step(4)
    def add_consumer(self, rng):
        module, name = rng.choice(CONSUMERS)
        with contextlib.suppress(ImportError):
            made = getattr(importlib.import_module("vtkmodules." + module), name)()
            made.SetInputConnection(self.raster.GetOutputPort())
            self.consumers.append(made)
            if rng.random() < 0.5:
                more = getattr(importlib.import_module("vtkmodules." + CONSUMERS[2][0]), CONSUMERS[2][1])()
                if isinstance(made.GetOutputDataObject(0), vtkImageData):
                    more.SetInputConnection(made.GetOutputPort())
                    self.consumers.append(more)

    @step(4)
    def delete_consumer(self, rng):
        """While it is connected; then another time."""
        if self.consumers:
            self.consumers.pop(rng.randrange(len(self.consumers)))
        gc.collect()
        self.held.append(Rubbish.fill(rng))
        del self.held[:-20]
        if self.route == "stream" and rng.random() < 0.7:
            self.give_time(rng)

    @step(2)
    def new_filter(self, rng):
        """One of the filters is deleted, perhaps in a cycle, and a new one takes its place."""
        which = rng.choice(("surface", "raster"))
        old = getattr(self, which)
        if rng.random() < 0.5:
            with contextlib.suppress(AttributeError):
                old.self = old
                old.AddObserver("ProgressEvent", lambda *_, held=old: held)
        setattr(self, which, Delaunay() if which == "surface" else Interpolation())
        self.consumers.clear()
        del old
        Rubbish.collect(rng)
        self._connect()
        self._apply()

    # --- changing inputs ---

    @step(4)
    def new_input(self, rng):
        self._give(make_input(rng))

    @step(4)
    def change_in_place(self, rng):
        self.isCurrent = False
        numbers = vtk_to_numpy(self.data.GetPoints().GetData())
        if rng.random() < 0.5:
            numbers[rng.randrange(len(numbers))] += 0.25
        else:
            numbers[:, rng.randrange(2)] *= -1
        self._modified()

    def _modified(self):
        self.data.GetPoints().GetData().Modified()
        self.data.GetPoints().Modified()
        self.data.Modified()

    @step(7)
    def move_points(self, rng):
        """The same numbers at another address. The former memory is reused or freed."""
        before = rng.choice((self.update_surface, self.update_raster, None))
        if before is not None:
            before(rng)
        points, how = self.data.GetPoints(), rng.randrange(7)
        numbers = vtk_to_numpy(points.GetData()).copy()
        if how == 0:
            points.Resize(4 * len(numbers))
            points.SetNumberOfPoints(len(numbers))  # VTK 9.7 makes points of all the room where it was larger
        elif how == 1:
            points.Initialize()
            for row in numbers:
                points.InsertNextPoint(row)
        elif how in (2, 3) and isinstance(points.GetData(), vtkDoubleArray):
            self._refill(points.GetData(), numbers)
        elif how == 4:
            self.data.SetPoints(points_of(numbers))
        else:
            points.SetData(doubles(numbers.astype(np.float64)))
        del points
        self._modified()
        self.held.append(Rubbish.fill(rng))
        del self.held[:-20]
        if before == self.update_surface:
            self.interpolate_on_output(rng)
        elif before is not None:
            self.update_raster(rng)

    def _refill(self, array, numbers):
        """An array gets other memory; the old one, if it is the program's, is used for other numbers."""
        old = lend(array, numbers)
        if old is not None:
            old[:] = 7 * np.random.default_rng(1).random(old.shape)

    @step(3)
    def copy_input(self, rng):
        """Another data set of the same content; the one before is overwritten."""
        old = self.data
        self._give(copy_of(old))
        if rng.random() < 0.7:
            vtk_to_numpy(old.GetPoints().GetData())[:] = 9.0
            old.GetPoints().GetData().Modified()
        self._apply()

    @step(3)
    def change_data(self, rng):
        data, how, count = self.data.GetPointData(), rng.randrange(4), self.data.GetNumberOfPoints()
        self.isCurrent = False
        if how == 0:
            data.AddArray(named(rng.choice("hk"), random_of(rng).random(count)))
        elif how == 1:
            data.RemoveArray(rng.choice("hk"))
        elif how == 2 and data.GetArray("h"):
            vtk_to_numpy(data.GetArray("h"))[rng.randrange(count)] += 1
            data.GetArray("h").Modified()
        else:
            self._mark_ghosts(rng, data, count)
        data.Modified()
        self.data.Modified()

    def _mark_ghosts(self, rng, data, count):
        if data.HasArray("vtkGhostType"):
            data.RemoveArray("vtkGhostType")
            return
        marks = vtkUnsignedCharArray()
        marks.SetName("vtkGhostType")
        for _ in range(count):
            marks.InsertNextValue(rng.choice((0, 0, 0, 2)))
        data.AddArray(marks)

    @step(4)
    def new_source(self, rng):
        self.source = make_source(rng) if rng.random() < 0.8 else None
        self.isCurrent = False
        self._apply()

    @step(3)
    def change_source(self, rng):
        if self.source is None:
            return
        self.isCurrent, other = False, make_source(rng)
        if rng.random() < 0.5:
            self.source.SetLines(other.GetLines())
            self.source.SetPolys(other.GetPolys())
        elif rng.random() < 0.5:
            points = self.source.GetPoints()
            numbers = vtk_to_numpy(points.GetData()).copy()
            points.SetData(doubles(numbers))
        else:
            vtk_to_numpy(self.source.GetPoints().GetData())[rng.randrange(12)] += 0.1
        self.source.GetPoints().Modified()
        self.source.Modified()

    @step(1)
    def lie_in_source(self, rng):
        """Invalid offsets of cells: an error, or those cells are left out, as in a new filter."""
        before, self.source = self.source, make_source(rng)
        self.source.SetLines(lying_cells(rng))
        self._apply()
        self.surface.Update()
        self.raster.Update()
        self.source, self.isCurrent = before, False
        self._apply()

    # --- changing outputs ---

    @step(4)
    def edit_output(self, rng):
        """Outputs of a filter belong to their holder."""
        data = self.surface.GetOutput()
        arrays = [data.GetCellData().GetArray(k) for k in range(data.GetCellData().GetNumberOfArrays())]
        arrays = [array for array in arrays if array is not None and array.GetNumberOfTuples()]
        self.kept.arrays.clear()
        self.isCurrent = False
        if data.GetNumberOfPolys() and (not arrays or rng.random() < 0.6):
            corners = data.GetPolys().GetConnectivityArray()
            corners.SetTuple1(0, corners.GetTuple1(1))
        elif arrays:
            vtk_to_numpy(rng.choice(arrays))[:] += 100
        self._input_modified()

    def _input_modified(self):
        (self.data if self.route != "stream" else self.stream).Modified()

    @step(2)
    def drop_outputs(self, rng):
        self.outputs.clear()
        self.kept.arrays.clear()
        self.surface.GetOutput().Initialize()
        self.isCurrent = False
        self.data.Modified()
        self.surface.Modified()

    # --- other processes and threads ---

    @step(1)
    def fork(self, rng):
        self.data.Modified()
        fork(lambda: self.update_surface(rng), 60)

    @step(1)
    def update_in_threads(self, rng):
        """Two filters of one input, each in a thread."""
        filters, wanted = [self._new()[0] for _ in range(2)], self._new()[0]
        shared = self._now()
        wanted.Update()
        for filter in filters:
            filter.SetInputDataObject(0, shared)
        threads = [threading.Thread(target=filter.Update) for filter in filters]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for filter in filters:
            expect_same("in a thread", dump(filter.GetOutput()), dump(wanted.GetOutput()))

    def end(self):
        self.update_surface(random.Random(1))
        self.update_raster(random.Random(2))
        if self.hasMesh:
            self.update_mesh(random.Random(3))
