# SPDX-License-Identifier: BSD-3-Clause
"""Exact 2D Delaunay triangulation of large point sets.

    from adaptivehilbertdelaunay import delaunay                     # NumPy arrays in, arrays out

    from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D, vtkPlanarPointSource    # for VTK

The first needs NumPy alone. The second are a VTK filter and a source of point sets; with
vtkAdaptiveHilbertInterpolation2D, values between the points on rasters and at places. They are the compiled classes if
the package was built with VTK and Python has that version (the first two numbers count); otherwise the same classes in
Python, over the imported `vtkmodules` or `cvista`. ImportError without VTK.

Code that uses vtkDelaunay2D runs on this filter after `import adaptivehilbertdelaunay.drop_in`. Code written for scipy
takes `Delaunay`, `griddata` and others from `adaptivehilbertdelaunay.scipy`, for points in the plane.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, List

if TYPE_CHECKING:
    from ._arrays import Boxes as Boxes
    from ._arrays import DelaunayWarning as DelaunayWarning
    from ._arrays import Kind as Kind
    from ._arrays import Location as Location
    from ._arrays import Outline as Outline
    from ._arrays import Triangulation as Triangulation
    from ._arrays import Voronoi as Voronoi
    from ._arrays import delaunay as delaunay
    from ._arrays import release_memory as release_memory
    from ._edit import Edit as Edit
    from ._edit import EditPlaces as EditPlaces
    from ._interpolators import LinearInterpolator as LinearInterpolator
    from ._interpolators import NaturalNeighborInterpolator as NaturalNeighborInterpolator
    from ._interpolators import NearestInterpolator as NearestInterpolator
    from ._raster import Raster as Raster
    from ._refined import BadReason as BadReason
    from ._refined import Mesh as Mesh
    from ._results import Adjacency as Adjacency
    from ._results import Contours as Contours
    from ._results import Lines as Lines
    from ._sampling import Weights as Weights

    __version__: str
    vtkAdaptiveHilbertAlgorithm: Any
    vtkAdaptiveHilbertDelaunay2D: Any
    vtkAdaptiveHilbertInterpolation2D: Any
    vtkAdaptiveHilbertInterpolationAlgorithm: Any
    vtkAdaptiveHilbertQualityMesh2D: Any
    vtkAdaptiveHilbertQualityMeshAlgorithm: Any
    vtkPlanarPointSource: Any

# Modules are loaded when one of their names is first used: arrays need no VTK, and VTK no arrays.
_ARRAYS = ("Boxes", "DelaunayWarning", "Kind", "Location", "Outline", "Triangulation", "Voronoi", "delaunay",
           "release_memory")  # fmt: skip
_MODULES = {
    **dict.fromkeys(_ARRAYS, "._arrays"),
    **dict.fromkeys(("LinearInterpolator", "NaturalNeighborInterpolator", "NearestInterpolator"), "._interpolators"),
    **dict.fromkeys(("Edit", "EditPlaces"), "._edit"),
    "Raster": "._raster",
    **dict.fromkeys(("BadReason", "Mesh"), "._refined"),
    "__version__": "._interface",
    **dict.fromkeys(("Adjacency", "Contours", "Lines"), "._results"),
    "Weights": "._sampling",
}
_CLASSES = (
    "vtkAdaptiveHilbertAlgorithm",
    "vtkAdaptiveHilbertDelaunay2D",
    "vtkAdaptiveHilbertInterpolation2D",
    "vtkAdaptiveHilbertInterpolationAlgorithm",
    "vtkAdaptiveHilbertQualityMesh2D",
    "vtkAdaptiveHilbertQualityMeshAlgorithm",
    "vtkPlanarPointSource",
    "vtkPlanarSurfaceOutline",
)

__all__ = [
    "Adjacency", "BadReason", "Boxes", "Contours", "DelaunayWarning", "Edit", "EditPlaces", "Kind",
    "LinearInterpolator", "Lines", "Location", "Mesh", "NaturalNeighborInterpolator", "NearestInterpolator", "Outline",
    "Raster", "Triangulation", "Voronoi", "Weights", "delaunay", "release_memory",
]  # fmt: skip


def _get(name: str) -> Any:
    if name not in _CLASSES and name not in _MODULES:
        raise AttributeError("module %r has no attribute %r" % (__name__, name))
    try:
        if name in _CLASSES:  # which one depends on the VTK in use, so it is found out each time
            return importlib.import_module("._vtk", __name__).vtk_class(name)
        found = getattr(importlib.import_module(_MODULES[name], __name__), name)
    except AttributeError as error:  # which Python would take for the answer that there is no such name
        raise ImportError("adaptivehilbertdelaunay: %s cannot be loaded: %s" % (name, error)) from error
    globals()[name] = found
    return found


if not TYPE_CHECKING:  # for which any name would be one of the package
    __getattr__ = _get


def __dir__() -> List[str]:
    classes = importlib.import_module("._vtk", __name__).class_names()
    return sorted({*globals(), *_MODULES, *(name for name in _CLASSES if name in classes)})
