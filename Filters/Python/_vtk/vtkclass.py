# SPDX-License-Identifier: BSD-3-Clause
"""What the classes in Python share: what VTK asks a class for, settings, inputs, outputs."""

from . import package_of


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


class Outputs:
    """Mixed into a class that has _backend."""

    def GetOutput(self, port=0):
        """The vtkPolyData at this output port."""
        found = self.GetOutputDataObject(port)
        return found if isinstance(found, self._backend.vtkPolyData) else None

    def SetOutput(self, output):
        """The data object that output port 0 puts its data into."""
        self.GetExecutive().SetOutputData(0, output)


def build(backend, names, parts, members, start, ports, puts_out="vtkPolyData"):
    """The class: of these parts over VTK's superclass of algorithms in Python. `start(self)`: its attributes before
    VTK asks for anything. `ports`: numbers of input and output ports. `puts_out`: what all outputs are."""
    base = backend.algorithm_base()

    def __new__(cls, *_given, **_properties):
        """Ready without __init__, which derived classes need not call: those of VTK are so too."""
        self = base.__new__(cls)
        start(self)
        base.__init__(self, nInputPorts=ports[0], inputType="vtkPointSet", nOutputPorts=ports[1],
                      outputType=puts_out)
        return self

    def __init__(self, *_given, **properties):
        for name, value in properties.items():
            if not hasattr(type(self), name):
                raise AttributeError("%s has no property %s" % (names[0], name))
            setattr(self, name, value)

    package = __name__.rsplit(".", 2)[0]
    return type(names[0], (*parts, Names, Outputs, base), dict(
        members, __new__=__new__, __init__=__init__, __module__=package, NAMES=names, _backend=backend))
