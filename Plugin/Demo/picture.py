# SPDX-License-Identifier: BSD-3-Clause
"""An oblique, hill-shaded picture of a triangulated surface, drawn by ParaView.

The horizontal unit is often not the vertical one: degrees beside metres would draw a wall. So
the surface is drawn at a scale of its own (choose_scale), which is said in the picture.
"""

import collections
import math

import numpy
from paraview import simple
from paraview.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from pointfiles import METRES_PER_DEGREE, InputError, are_degrees

RELIEF = 0.11  # the drawn relief, as a share of the horizontal diagonal
SIZE = (1920, 1080)
VIEW_ANGLE = 18.0  # degrees, of the camera
VIEW_HEIGHT = 45.0  # degrees above the horizon that the camera looks from
FLOOR, WEST_EDGE, SOUTH_EDGE, EAST_EDGE = 4, 1, 2, 8  # bits of vtkGridAxesHelper: faces and axes to label
LARGEST, SMALLEST = 1e30, 1e-20  # coordinates and extents that the renderer can draw, which computes in float
LIGHT_FROM = (75.0, 36.0)  # degrees to the left of the camera, and above the horizon

# Elevation colours: lightness rises evenly from deep violet-blue through teal to pale yellow.
COLOURS = (
    (0.00, 0.157, 0.102, 0.278),
    (0.15, 0.196, 0.216, 0.459),
    (0.30, 0.169, 0.357, 0.553),
    (0.45, 0.157, 0.498, 0.580),
    (0.60, 0.231, 0.635, 0.561),
    (0.75, 0.478, 0.765, 0.510),
    (0.88, 0.745, 0.871, 0.510),
    (1.00, 0.988, 0.969, 0.671),
)  # fmt: skip

# factors: what x, y and z are multiplied with to be drawn · exaggeration: of z against x and y
# geographic: x and y are degrees · low, high: the range of z without its outermost 1 %
Scale = collections.namedtuple("Scale", "factors exaggeration geographic low high")


def choose_scale(xyz, names, exaggeration=None):
    """How to draw the points. Degrees of longitude and latitude are taken as metres on a sphere;
    all else is taken to be in one unit. Without a wish, the exaggeration makes the relief
    (without its outermost 1 %) about RELIEF of the horizontal diagonal, or is 1 if that is near."""
    check_size(xyz)
    good = xyz[numpy.isfinite(xyz).all(axis=1)]
    if len(good):
        xyz = good
        low, high = numpy.percentile(xyz[:, 2], (0.5, 99.5))
    else:  # no height at all: flat
        xyz = xyz[numpy.isfinite(xyz[:, :2]).all(axis=1)]
        low, high = 0.0, 0.0
    west, south = xyz[:, :2].min(axis=0)
    east, north = xyz[:, :2].max(axis=0)
    geographic = are_degrees(names, south, north)
    shrink = math.cos(math.radians((south + north) / 2)) if geographic else 1.0
    unit = METRES_PER_DEGREE if geographic else 1.0
    diagonal = unit * math.hypot((east - west) * shrink, north - south)
    low, high = float(low), float(high)
    if high - low < SMALLEST:
        high = low  # flat
    if exaggeration is None:
        exaggeration = choose_exaggeration(high - low, diagonal)
    scale = Scale((shrink, 1.0, exaggeration / unit), exaggeration, geographic, low, high)
    check_extent(diagonal / unit, scale)
    return scale


def check_size(xyz):
    """Raises InputError if coordinates are too large to be drawn."""
    largest = float(numpy.max(numpy.abs(xyz), where=numpy.isfinite(xyz), initial=0.0))
    if largest > LARGEST:
        raise InputError("no picture: coordinates as large as %.3g cannot be drawn, only up to %g" % (largest, LARGEST))


def check_extent(diagonal, scale):
    """Raises InputError if the surface is too small to be drawn, or made too steep or too flat."""
    if diagonal < SMALLEST:
        raise InputError("no picture: an extent as small as %.3g cannot be drawn, only from %g" % (diagonal, SMALLEST))
    factor = scale.factors[2]
    if not (SMALLEST <= factor <= LARGEST and (scale.high - scale.low) * factor <= LARGEST):
        raise InputError("no picture: a vertical exaggeration of %g cannot be drawn" % scale.exaggeration)


def choose_exaggeration(relief, diagonal):
    if relief == 0 or diagonal == 0 or 0.5 * RELIEF < relief / diagonal < 1.5 * RELIEF:
        return 1.0  # as it is: nothing to bend
    return two_digits(RELIEF * diagonal / relief)


def two_digits(value):
    """To two digits, or to halves from 1 to 10: 34.2 is 34, 7.36 is 7.5, 0.0123 is 0.012."""
    if 1 <= value < 10:
        return round(2 * value) / 2
    digits = 1 - math.floor(math.log10(value))
    return round(value, digits)


def corner_ids(surface):
    """The triangles of a vtkPolyData as an n × 3 array."""
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def smooth_normals(xyz, triangles, factors):
    """Unit normals of the points of the surface as drawn, given for the surface as stored: the
    renderer will divide them by the factors, as it must with normals."""
    drawn = (xyz - xyz[triangles[0, 0]]) * factors
    a, b, c = (drawn[triangles[:, corner]] for corner in range(3))
    flat = numpy.cross(b - a, c - a)  # twice the area long: bigger triangles count more
    # a long thin triangle across a gap must not bend the normals of a dense survey beside it
    size = numpy.maximum(numpy.linalg.norm(flat, axis=1, keepdims=True), 1e-300)
    flat /= numpy.sqrt(size)
    normals = numpy.empty_like(drawn)
    for axis in range(3):
        normals[:, axis] = sum(
            numpy.bincount(triangles[:, corner], flat[:, axis], len(xyz)) for corner in range(3)
        )
    normals *= factors
    return normals / numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


def finite(xyz, scale):
    """The points with what cannot be drawn put right: a z that is not finite becomes the lowest;
    points with such x or y, which are in no triangle, are put upon one that is."""
    z = xyz[:, 2]
    z[~numpy.isfinite(z)] = scale.low
    lost = ~numpy.isfinite(xyz).all(axis=1)
    xyz[lost] = xyz[numpy.argmin(lost)]
    return xyz


def drawable(surface, scale, z_name):
    """A copy of the surface with what drawing needs: normals, and z as an array to colour by."""
    xyz = finite(vtk_to_numpy(surface.GetPoints().GetData()).astype(float), scale)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(xyz, deep=1))
    copy = vtkPolyData()
    copy.SetPoints(points)
    copy.SetPolys(surface.GetPolys())
    normals = numpy_to_vtk(smooth_normals(xyz, corner_ids(surface), scale.factors).astype("f4"), deep=1)
    normals.SetName("Normals")
    copy.GetPointData().SetNormals(normals)
    z = numpy_to_vtk(numpy.ascontiguousarray(xyz[:, 2]), deep=1)
    z.SetName(z_name)
    copy.GetPointData().AddArray(z)
    return copy, xyz


def boundary_edges(triangles):
    """The edges that only one triangle has, as an n × 2 array."""
    edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2).astype(numpy.int64), axis=1)
    keys, counts = numpy.unique(edges[:, 0] << 32 | edges[:, 1], return_counts=True)
    lonely = keys[counts == 1]
    return numpy.column_stack([lonely >> 32, lonely & 0xFFFFFFFF])


def walls(xyz, triangles, floor):
    """Upright walls from the boundary of the surface down to the floor."""
    edges = boundary_edges(triangles)
    upper = xyz[edges].reshape(-1, 3)
    lower = upper.copy()
    lower[:, 2] = floor
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.vstack([upper, lower]), deep=1))
    first = 2 * numpy.arange(len(edges))
    quads = numpy.column_stack([first, first + 1, first + 1 + len(upper), first + len(upper)])
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtk(quads.ravel(), deep=1, array_type=VTK_ID_TYPE))
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetPolys(cells)
    return result


def show(data, name, view, scale):
    source = simple.TrivialProducer(registrationName=name)
    source.GetClientSideObject().SetOutput(data)
    display = simple.Show(source, view)
    display.Scale = list(scale.factors)
    display.Specular = 0.0
    return display


def draw(surface, scale, z_name, title, path, edges=False):
    """Draws the surface and writes the picture to path."""
    copy, xyz = drawable(surface, scale, z_name)
    flat = scale.low == scale.high
    floor = xyz[:, 2].min() - (0.1 * (scale.high - scale.low) or thickness(xyz, scale))
    azimuth = viewing_azimuth(xyz * scale.factors)
    view = new_view(azimuth)
    display = show(copy, "surface", view, scale)
    display.Representation = "Surface With Edges" if edges or flat else "Surface"
    display.EdgeColor = [0.1, 0.1, 0.15]
    display.Ambient = 0.35
    display.Diffuse = 0.8
    if flat:
        display.AmbientColor = display.DiffuseColor = COLOURS[4][1:]
    else:
        colour(display, scale, z_name, view)
    block = show(walls(xyz, corner_ids(surface), floor), "walls", view, scale)
    block.AmbientColor = block.DiffuseColor = [0.66, 0.63, 0.59]
    block.Ambient, block.Diffuse = 0.75, 0.35
    frame(view, scale, azimuth, xyz)
    write_title(title, view)
    place_camera(view, xyz * scale.factors, floor * scale.factors[2], azimuth)
    simple.SaveScreenshot(path, view, ImageResolution=list(SIZE))


def new_view(azimuth):
    view = simple.CreateView("RenderView")
    view.ViewSize = list(SIZE)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background = [0.86, 0.89, 0.92]
    view.Background2 = [1.0, 1.0, 1.0]
    view.UseLight = 0  # no lamp at the camera
    sun = simple.AddLight(view=view)
    sun.Coords = "Scene"
    sun.Type = "Directional"
    sun.Position = list(toward(azimuth + LIGHT_FROM[0], LIGHT_FROM[1]))
    sun.FocalPoint = [0, 0, 0]
    sun.Intensity = 1.1
    return view


def colour(display, scale, z_name, view):
    simple.ColorBy(display, ("POINTS", z_name))
    table = simple.GetColorTransferFunction(z_name)
    low, high = scale.low, scale.high
    table.ColorSpace = "Lab"
    table.RGBPoints = [n for t, *rgb in COLOURS for n in [low + t * (high - low)] + rgb]
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = z_name, ""
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.TitleFontSize = bar.LabelFontSize = 16
    bar.WindowLocation = "Any Location"
    bar.Position = [0.93, 0.3]
    bar.ScalarBarLength = 0.4
    bar.DrawTickMarks = 1
    bar.AutomaticLabelFormat = 0
    digits = ".0f" if high - low > 10 else ".4g"
    # ParaView 6.1 wants the formats of std::format, those before it those of printf
    bar.LabelFormat = bar.RangeLabelFormat = "{:%s}" % digits if "{" in bar.LabelFormat else "%" + digits
    display.SetScalarBarVisibility(view, True)


def frame(view, scale, azimuth, xyz):
    """A box with the data's own numbers along its lower edges."""
    axes = view.AxesGrid
    axes.Visibility = 1
    axes.DataScale = list(scale.factors)  # else the numbers would be those of the drawn surface
    axes.ShowGrid = 1
    axes.FacesToRender = FLOOR
    axes.AxesToLabel = SOUTH_EDGE | (WEST_EDGE if azimuth > 180 else EAST_EDGE)
    axes.XTitle, axes.YTitle, axes.ZTitle = ("Longitude", "Latitude", "") if scale.geographic else ("", "", "")
    for axis, values in zip("XYZ", xyz.T):
        if numpy.abs(values).max() >= 1e5:  # eastings and northings: not as 6.574e+6
            setattr(axes, axis + "AxisNotation", "Fixed")
            setattr(axes, axis + "AxisPrecision", decimals(float(numpy.ptp(values))))
        for part in ("Title", "Label"):
            setattr(axes, axis + part + "Color", [0.25, 0.25, 0.25])
        setattr(axes, axis + "TitleFontSize", 18)
        setattr(axes, axis + "LabelFontSize", 15)
    axes.GridColor = [0.55, 0.58, 0.62]


def decimals(span):
    """How many decimals tell some twenty numbers along the span apart."""
    return max(0, math.ceil(-math.log10(span / 20))) if span > 0 else 0


def thickness(xyz, scale):
    """In z, of the slab that a flat set is drawn as: a hundredth of its diagonal."""
    width, depth = numpy.ptp(xyz[:, :2], axis=0)
    return 0.01 * math.hypot(width * scale.factors[0], depth) / scale.factors[2]


def write_title(title, view):
    for number, line in enumerate(title):
        text = simple.Text(Text=line)
        shown = simple.Show(text, view)
        shown.WindowLocation = "Any Location"
        shown.Position = [0.025, 0.94 - 0.04 * number]
        shown.Color = [0.1, 0.1, 0.1]
        shown.FontSize = 26 if number == 0 else 18
        shown.Bold = int(number == 0)


def viewing_azimuth(drawn):
    """Where the camera stands, in degrees from north: in the south, a little to the west; in the
    east, a little to the south, where the survey is much longer from north to south."""
    width, depth = numpy.ptp(drawn[:, :2], axis=0)
    return 202.0 if width >= 0.7 * depth else 112.0


def toward(azimuth, height):
    """The direction from the middle to a place at so many degrees from north and above the horizon."""
    azimuth, height = math.radians(azimuth), math.radians(height)
    return numpy.array([math.sin(azimuth) * math.cos(height), math.cos(azimuth) * math.cos(height), math.sin(height)])


def place_camera(view, drawn, floor, azimuth):
    """So near that all of the block just fits below the title and beside the colour bar."""
    low, high = drawn.min(axis=0), drawn.max(axis=0)
    back = toward(azimuth, VIEW_HEIGHT)
    right = toward(azimuth - 90.0, 0.0)
    up = numpy.cross(back, right)
    corners = [[x, y, floor] for x in (low[0], high[0]) for y in (low[1], high[1])]
    sample = numpy.vstack([drawn[:: max(1, len(drawn) // 20000)], corners])
    focus, distance = fit(sample, (low + high) / 2, back, right, up)
    view.CameraFocalPoint = list(focus)
    view.CameraPosition = list(focus + distance * back)
    view.CameraViewUp = list(up)
    view.CameraViewAngle = VIEW_ANGLE
    view.CenterOfRotation = list(focus)


def fit(points, focus, back, right, up):
    """The nearest camera that has all points within the frame, and what it looks at."""
    tangent = math.tan(math.radians(VIEW_ANGLE / 2))
    left_edge, right_edge = -0.90 * SIZE[0] / SIZE[1], 0.80 * SIZE[0] / SIZE[1]
    lower_edge, upper_edge = -0.86, 0.74
    distance = 2.0 * float(numpy.ptp(points, axis=0).max()) / tangent
    for _ in range(30):
        local = points - focus
        away = (distance - local @ back) * tangent
        across, upward = (local @ right) / away, (local @ up) / away
        shift_x = (across.max() + across.min() - right_edge - left_edge) / 2
        shift_y = (upward.max() + upward.min() - upper_edge - lower_edge) / 2
        focus = focus + (shift_x * right + shift_y * up) * distance * tangent
        grow = max(numpy.ptp(across) / (right_edge - left_edge), numpy.ptp(upward) / (upper_edge - lower_edge))
        distance *= grow
    return focus, distance
