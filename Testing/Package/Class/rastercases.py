# SPDX-License-Identifier: BSD-3-Clause
"""Inputs, places and settings of vtkAdaptiveHilbertInterpolation2D, good and bad. For test_interpolation.py."""

import math

from classtests import Filter, Said, array, blocks, cloud, core, model, source, vtk
from inputs import full, lines_and_loops, scattered, square

NAN = math.nan
SMALL = {"Dimensions": (13, 7)}
CASES = {}


def case(make):
    """A function that makes an input and settings; those of Triangulation have its name before theirs."""
    CASES[make.__name__] = make
    return make


def wanted_places():
    """On the surface, beyond it, in between, not finite; with data of their own."""
    made = cloud([(x * 101.0, y * 77.0, 5.0) for x in range(-1, 12) for y in range(-1, 14)] + [(NAN, 1, 2)])
    count = made.GetNumberOfPoints()
    made.GetPointData().AddArray(array("vtkDoubleArray", "Height", range(count)))
    made.GetPointData().AddArray(array("vtkIntArray", "Own", range(count)))
    made.GetFieldData().AddArray(array("vtkDoubleArray", "Month", [7.0]))
    return made


def image(kind="vtkImageData"):
    made = getattr(model, kind)()
    made.SetDimensions(9, 8, 1)
    if kind == "vtkImageData":
        made.SetOrigin(50.0, 60.0, 7.0)
        made.SetSpacing(100.0, 90.0, 1.0)
    return made


def holey():
    """Values that are NaN at some points."""
    made = full(120)
    heights = made.GetPointData().GetArray("Height")
    for i in range(0, 120, 9):
        heights.SetValue(i, NAN)
    return made


@case
def linear():
    return full(), SMALL


@case
def linear_with_gradients():
    return full(), dict(SMALL, GenerateGradients=True)


def named(*names):
    """With arrays of these names, of one component."""
    made = full()
    for name in names:
        made.GetPointData().AddArray(array("vtkDoubleArray", name, range(made.GetNumberOfPoints())))
    return made


@case
def names_of_gradients():
    return named("T", "TGradient", "TGradientGradient"), dict(SMALL, GenerateGradients=True)


@case
def names_of_gradients_before():
    return named("TGradientGradient", "ElevationGradient", "TGradient", "T"), dict(SMALL, GenerateGradients=True)


@case
def natural():
    return full(), dict(SMALL, Method=1, GenerateGradients=True)


@case
def laplace():
    return full(), dict(SMALL, Method=2)


@case
def nearest():
    return full(), dict(SMALL, Method=3, UseBounds=True, Bounds=(-100.0, 1100.0, 0.0, 500.0))


@case
def floats():
    return full(150, core.VTK_FLOAT), dict(SMALL, OutputType=1)


@case
def cells_of_a_size():
    return full(), {"RasterSize": 1, "CellSize": (90.0, 110.5)}


@case
def chosen_cells():
    return full(), {"RasterSize": 1, "CellSize": (0.0, 0.0), "AlignToCellSize": True, "Method": 3}


@case
def cells_on_multiples():
    return full(), {"RasterSize": 1, "CellSize": (90.0, 110.5), "AlignToCellSize": True}


@case
def tenths():
    return cloud(square()), {"RasterSize": 1, "CellSize": (0.1, 0.3), "UseBounds": True, "Bounds": (0.0, 1.1, 0.0, 3.3)}


@case
def beyond_the_surface():
    return full(), dict(SMALL, UseBounds=True, Bounds=(-500.0, 700.0, -300.0, 2000.0), NoValue=-9999.0)


@case
def filled_beyond_the_surface():
    return full(), dict(SMALL, UseBounds=True, Bounds=(-500.0, 700.0, -300.0, 2000.0), Outside=1, OutputType=1)


@case
def its_border_beyond_the_surface():
    return full(), dict(SMALL, UseBounds=True, Bounds=(-500.0, 700.0, -300.0, 2000.0), Outside=2)


@case
def nowhere_on_the_surface():
    return full(), dict(SMALL, UseBounds=True, Bounds=(2000.0, 3000.0, 0.0, 1.0))


@case
def values_that_are_nan():
    return holey(), dict(SMALL, OutputType=1)


@case
def heights_that_are_nan():
    return cloud([(x, y, NAN if x > 2 else x) for x in range(5) for y in range(3)]), dict(SMALL, Outside=1)


@case
def neighbors_that_are_nan():
    return holey(), dict(SMALL, Method=1)


@case
def nearest_that_are_nan():
    return holey(), dict(SMALL, Method=3, NoValue=-1.0)


@case
def nearest_of_other_layouts():
    """Components that lie apart; a whole number that is no double."""
    made, apart = full(120), core.vtkSOADataArrayTemplate["float32"]()
    apart.SetName("Apart")
    apart.SetNumberOfComponents(2)
    large = core.vtkSOADataArrayTemplate["int64"]()
    large.SetNumberOfComponents(1)  # required by VTK 9.1
    large.SetName("Large")
    for data in (apart, large):
        data.SetNumberOfTuples(120)
        made.GetPointData().AddArray(data)
    for i in range(120):
        apart.SetTypedComponent(i, 0, i / 7)
        apart.SetTypedComponent(i, 1, NAN if i % 3 == 0 else -i)
        large.SetTypedComponent(i, 0, 2**60 + i)
    return made, {"PlacesData": wanted_places(), "Method": 3, "NoValue": 1e300}


@case
def one_name_for_heights_and_mask():
    return full(), dict(SMALL, HeightArrayName="vtkValidPointMask")


@case
def the_name_of_marks_for_heights():
    return full(), dict(SMALL, HeightArrayName="vtkGhostType", OutputType=1)


@case
def the_name_of_marks_for_the_mask():
    return full(), {"PlacesData": wanted_places(), "ValidPointMaskArrayName": "vtkGhostType"}


@case
def the_name_of_gradients_for_the_mask():
    return full(), dict(SMALL, ValidPointMaskArrayName="ElevationGradient", GenerateGradients=True)


@case
def places():
    return full(), {"PlacesData": wanted_places()}


@case
def places_by_neighbors():
    return full(), {"PlacesData": wanted_places(), "Method": 1, "Outside": 1}


@case
def places_none_of_which_is_on_the_surface():
    return full(), {"PlacesData": cloud([(5000, 1, 0), (6000, 2, 0)])}


@case
def no_places():
    return full(), {"PlacesData": cloud([])}


@case
def places_of_an_image():
    return full(), {"PlacesData": image()}


@case
def places_of_blocks():
    nothing = model.vtkMultiBlockDataSet()
    nothing.SetNumberOfBlocks(1)
    return full(), {"InputDataObject": (1, blocks(wanted_places(), nothing, image(), model.vtkTable()))}


@case
def places_of_blocks_none_of_which_is_on_the_surface():
    return full(), {"InputDataObject": (1, blocks(
        cloud([(5000, 1, 0), (6000, 2, 0), (NAN, 1, 0)]), cloud([(-10, 7000, 5)]), cloud([])))}


@case
def places_of_no_block():
    return full(), {"InputDataObject": (1, model.vtkMultiBlockDataSet())}


@case
def constraints():
    return full(), dict(SMALL, SourceData=lines_and_loops(), **{
        "Triangulation.SourceMode": 1, "Triangulation.FillRule": 1, "Triangulation.CrossingMode": 1})


@case
def heights_from_the_surface():
    return full(), dict(SMALL, Method=1, SourceData=lines_and_loops(), **{
        "Triangulation.SourceMode": 1, "Triangulation.SourceHeights": 1})


@case
def triangles_that_are_left_out():
    return full(), dict(SMALL, **{"Triangulation.Alpha": 70.0, "Triangulation.MaximumEdgeLength": 130.0})


@case
def means():
    return full(), dict(SMALL, **{"Triangulation.DuplicatePolicy": 3, "Triangulation.Tolerance": 0.01})


@case
def means_and_crossings():
    return full(), dict(SMALL, SourceData=lines_and_loops(), **{
        "Triangulation.DuplicatePolicy": 3, "Triangulation.SourceMode": 1, "Triangulation.CrossingMode": 1,
        "Triangulation.ClosedLines": 1, "Triangulation.FillRule": 1})


@case
def bounding():
    return full(), dict(SMALL, **{"Triangulation.BoundingTriangulation": 1})


def turned():
    made = vtk("vtkCommonTransforms").vtkTransform()
    made.RotateX(30.0)
    made.RotateY(-20.0)
    return made


@case
def another_plane():
    return full(), dict(SMALL, **{"Triangulation.ProjectionPlaneMode": 1, "Triangulation.Transform": turned()})


@case
def places_in_another_plane():
    return full(), {"PlacesData": full(), "Triangulation.ProjectionPlaneMode": 1, "Triangulation.Transform": turned()}


@case
def places_in_the_best_plane():
    return full(), {"PlacesData": full(), "Triangulation.ProjectionPlaneMode": 2}


@case
def the_best_plane():
    return full(), dict(SMALL, OutputType=1, **{"Triangulation.ProjectionPlaneMode": 2})


@case
def no_transform():
    return full(), dict(SMALL, **{"Triangulation.ProjectionPlaneMode": 1})


@case
def merged_blocks():
    return blocks(full(80), cloud(scattered(60)), image()), SMALL


@case
def names():
    return full(), dict(SMALL, HeightArrayName="Kind", ValidPointMaskArrayName="", GenerateGradients=True)


@case
def no_name_for_heights():
    return full(), dict(SMALL, HeightArrayName="", GenerateGradients=True)


@case
def no_points():
    return model.vtkPolyData(), SMALL


@case
def no_points_but_places():
    return cloud([]), {"PlacesData": wanted_places(), "Outside": 1}


@case
def one_point():
    return cloud([(1, 2, 3)]), {"PlacesData": cloud([(1, 2, 0), (1, 3, 0)])}


@case
def one_point_and_a_raster():
    return cloud([(1, 2, 3)]), SMALL


@case
def collinear():
    return cloud([(i, 2 * i, i % 3) for i in range(30)]), {"PlacesData": cloud([(2.5, 5, 0), (3, 5, 0)])}


@case
def not_finite():
    return cloud(square((NAN, 1, 0), (5, 5, NAN), (3, 3, math.inf))), SMALL


@case
def cells_of_no_size():
    return full(), {"RasterSize": 1, "CellSize": (1.0, 0.0)}


@case
def too_many_cells():
    return full(), {"RasterSize": 1, "CellSize": (1e-9, 1.0)}


@case
def more_cells_than_memory():
    return full(), {"RasterSize": 1, "CellSize": (1e-4, 1e-4)}


@case
def cells_too_fine():
    return cloud([(x + 1e15, y, 0) for x, y, _ in square()]), {"RasterSize": 1, "CellSize": (0.01, 1.0)}


@case
def bounds_too_wide():
    return full(), dict(SMALL, UseBounds=True, Bounds=(-1.7e308, 1.7e308, 0.0, 1.0))


@case
def cells_too_large():
    return full(), {"RasterSize": 1, "CellSize": (1e300, 1e300), "UseBounds": True,
                    "Bounds": (0.0, 1.0, -1.7e308, 1.7e308)}


@case
def bounds_that_are_none():
    return full(), {"UseBounds": True, "Bounds": (1.0, 1.0, 0.0, 2.0)}


@case
def a_memory_limit():
    return full(), {"Triangulation.MemoryLimit": 16}


@case
def no_triangulation():
    return full(), {"Triangulation": None}


def maker_of(given, constraints=None, **settings):
    """A filter that has made a surface."""
    maker = Filter()
    Said(maker)
    maker.SetInputDataObject(given)
    maker.SetSourceData(constraints)
    for name, value in settings.items():
        getattr(maker, "Set" + name)(value)
    maker.Update()
    return maker


def copy_of(data):
    made = model.vtkPolyData()
    made.DeepCopy(data)
    return made


def surface(*given, **settings):
    """A surface without its filter: only its own triangles are known."""
    return copy_of(maker_of(*given, **settings).GetOutput())


INSIDE = {"SourceMode": 1, "FillRule": 1, "CrossingMode": 1}
MAKERS = {
    "outline_and_island": lambda: maker_of(full(), lines_and_loops(), GenerateConstraintEdges=True, **INSIDE),
    "outline_and_island_unnamed": lambda: maker_of(full(), lines_and_loops(), **INSIDE),
    "breaklines": lambda: maker_of(
        full(), source([], lines=[(0, 150, 77), (20, 110)]), GenerateConstraintEdges=True),
    "size_limits": lambda: maker_of(full(), Alpha=70.0, MaximumEdgeLength=130.0, Tolerance=0.001, DuplicatePolicy=3),
    "size_limits_and_constraints": lambda: maker_of(
        full(), lines_and_loops(), GenerateConstraintEdges=True, Alpha=90.0, SourceMode=1),
}
ALIVE = []  # makers of surfaces that are interpolated on


def behind(name):
    """The surface of an existing filter."""
    ALIVE.append(MAKERS[name]())
    return ALIVE[-1].GetOutput()


def surface_of(name):
    return copy_of(MAKERS[name]().GetOutput())


for _name in MAKERS:
    for _method in range(4):
        _wishes = dict(SMALL, Method=_method, Outside=_method % 2, GenerateGradients=True)
        CASES["surface_%s_%d" % (_name, _method)] = lambda name=_name, wishes=_wishes: (surface_of(name), wishes)
        CASES["behind_%s_%d" % (_name, _method)] = lambda name=_name, wishes=_wishes: (behind(name), wishes)


@case
def behind_without_memory():
    return behind("outline_and_island"), dict(SMALL, **{"Triangulation.MemoryLimit": 20})


@case
def behind_and_places_none_of_which_is_on_it():
    return behind("outline_and_island"), {"PlacesData": cloud([(5000, 1, 0), (6000, 2, 0)])}


@case
def surface_and_places():
    return surface_of("outline_and_island"), {"PlacesData": wanted_places(), "Method": 1}


@case
def surface_and_places_none_of_which_is_on_it():
    return surface_of("outline_and_island"), {"PlacesData": cloud([(5000, 1, 0), (6000, 2, 0)])}


@case
def surface_in_the_best_plane():
    """It is fitted to points that are no corner, too, but not to added ones."""
    added = source([(500.0, 500.0, 2000.0)])
    made = surface(full(), added, SourceMode=1, ProjectionPlaneMode=2, MaximumEdgeLength=130.0)
    return made, dict(SMALL, Method=1, **{"Triangulation.ProjectionPlaneMode": 2})


@case
def surface_in_another_plane():
    there = {"ProjectionPlaneMode": 1, "Transform": turned()}
    made = surface(full(), lines_and_loops(), GenerateConstraintEdges=True, **INSIDE, **there)
    return made, dict(SMALL, Method=2, **{"Triangulation." + name: value for name, value in there.items()})


@case
def surface_that_is_turned_over():
    mirror = vtk("vtkCommonTransforms").vtkTransform()
    mirror.Scale(-1.0, 1.0, 1.0)
    return surface(full()), dict(
        SMALL, **{"Triangulation.ProjectionPlaneMode": 1, "Triangulation.Transform": mirror})


@case
def surface_and_constraints():
    """Its points count alone."""
    return surface(full(), MaximumEdgeLength=130.0), dict(SMALL, SourceData=lines_and_loops())


@case
def surface_without_memory():
    return surface_of("outline_and_island"), dict(SMALL, **{"Triangulation.MemoryLimit": 20})
