# SPDX-License-Identifier: BSD-3-Clause
"""vtkAdaptiveHilbertDelaunay2D and the classes beside it in Python, over whichever VTK a process uses: `vtkmodules`
(VTK's wheels, Debian, ParaView) or `cvista`.

The engine is called through its C interface; nothing is compiled against VTK. Methods, outputs, messages and results
are those of the compiled class.
"""

import importlib
import importlib.util
import sys

PACKAGES = ("vtkmodules", "cvista")

COMPILED = "_compiled"  # the module of the classes that were compiled with VTK
# The classes that there are in Python, and their modules.
_PYTHON = {"vtkAdaptiveHilbertDelaunay2D": "filter", "vtkAdaptiveHilbertInterpolation2D": "interpolation",
           "vtkAdaptiveHilbertQualityMesh2D": "quality", "vtkPlanarPointSource": "source",
           "vtkPlanarSurfaceOutline": "outline"}

_classes = {}


class Backend:
    """One VTK: its classes as attributes, looked up when they are asked for."""

    MODULES = ("vtkCommonCore", "vtkCommonDataModel", "vtkCommonExecutionModel", "vtkCommonTransforms",
               "vtkFiltersGeneral")

    def __init__(self, package):
        self.package = package

    def __getattr__(self, name):
        for module in self.MODULES:
            found = getattr(importlib.import_module(self.package + "." + module), name, None)
            if found is not None:
                setattr(self, name, found)
                return found
        raise AttributeError("%s has no %s" % (self.package, name))

    def algorithm_base(self):
        """VTK's superclass of algorithms in Python."""
        return importlib.import_module(self.package + ".util.vtkAlgorithm").VTKPythonAlgorithmBase

    def controller(self):
        """VTK's global vtkMultiProcessController; None if that module is not loaded."""
        module = sys.modules.get(self.package + ".vtkParallelCore")
        return module.vtkMultiProcessController.GetGlobalController() if module else None


def package_of(thing):
    """Which VTK an object or a class is of, "vtkmodules" or "cvista"; None if it is of neither. By its superclass: what
    classes of cvista call their module is not always true."""
    kind = thing if isinstance(thing, type) else type(thing)
    for package in PACKAGES:
        core = sys.modules.get(package + ".vtkCommonCore")
        if core is not None and issubclass(kind, core.vtkObjectBase):
            return package
    return None


def package_in_use():
    """The VTK that is imported; PyVista's, if both are; if none is, the one that is installed, `vtkmodules` first.
    ImportError if there is none."""
    imported = [package for package in PACKAGES if sys.modules.get(package) is not None]
    if len(imported) > 1 and "pyvista" in sys.modules:
        of_pyvista = package_of(sys.modules["pyvista"].PolyData)
        imported = [of_pyvista] if of_pyvista else imported
    installed = imported or [package for package in PACKAGES if importlib.util.find_spec(package)]
    if not installed:
        raise ImportError("vtkAdaptiveHilbertDelaunay2D needs VTK, and Python finds none: pip install vtk")
    return installed[0]


def python_class(package=None, name="vtkAdaptiveHilbertDelaunay2D"):
    """A class of this package in Python over this VTK ("vtkmodules" or "cvista"; None: the one in use), the same class
    each time. ImportError if that VTK is not installed."""
    package = package or package_in_use()
    if package not in PACKAGES:
        raise ValueError("no VTK that is known here: %r; there are %s" % (package, " and ".join(PACKAGES)))
    if (package, name) not in _classes:
        module = importlib.import_module("." + _PYTHON[name], __name__)
        _classes[package, name] = module.make_class(Backend(package))
    return _classes[package, name]


def vtk_class(name, package=None):
    """A class of this package by VTK's name, over this VTK (None: the one in use): the compiled one where it was built
    with that VTK, else the one in Python. ImportError if there is neither."""
    package = package or package_in_use()
    if package == "vtkmodules":
        try:
            compiled = importlib.import_module("..%s" % COMPILED, __name__)
            if hasattr(compiled, name):
                return getattr(compiled, name)
            refused = None
        except ImportError as error:
            refused = error
    else:
        refused = None
    if name in _PYTHON:
        try:
            return python_class(package, name)
        except ImportError as error:
            raise refused if refused and not isinstance(refused, ModuleNotFoundError) else error
    raise refused or ImportError("%s is compiled with VTK only; here it is not" % name)


def class_names():
    """The names for which there surely is a class, found without loading a VTK."""
    return list(_PYTHON) if any(importlib.util.find_spec(package) for package in PACKAGES) else []
