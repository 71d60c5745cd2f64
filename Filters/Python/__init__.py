# SPDX-License-Identifier: BSD-3-Clause
"""Exact 2D Delaunay triangulation of large point sets, as a VTK filter, and a source of such sets.

    from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D, vtkPlanarPointSource

The package links the VTK it was built with: `vtkmodules` found by Python must be that one. With another
version the import raises ImportError.

Code that uses vtkDelaunay2D runs on this filter after `import adaptivehilbertdelaunay.drop_in`.
"""

from vtkmodules.vtkCommonCore import vtkVersion as _vtkVersion

_BUILT_FOR = "@VTK_VERSION@"  # CMake writes it here

# Loading a second VTK into the process would crash it.
if _vtkVersion.GetVTKVersion() != _BUILT_FOR:
    raise ImportError(
        "adaptivehilbertdelaunay was built for VTK %s, but Python found VTK %s"
        % (_BUILT_FOR, _vtkVersion.GetVTKVersion())
    )

from .AdaptiveHilbertDelaunayFilters import *  # noqa: E402
