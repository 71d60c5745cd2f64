# SPDX-License-Identifier: BSD-3-Clause
"""Inputs and settings, good and bad: every feature of the filter is in one of them at least. For test_cases.py."""

import math

from classtests import array, blocks, cloud, core, model, source, vtk
from inputs import full, generate_all, lines_and_loops, scattered, square

NAN, INF = math.nan, math.inf
CASES = {}


def case(make):
    """A function that makes an input and settings."""
    CASES[make.__name__] = make
    return make


@case
def no_points():
    return model.vtkPolyData(), generate_all()


@case
def no_points_but_a_source():
    return cloud([]), dict(generate_all(), SourceData=lines_and_loops(), SourceMode=1)


@case
def no_points_in_the_plane():
    return cloud([]), {"ProjectionPlaneMode": 2, "BoundingTriangulation": True}


@case
def one_point():
    return cloud([(1, 2, 3)]), generate_all()


@case
def two_places():
    return cloud([(1, 2, 3), (2, 2, 3), (1, 2, 9), (2, 2, 0)]), generate_all()


@case
def collinear():
    return cloud([(i, 2 * i, 0) for i in range(30)]), dict(generate_all(), SourceData=source(lines=[(0, 1)]))


@case
def collinear_in_a_box():
    return cloud([(i, 2 * i, 0) for i in range(30)]), {"GenerateVoronoi": True, "VoronoiClip": 1, "Alpha": 100.0}


@case
def a_wall():
    return cloud([(i % 8, 2 * (i % 8), i // 8) for i in range(40)]), {}


@case
def a_wall_in_its_plane():
    return cloud([(i % 8, 2 * (i % 8), i // 8) for i in range(40)]), {"ProjectionPlaneMode": 2}


@case
def a_table():
    return model.vtkTable(), {}


@case
def a_volume():
    return cloud([(i % 4, i // 4 % 4, i // 16) for i in range(64)]), {}


@case
def not_finite():
    points = square((NAN, 1, 0), (INF, 2, 0), (5, 5, NAN), (4, -INF, 1), (3, 3, INF))
    return cloud(points), dict(generate_all(), Alpha=20.0)


@case
def nothing_finite():
    return cloud([(NAN, 0, 0), (0, NAN, 0), (INF, INF, 0)]), generate_all()


@case
def not_finite_in_a_plane():
    return cloud(square((NAN, 1, 0), (5, 5, NAN))), {"ProjectionPlaneMode": 2}


@case
def whole_numbers():
    return full(number=core.VTK_INT), {"Tolerance": 0.05}


@case
def a_grid_as_input():
    grid = model.vtkUnstructuredGrid()
    grid.SetPoints(full().GetPoints())
    return grid, {}


@case
def a_structured_grid():
    grid = model.vtkStructuredGrid()
    grid.SetDimensions(4, 3, 1)
    grid.SetPoints(cloud([(i % 4, i // 4, 0) for i in range(12)]).GetPoints())
    return grid, {}


@case
def unfit_marks():
    given = cloud(square())
    given.GetPointData().AddArray(array("vtkUnsignedCharArray", "vtkGhostType", [0, 0]))
    return given, {"BoundingTriangulation": True}


@case
def marks_of_a_wrong_type():
    given = cloud(square())
    given.GetPointData().AddArray(array("vtkIntArray", "vtkGhostType", [1, 0, 0, 0]))
    return given, {"GeneratePointStatus": True}


@case
def skipped_points():
    given = cloud(square((5, 5, 0), (5, 5, 0), (6, 6, 0)))
    given.GetPointData().AddArray(array("vtkUnsignedCharArray", "vtkGhostType", [0, 0, 0, 0, 1, 0, 2]))
    return given, {"GeneratePointStatus": True, "SourceData": source(lines=[(0, 6)])}


@case
def arrays_in_the_way():
    """Of the names that the filter gives to its own."""
    given = full(40)
    for name in ("Fate", "InsertionRank", "OriginalPointIds"):
        given.GetPointData().AddArray(array("vtkFloatArray", name, [7.0] * 40))
    for name in ("Crossings", "NumberOfTriangles"):
        given.GetFieldData().AddArray(array("vtkFloatArray", name, [7.0]))
    return given, generate_all()


@case
def short_arrays():
    given = full(40)
    given.GetPointData().AddArray(array("vtkFloatArray", "Short", [7.0] * 30))
    return given, {"GenerateVoronoi": True, "BoundingTriangulation": True}


@case
def everything_with_ids():
    given = source(lines=[(0, 5, 11), (7, 12)], polygons=[(20, 21, 22)])
    return full(), dict(generate_all(), SourceData=given, DuplicatePolicy=3, Alpha=100.0)


@case
def everything_with_coordinates_and_split():
    return full(number=core.VTK_INT), dict(
        generate_all(), SourceData=lines_and_loops(), SourceMode=1, CrossingMode=1, FillRule=1, Tolerance=0.01)


@case
def means_and_split():
    return full(), dict(SourceData=lines_and_loops(), SourceMode=1, CrossingMode=1, DuplicatePolicy=3,
                        MaximumEdgeLength=300.0, Alpha=100.0)


@case
def means_of_floats():
    return full(number=core.VTK_FLOAT), {"DuplicatePolicy": 3}


@case
def left_out():
    return full(), dict(SourceData=lines_and_loops(), SourceMode=1, GenerateConstraintEdges=True)


@case
def fitted_plane_with_all():
    return full(), dict(generate_all(), ProjectionPlaneMode=2, DuplicatePolicy=2, SourceData=lines_and_loops(),
                        SourceMode=1, VoronoiClip=1, Alpha=100.0)


@case
def fitted_plane_with_split_and_means():
    return full(), dict(generate_all(), ProjectionPlaneMode=2, DuplicatePolicy=3, SourceData=lines_and_loops(),
                        SourceMode=1, CrossingMode=1)


def turned(name="RotateX", *angle):
    made = vtk("vtkCommonTransforms").vtkTransform()
    getattr(made, name)(*(angle or (20.0,)))
    return made


@case
def transform_with_all():
    return full(number=core.VTK_FLOAT), dict(generate_all(), Transform=turned(), InsertionOrder=1, InsertionLimit=100)


@case
def transform_that_flattens():
    return full(), dict(Transform=turned("Scale", 1, 1, 0), GenerateVoronoi=True)


@case
def transform_that_is_not_linear():
    made = vtk("vtkCommonTransforms").vtkSphericalTransform()
    made.Inverse()
    return full(), dict(Transform=made, Rim=2)


@case
def transform_by_landmarks():
    made = vtk("vtkCommonTransforms").vtkThinPlateSplineTransform()
    made.SetSourceLandmarks(cloud(square((5, 5, 1))).GetPoints())
    made.SetTargetLandmarks(cloud(square((5, 6, 1))).GetPoints())
    made.SetBasisToR2LogR()
    return full(60), dict(Transform=made)


@case
def transform_is_missing():
    return cloud(square()), dict(ProjectionPlaneMode=1)


@case
def bounding_with_all():
    return full(), dict(generate_all(), BoundingTriangulation=True, DuplicatePolicy=1, CountWork=True)


@case
def bounding_in_a_plane():
    return full(), dict(BoundingTriangulation=True, ProjectionPlaneMode=2, Offset=3.0)


@case
def rim_that_is_trimmed():
    return cloud(scattered(30) + [(500, -1, 0), (-1, 500, 0)]), dict(Rim=2)


@case
def rim_that_takes_much():
    return cloud([(0, 0, 0), (10, 0, 0), (5, 0.5, 0)]), dict(Rim=2)


@case
def alpha_of_triangles_only():
    return full(), dict(Alpha=60.0, AlphaLines=0, AlphaVerts=0, GenerateNeighbors=True)


@case
def alpha_of_lines_and_points_only():
    return full(), dict(Alpha=40.0, AlphaTris=0, GenerateRegionIds=True)


@case
def nothing_is_left():
    return cloud(square()), dict(Alpha=0.001, AlphaVerts=0)


@case
def edges_that_are_short():
    return full(), dict(MaximumEdgeLength=80.0, GenerateNeighbors=True)


@case
def voronoi_in_a_box():
    return full(), dict(GenerateVoronoi=True, VoronoiClip=1, Tolerance=0.02)


@case
def voronoi_in_a_polygon():
    return full(), dict(GenerateVoronoi=True, VoronoiClip=2, VoronoiPolygon="20 30, 400 100; 100 300")


@case
def voronoi_of_two_points():
    return cloud([(0, 0, 5), (2, 2, 6)]), dict(GenerateVoronoi=True, VoronoiClip=2, VoronoiPolygon="0 0 4 3")


@case
def voronoi_in_a_bow():
    return full(), dict(GenerateVoronoi=True, VoronoiClip=2, VoronoiPolygon="0 0, 1 1, 1 0, 0 1")


@case
def voronoi_in_words():
    return full(), dict(GenerateVoronoi=True, VoronoiClip=2, VoronoiPolygon="0 0, 1 one, 1")


@case
def tolerance_that_merges_all():
    return full(), dict(Tolerance=1.0, GeneratePointStatus=True)


@case
def limit_of_two():
    return full(), dict(InsertionLimit=2, GenerateInsertionCurve=True, GenerateInsertionRank=True)


@case
def as_given_with_boxes():
    return full(), dict(InsertionOrder=3, GenerateBoxes=True, GenerateInsertionCurve=True)


@case
def regular_grid_with_boxes():
    return full(), dict(InsertionOrder=2, GenerateBoxes=True, CountWork=True)


@case
def multi_grid_without_control_points():
    return full(), dict(InsertionOrder=1, GenerateBoxes=True, ControlPoints=0, Nmax=3, CountWork=True)


@case
def no_genes():
    return full(), dict(GeneRotation=False, GenerateInsertionRank=True, Nmax=3, ControlPoints=1)


@case
def source_of_nothing():
    return cloud(square()), dict(SourceData=model.vtkPolyData())


@case
def source_of_points():
    return cloud(square()), dict(SourceData=source(square()))


@case
def source_of_points_and_strips():
    given = source(square(), verts=[(0,), (1, 2)], strips=[(0, 1, 2, 3)])
    return cloud(square()), dict(SourceData=given)


@case
def source_with_strips_and_lines():
    given = source(square(), lines=[(0, 2)], strips=[(0, 1, 2, 3), (3, 2, 1)], verts=[(0,)])
    return cloud(square((5, 2, 0))), dict(SourceData=given)


@case
def ids_that_are_none():
    return cloud(square()), dict(SourceData=source(lines=[(0, 9), (-1, 2)], polygons=[(0, 1, 77)]))


@case
def ids_of_the_source_that_are_none():
    return cloud(square()), dict(SourceData=source([(1, 1, 1)], lines=[(0, 5)]), SourceMode=1)


@case
def crossing_lines():
    given = source(lines=[(0, 2), (1, 3), (4, 4)], polygons=[(0, 1, 2, 3), (0, 1, 2)])
    return cloud(square((5, 2, 0))), dict(SourceData=given, GenerateConstraintEdges=True)


@case
def crossing_loops():
    given = source(polygons=[(0, 2, 4), (1, 3, 4)])
    return cloud(square((2, 6, 0))), dict(SourceData=given)


@case
def a_segment_that_bends():
    """The second segment of cell 2 passes above (1, 1/3), which is rounded down."""
    points = [(0, 0, 0), (3, 1, 0), (1, 1 / 3.0, 0), (1, -1, 0), (1, 2, 0), (2, 2, 0), (1, 1, 0), (2, 0, 0)]
    return cloud(points), dict(SourceData=source(lines=[(3, 2), (2, 4), (7, 0, 1), (0, 5)]), CrossingMode=1)


@case
def closed_lines_as_loops():
    given = source(lines=[(0, 1, 2, 3, 0), (4, 5, 6, 4)])
    return cloud(square((2, 2, 0), (2, 5, 0), (5, 2, 0))), dict(SourceData=given, ClosedLines=1, FillRule=1)


@case
def loops_that_keep_nothing():
    return cloud(square()), dict(SourceData=source(polygons=[(3, 2, 1, 0)]))


@case
def cells_of_64_bits():
    given = source(lines=[(0, 2)], polygons=[(0, 1, 2)])
    for cells in (given.GetLines(), given.GetPolys()):
        cells.ConvertTo64BitStorage()
    return cloud(square((5, 2, 0))), dict(SourceData=given)


@case
def cells_of_32_bits():
    given = source(lines=[(0, 2)], polygons=[(0, 1, 2)])
    for cells in (given.GetLines(), given.GetPolys()):
        cells.ConvertTo32BitStorage()
    return cloud(square((5, 2, 0))), dict(SourceData=given)


def tiles():
    """Of which the second has no ghost marks, and not all arrays."""
    made = []
    for tile in range(3):
        member = full(60)
        for i in range(60):
            x, y, z = member.GetPoint(i)
            member.GetPoints().SetPoint(i, x + 990.0 * tile, y, z)
        made.append(member)
    made[1].GetPointData().RemoveArray("vtkGhostType")
    made[2].GetPointData().RemoveArray("Kind")
    return made


@case
def blocks_in_one():
    return blocks(*tiles()), dict(generate_all(), MergeBlocks=True)


@case
def blocks_one_by_one():
    return blocks(*tiles()), dict(GenerateVoronoi=True)


@case
def blocks_of_other_kinds():
    return blocks(cloud(square()), model.vtkImageData(), None, cloud([]), model.vtkTable()), dict(MergeBlocks=True)


@case
def blocks_of_other_kinds_one_by_one():
    return blocks(cloud(square()), model.vtkImageData()), {}


@case
def blocks_with_unfit_marks():
    odd = cloud(square((3, 4, 0)))
    odd.GetPointData().AddArray(array("vtkUnsignedCharArray", "vtkGhostType", [1, 1]))
    return blocks(odd, cloud([(20, 20, 0), (30, 30, 0)], core.VTK_FLOAT)), dict(MergeBlocks=True)


@case
def blocks_of_a_source():
    given = blocks(source([(5, 5, 0), (95, 105, 0)], lines=[(0, 1)]),
                   source([(300, 5, 0), (300, 900, 0), (5, 600, 0)], polygons=[(0, 1, 2)]), model.vtkImageData())
    return full(), dict(InputData=(1, given), SourceMode=1, CrossingMode=1)


@case
def blocks_of_a_source_by_ids():
    return full(), dict(InputData=(1, blocks(source(lines=[(0, 1)]), source(lines=[(2, 3)], polygons=[(6, 7, 8)]))))


@case
def little_memory():
    return full(1000), dict(MemoryLimit=10)


@case
def little_memory_for_boxes():
    """Enough until the boxes are known: the second execution's limit is the first one's estimate."""
    return full(2000), dict(MemoryLimit=1700, GenerateBoxes=True, Nmax=1)


@case
def little_memory_for_crossings():
    """Enough for the points and lines, but not for 1600 crossings."""
    ends = [[(i + 0.5, k, 0) for i in range(40)] for k in (-1, 41)] + [[(k, i + 0.25, 0) for i in range(40)]
                                                                      for k in (-1, 41)]
    lines = [(i, 40 + i) for i in range(40)] + [(80 + i, 120 + i) for i in range(40)]
    given = source([point for side in ends for point in side], lines=lines)
    return cloud(square()), dict(SourceData=given, SourceMode=1, CrossingMode=1, MemoryLimit=1500)


@case
def little_memory_for_blocks():
    return blocks(*tiles()), dict(MergeBlocks=True, MemoryLimit=1)


@case
def many_small_cells():
    given = cloud([(i % 60, i // 60, (i * i) % 7) for i in range(3600)])
    return given, dict(GenerateVoronoi=True, GenerateRegionIds=True)
