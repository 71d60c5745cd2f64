# SPDX-License-Identifier: BSD-3-Clause
"""Every rank of pvbatch --sym triangulates its own piece of a sphere, twice."""

from paraview.simple import *
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()

# A sphere comes in pieces, one for each rank.
surface = AdaptiveHilbertDelaunay2D(Input=Sphere())
surface.UpdatePipeline()
surface.GenerateFate = 1
surface.GenerateInsertionCurve = 1
surface.UpdatePipeline()
check_equal(surface.GetDataInformation().GetNumberOfPoints(), 32, "points of rank %d" % rank)
check_equal(surface[1].GetDataInformation().GetNumberOfCells(), 1, "curves of rank %d" % rank)
print("rank %d of %d: %d triangles" % (rank, ranks, surface.GetDataInformation().GetNumberOfCells()), flush=True)
