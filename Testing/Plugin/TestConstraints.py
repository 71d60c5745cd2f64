# SPDX-License-Identifier: BSD-3-Clause
"""The source of constraints, and the other features of Delaunay 2D, in a ParaView pipeline."""

import math

from paraview.simple import *
from paraview import servermanager

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())

# A lattice of 7 x 7 points, its points numbered row by row from (-0.5, -0.5) in steps of 1/6.
SIDE = 7
WHOLE = 2 * (SIDE - 1) ** 2


def lattice(**settings):
    return AdaptiveHilbertDelaunay2D(Input=Plane(XResolution=SIDE - 1, YResolution=SIDE - 1), **settings)


def source(name, points, loops=(), lines=()):
    return XMLPolyDataReader(FileName=[write_vtp(name + ".vtp", points, loops, lines)])


def cell_array(surface, name):
    surface.UpdatePipeline()
    array = servermanager.Fetch(surface).GetCellData().GetArray(name)
    check(array, "no cell array " + name)
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


def test_point_ids():
    """A clockwise square of the lattice's own points is a hole of four cells. The source's points are elsewhere."""
    corner = SIDE + 1
    square = [corner, corner + 2 * SIDE, corner + 2 * SIDE + 2, corner + 2]
    hole = source("ids", [(9.0, 9.0, 9.0)] * SIDE**2, loops=[square])
    surface = lattice(Source=hole, SourceMode="Point ids", FillRule="Orientation")
    found = measures(surface)
    check_equal(found["NumberOfTriangles"], WHOLE - 8, "triangles around the hole")
    check_equal(found["NumberOfAddedPoints"], 0, "points added")
    check_equal(
        found["NumberOfConstraintEdges"], 8, "edges of the hole, each side split by a point of the lattice"
    )
    check_equal(found["NumberOfConstraintsLeftOut"], 0, "segments left out")


def test_coordinates():
    """An octagon between the points of the lattice: a hole or the whole surface, by direction and rule."""
    for clockwise in (True, False):
        shore = source("ring%d" % clockwise, ring(0.3, clockwise=clockwise), loops=[range(8)])
        surface = lattice(Source=shore, FillRule="Orientation")
        found = measures(surface)
        check_equal(found["NumberOfAddedPoints"], 8, "points of the source")
        check_equal(found["NumberOfConstraintEdges"], 8, "edges of the octagon")
        inside = 2 * 9 + 6  # 3 x 3 points of the lattice in the octagon
        outside = WHOLE + 2 * 8 - inside
        check_equal(
            found["NumberOfTriangles"],
            outside if clockwise else inside,
            "triangles, clockwise %r" % clockwise,
        )
        surface.FillRule = "Even-odd"
        check_equal(measures(surface)["NumberOfTriangles"], inside, "triangles by even-odd")
        surface.Source = None
        check_equal(measures(surface)["NumberOfTriangles"], WHOLE, "triangles without the source")
        surface.Source = shore
        check_equal(measures(surface)["NumberOfTriangles"], inside, "triangles with the source again")


def test_crossings():
    """Two lines that cross: the later one is left out and named, or both are split."""
    ends = [(-0.4, 0.03, 1.0), (0.4, 0.03, 1.0), (0.04, -0.4, 5.0), (0.04, 0.4, 5.0)]
    cross = source("cross", ends, lines=[(0, 1), (2, 3)])
    surface = lattice(Source=cross)
    found = measures(surface)
    left = ["NumberOfCrossings", "NumberOfConstraintsLeftOut", "NumberOfUnfilledLoops"]
    check_equal([found[name] for name in left], [1, 1, 0], "crossings, left out, unfilled")
    table = servermanager.Fetch(surface).GetFieldData().GetArray("Crossings")
    check(table, "no field data array Crossings")
    check_equal([table.GetTuple(i) for i in range(table.GetNumberOfTuples())], [(1.0, 0.0)], "Crossings")
    surface.CrossingMode = "Split"
    found = measures(surface)
    check_equal([found[name] for name in left], [1, 0, 0], "crossings, left out, unfilled, when split")
    check_equal(found["NumberOfAddedPoints"], 5, "points added, when split")
    data = servermanager.Fetch(surface)
    check_equal(
        data.GetPoint(data.GetNumberOfPoints() - 1)[2], 3.0, "height where a line at 1 crosses one at 5"
    )


def test_a_loop_that_is_crossed_bounds_nothing():
    points = ring(0.3, clockwise=True) + [(-0.45, 0.02, 0.0), (-0.02, 0.02, 0.0)]
    crossed = source("crossed", points, loops=[range(8)], lines=[(8, 9)])
    found = measures(lattice(Source=crossed))
    check_equal(found["NumberOfUnfilledLoops"], 1, "loops that bound nothing")
    check_equal(found["NumberOfTriangles"], WHOLE + 2 * 10, "triangles, all of them")


def test_several_blocks_are_one_source():
    """As GIS readers give them: a block for each feature, outlines as closed lines."""
    shore = source("block0", ring(0.3) + ring(0.3)[:1], lines=[range(9)])
    island = source("block1", ring(0.1) + ring(0.1)[:1], lines=[range(9)])
    river = source("block2", [(-0.45, -0.41, 0.0), (-0.45, 0.43, 0.0)], lines=[(0, 1)])
    surface = lattice(Source=GroupDatasets(Input=[shore, island, river]))
    found = measures(surface)
    check(not surface.GetDataInformation().IsCompositeDataSet(), "there is a surface per block")
    check_equal(found["NumberOfAddedPoints"], 20, "points of all blocks")
    whole = found["NumberOfTriangles"]
    surface.ClosedLines = "Loops"
    check(0 < measures(surface)["NumberOfTriangles"] < whole / 2, "closed lines are no loops")
    surface.ClosedLines = "Lines"
    check_equal(measures(surface)["NumberOfTriangles"], whole, "triangles without loops")


def test_heights_from_the_surface():
    slope = Calculator(
        Input=Plane(XResolution=6, YResolution=6), Function="coordsX", CoordinateResults=0, ResultArrayName="h"
    )
    slope = WarpByScalar(Input=slope, Scalars=["POINTS", "h"])
    line = source("flat", [(-0.4, 0.03, 0.0), (0.4, 0.03, 0.0)], lines=[(0, 1)])
    surface = AdaptiveHilbertDelaunay2D(Input=slope, Source=line)
    surface.UpdatePipeline()
    check_equal(servermanager.Fetch(surface).GetPoint(49)[2], 0.0, "the line's own height")
    surface.SourceHeights = "From Surface"
    surface.UpdatePipeline()
    data = servermanager.Fetch(surface)
    for i, height in ((49, -0.4), (50, 0.4)):
        check(abs(data.GetPoint(i)[2] - height) < 1e-6, "the height of the surface")
        check(abs(data.GetPointData().GetArray("h").GetValue(i) - height) < 1e-6, "the data of the surface")


def test_a_source_made_from_the_surface_itself():
    """A cycle in the pipeline would never end: the source is removed again."""
    shore = source("own", ring(0.3), loops=[range(8)])
    surface = lattice(Source=shore)
    rim = FeatureEdges(Input=surface)
    for own in (rim, surface):
        surface.Source = own
        check(surface.Source is None, "the surface is its own source")
        check_equal(measures(surface)["NumberOfTriangles"], WHOLE, "triangles without the source")
    # A source that does not depend on the surface is accepted, of course.
    surface.Source = FeatureEdges(Input=Sphere())
    check(surface.Source is not None, "a source that is no part of a circle was refused")


def test_an_input_made_from_the_surface_itself():
    surface = lattice()
    points = surface.Input
    for own in (Clip(Input=surface), surface):
        surface.Input = own
        check(surface.Input is None, "the surface is made of itself")
        surface.Input = points
        check_equal(measures(surface)["NumberOfTriangles"], WHOLE, "triangles of the input before")


def test_counts_are_in_the_field_data():
    surface = lattice(Source=source("counted", ring(0.3), loops=[range(8)]))
    found = measures(surface)
    for name in COUNTS:
        array = surface.FieldData[name]
        check(array, "no array %s in the field data" % name)
        check_equal(array.GetRange(0), (found[name], found[name]), "field data " + name)


def test_extras():
    shore = source("extras", ring(0.3), loops=[range(8)])
    surface = lattice(Source=shore, GenerateConstraintEdges=1, GenerateRegionIds=1, GenerateNeighbors=1)
    marks = [int(mark) for (mark,) in cell_array(surface, "ConstraintEdges")]
    check_equal(sum(bin(mark).count("1") for mark in marks), 8, "sides of triangles that are constraints")
    check_equal(set(cell_array(surface, "RegionId")), {(0.0,)}, "regions")
    neighbours = cell_array(surface, "Neighbors")
    check_equal(sum(row.count(-1.0) for row in neighbours), 8, "sides without a neighbour")
    for triangle, row in enumerate(neighbours):
        for other in row:
            check(
                other < 0 or triangle in neighbours[int(other)],
                "triangle %d is no neighbour's neighbour" % triangle,
            )


def test_voronoi():
    surface = lattice(GenerateVoronoi=1)
    surface.UpdatePipeline()
    cells = servermanager.Fetch(surface, idx=2)
    check_equal(cells.GetNumberOfPolys(), SIDE**2, "Voronoi cells")
    area = IntegrateVariables(Input=OutputPort(surface, 2))
    area.UpdatePipeline()
    check(abs(area.CellData["Area"].GetRange(0)[0] - 1.0) < 1e-12, "the Voronoi cells do not fill the square")
    surface.GenerateVoronoi = 0
    surface.UpdatePipeline()
    check_equal(surface[2].GetDataInformation().GetNumberOfCells(), 0, "Voronoi cells, unasked")


def test_outline():
    """Without long edges: two lattices far apart do not grow together."""
    far = Plane(XResolution=2, YResolution=2, Origin=[9, -0.5, 0], Point1=[10, -0.5, 0], Point2=[9, 0.5, 0])
    both = AppendDatasets(Input=[Plane(XResolution=2, YResolution=2), far])
    surface = AdaptiveHilbertDelaunay2D(Input=both)
    check(
        measures(surface)["NumberOfTriangles"] > 16,
        "nothing joins the lattices, so this test would prove nothing",
    )
    surface.MaximumEdgeLength = 0.75
    check_equal(measures(surface)["NumberOfTriangles"], 16, "triangles without long edges")
    set_properties(surface, MaximumEdgeLength=0, Alpha=0.36)  # the cells' circles have a radius of 0.354
    check_equal(measures(surface)["NumberOfTriangles"], 16, "triangles of the alpha shape")
    surface.AlphaTris = 0
    check_equal(measures(surface)["NumberOfTriangles"], 0, "triangles of the alpha shape, not asked for")


def test_planes():
    """A wall of 7 x 7 points along y and z, all with the same x."""
    wall = Plane(XResolution=6, YResolution=6, Origin=[3, 0, 0], Point1=[3, 1, 0], Point2=[3, 0, 1])
    surface = AdaptiveHilbertDelaunay2D(Input=wall)
    check_equal(measures(surface)["NumberOfTriangles"], 0, "triangles of a wall seen from above")
    surface.ProjectionPlaneMode = "Best-Fitting Plane"
    check_equal(measures(surface)["NumberOfTriangles"], WHOLE, "triangles in the best-fitting plane")
    surface.ProjectionPlaneMode = "Transform Plane"
    surface.Transform = "Transform"
    surface.Transform.Rotate = [0, 90, 0]
    check_equal(measures(surface)["NumberOfTriangles"], WHOLE, "triangles of the turned wall")
    check_equal(
        surface.GetDataInformation().GetBounds()[:2], (3.0, 3.0), "x of the wall, which stays where it was"
    )
    surface.Transform.Rotate = [0, 0, 0]
    check_equal(measures(surface)["NumberOfTriangles"], 0, "triangles when it is not turned")
    surface.Transform.Rotate = [0, 90, 0]
    surface.UpdatePipeline()
    surface.Transform = "None"
    check_equal(measures(surface)["NumberOfTriangles"], 0, "triangles without the transform")


def test_coinciding_points():
    """Two soundings in one place, and one 0.001 beside a third."""
    points = [(0, 0, 1), (1, 0, 5), (1, 1, 0), (0, 1, 0), (1, 0, 2), (0.001, 0, 9)]
    surface = AdaptiveHilbertDelaunay2D(Input=source("coinciding", points), GenerateFate=1)

    def fates():
        array = servermanager.Fetch(surface).GetPointData().GetArray("Fate")
        return [int(array.GetValue(i)) for i in range(6)]

    found = measures(surface)
    check_equal(
        (found["NumberOfDuplicates"], found["NumberOfMergedPoints"]), (1, 0), "duplicates, merged points"
    )
    check_equal(fates(), [0, 1, 2, 3, 1, 5], "fates")
    surface.Tolerance = 0.01
    found = measures(surface)
    check_equal((found["NumberOfDuplicates"], found["NumberOfMergedPoints"]), (1, 1), "with a tolerance")
    check_equal(fates(), [0, 1, 2, 3, 1, 0], "fates with a tolerance")
    set_properties(surface, Tolerance=0, DuplicatePolicy="Lowest z")
    surface.UpdatePipeline()
    check_equal(fates()[1], 4, "the fate of a point with a lower one in its place")
    surface.DuplicatePolicy = "Mean z"
    surface.UpdatePipeline()
    check_equal(servermanager.Fetch(surface).GetPoint(1)[2], 3.5, "the mean height")

def test_blocks_merged():
    """Two tiles side by side: with a seam between them or, merged, without."""
    tiles = [Plane(XResolution=2, YResolution=2), Plane(XResolution=2, YResolution=2)]
    for tile, west in zip(tiles, (0, 1.5)):
        set_properties(tile, Origin=[west, 0, 0], Point1=[west + 1, 0, 0], Point2=[west, 1, 0])
    surface = AdaptiveHilbertDelaunay2D(Input=GroupDatasets(Input=tiles))
    surface.UpdatePipeline()
    check(surface.GetDataInformation().IsCompositeDataSet(), "the blocks do not stay by themselves")
    check_equal(surface.GetDataInformation().GetNumberOfCells(), 16, "triangles of both tiles")
    surface.MergeBlocks = 1
    found = measures(surface)
    check(not surface.GetDataInformation().IsCompositeDataSet(), "merged blocks are still blocks")
    check_equal(found["NumberOfTriangles"], 16 + 4, "triangles of the merged tiles")
    check_equal(len(triangles(surface)), 16 + 4, "triangles that came from the filter")
    surface.MergeBlocks = 0
    surface.UpdatePipeline()
    check_equal(surface.GetDataInformation().GetNumberOfCells(), 16, "triangles of both tiles again")


def test_points_that_stay():
    """An array that changes and points that do not: triangulated twice, then kept."""
    points = Calculator(Input=Plane(XResolution=6, YResolution=6), Function="1", ResultArrayName="level")
    surface = AdaptiveHilbertDelaunay2D(Input=points)
    for level, times in ((1, 1), (2, 2), (3, 2), (4, 2)):
        points.Function = str(level)
        check_equal(measures(surface)["NumberOfTriangulations"], times, "triangulations at level %d" % level)
        check_equal(surface.PointData["level"].GetRange(0), (level, level), "the array that changes")
    set_properties(surface, KeepTriangulation=0)
    points.Function = "5"
    check_equal(measures(surface)["NumberOfTriangulations"], 3, "triangulations, if none is kept")


def test_bounding_triangulation():
    surface = lattice(BoundingTriangulation=1, Offset=2)
    check_equal(measures(surface)["NumberOfPointsInserted"], SIDE**2 + 8, "points and the eight around them")
    bounds = surface.GetDataInformation().GetBounds()
    check(
        abs(bounds[1] - 2 * math.sqrt(2)) < 1e-12,
        "the eight points are not twice the diagonal away: %r" % (bounds,),
    )


for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
