# SPDX-License-Identifier: BSD-3-Clause
"""Lets Python code that uses vtkDelaunay2D run on vtkAdaptiveHilbertDelaunay2D, unchanged.

    import adaptivehilbertdelaunay.drop_in

From then on `vtkmodules.vtkFiltersCore.vtkDelaunay2D` is the class vtkDelaunay2D of this module. Modules
that have taken the name from there before get the new class too, whatever they call it: `vtk`,
`vtkmodules.all`, PyVista, your own `from vtkmodules.vtkFiltersCore import vtkDelaunay2D`. So it makes no
difference whether this import comes first or last, as long as it comes before the filter is made.

    drop_in.uninstall()            # the original is back
    drop_in.install()              # replaced again
    with drop_in.suspended():      # the original is back inside the block
        ...

Not reached, since no module holds them under a name: a class derived from the original before, the original
in somebody's list or default argument or local variable, filters made before, filters that C++ code makes.

README.md beside the source of this file says in what the two classes differ.
"""

import contextlib
import sys

from vtkmodules import vtkFiltersCore
from vtkmodules.vtkCommonCore import vtkCommand

from . import vtkAdaptiveHilbertDelaunay2D

__all__ = ["install", "installed", "original", "suspended", "uninstall", "vtkDelaunay2D"]

#: VTK's own class, whatever is installed.
original = vtkFiltersCore.vtkDelaunay2D


class _SaysYesToOriginals(type):
    """Makes isinstance true for filters of the original class, made before it was replaced."""

    def __instancecheck__(cls, instance):
        return super().__instancecheck__(instance) or (
            cls is vtkDelaunay2D and isinstance(instance, original)
        )


def _pass_field_data(given, made):
    """Gives an output the field data of its input, block by block, and no other."""
    if made is None or given is None:
        return
    made.GetFieldData().ShallowCopy(given.GetFieldData())
    if made.IsA("vtkMultiBlockDataSet") and given.IsA("vtkMultiBlockDataSet"):
        for block in range(made.GetNumberOfBlocks()):
            _pass_field_data(given.GetBlock(block), made.GetBlock(block))


def _forget_measures(algorithm, _event):
    """Takes the filter's measures out of the field data, where the original has none."""
    _pass_field_data(algorithm.GetInputDataObject(0, 0), algorithm.GetOutputDataObject(0))


class vtkDelaunay2D(vtkAdaptiveHilbertDelaunay2D, metaclass=_SaysYesToOriginals):
    """vtkAdaptiveHilbertDelaunay2D in the clothes of vtkDelaunay2D.

    What is different from vtkAdaptiveHilbertDelaunay2D:
    - Tolerance is 1e-5 to begin with, as in vtkDelaunay2D: a fraction of the diagonal of the bounding box,
      here in the triangulation plane; points nearer to another than that are merged, and GetNumberOfMergedPoints
      says how many;
    - it says that its class is vtkDelaunay2D;
    - the field data of the output are those of the input, without the filter's measures. Observers of the
      EndEvent take these out, before those of the caller that have the priority 0, as all have by default. Neither
      RemoveAllObservers nor RemoveObservers("EndEvent") takes them off.

    All further properties and measures of vtkAdaptiveHilbertDelaunay2D can be used as well.
    """

    def __new__(cls, *arguments, **properties):
        if cls is vtkDelaunay2D:
            original(*arguments, **properties)  # VTK looks at the arguments of its own classes only
        made = super().__new__(cls, *arguments, **properties)
        made.SetTolerance(1e-5)
        made._watch()
        return made

    def _watch(self):
        """Has the measures taken out after each run, before observers of the caller see them. Twice: of observers
        of one priority VTK calls the one that was added first last, and the others in order. No priority above 0:
        VTK 9.7 calls such an observer without end once Python holds the filter no longer."""
        for _ in range(2):
            self.AddObserver("EndEvent", _forget_measures)

    def RemoveAllObservers(self):
        """Takes off the observers that were added."""
        super().RemoveAllObservers()
        self._watch()

    def RemoveObservers(self, event, *command):
        """Takes off the observers of this event that were added, or those with this command."""
        super().RemoveObservers(event, *command)
        if not command and event in ("EndEvent", vtkCommand.EndEvent):
            self._watch()

    def NewInstance(self):
        """A new filter with default settings."""
        return vtkDelaunay2D()

    def GetClassName(self):
        """ "vtkDelaunay2D"."""
        return "vtkDelaunay2D"

    def IsA(self, name):
        """1 if this is what vtkDelaunay2D is or what vtkAdaptiveHilbertDelaunay2D is, else 0."""
        return int(name == "vtkDelaunay2D" or super().IsA(name))

    @staticmethod
    def IsTypeOf(name):
        """1 if vtkDelaunay2D or vtkAdaptiveHilbertDelaunay2D is or derives from the named class, else 0."""
        return int(name == "vtkDelaunay2D" or vtkAdaptiveHilbertDelaunay2D.IsTypeOf(name))

    @staticmethod
    def SafeDownCast(instance):
        """The argument if it is a vtkDelaunay2D, be it the original or this one, else None."""
        return instance if isinstance(instance, vtkDelaunay2D) else None

    def GetNumberOfGenerationsFromBase(self, name):
        """How many classes vtkDelaunay2D is derived from the named one; negative if it is not."""
        return self.GetNumberOfGenerationsFromBaseType(name)

    @staticmethod
    def GetNumberOfGenerationsFromBaseType(name):
        """How many classes vtkDelaunay2D is derived from the named one; negative if it is not."""
        return original.GetNumberOfGenerationsFromBaseType(name)


def _replace(old, new):
    """Puts `new` in the place of `old` wherever a loaded module holds it under a name."""
    for module in list(sys.modules.values()):
        try:  # past __getattribute__: a look at a lazy module must not load it
            names = object.__getattribute__(module, "__dict__")
        except AttributeError:
            continue
        if names is globals():
            continue
        for name, value in list(names.items()):
            if value is old:
                names[name] = new


def install():
    """Replaces VTK's vtkDelaunay2D in all loaded modules. Importing this module does it."""
    _replace(original, vtkDelaunay2D)


def uninstall():
    """Puts VTK's vtkDelaunay2D back in all loaded modules. Filters that were made stay what they are."""
    _replace(vtkDelaunay2D, original)


def installed():
    """Is VTK's vtkDelaunay2D replaced at the moment?"""
    return vtkFiltersCore.vtkDelaunay2D is vtkDelaunay2D


@contextlib.contextmanager
def suspended():
    """VTK's vtkDelaunay2D is back inside a `with` block; afterwards all is as it was before."""
    was_installed = installed()
    uninstall()
    try:
        yield original
    finally:
        if was_installed:
            install()


install()
