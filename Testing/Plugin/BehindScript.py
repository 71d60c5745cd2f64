# SPDX-License-Identifier: BSD-3-Clause
"""Results of downstream filters of a surface over all ranks; run by RunBehind.py on one rank and on several.

    pvbatch BehindScript.py           the ranks are those of pvbatch
    pvpython BehindScript.py PORT     those of a server

The points are read by one rank. Writes numbers, and pictures that all ranks draw together, into AHD_SCRATCH.
"""

import json
import math

import paraview.simple
from paraview import servermanager
from paraview.simple import *

from pluginsupport import *

POINTS = 4000


def integrated(proxy):
    """The cells' number, and the integral of each array over them."""
    found = servermanager.Fetch(IntegrateVariables(Input=proxy)).GetCellData()
    arrays = (found.GetArray(k) for k in range(found.GetNumberOfArrays()))
    return {array.GetName(): array.GetTuple1(0) for array in arrays if array.GetNumberOfComponents() == 1}


def length_of(proxy):
    """Of all lines, ghosts left out. IntegrateVariables gives no result if the first rank has no line."""
    found = servermanager.Fetch(proxy)
    ghosts = found.GetCellData().GetArray("vtkGhostType")
    length = 0.0
    for k in range(found.GetNumberOfCells()):
        points = found.GetCell(k).GetPointIds()
        corners = [found.GetPoint(points.GetId(i)) for i in range(points.GetNumberOfIds())]
        if not (ghosts and ghosts.GetValue(k)):
            length += sum(math.dist(p, q) for p, q in zip(corners, corners[1:]))
    return length


def numbers_behind(surface):
    surface.UpdatePipeline()
    numbers = {"triangles": measures(surface)["NumberOfTriangles"]}
    contour = Contour(Input=surface, ContourBy=["POINTS", "Height"], Isosurfaces=[0.05, 0.2, 0.4])
    cut = Slice(Input=surface, SliceType="Plane")
    set_properties(cut.SliceType, Origin=[0.5, 0.5, 0.0], Normal=[1.0, 0.3, 0.1])
    numbers["contour"], numbers["slice"] = length_of(contour), length_of(cut)
    quality = integrated(MeshQuality(Input=surface))
    numbers["quality"], numbers["area"] = quality["Quality"], quality["Area"]
    outside = ExtractSurface(Input=surface)
    spread = RedistributeDataSet(Input=surface)
    for name, proxy in (("extracted", outside), ("redistributed", spread)):
        proxy.UpdatePipeline()
        numbers[name] = integrated(proxy)["Area"]
        numbers[name + " cells"] = cells_of(proxy)
    numbers["cells"] = cells_of(surface)
    return numbers


def cells_of(proxy):
    """The number of those that are no ghosts: integration leaves these out."""
    sizes = CellSize(Input=proxy, ComputeArea=1)
    ones = Calculator(Input=sizes, AttributeType="Cell Data", ResultArrayName="One", Function="1/Area")
    return round(integrated(ones)["One"], 6)


def draw(surface, kind, name):
    """From above, drawn by all ranks together even if it is small."""
    GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0.0
    view = CreateRenderView(ViewSize=[500, 500], Background=[0.0, 0.0, 1.0], OrientationAxesVisibility=0)
    view.UseColorPaletteForBackground = 0
    shown = Show(surface, view)
    shown.SetRepresentationType(kind)
    ColorBy(shown, None)
    set_properties(view, CameraParallelProjection=1, CameraPosition=[0.5, 0.5, 5.0], CameraFocalPoint=[0.5, 0.5, 0.0],
                   CameraViewUp=[0.0, 1.0, 0.0], CameraParallelScale=0.55)
    Render(view)
    SaveScreenshot(scratch(name), view, ImageResolution=[500, 500])
    Delete(view)


names = vars(paraview.simple)
if len(sys.argv) > 1:
    Connect("localhost", int(sys.argv[1]))
    LoadPlugin(PLUGIN, remote=True, ns=names)
LoadPlugin(PLUGIN, remote=False, ns=names)
source = names["PlanarPointSource"](Distribution="Uniform", NumberOfPoints=POINTS)
height = "0.5*exp(-8*((coordsX-0.5)^2+(coordsY-0.5)^2))+0.1*sin(9*coordsX)*cos(7*coordsY)"
named = Calculator(Input=source, ResultArrayName="Height", Function=height)
raised = Calculator(Input=named, CoordinateResults=1, Function="coordsX*iHat+coordsY*jHat+Height*kHat")
surface = names["AdaptiveHilbertDelaunay2D"](Input=raised, DistributePoints=1)
numbers = numbers_behind(surface)
draw(surface, "Surface", "surface.png")
draw(surface, "Surface With Edges", "edges.png")
numbers["points"] = surface.GetDataInformation().GetNumberOfPoints()
numbers["ranks"] = servermanager.ActiveConnection.GetNumberOfDataPartitions()
with open(scratch("numbers.json"), "w") as file:
    json.dump(numbers, file)
print(json.dumps(numbers, indent=1))
