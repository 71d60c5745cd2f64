# SPDX-License-Identifier: BSD-3-Clause
"""vtkAdaptiveHilbertInterpolation2D in Python, made for one VTK."""

import contextlib

from .. import _library as engine
from . import messages, python_class, raster, raster_messages, raster_settings, settings, table
from .arrays import Watched, held
from .blocks import Merged
from .columns import Columns
from .interpolating import Interpolating, Stopped
from .sampling import area_of, surface_of
from .vtkclass import Followers, Inputs, Pieces, Source, build

NAMES = ("vtkAdaptiveHilbertInterpolation2D", "vtkAdaptiveHilbertInterpolationAlgorithm", "vtkDataSetAlgorithm")

ABOUT = """Values between scattered points: rasters, and places of any data set.

Triangulates the points of input port 0, a vtkPointSet or blocks of these, as vtkAdaptiveHilbertDelaunay2D does, and
interpolates their heights and point arrays on the surface: at the cell centres of a raster, or at the points of the
data set in port 1. Input port 2: constraints. The output is a vtkImageData, a vtkStructuredGrid, or a data set of the
kind that the places are.

In Python, over the engine's C interface; the compiled class has the same methods and gives the same results.
"""


class Triangulations:
    """The settings of the triangulation; mixed into the class."""

    def SetTriangulation(self, triangulation):
        """How the points are triangulated: a vtkAdaptiveHilbertDelaunay2D of which the settings count. None is an error
        of the execution."""
        if triangulation is not None and not (
                hasattr(triangulation, "IsA") and triangulation.IsA("vtkAdaptiveHilbertDelaunay2D")):
            raise TypeError("SetTriangulation argument 1: a vtkAdaptiveHilbertDelaunay2D is required, not %s"
                            % type(triangulation).__name__)
        if triangulation is not self._triangulation:
            self._triangulation = triangulation
            self._follow(triangulation.changes() if hasattr(triangulation, "changes") else None)
            self.Modified()

    def GetTriangulation(self):
        """How the points are triangulated."""
        return self._triangulation

    def GetMTime(self):
        """When the filter or Triangulation was changed last."""
        own = super().GetMTime()
        return max(own, self._triangulation.GetMTime()) if self._triangulation is not None else own

    def Update(self, *given):
        """Brings the output up to date."""
        compiled = self._triangulation is not None and not hasattr(self._triangulation, "changes")
        if self._must_describe_anew or (compiled and self._triangulation.GetMTime() > super().GetMTime()):
            self.Modified()
        super().Update(*given)

    def _surface_settings(self):
        """Those of Triangulation, without its outputs."""
        made = {setting.name: getattr(self._triangulation, "Get" + setting.name)() for setting in settings.SETTINGS}
        made.update({name: False for name in made if name.startswith("Generate")})
        return made


class _Ports:
    """Inputs and outputs; mixed into the class."""

    KINDS = (("vtkCompositeDataSet", "vtkPointSet", "vtkTable"), ("vtkDataSet", "vtkCompositeDataSet"),
             ("vtkCompositeDataSet", "vtkPolyData"))
    _source_port = 2

    def SetPlacesData(self, places):
        """The places: any vtkDataSet, whose points they are; None: a raster."""
        self._give(1, "SetPlacesData", "vtkDataSet", places)

    def SetPlacesConnection(self, output):
        """The places as an output port of another filter."""
        self.SetInputConnection(1, output)

    def GetPlaces(self):
        """The places, if they are one vtkDataSet."""
        return self._given(1, "vtkDataSet")

    def GetOutput(self, port=0):
        """The vtkDataSet at this output port."""
        return self.GetOutputDataObject(port)


class _Measures:
    """The measures of the filter; mixed into the class."""

    def _clear_measures(self):
        self._values.update(settings.as_before(raster_settings.MEASURES))

    def PrintSelf(self):
        """The settings and measures, as text."""
        lines = ["Triangulation: %s" % (self._triangulation and self._triangulation.GetClassName())]
        lines += ["%s: %s" % (setting.name, setting.text(self._values[setting.name]))
                  for setting in raster_settings.SETTINGS]
        for name in raster_settings.MEASURES:
            value = self._values[name]
            lines.append("%s: %s" % (name, "%g" % value if isinstance(value, float) else value))
        return "".join("  %s\n" % line for line in lines)


class _Executions:
    """How requests go; mixed into the class."""

    def RequestDataObject(self, _request, inputs, outputs):
        """The kind of the places, or that of OutputType."""
        vtk = self._backend
        places = self._data(inputs, 1)
        if places is None and inputs[1].GetNumberOfInformationObjects():
            return 0
        kind = "vtkStructuredGrid" if self._values["OutputType"] else "vtkImageData"
        made = places.NewInstance() if places is not None else getattr(vtk, kind)()
        now = vtk.vtkDataObject.GetData(outputs, 0)
        if now is None or now.GetClassName() != made.GetClassName():
            outputs.GetInformationObject(0).Set(vtk.vtkDataObject.DATA_OBJECT(), made)
            self.GetOutputPortInformation(0).Set(vtk.vtkDataObject.DATA_EXTENT_TYPE(), made.GetExtentType())
        return 1

    def RequestInformation(self, _request, inputs, outputs):
        """Filters behind have to know extent, origin, spacing and the type of the scalars before there are data. The
        points say them, so these are brought up to date here. What is wrong is said when they are used."""
        vtk, info = self._backend, outputs.GetInformationObject(0)
        is_raster = inputs[1].GetNumberOfInformationObjects() == 0
        if is_raster:
            self._announce(raster.NONE, info)  # until it is known
        else:
            for key in (vtk.vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), vtk.vtkDataObject.ORIGIN(),
                        vtk.vtkDataObject.SPACING()):
                info.CopyEntry(inputs[1].GetInformationObject(0), key)
        if self._triangulation is not None:
            for port in (0, 2):
                if self.GetNumberOfInputConnections(port):
                    self._update_input(self.GetInputConnection(port, 0))
            with contextlib.suppress(raster.Fault, engine.EngineError, MemoryError):
                self._describe(info, is_raster)
        return 1

    def _update_input(self, output):
        """Others may have asked the same input for a piece, which is not what the points are then."""
        vtk, index, requests = self._backend, output.GetIndex(), self._backend.vtkInformationVector()
        requests.SetInformationObject(index, vtk.vtkInformation())
        requests.GetInformationObject(index).CopyEntry(
            output.GetProducer().GetOutputInformation(index), vtk.vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT())
        if self._is_alone(self._triangulation.GetController()):
            self._ask_for_all(requests)
        output.GetProducer().Update(index, requests)

    def _describe(self, info, is_raster):
        """Announces the output."""
        vtk, values = self._backend, self._surface_settings()
        merged = Merged(vtk, messages.Silence(), values, self.GetInput(0), self.GetInput(2))
        given = merged.input
        if given is None:
            return
        surface = surface_of(merged)
        values.update(table.USED_UP if surface else {})
        data = given.GetPointData()
        kind = Columns(vtk, self._values, data, data, given.GetNumberOfPoints()).kind_of_scalars()
        vtk.vtkDataObject.SetPointDataActiveScalarInfo(info, *kind)
        if not is_raster:
            return
        if self._values["UseBounds"]:
            cells = raster.make_raster_within(self._values, self._values["Bounds"], given.GetNumberOfPoints())
        else:
            area = area_of(vtk, self._triangulation, values, given, merged.source, surface)
            cells = raster.make_raster(self._values, area, given.GetNumberOfPoints())
        # Filters for images behind may make room for one as large before the data are there.
        if 9 * cells.count() <= (values["MemoryLimit"] * 1024 or engine.available_memory()):
            self._announce(cells, info)

    def _announce(self, cells, info):
        vtk = self._backend
        extent = 0, cells.columns - 1, 0, cells.rows - 1, 0, 0 if cells.count() else -1
        info.Set(vtk.vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), extent, 6)
        info.Set(vtk.vtkDataObject.ORIGIN(), (*cells.origin, 0.0), 3)
        info.Set(vtk.vtkDataObject.SPACING(), (*cells.spacing, 1.0), 3)

    def _is_as_announced(self, made, info):
        """Else the points were others at that time, those of another time step."""
        pipeline, data = self._backend.vtkStreamingDemandDrivenPipeline, self._backend.vtkDataObject
        if tuple(info.Get(pipeline.WHOLE_EXTENT())) != made.GetExtent():
            return False
        return not (made.IsA("vtkImageData") and made.GetNumberOfPoints()) or (
            tuple(info.Get(data.ORIGIN())) == made.GetOrigin() and (
                tuple(info.Get(data.SPACING())) == made.GetSpacing()))

    def RequestUpdateExtent(self, _request, inputs, _outputs):
        """All points are needed whatever part of the output is wanted; on ranks those of each. Of places as many as
        are wanted of the output, and all where these have an extent."""
        pipeline = self._backend.vtkStreamingDemandDrivenPipeline
        if self._triangulation is not None and self._is_alone(self._triangulation.GetController()):
            for port in (0, 2):
                self._ask_for_all(inputs[port])
        for vector in inputs:
            for i in range(vector.GetNumberOfInformationObjects()):
                info = vector.GetInformationObject(i)
                if info.Has(pipeline.WHOLE_EXTENT()):
                    info.Set(pipeline.UPDATE_EXTENT(), info.Get(pipeline.WHOLE_EXTENT()), 6)
        return 1

    def _data(self, inputs, port):
        there = inputs[port].GetNumberOfInformationObjects()
        return self._backend.vtkDataObject.GetData(inputs[port]) if there else None

    def RequestData(self, _request, inputs, outputs):
        """Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more. But filters for
        images would read pixels that are not there: without an announced raster those behind are not run."""
        made, speaker = self._backend.vtkDataObject.GetData(outputs, 0), messages.Speaker(self._backend, self)
        if made.IsA("vtkDataSet"):
            made.GetPointData().Initialize()  # VTK leaves an image the scalars of the last execution
        self._clear_measures()
        is_done = False
        if self._triangulation is None:
            speaker.error(messages.refusal(triangulation_is_null=1))
        else:
            own = made.NewInstance()  # observers have the output, too, which is filled in the end
            own.ShallowCopy(made)
            given = [self._data(inputs, port) for port in range(3)]
            self._watched, self._input_is_changed = Watched(self._backend, *given), False
            try:
                is_done = self._execute(given, own, speaker)
                made.ShallowCopy(own)
            except BaseException:  # Ctrl-C, mostly
                self._let_go()
                self._clear_measures()
                made.Initialize()
                raise
            finally:
                self._watched = None
        if not is_done:
            made.Initialize()
        info, is_raster = outputs.GetInformationObject(0), self._data(inputs, 1) is None
        self._must_describe_anew = is_done and is_raster and not self._is_as_announced(made, info)
        if is_done or not is_raster or not self._is_wanted_behind(info):
            return 1
        self.Modified()  # VTK takes the output for that of the last time that did not fail
        return 0

    def _is_wanted_behind(self, info):
        """Are there filters behind, which want a part of the raster?"""
        wanted = info.Get(self._backend.vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT()) or (0, -1) * 3
        is_behind = info.GetReferenceCount() > 2  # one is VTK's, one Python's
        return is_behind and wanted[0] <= wanted[1] and wanted[2] <= wanted[3] and wanted[4] <= wanted[5]

    def _execute(self, given, made, speaker):
        """False if the output is empty."""
        points, places, source = given
        unfit = raster_messages.of_names(self._values)
        if unfit is not None:
            speaker.error(unfit)
            return False
        triangulation, values, wishes = self._triangulation, self._surface_settings(), dict(self._values)
        merged = Merged(self._backend, speaker, values, points, source)
        merged.warn()
        if merged.input is None:
            return False
        surface = surface_of(merged)
        values.update(table.USED_UP if surface else {})
        asked = triangulation, values, wishes, surface
        pieces, found = self._pieces(places, made), None
        all_places = [piece for piece, _ in pieces] if isinstance(places, self._backend.vtkCompositeDataSet) else ()
        try:
            for k, (piece, output) in enumerate(pieces):
                more = Interpolating(
                    self, asked, merged, piece, speaker, k == 0, k + 1 == len(pieces), all_places).run(output)
                found = raster_messages.together(found, more)
        except Stopped as stopped:
            self._let_go()
            self._clear_measures()
            self._values["MemoryEstimate"] = stopped.estimate
            if stopped.text:
                speaker.error(stopped.text)
            return False
        for text in raster_messages.of_places(found) if found is not None else ():
            speaker.warn(text)
        return True

    def _pieces(self, places, made):
        """(places, output) of each block of places, or of the only one; places are held, and None for a raster."""
        vtk = self._backend
        if not isinstance(places, vtk.vtkCompositeDataSet):
            return [(held(vtk, places), made)]
        made.CopyStructure(places)
        pieces, each = [], places.NewIterator()
        each.InitTraversal()
        while not each.IsDoneWithTraversal():
            block = each.GetCurrentDataObject()
            if isinstance(block, vtk.vtkDataSet):
                pieces.append((held(vtk, block), block.NewInstance()))
                made.SetDataSet(each, pieces[-1][1])
            each.GoToNextItem()
        return pieces

    def _let_go(self):
        """Of the triangulation and its memory."""
        if self._surface is not None:
            self._surface.give_back()
            self._surface = None
        self._job.release()


def _output_getter(backend, name):
    kind = "vtkImageData" if name == "StructuredPoints" else "vtk" + name

    def get(self):
        found = self.GetOutputDataObject(0)
        return found if isinstance(found, getattr(backend, kind)) else None

    get.__name__, get.__doc__ = "Get%sOutput" % name, "The output if it is a %s, else None." % kind
    return get


def make_class(backend):
    """The class over this VTK."""

    def start(self):
        self._values = {setting.name: setting.default for setting in raster_settings.SETTINGS}
        self._values.update(raster_settings.MEASURES)
        self._surface = None
        self._must_describe_anew = False  # the raster is another than was announced
        self._job = engine.Job()
        self._triangulation = None

    def begin(self):
        self.SetTriangulation(python_class(backend.package)())

    members = dict(raster_settings.all_methods(), __doc__=ABOUT)
    members.update(("Get%sOutput" % name, _output_getter(backend, name)) for name in (
        "ImageData", "PolyData", "RectilinearGrid", "StructuredGrid", "StructuredPoints", "UnstructuredGrid"))
    parts = _Measures, _Executions, _Ports, Triangulations, Source, Inputs, Followers, Pieces
    made = build(backend, NAMES, parts, members, start, (3, 1), "vtkDataObject", begin)
    for name, member in raster_settings.all_properties(made).items():
        setattr(made, name, member)
    return made
