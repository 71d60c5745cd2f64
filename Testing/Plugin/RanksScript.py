# SPDX-License-Identifier: BSD-3-Clause
"""Two ranks of pvbatch --sym triangulate a sphere, a piece on each: together, then each its own, twice."""

from paraview.simple import *
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from pluginsupport import *



def leaves(data):
    """The blocks of a composite data set."""
    each = data.NewIterator()
    each.InitTraversal()
    while not each.IsDoneWithTraversal():
        yield each.GetCurrentDataObject()
        each.GoToNextItem()


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
# Of blocks, each is a surface over all ranks.
blocks = AdaptiveHilbertDelaunay2D(Input=GroupDatasets(Input=[Sphere(), Sphere(Center=[5.0, 0.0, 0.0])]))
blocks.UpdatePipeline()
found = [part.GetNumberOfCells() for part in leaves(blocks.GetClientSideObject().GetOutputDataObject(0))]
check_equal(len(found), 2, "blocks of rank %d" % rank)
check(min(found) > 10, "triangles in the blocks of rank %d: %r" % (rank, found))
check_equal(measures(blocks)["NumberOfTriangles"], together, "triangles of the last block")
surface.DistributePoints = 0
surface.UpdatePipeline()
surface.GenerateFate = 1
surface.GenerateInsertionCurve = 1
surface.UpdatePipeline()
check_equal(surface.GetDataInformation().GetNumberOfPoints(), 32, "points of rank %d" % rank)
check_equal(surface[1].GetDataInformation().GetNumberOfCells(), 1, "curves of rank %d" % rank)
print("rank %d of %d: %d triangles" % (rank, ranks, surface.GetDataInformation().GetNumberOfCells()), flush=True)
