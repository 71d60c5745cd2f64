# SPDX-License-Identifier: BSD-3-Clause
"""The classes that were compiled with VTK. They link the VTK they were built with: `vtkmodules` found by Python
must be of that version, in its first two numbers. ImportError if it is another, or if nothing was compiled.
"""

from vtkmodules.vtkCommonCore import vtkVersion as _vtkVersion

_BUILT_FOR = "@VTK_VERSION@"  # CMake writes it here

# Loading a second VTK into the process would crash it.
if _vtkVersion.GetVTKVersion().split(".")[:2] != _BUILT_FOR.split(".")[:2]:
    raise ImportError(
        "adaptivehilbertdelaunay was built for VTK %s, but Python found VTK %s"
        % (_BUILT_FOR, _vtkVersion.GetVTKVersion())
    )

from .AdaptiveHilbertDelaunayFilters import *  # noqa: E402
