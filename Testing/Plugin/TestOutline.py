# SPDX-License-Identifier: BSD-3-Clause
"""The outline of a surface in ParaView: in the menu, of surfaces, alpha shapes, groups of cells and bands."""

from paraview.simple import *
from paraview import servermanager

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())


def surface(**settings):
    heights = Calculator(Input=PlanarPointSource(NumberOfPoints=3000), CoordinateResults=1,
                         Function="coordsX*iHat + coordsY*jHat + sin(9*coordsX)*cos(8*coordsY)*kHat")
    return AdaptiveHilbertDelaunay2D(Input=heights, **settings)


def area(xy):
    """Signed; from the first corner, for accuracy."""
    (x, y), rest = xy[0][:2], xy[1:]
    return sum((p[0] - x) * (q[1] - y) - (p[1] - y) * (q[0] - x) for p, q in zip(rest, rest[1:])) / 2


def corners(data, k):
    points = data.GetCell(k).GetPoints()
    return [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]


def rings(source):
    """Of each ring: the number of its polygon, is it a hole, and its signed area."""
    data = servermanager.Fetch(source)
    cells, found = data.GetCellData(), []
    for k in range(data.GetNumberOfCells()):
        xy = corners(data, k)
        check_equal(xy[0], xy[-1], "the ends of a ring")
        hole = cells.GetArray("IsHole").GetTuple1(k)
        check_equal(area(xy) < 0, hole == 1, "clockwise")
        found.append((cells.GetArray("PolygonId").GetTuple1(k), hole, area(xy)))
    return found


def area_of(source):
    data = servermanager.Fetch(source)
    return sum(abs(area(corners(data, k))) for k in range(data.GetNumberOfCells()))


def check_outline(source, **settings):
    found = rings(PlanarSurfaceOutline(Input=source, **settings))
    whole, outlined = area_of(source), sum(ring[2] for ring in found)
    check(abs(outlined - whole) < 1e-6 * whole, "area %g in rings, %g in cells" % (outlined, whole))
    return found


def test_menu_and_help():
    made = PlanarSurfaceOutline(Input=surface())
    sm = made.SMProxy
    check_equal((sm.GetXMLGroup(), sm.GetXMLLabel()), ("filters", "Planar Surface Outline"), "group and label")
    check_equal(sm.GetVTKClassName(), class_in_paraview("PlanarSurfaceOutline"), "class")
    menu = sm.GetHints().FindNestedElementByName("ShowInMenu")
    check_equal(menu.GetAttribute("category"), "Adaptive Hilbert", "menu")
    check_equal(set(made.ListProperties()), {"Input", "GroupArrayName", "MemoryLimit"}, "properties")
    check_equal((made.GroupArrayName, made.MemoryLimit), ("None", 0), "defaults")
    check(len(sm.GetDocumentation().GetLongHelp() or "") > 80, "long help is missing")


def test_surfaces_and_alpha_shapes():
    check_equal(len(check_outline(surface())), 1, "rings of a hull")
    check_outline(surface(Alpha=0.06, AlphaLines=0, AlphaVerts=0))
    found = check_outline(surface(MaximumEdgeLength=0.035))
    check(sum(ring[1] for ring in found) > 3, "no holes in what is left")


def test_groups():
    """Regions between breaklines, or any numbers of cells."""
    parts = surface(MaximumEdgeLength=0.05, GenerateRegionIds=1)
    made = PlanarSurfaceOutline(Input=parts)
    made.UpdatePipeline()
    available = list(made.GetProperty("GroupArrayName").Available)
    check_equal(available, ["None", "RegionId"], "arrays to choose")
    check_outline(parts, GroupArrayName="RegionId")


def test_a_band_of_contours():
    """As the help has it."""
    heights = Calculator(Input=surface(), Function="coordsZ", ResultArrayName="Height")
    band = ExtractSurface(Input=IsoVolume(Input=heights, InputScalars=["POINTS", "Height"], ThresholdRange=[-0.3, 0.3]))
    check(len(check_outline(band)) > 1, "one ring for a band")


for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
