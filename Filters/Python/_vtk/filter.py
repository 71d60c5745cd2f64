# SPDX-License-Identifier: BSD-3-Clause
"""The class itself, made for one VTK."""

import itertools

from .. import _library as engine
from . import cache, messages, settings
from .arrays import Watched, coordinates, ghost_marks, new_array, without_points
from .blocks import Merged
from .execution import SKIPPED, Execution, Progress, let_go
from .lent import lent_of
from .outputs import plane_transform
from .vtkclass import Followers, Inputs, Pieces, Source, build

NAMES = ("vtkAdaptiveHilbertDelaunay2D", "vtkAdaptiveHilbertAlgorithm", "vtkPolyDataAlgorithm")

ABOUT = """Exact 2D Delaunay triangulation of large point sets.

Triangulates points in x and y (or another plane: ProjectionPlaneMode); z is carried along. Input port 0: a vtkPointSet,
or blocks of these. Input port 1: constraints, see SetSourceData. Output ports: the surface, the order of insertion and
the Voronoi diagram, both vtkPolyData and empty unless asked for.

In Python, over the engine's C interface; the compiled class has the same methods and gives the same results.
"""


class _Measures:
    """The measures of the filter; mixed into the class."""

    def _clear_measures(self):
        self._values.update(settings.as_before(settings.MEASURES))

    def _add_counts(self, surface):
        """Field data, with the names of the Get methods."""
        for name in settings.COUNTS:
            made, write = new_array(self._backend.vtkIdTypeArray, 1, 1, name)
            write[0] = self._values[name]
            surface.GetFieldData().AddArray(made)

    def PrintSelf(self):
        """The settings and measures, as text."""
        lines = ["%s: %s" % (setting.name, setting.text(self._values[setting.name])) for setting in settings.SETTINGS]
        for name in settings.MEASURES:
            value = self._values[name]
            lines.append("%s: %s" % (name, "%g" % value if isinstance(value, float) else value))
        transform = self._transform
        lines.append("Transform: %s" % (transform.GetObjectDescription() if hasattr(
            transform, "GetObjectDescription") else transform and transform.GetClassName()))
        return "".join("  %s\n" % line for line in lines)


class _Executions:
    """How RequestData goes; mixed into the class."""

    def RequestData(self, _request, inputs, outputs):
        """Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more."""
        vtk = self._backend
        made = [vtk.vtkPolyData.GetData(outputs, port) for port in range(3)]
        later, time = self._later_pieces(outputs), self.GetMTime()
        if not self._is_wanted(later) and self._empty_of == time:
            self._give_empty(made, later)
            return 1
        given = [vtk.vtkDataObject.GetData(inputs[port]) if inputs[port].GetNumberOfInformationObjects() else None
                 for port in range(2)]
        self._watched, self._input_is_changed = Watched(vtk, *given), False
        try:
            self._make(*given, made)
            self._empty, self._empty_of = [without_points(vtk, output) for output in made], time
            self._give_empty(made, later)
        except engine.EngineError as error:
            self._end(made, error.status, str(error))
        except MemoryError:
            self._end(made, None)
        except BaseException:  # Ctrl-C, mostly
            self._end(made, engine.CANCELLED)
            raise
        finally:
            self._watched = None
            let_go(self._job)
        return 1

    def _give_empty(self, made, later):
        """Empties others than the first piece, but for their arrays: writers of pieces say by the last one which there
        are."""
        for output, empty in itertools.compress(zip(made, self._empty), later):
            output.ShallowCopy(without_points(self._backend, empty))

    def _later_pieces(self, outputs):
        """Of each output, whether it is empty: in one process the first piece has all, and the others nothing."""
        is_alone = self._is_alone(self.GetController())
        return [is_alone and self._is_later_piece(outputs.GetInformationObject(port)) for port in range(3)]

    def _is_wanted(self, later):
        """Is there an output that is made and not empty?"""
        values = self._values
        is_made = True, values["GenerateInsertionCurve"] or values["GenerateBoxes"], values["GenerateVoronoi"]
        return any(made and not empty for made, empty in zip(is_made, later))

    def _make(self, given, source, made):
        """Observers have the outputs, too: all is made in others, and handed on in the end."""
        own = [output.NewInstance() for output in made]
        for ours, output in zip(own, made):
            ours.ShallowCopy(output)
        self._execute(given, source, own)
        for ours, output in zip(own, made):
            output.ShallowCopy(ours)

    def _execute(self, given, source, made):
        vtk, speaker = self._backend, messages.Speaker(self._backend, self)
        merged = Merged(vtk, speaker, self._values, given, source)
        if merged.input is not None and self._pass_on(merged, made):
            merged.hand_on_points(made[0])
            return
        self._clear_measures()
        self._warn_about_ranks(speaker)
        merged.warn()
        if merged.input is None:
            self._cache.forget()
            return
        self._take_back()
        self._values["NumberOfTriangulations"] += 1
        execution = Execution(vtk, self, merged.input, merged.source, merged.bytes)
        # observers may write to them
        numbers = cache.Inputs(merged.input, None) if self.HasObserver("ProgressEvent") else None
        before = numbers and numbers.fingerprints()
        execution.run(made)
        self._values.update(execution.measures())
        self._values["MemoryEstimate"] = self._job.count("memory_estimate") // 1024
        self._add_counts(made[0])
        for text in execution.warnings(self._warned_about_limit):
            speaker.warn(text)
        is_told = self._job.count("segments_without_vertex") and self._job.count("delaunay_triangles")
        self._warned_about_limit = self._job.count("beyond_limit") > 0 and bool(self._warned_about_limit or is_told)
        if self._values["KeepTriangulation"] and not (execution.simplifies or execution.names_numbers):
            self._cache.keep(merged.input, made)  # it knows points, none of their data
        merged.hand_on_points(made[0])
        if not numbers or (before and before == numbers.fingerprints()):
            self._lent = lent_of(execution, made[0], self._values["ReuseLimit"])
        if self._lent is not None:
            self._job = engine.Job()
        else:
            self._job.release(min(self._values["ReuseLimit"] * 1024, 2**62))

    def _take_back(self):
        """What the last execution lent, for its memory."""
        lent, self._lent = self._lent, None
        self._job = lent and lent.close() or self._job

    def _pass_on(self, merged, made):
        """What the last execution made, if that was of the same."""
        if not self._values["KeepTriangulation"] or Progress(self).is_aborted():
            self._cache.forget()
            return False
        if not self._cache.fits(merged.input, merged.source, self.GetMTime()):
            return False
        self._cache.pass_on(merged.input, made)
        if self._lent is not None and not self._lent.reads(merged.input):
            self._take_back()  # no other input is to be held
        self._values.update(dict.fromkeys(settings.SECONDS, 0.0))
        return True

    def _end(self, made, status, more=""):
        """Empties the outputs and reports why. `status`: of the job, None for memory that ran out elsewhere. `more`:
        what is said of faults for which there are no words here."""
        for output in made:
            output.Initialize()
        self._cache.forget()
        self._clear_measures()
        text = "Out of memory. The output is empty."
        if status is not None:
            self._values["MemoryEstimate"] = self._job.count("memory_estimate") // 1024
            text = messages.error_text(status, self._job, more)
        self._job.release()
        if text:
            messages.Speaker(self._backend, self).error(text)

    def _warn_about_ranks(self, speaker):
        ranks = self._backend.controller()
        if ranks and not self._warned_about_ranks and ranks.GetNumberOfProcesses() > 1 and (
                ranks.GetLocalProcessId() == 0):
            self._warned_about_ranks = True
            speaker.warn("There are %d ranks, and each triangulates its own points only: the surfaces of the ranks do "
                         "not join. DistributePoints has an effect in the compiled class only."
                         % ranks.GetNumberOfProcesses())


class _Ports:
    """Inputs and outputs; mixed into the class."""

    def FillInputPortInformation(self, port, info):
        """The first type decides: a filter that takes composite data sets is not run for each block."""
        if port > 1:
            return self._describe_followed(info)
        required = self._backend.vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
        info.Remove(required)
        if port == 1:
            kinds = ("vtkPolyData", "vtkCompositeDataSet")
            info.Set(self._backend.vtkAlgorithm.INPUT_IS_OPTIONAL(), 1)
        else:
            kinds = ("vtkCompositeDataSet", "vtkPointSet") if self._values["MergeBlocks"] else ("vtkPointSet",)
            kinds += ("vtkTable",)  # to say what to do with it
        for kind in kinds:
            info.Append(required, kind)
        return 1

    def RequestUpdateExtent(self, _request, inputs, _outputs):
        """All of the input, and no more. In one process whatever piece of the output is wanted: surfaces of pieces do
        not join."""
        exact = self._backend.vtkStreamingDemandDrivenPipeline.EXACT_EXTENT()
        for vector in inputs:
            for i in range(vector.GetNumberOfInformationObjects()):
                vector.GetInformationObject(i).Set(exact, 1)
            if self._is_alone(self.GetController()):
                self._ask_for_all(vector)
        return 1

    def GetPolyDataInput(self, port=0):
        """The vtkPolyData at this input port, or None."""
        return self._given(port, "vtkPolyData")


class _Ranks:
    """The compiled class's ranks, kept for programs that name them; mixed into the class."""

    _controller = ()  # none was set

    def SetController(self, controller):
        """No effect in this class, which knows no ranks: see SetDistributePoints."""
        self._controller = controller

    def GetController(self):
        """The ranks of the compiled class: by default VTK's global controller, or None."""
        return self._backend.controller() if self._controller == () else self._controller


class _Transforms:
    """The transform, whose changes are the filter's; mixed into the class."""

    def SetTransform(self, transform):
        """The transform applied to the points before they are triangulated; None: none."""
        if transform is not None and not isinstance(transform, self._backend.vtkAbstractTransform):
            raise TypeError("SetTransform argument 1: a vtkAbstractTransform of %s is required, not %s" % (
                self._backend.package, type(transform).__name__))
        if transform is self._transform:
            return
        self._transform = transform
        if transform is not None or self._changes is not None:
            self.changes().SetTransform(transform or self._backend.vtkTransform())
            self._follow(self.changes() if transform else None)
        self.Modified()

    def GetTransform(self):
        """The transform applied to the points, or None."""
        return self._transform

    def GetMTime(self):
        """When the filter or its Transform was changed last."""
        own = super().GetMTime()
        return max(own, self._transform.GetMTime()) if self._transform is not None else own

    def _changed(self, name):
        """A setting has another value now."""
        if name == "MergeBlocks":
            self.FillInputPortInformation(0, self.GetInputPortInformation(0))


def _plane_computer(backend):
    def ComputeBestFittingPlane(given):
        """The plane with the least sum of squared distances of the finite points, as a vtkTransform that turns and
        shifts it to z = 0; None without input or memory."""
        if given is None:
            return None
        job = engine.Job()
        job.set_array("points", coordinates(backend, given.GetPoints()))
        job.set_array("skip", ghost_marks(given)[0])
        job.set(skip_mask=SKIPPED)
        try:
            return plane_transform(backend, job.fit_plane())
        except MemoryError:
            return None

    return ComputeBestFittingPlane


def make_class(backend):
    """The class over this VTK."""

    def start(self):
        self._values = {setting.name: setting.default for setting in settings.SETTINGS}
        self._values.update(settings.MEASURES)
        self._transform = None
        self._warned_about_ranks = False
        self._warned_about_limit = False  # once, as some move InsertionLimit step by step
        self._job = engine.Job()
        self._cache, self._lent = cache.OutputCache(backend), None
        self._empty, self._empty_of = [], None  # the last outputs without a point, and the time of their settings

    members = dict(settings.all_methods(), __doc__=ABOUT,
                   ComputeBestFittingPlane=staticmethod(_plane_computer(backend)))
    parts = _Measures, _Executions, _Ports, _Ranks, _Transforms, Source, Inputs, Followers, Pieces
    made = build(backend, NAMES, parts, members, start, (2, 3))
    for name, member in settings.properties_of(made).items():
        setattr(made, name, member)
    return made
