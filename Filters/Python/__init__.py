# SPDX-License-Identifier: BSD-3-Clause
"""Exact 2D Delaunay triangulation of large point sets, as a VTK filter, and a source of such sets.

    from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D, vtkPlanarPointSource

The package links the same VTK it was built with: `vtkmodules` found by Python must be that one.
"""

from .AdaptiveHilbertDelaunayFilters import *
