# SPDX-License-Identifier: BSD-3-Clause
"""vtkAdaptiveHilbertQualityMesh2D in Python, made for one VTK: Filters/Execution/vtkAHDRefineExecution.cxx."""

import types

import numpy

from .. import _library as engine
from .._found import Found, spread
from . import messages, python_class, settings, table
from .arrays import Watched, cell_array, cells_of, new_array, replace_array, view
from .blocks import Merged
from .execution import Execution, Progress, let_go
from .interpolation import Triangulations
from .outputs import IDS_NAME, Surface
from .pointdata import RefinedData
from .vtkclass import Followers, Inputs, Pieces, Source, build

NAMES = ("vtkAdaptiveHilbertQualityMesh2D", "vtkAdaptiveHilbertQualityMeshAlgorithm", "vtkPolyDataAlgorithm")
MEASURES = {name: value for name, value, _about in table.QUALITY_MEASURES}

ABOUT = """Triangles to compute on: of wide angles and wished sizes.

Triangulates the points of input port 0 with the constraints of port 1, as vtkAdaptiveHilbertDelaunay2D does, and adds
points until no angle is smaller and no triangle is larger than wished. Output port 0 has the triangles, port 1 the
edges along lines and outlines.

In Python, over the engine's C interface; the compiled class has the same methods and gives the same results.
"""


class _Stopped(Exception):
    """An execution came to nothing. Its text: why; empty for an abort."""


class _Parts:
    """The progress of several calls of the engine as one."""

    ENDS = 0.0, 0.1, 0.9, 1.0  # to triangulate, to refine, to triangulate again

    def __init__(self, algorithm):
        self.progress, self.part = Progress(algorithm), 0

    def __call__(self, phase, fraction):
        begin, end = self.ENDS[self.part:self.part + 2]
        return self.progress(phase, begin + (end - begin) * fraction)


class _Meshing:
    """One execution."""

    def __init__(self, backend, algorithm, merged, values):
        self.backend, self.algorithm, self.merged, self.values = backend, algorithm, merged, values
        self.wishes, self.measures = dict(algorithm._values), dict(MEASURES)
        asked = types.SimpleNamespace(
            _job=engine.take_job(), _values=values, _transform=algorithm._triangulation.GetTransform())
        self.execution = Execution(backend, asked, merged.input, merged.source, merged.bytes)
        self.job, self.again, self.parts = asked._job, engine.take_job(), _Parts(algorithm)

    def run(self, speaker, mesh, segments):
        """Fills the outputs. _Stopped, MemoryError."""
        for name in ("InsertionLimit", "Alpha", "MaximumEdgeLength"):
            if self.values[name] > 0:
                raise _Stopped(messages.refusal(not_to_refine=name))
        self._step(self.execution.triangulate, self.parts, 0)
        for text in self.execution.warnings():
            speaker.warn(text)
        given = self.backend.vtkPolyData()
        Surface(self.backend, self.job, self.values, given).write_points(self.merged.input, self.merged.source)
        self.merged.hand_on_points(given)
        self._refine(given)
        self._triangulate_again()
        self._write_points(given, mesh)
        self._write_triangles(mesh)
        self._write_segments(mesh, segments)

    def end(self):
        for job in (self.job, self.again):
            let_go(job)
            engine.give_back(job)

    def _step(self, call, *given, of=None):
        job = of or self.job
        try:
            call(*given)
        except engine.EngineError as error:
            raise _Stopped(messages.error_text(error.status, job, str(error)) or "") from None
        finally:
            self._need(job.count("memory_estimate"))

    def _need(self, needed):
        self.measures["MemoryEstimate"] = max(self.measures["MemoryEstimate"], needed // 1024)

    def _sizes(self, given):
        """The number of each point; None without an array."""
        name = self.wishes["SizeArrayName"]
        if name in ("", "None"):
            return None
        found, count = given.GetPointData().GetArray(name), given.GetNumberOfPoints()
        if found is None or found.GetNumberOfComponents() != 1 or found.GetNumberOfTuples() < count:
            raise _Stopped(messages.refusal(unfit_sizes=name))
        copy = self.backend.vtkDoubleArray()
        copy.DeepCopy(found)
        return numpy.array(view(copy)[:count])

    def _refine(self, given):
        sizes, wishes, report = self._sizes(given), self.wishes, engine.RefineReport()
        most = wishes["MaximumNumberOfAddedPoints"]
        request = engine.RefineRequest(
            wishes["MinimumAngle"], wishes["MaximumArea"], wishes["MaximumLength"],
            None if sizes is None else engine.address_of(sizes), engine.REFINE_ALL if most < 0 else most)
        self.parts.part = 1
        try:
            self.found = Found(self.job, request, sizes, report)
        except engine.EngineError as error:
            text = messages.not_computed(str(error))
            if error.status in (engine.MEMORY_LIMIT, engine.OUT_OF_MEMORY):
                text = messages.said(engine.SAY_REFUSAL, {
                    "reason": error.status, "doing": "refining", "points": self.job.count("points"),
                    "memory_limit": self.values["MemoryLimit"] * 1024, "memory_estimate": report.memory_needed,
                    "memory_allowed": report.memory_allowed})[0]
            raise _Stopped("" if error.status == engine.CANCELLED else text) from None
        finally:
            self._need(report.memory_needed)
        self.measures.update(
            NumberOfTriangles=report.triangles, NumberOfAddedPoints=report.points,
            NumberOfPointsAddedToSegments=report.on_segments, NumberOfBadTriangles=report.bad,
            NumberOfEncroachedPieces=report.encroached_pieces)

    def _triangulate_again(self):
        """All points, with the pieces of segments; none where loops leave nothing."""
        job, found = self.again, self.found
        status = self.job.array("point_status")
        skip = numpy.zeros(len(status) + len(found.places), numpy.uint8)
        skip[:len(status)] = (status != numpy.arange(len(status))) | (found.report.triangles == 0)
        job.set_array("points", numpy.concatenate((self.job.array("plane_points")[:, :2], found.places)))
        job.set_array("skip", skip)
        for kind, (ids, offsets) in found.chains().items():
            if len(ids):
                job.set_array(kind + "_ids", ids)
                job.set_array(kind + "_offsets", offsets)
        job.set(fill_rule=engine.FILL_EVEN_ODD, want_regions=1, threads=self.job.get("threads"),
                memory_limit=self.job.get("memory_limit"),
                other_memory=min(self.job.count("memory_estimate"), 2**62))
        self.parts.part = 2
        job.set_progress(self.parts)
        self._step(job.run, of=job)

    def _write_points(self, given, mesh):
        found, before = self.found, given.GetNumberOfPoints()
        data, xyz = new_array(self.backend.vtkDoubleArray, before + len(found.places), 3)
        if len(xyz):
            xyz[:before] = self.job.array("points", numpy.float64)
            xyz[before:] = spread(xyz[:before].copy(), found.corners, found.weights)
            if not self.execution.found.is_projected:
                xyz[before:, :2] = found.places
        points = self.backend.vtkPoints()
        points.SetData(data)
        mesh.SetPoints(points)
        RefinedData(self.backend, given, found).write(mesh.GetPointData())
        ids, write = new_array(self.backend.vtkIdTypeArray, len(xyz), 1, IDS_NAME)
        write[:] = numpy.where(numpy.arange(len(xyz)) < self.execution.found.input_points, numpy.arange(len(xyz)), -1)
        replace_array(mesh.GetPointData(), ids)

    def _write_triangles(self, mesh):
        triangles = self.again.array("triangles", numpy.int32)
        regions, bad, self.measures["LeastAngle"] = self.found.described(
            self.job, triangles, self.again.array("regions"))
        ids, write = new_array(self.backend.vtkTypeInt32Array, triangles.size)
        write[:] = triangles.ravel()
        mesh.SetPolys(cell_array(self.backend, ids, 3))
        reasons = numpy.full(len(triangles), -1)
        reasons[bad] = self.found.reasons
        data, vtk = mesh.GetCellData(), self.backend
        for kind, name, values in ((vtk.vtkIdTypeArray, "RegionId", regions), (vtk.vtkIntArray, "BadReason", reasons)):
            self._add(data, kind, name, values)

    def _write_segments(self, mesh, segments):
        found, vtk = self.found, self.backend
        count = len(found.pieces)
        segments.SetPoints(mesh.GetPoints())
        segments.GetPointData().ShallowCopy(mesh.GetPointData())
        segments.SetLines(cells_of(vtk, 2 * numpy.arange(count + 1), found.pieces.ravel()))
        data = segments.GetCellData()
        self._add(data, vtk.vtkIdTypeArray, "SourceCell", found.cells)
        self._add(data, vtk.vtkUnsignedCharArray, "IsBoundary", numpy.arange(count) >= found.report.inner_pieces)

    @staticmethod
    def _add(data, kind, name, values):
        made, write = new_array(kind, len(values), 1, name)
        write[:] = values
        data.AddArray(made)


class _Executions:
    """Inputs, and how requests go; mixed into the class."""

    KINDS = ("vtkCompositeDataSet", "vtkPointSet", "vtkTable"), ("vtkCompositeDataSet", "vtkPolyData")

    def _ranks_are_alone(self):
        return self._is_alone(self._triangulation and self._triangulation.GetController())

    def RequestUpdateExtent(self, _request, inputs, _outputs):
        """In one process all is needed whatever piece of the output is wanted."""
        if self._ranks_are_alone():
            for vector in inputs[:2]:
                self._ask_for_all(vector)
        return 1

    def RequestData(self, _request, inputs, outputs):
        """Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more."""
        vtk, is_alone = self._backend, self._ranks_are_alone()
        outs = [vtk.vtkPolyData.GetData(outputs, port) for port in range(2)]
        wanted = [not (is_alone and self._is_later_piece(outputs.GetInformationObject(port))) for port in range(2)]
        own = [output.NewInstance() for output in outs]  # observers have the outputs, too
        for ours, output in zip(own, outs):
            ours.GetFieldData().ShallowCopy(output.GetFieldData())
        self._values.update(MEASURES)
        given = [vtk.vtkDataObject.GetData(inputs[port]) if inputs[port].GetNumberOfInformationObjects() else None
                 for port in range(2)]
        self._watched, self._input_is_changed = Watched(vtk, *given), False
        is_done = False
        try:
            is_done = any(wanted) and self._execute(given, own)
        finally:
            self._watched = None
            for ours, output, is_wanted in zip(own, outs, wanted):
                output.ShallowCopy(ours) if is_done and is_wanted else output.Initialize()
        return 1

    def _execute(self, given, own):
        """False if the outputs are empty."""
        vtk, speaker, meshing = self._backend, messages.Speaker(self._backend, self), None
        try:
            if self._triangulation is None:
                raise _Stopped(messages.refusal(triangulation_is_null=1))
            values = self._surface_settings()
            self._look_at_ranks(speaker, values["DistributePoints"])
            merged = Merged(vtk, speaker, values, *given)
            merged.warn()
            if merged.input is None:
                return False
            meshing = _Meshing(vtk, self, merged, values)
            meshing.run(speaker, *own)
            self._values.update(meshing.measures)
            for name in table.QUALITY_COUNTS:
                made, write = new_array(vtk.vtkIdTypeArray, 1, 1, name)
                write[0] = self._values[name]
                own[0].GetFieldData().AddArray(made)
            return True
        except _Stopped as stopped:
            if str(stopped):
                speaker.error(str(stopped))
        except MemoryError:
            speaker.error("Out of memory. The output is empty.")
        finally:
            if meshing is not None:
                self._values["MemoryEstimate"] = meshing.measures["MemoryEstimate"]
                meshing.end()
        return False

    def _look_at_ranks(self, speaker, distributes):
        ranks = self._triangulation.GetController() if distributes else None
        if ranks and ranks.GetNumberOfProcesses() > 1:
            raise _Stopped(messages.refusal(mesh_ranks=ranks.GetNumberOfProcesses()))
        ranks = self._backend.controller()
        if ranks and ranks.GetNumberOfProcesses() > 1 and not self._warned_about_ranks and (
                ranks.GetLocalProcessId() == 0):
            self._warned_about_ranks = True
            for text in messages.said(engine.SAY_BLOCKS, {"mesh_ranks": ranks.GetNumberOfProcesses()}):
                speaker.warn(text)

    def PrintSelf(self):
        """The settings and measures, as text."""
        lines = ["%s: %s" % (setting.name, setting.text(self._values[setting.name])) for setting in settings.QUALITY]
        for name in MEASURES:
            value = self._values[name]
            lines.append("%s: %s" % (name, "%g" % value if isinstance(value, float) else value))
        lines.append("Triangulation: %s" % (self._triangulation and self._triangulation.GetClassName()))
        return "".join("  %s\n" % line for line in lines)


def make_class(backend):
    """The class over this VTK."""

    def start(self):
        self._values = {setting.name: setting.default for setting in settings.QUALITY}
        self._values.update(MEASURES)
        self._triangulation, self._must_describe_anew, self._warned_about_ranks = None, False, False

    def begin(self):
        self.SetTriangulation(python_class(backend.package)())

    members = dict(settings.getters_of(table.QUALITY_MEASURES), __doc__=ABOUT)
    members.update(settings.getters_of_texts(table.QUALITY_TEXTS, MEASURES))
    for setting in settings.QUALITY:
        members.update(settings.methods_of(setting))
    parts = _Executions, Triangulations, Source, Inputs, Followers, Pieces
    made = build(backend, NAMES, parts, members, start, (2, 2), begin=begin)
    names = [setting.name for setting in settings.QUALITY] + list(MEASURES) + list(table.QUALITY_TEXTS)
    for name, member in settings.properties_of(
            made, names + ["Triangulation", "Source", "SourceData", "SourceConnection"]).items():
        setattr(made, name, member)
    return made
