# SPDX-License-Identifier: BSD-3-Clause
"""Lets Python code that uses vtkDelaunay2D run on vtkAdaptiveHilbertDelaunay2D, unchanged.

    import adaptivehilbertdelaunay.drop_in

From then on `vtkmodules.vtkFiltersCore.vtkDelaunay2D`, and that of `cvista`, is the class vtkDelaunay2D of this
module. Modules that imported the name before get the new class too, whatever they call it: `vtk`,
`vtkmodules.all`, PyVista, your own `from vtkmodules.vtkFiltersCore import vtkDelaunay2D`. So it makes no
difference whether this import comes first or last, as long as it comes before the filter is made.

    drop_in.uninstall()            # the original is back
    drop_in.install()              # replaced again
    with drop_in.suspended():      # the original is back inside the block
        ...

Not replaced, because no module has a name for them: classes derived from the original before, the original in a list,
default argument or local variable, filters created before, filters created by C++ code. Left alone: names that a module
imported from this one, `drop_in.original` or `drop_in.vtkDelaunay2D`.

README.md beside the source of this file describes how the two classes differ.
"""

import contextlib
import importlib
import importlib.abc
import sys
from typing import Any, Iterator

from . import _vtk

__all__ = ["install", "installed", "suspended", "uninstall"]  # original and vtkDelaunay2D by __getattr__

MODULE = ".vtkFiltersCore"  # that has the class, in each VTK

if "uninstall" in globals():  # importlib.reload()
    uninstall()  # noqa: F821

_replaced = {}  # by VTK, "vtkmodules" or "cvista": its own class, and the one in its place
_wanted = [False]  # is the original to be replaced where a VTK is imported from now on?
_in_place = {}  # by VTK: is it the one in its place that modules have?
_places = {}  # by VTK: (names of a module, name) where a class was put
_askers = globals().get("_askers") or {"original": [], "vtkDelaunay2D": []}  # names of modules that asked for these


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


class _Clothes:
    """The differences from vtkAdaptiveHilbertDelaunay2D:
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
        if cls is cls._made:
            cls._original(*arguments, **properties)  # VTK looks at the arguments of its own classes only
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
        if not command and event in ("EndEvent", self._end_event):
            self._watch()

    def NewInstance(self):
        """A new filter with default settings."""
        return self._made()

    def GetClassName(self):
        """ "vtkDelaunay2D"."""
        return "vtkDelaunay2D"

    def IsA(self, name):
        """1 if this is what vtkDelaunay2D is or what vtkAdaptiveHilbertDelaunay2D is, else 0."""
        return int(name == "vtkDelaunay2D" or super().IsA(name))

    def GetNumberOfGenerationsFromBase(self, name):
        """How many classes vtkDelaunay2D is derived from the named one; negative if it is not."""
        return self.GetNumberOfGenerationsFromBaseType(name)

    @classmethod
    def IsTypeOf(cls, name):
        """1 if vtkDelaunay2D or vtkAdaptiveHilbertDelaunay2D is or derives from the named class, else 0."""
        return int(name == "vtkDelaunay2D" or cls._base.IsTypeOf(name))

    @classmethod
    def SafeDownCast(cls, instance):
        """The argument if it is a vtkDelaunay2D, be it the original or this one, else None."""
        return instance if isinstance(instance, cls._made) else None

    @classmethod
    def GetNumberOfGenerationsFromBaseType(cls, name):
        """How many classes vtkDelaunay2D is derived from the named one; negative if it is not."""
        return cls._original.GetNumberOfGenerationsFromBaseType(name)


class _SaysYesToOriginals(type):
    """Makes isinstance true for filters of the original class, made before it was replaced."""

    def __instancecheck__(cls, instance):
        return super().__instancecheck__(instance) or (
            cls is cls._made and isinstance(instance, cls._original))


def _make(package, original):
    """The class that takes the place of a VTK's own."""
    base = _vtk.vtk_class("vtkAdaptiveHilbertDelaunay2D", package)
    about = "vtkAdaptiveHilbertDelaunay2D in the clothes of vtkDelaunay2D.\n\n    " + _Clothes.__doc__
    members = {
        "__doc__": about, "__module__": __name__, "_original": original, "_base": base,
        "_end_event": importlib.import_module(package + ".vtkCommonCore").vtkCommand.EndEvent}
    # Not by the original's name: cvista for Python 3.12 and later makes what it knows by that name.
    made = _SaysYesToOriginals("Delaunay2D", (_Clothes, base), members)
    made._made = made
    return made


def _pair(package):
    """A VTK's own class, and the one in its place. Imports that VTK."""
    if package not in _replaced:
        original = importlib.import_module(package + MODULE).vtkDelaunay2D
        if package not in _replaced:  # the import may have seen to it
            _replaced[package] = original, _make(package, original)
    return _replaced[package]


def __getattr__(name: str) -> Any:
    """`original`: the class of the VTK in use, whatever is installed; `vtkDelaunay2D`: the one for its place."""
    if name in _askers:
        return _given(name, sys._getframe(1).f_globals)
    raise AttributeError("module %r has no attribute %r" % (__name__, name))


def _given(name, asker):
    """The class of this name, for a module with these names: under which of them it keeps it is its own business from
    now on. Those that hold it already have it of VTK."""
    package = _vtk.package_in_use()
    made = _pair(package)[name == "vtkDelaunay2D"]
    if not _is_one_of(asker, _askers[name]):
        _askers[name].append(asker)
        _places.setdefault(package, []).extend((asker, own) for own, value in list(asker.items()) if value is made)
    return made


def _is_one_of(names, among):
    return any(names is other for other in among)


def _replace(package, installs):
    """Puts this VTK's class, or the one in its place, where a loaded module holds the other under a name: where it did
    so before, unless the module has put another one there since, and in modules that cannot have the other from
    here."""
    original, ours = _pair(package)
    old, new = (original, ours) if installs else (ours, original)
    askers = _askers["original" if installs else "vtkDelaunay2D"]
    before, now = _places.get(package, ()), []
    has = new if _in_place.get(package) == installs else old  # the value of a name where a class was put
    _in_place[package] = installs
    for module in list(sys.modules.values()):
        try:  # past __getattribute__: a look at a lazy module must not load it
            names = object.__getattribute__(module, "__dict__")
        except AttributeError:
            continue
        if names is globals():
            continue
        put = {name for others, name in before if others is names and names.get(name) is has}
        is_asker = _is_one_of(names, askers)
        for name, value in list(names.items()):
            if value is old and (name in put or not is_asker):
                names[name] = new
                put.add(name)
        now += [(names, name) for name in put]
    _places[package] = now


class _Watch(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Replaces the class where a VTK is imported later: stands before the other finders, of which VTK's packages add
    one themselves, and lets them load the modules."""

    def __init__(self):
        self._loaders = {}

    def come_first(self):
        self.go()
        sys.meta_path.insert(0, self)

    def go(self):
        if self in sys.meta_path:
            sys.meta_path.remove(self)

    def find_spec(self, name, path, target=None):
        """The spec that another finder has, to be loaded by this object."""
        if name not in _vtk.PACKAGES and name not in [package + MODULE for package in _vtk.PACKAGES]:
            return None
        for finder in sys.meta_path:
            found = None if finder is self else finder.find_spec(name, path, target)
            if found is not None and found.loader is not None:
                self._loaders[name], found.loader = found.loader, self
                return found
        return None

    def create_module(self, spec):
        """By the other loader."""
        return self._loaders[spec.name].create_module(spec)

    def exec_module(self, module):
        """By the other loader; then the class is replaced, if it is to be."""
        name = module.__name__
        module.__spec__.loader = module.__loader__ = self._loaders.pop(name)
        module.__loader__.exec_module(module)
        if _wanted[0]:
            self.come_first()
            if name.endswith(MODULE):
                _replace(_package_of(module), True)


def _package_of(module):
    """The VTK of this module, which has its class."""
    package = module.__name__.split(".", 1)[0]
    if package not in _replaced:
        _replaced[package] = module.vtkDelaunay2D, _make(package, module.vtkDelaunay2D)
    return package


_watch = _Watch()


def _loaded():
    """The VTKs whose module with the class is there."""
    return [package for package in _vtk.PACKAGES if package + MODULE in sys.modules]


def install() -> None:
    """Replaces VTK's vtkDelaunay2D in all loaded modules, of `vtkmodules` and of `cvista`, and in those that are loaded
    later. Importing this module does it."""
    _wanted[0] = True
    _watch.come_first()
    for package in _loaded():
        _replace(package, True)


def uninstall() -> None:
    """Puts VTK's vtkDelaunay2D back in all loaded modules. Existing filters stay unchanged."""
    _wanted[0] = False
    _watch.go()
    for package in list(_replaced):
        _replace(package, False)


def installed() -> bool:
    """Is VTK's vtkDelaunay2D replaced at the moment?"""
    return _wanted[0]


@contextlib.contextmanager
def suspended() -> Iterator[Any]:
    """VTK's vtkDelaunay2D is back inside a `with` block; afterwards all is as it was before. Gives the original."""
    was_installed = installed()
    uninstall()
    asker = sys._getframe(1)
    while asker.f_globals.get("__name__") == contextlib.__name__ and asker.f_back is not None:
        asker = asker.f_back
    try:
        yield _given("original", asker.f_globals)
    finally:
        if was_installed:
            install()


install()
