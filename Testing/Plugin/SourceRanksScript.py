# SPDX-License-Identifier: BSD-3-Clause
"""On several ranks (pvbatch --sym), the first has all points of the source and the others none."""

from paraview.simple import *
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())
controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId()
check_equal(controller.GetNumberOfProcesses(), 2, "ranks")
for name in ("Uniform", "Lattice"):
    source = PlanarPointSource(Distribution=name, NumberOfPoints=1000)
    source.UpdatePipeline()
    found = source.GetDataInformation().GetNumberOfPoints()
    check_equal(found, 0 if rank else 1000, "%s: points of rank %d" % (name, rank))
print("passed: rank", rank)
