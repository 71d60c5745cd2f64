# SPDX-License-Identifier: BSD-3-Clause
"""The common part of the classes in Python: VTK's requests, settings, inputs, outputs."""

from . import package_of
from .interrupts import ends_by_ctrl_c


class Names:
    """Names of classes, text, settings; mixed into a class that has NAMES, its own name and those of its superclasses
    up to vtkPolyDataAlgorithm, _backend, _values and PrintSelf."""

    def GetClassName(self):
        """The name that the compiled class has."""
        return self.NAMES[0]

    def IsA(self, name):
        """1 if this is of the named class or derives from it, else 0."""
        return int(name in self.NAMES or super().IsA(name))

    @classmethod
    def IsTypeOf(cls, name):
        """1 if the class is or derives from the named one, else 0."""
        return int(name in cls.NAMES or cls._backend.vtkAlgorithm.IsTypeOf(name))

    @classmethod
    def SafeDownCast(cls, instance):
        """The argument if it is of this class, else None."""
        return instance if isinstance(instance, cls) else None

    @classmethod
    def GetNumberOfGenerationsFromBaseType(cls, name):
        """How many classes this one is derived from the named one; negative if it is not."""
        if name in cls.NAMES:
            return cls.NAMES.index(name)
        above = cls._backend.vtkAlgorithm.GetNumberOfGenerationsFromBaseType(name)
        return above + len(cls.NAMES) if above >= 0 else above

    def GetNumberOfGenerationsFromBase(self, name):
        """How many classes this one is derived from the named one; negative if it is not."""
        return self.GetNumberOfGenerationsFromBaseType(name)

    def NewInstance(self):
        """A new one with default settings."""
        return type(self)()

    @ends_by_ctrl_c
    def ProcessRequest(self, request, inputs, outputs):
        """Called by the pipeline: 1 if the request was met. What is raised while data are made, by Ctrl-C mostly,
        leaves nothing of them."""
        try:
            return super().ProcessRequest(request, inputs, outputs)
        except BaseException:
            if request.Has(self._backend.vtkDemandDrivenPipeline.REQUEST_DATA()):
                for port in range(self.GetNumberOfOutputPorts()):
                    self._backend.vtkDataObject.GetData(outputs, port).Initialize()
            raise

    def __str__(self):
        header, _, rest = super().__str__().partition("\n")
        address = header[header.find(" ("):] if " (" in header else ""
        return "%s%s\n%s%s" % (self.NAMES[0], address, rest, self.PrintSelf())

    def _set(self, setting, value):
        now = self._values[setting.name]
        value = setting.convert(value, now)
        if value is not now and value != now:
            self._values[setting.name] = value
            self._changed(setting.name)
            self.Modified()

    def _changed(self, name):
        """A setting has another value now."""


class Followers:
    """Has the pipeline ask whether other objects have changed; mixed into a class that has _backend.

    VTK asks a filter and those before it when they were changed, but asks no code in Python. So there is one more input
    port, behind all others and seen by C++ code only, for a filter of VTK's that has been changed when the objects
    have."""

    _changes = None  # that filter of this one's own

    def GetNumberOfInputPorts(self):
        """How many there are for data."""
        return super().GetNumberOfInputPorts() - 1

    def GetTotalNumberOfInputConnections(self):
        """How many connections bring data."""
        return sum(self.GetNumberOfInputConnections(port) for port in range(self.GetNumberOfInputPorts()))

    def changes(self):
        """A filter of VTK's that was changed when this one was, or its transform."""
        if self._changes is None:
            made, moved = self._backend.vtkTransformFilter(), self._backend.vtkPolyData()
            moved.SetPoints(self._backend.vtkPoints())
            made.SetInputDataObject(moved)
            made.SetTransform(self._backend.vtkTransform())
            self._changes = made
        return self._changes

    def _follow(self, changes):
        """Has the pipeline ask this filter of VTK's. None: no more."""
        self.SetInputConnection(self.GetNumberOfInputPorts(), changes and changes.GetOutputPort())

    def Modified(self):
        """Has the filter run at the next update."""
        super().Modified()
        if self._changes is not None:
            self._changes.Modified()

    def _describe_followed(self, info):
        algorithm = self._backend.vtkAlgorithm
        info.Set(algorithm.INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData")
        info.Set(algorithm.INPUT_IS_OPTIONAL(), 1)
        return 1


class Pieces:
    """Pieces of outputs that are asked for in one process; mixed into a class that has _backend."""

    def _is_alone(self, controller):
        """Does no other process work on pieces of its own? `controller`: the filter's, or None."""
        return all(ranks is None or ranks.GetNumberOfProcesses() < 2 for ranks in (
            controller, self._backend.controller()))

    def _ask_for_all(self, inputs):
        """Of these inputs, whichever piece of the output is wanted."""
        pipeline = self._backend.vtkStreamingDemandDrivenPipeline
        for i in range(inputs.GetNumberOfInformationObjects()):
            info = inputs.GetInformationObject(i)
            info.Set(pipeline.UPDATE_PIECE_NUMBER(), 0)
            info.Set(pipeline.UPDATE_NUMBER_OF_PIECES(), 1)
            info.Set(pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
            if info.Has(pipeline.WHOLE_EXTENT()):
                info.Set(pipeline.UPDATE_EXTENT(), info.Get(pipeline.WHOLE_EXTENT()), 6)

    def _is_later_piece(self, output):
        """Is another piece than the first wanted of this output?"""
        number = self._backend.vtkStreamingDemandDrivenPipeline.UPDATE_PIECE_NUMBER()
        return bool(output.Has(number)) and output.Get(number) > 0


class Inputs:
    """Mixed into a class that has _backend and input ports."""

    def SetInputDataObject(self, *given):
        """SetInputDataObject(data) or SetInputDataObject(port, data): an input, without a pipeline. TypeError for data
        of another VTK than the filter's."""
        package = package_of(given[-1]) if given else None
        if package not in (None, self._backend.package):
            raise TypeError("data of %s, but the filter is over %s: import %s before the class is asked for" % (
                package, self._backend.package, package))
        super().SetInputDataObject(*given)

    def SetInputData(self, *given):
        """SetInputData(data) or SetInputData(port, data): an input, without a pipeline."""
        self.SetInputDataObject(*given)

    def AddInputData(self, *given):
        """AddInputData(data) or AddInputData(port, data)."""
        self.AddInputDataObject(*given)

    def GetInput(self, port=0):
        """The data object at this input port, or None."""
        return self.GetInputDataObject(port, 0) if self.GetNumberOfInputConnections(port) > 0 else None


    def _give(self, port, name, kind, data):
        if data is not None and not isinstance(data, getattr(self._backend, kind)):
            raise TypeError("%s argument 1: a %s of %s is required, not %s" % (
                name, kind, self._backend.package, type(data).__name__))
        self.SetInputDataObject(port, data)

    def _given(self, port, kind):
        found = self.GetInput(port)
        return found if isinstance(found, getattr(self._backend, kind)) else None


class Source:
    """Constraints at an input port; mixed into a class that has Inputs, Followers and KINDS, the types of each port."""

    _source_port = 1

    def FillInputPortInformation(self, port, info):
        """The first type decides: a filter that takes composite data sets is not run for each block."""
        if port >= len(self.KINDS):
            return self._describe_followed(info)
        algorithm = self._backend.vtkAlgorithm
        info.Remove(algorithm.INPUT_REQUIRED_DATA_TYPE())
        for kind in self.KINDS[port]:
            info.Append(algorithm.INPUT_REQUIRED_DATA_TYPE(), kind)
        if port > 0:
            info.Set(algorithm.INPUT_IS_OPTIONAL(), 1)
        return 1

    def SetSourceData(self, source):
        """The constraints: a vtkPolyData, whose lines become edges and whose polygons edges and loops that bound what
        is kept; None: none."""
        self._give(self._source_port, "SetSourceData", "vtkPolyData", source)

    def SetSourceConnection(self, output):
        """The constraints as an output port of another filter."""
        self.SetInputConnection(self._source_port, output)

    def GetSource(self):
        """The constraints, if they are one vtkPolyData."""
        return self._given(self._source_port, "vtkPolyData")


class Outputs:
    """Mixed into a class that has _backend."""

    _watched, _input_is_changed = None, False  # while an execution goes: arrays.Watched, and what became of it

    def GetOutput(self, port=0):
        """The vtkPolyData at this output port."""
        found = self.GetOutputDataObject(port)
        return found if isinstance(found, self._backend.vtkPolyData) else None

    def SetOutput(self, output):
        """The data object that output port 0 puts its data into."""
        self.GetExecutive().SetOutputData(0, output)


def build(backend, names, parts, members, start, ports, puts_out="vtkPolyData", begin=lambda self: None):
    """The class: of these parts over VTK's superclass of algorithms in Python. `start(self)`: its attributes before
    VTK asks for anything. `ports`: numbers of input and output ports. `puts_out`: what all outputs are. `begin(self)`:
    what is done when it has ports."""
    base = backend.algorithm_base()

    def __new__(cls, *_given, **_properties):
        """Ready without __init__, which derived classes need not call: those of VTK are so too."""
        self = base.__new__(cls)
        start(self)
        base.__init__(self, nInputPorts=ports[0] + issubclass(cls, Followers), inputType="vtkPointSet",
                      nOutputPorts=ports[1], outputType=puts_out)
        begin(self)
        return self

    def __init__(self, *_given, **properties):
        for name, value in properties.items():
            if not hasattr(type(self), name):
                raise AttributeError("%s has no property %s" % (names[0], name))
            setattr(self, name, value)

    package = __name__.rsplit(".", 2)[0]
    return type(names[0], (*parts, Names, Outputs, base), dict(
        members, __new__=__new__, __init__=__init__, __module__=package, NAMES=names, _backend=backend))
