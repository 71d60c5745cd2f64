# SPDX-License-Identifier: BSD-3-Clause
"""Two ranks of pvbatch --sym triangulate a sphere, each having a piece: together, then each its own, twice."""

from paraview.simple import *
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()

# A sphere comes in pieces, one for each rank.
surface = AdaptiveHilbertDelaunay2D(Input=Sphere())
surface.UpdatePipeline()
marks = surface.GetClientSideObject().GetOutputDataObject(0).GetCellData().GetArray("vtkGhostType")
cells = surface.GetDataInformation().GetNumberOfCells()
own = sum(marks.GetValue(i) == 0 for i in range(cells)) if marks else cells
together = measures(surface)["NumberOfTriangles"]
print("rank %d of %d: %d of %d triangles together" % (rank, ranks, own, together), flush=True)
surface.DistributePoints = 0
surface.UpdatePipeline()
surface.GenerateFate = 1
surface.GenerateInsertionCurve = 1
surface.UpdatePipeline()
check_equal(surface.GetDataInformation().GetNumberOfPoints(), 32, "points of rank %d" % rank)
check_equal(surface[1].GetDataInformation().GetNumberOfCells(), 1, "curves of rank %d" % rank)
print("rank %d of %d: %d triangles" % (rank, ranks, surface.GetDataInformation().GetNumberOfCells()), flush=True)
