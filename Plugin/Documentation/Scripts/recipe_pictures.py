# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of Recipes.md, drawn by ParaView from the pipelines of recipes.py.

    pvpython recipe_pictures.py <AdaptiveHilbertDelaunay.so> <folder for the pictures> [<lidar.csv> [only these]]

lidar.csv has the columns x, y, z in feet: the points of PDAL's test/data/las/autzen_trim.las (BSD). Without it the
picture recipe-dem.png is left as it is. make_figures.sh runs this, without lidar.csv.
"""

import os
import sys
import tempfile

from paraview import simple
from PIL import Image, ImageDraw

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import recipes

WIDTH, HEIGHT = 1440, 560  # shown at half its size
GREENS = [0.0, 0.27, 0.45, 0.45, 0.35, 0.55, 0.70, 0.50, 0.6, 0.85, 0.80, 0.62, 1.0, 0.96, 0.95, 0.92]
CENTRE = (500.0, 500.0, 45.0)
BESIDE = (650.0, 500.0, 45.0)  # leaves room for a legend


# --- views -----------------------------------------------------------------------------------------


def view(distance=None, turned=None, focus=CENTRE, angle=28):
    """From above, so that a height of `distance` is seen; or from the side (turned: where the camera is)."""
    made = simple.CreateView("RenderView")
    made.UseColorPaletteForBackground = 0
    made.BackgroundColorMode = "Single Color"
    made.Background = [1, 1, 1]
    made.OrientationAxesVisibility = 0
    made.CameraFocalPoint = list(focus)
    if turned:
        made.CameraPosition = list(turned)
        made.CameraViewUp = [0, 0, 1]
        made.CameraViewAngle = angle
    else:
        made.CameraParallelProjection = 1
        made.CameraParallelScale = distance / 2
        made.CameraPosition = [focus[0], focus[1], focus[2] + 5000]
        made.CameraViewUp = [0, 1, 0]
    return made


def show(source, where, array=None, colours=GREENS, limits=None, title="", **look):
    """Shows a filter coloured by an array, from the first to the last of the limits, with a legend of this title; or in
    one colour."""
    display = simple.Show(source, where)
    display.SetRepresentationType(look.pop("Representation", "Surface"))
    if array:
        simple.ColorBy(display, ("POINTS", array))
        table = simple.GetColorTransferFunction(array)
        low, high = limits or source.PointData[array].GetRange()
        steps = [number + 0.0 for number in colours]
        steps[::4] = [low + (high - low) * step for step in colours[::4]]
        table.RGBPoints = steps
        table.ColorSpace = "RGB"
        table.NanOpacity = 0.0
        add_legend(table, where, title)
    else:
        display.ColorArrayName = ["POINTS", ""]  # one colour
        display.AmbientColor = display.DiffuseColor = colours
    for name, value in look.items():
        setattr(display, name, value)
    return display


def add_legend(table, where, title):
    bar = simple.GetScalarBar(table, where)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.15, 0.15, 0.15]
    bar.TitleFontSize = bar.LabelFontSize = 15
    bar.RangeLabelFormat = bar.LabelFormat = "%.0f"
    bar.HorizontalTitle, bar.DrawBackground = 1, 1
    bar.BackgroundColor = [1, 1, 1, 0.8]
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.4, 16
    bar.WindowLocation = "Upper Right Corner"
    bar.Visibility = int(bool(title))


def lay_down_legend(array, where):
    """Below the picture."""
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), where)
    bar.Orientation, bar.WindowLocation, bar.ScalarBarLength = "Horizontal", "Lower Center", 0.6
    bar.DrawBackground = 0
    return bar


def add_note(text, where, size=15, place="Upper Right Corner"):
    """Says what the colours are, where there is no scale of them."""
    note = simple.Show(simple.Text(Text=text), where)
    note.Color, note.FontSize = [0.15, 0.15, 0.15], size
    note.WindowLocation = place


def side_by_side(path, left, right):
    layout = simple.CreateLayout(os.path.basename(path))
    layout.SplitHorizontal(0, 0.5)
    simple.AssignViewToLayout(left, layout, 1)
    simple.AssignViewToLayout(right, layout, 2)
    save(path, layout)


def save(path, what):
    simple.SaveScreenshot(path, what, ImageResolution=[WIDTH, HEIGHT])
    with Image.open(path) as picture:
        few = picture.convert("RGB").quantize(192, dither=Image.Dither.NONE)
    few.save(path, optimize=True)
    print("%s  %d KB" % (path, os.path.getsize(path) // 1024), flush=True)


def hills(seed=1, **more):
    made = recipes.survey(seed=seed, **more)
    made.UpdatePipeline()
    return made


# --- pictures --------------------------------------------------------------------------------------


def dem(path, lidar):
    """The piece of README's picture, from above and from the side."""
    table = simple.TableToPoints(Input=simple.CSVReader(FileName=[lidar]), XColumn="x", YColumn="y", ZColumn="z")
    table.UpdatePipeline()
    # the river, its bank, trees and their tops
    colours = [0.0, 0.55, 0.71, 0.82, 0.1, 0.66, 0.79, 0.87, 0.14, 0.9, 0.85, 0.73, 0.26, 0.93, 0.89, 0.78,
               0.32, 0.85, 0.86, 0.66, 0.4, 0.62, 0.76, 0.47, 0.65, 0.4, 0.64, 0.38, 1.0, 0.22, 0.48, 0.3]  # fmt: skip
    above = view(distance=470, focus=(636600, 849190, 418))
    show(recipes.dem(table), above, "Elevation", colours, (406, 480), "height, feet", Ambient=1.0,
         Diffuse=0.0)
    side = view(turned=(636690, 849040, 560), focus=(636745, 849215, 418))
    show(recipes.dem(table, OutputType="Surface"), side, "Elevation", colours, (406, 480), "height, feet")
    side_by_side(path, above, side)


def contours(path):
    points = recipes.survey(count=220)
    points.UpdatePipeline()
    levels = [5.0 * k for k in range(19)]
    surface = simple.AdaptiveHilbertDelaunay2D(Input=points)
    heights = simple.Calculator(Input=surface, ResultArrayName="Elevation", Function="coordsZ")
    angular = simple.Contour(Input=heights, ContourBy=["POINTS", "Elevation"], Isosurfaces=levels)
    views = []
    for lines, made in ((angular, "of the\ntriangles"), (recipes.contours(points, levels), "by natural\nneighbours")):
        lines.UpdatePipeline()
        views.append(view(distance=560, focus=(780, 500, 45)))
        show(lines, views[-1], None, [0.45, 0.3, 0.15], LineWidth=3.0, Ambient=1.0, Diffuse=0.0)
        add_note("every 5 m,\n" + made, views[-1], 10)
    side_by_side(path, *views)


def flat(path):
    """Contours alone, and with spot heights: the flat triangles in red."""
    lines = recipes.contours(recipes.survey(), range(10, 90, 10), 10.0)
    views = []
    for spots in ((), recipes.SPOTS):
        surface = recipes.from_contours(lines, spots)
        surface.UpdatePipeline()
        views.append(view(distance=1040, focus=BESIDE))
        show(surface, views[-1], None, [0.85, 0.87, 0.82], Representation="Surface With Edges",
             EdgeColor=[0.72, 0.74, 0.7], Ambient=1.0, Diffuse=0.0)  # fmt: skip
        show(lines, views[-1], None, [0.45, 0.3, 0.15], LineWidth=3.0, Ambient=1.0, Diffuse=0.0)
        flats = recipes.flat_triangles(surface)
        flats.UpdatePipeline()
        if flats.GetDataInformation().GetNumberOfCells():
            show(flats, views[-1], None, [0.9, 0.3, 0.2], Ambient=1.0, Diffuse=0.0)
        add_note("brown: contours\nred: flat" + "\nblue: added" * bool(spots), views[-1], 10)
    points = simple.PolyPointSource(Points=[c for x, y, _ in recipes.SPOTS for c in (x, y, 120)])  # above all
    show(points, views[-1], None, [0.15, 0.3, 0.75], PointSize=14.0, Ambient=1.0,
         Diffuse=0.0)  # fmt: skip
    side_by_side(path, *views)


def outline(path):
    points = recipes.survey(count=9000)
    gaps = simple.Clip(Input=points, ClipType="Sphere", Invert=0)
    gaps.ClipType.Center, gaps.ClipType.Radius = [300, 680, 15], 130
    gaps = simple.Clip(Input=gaps, ClipType="Sphere", Invert=0)
    gaps.ClipType.Center, gaps.ClipType.Radius = [1020, 160, 45], 330
    views = []
    for made in (recipes.outline(simple.ExtractSurface(Input=gaps), 40.0), recipes.filled_contour(points, 40.0, 60.0)):
        made.UpdatePipeline()
        views.append(view(distance=1080, focus=BESIDE))
        cells = show(made.Input, views[-1], None, [0.82, 0.84, 0.8], Ambient=1.0, Diffuse=0.0)
        cells.SetRepresentationType("Surface")
        for hole, colour in ((0, [0.1, 0.3, 0.7]), (1, [0.8, 0.15, 0.1])):
            rings = simple.Threshold(Input=made, Scalars=["CELLS", "IsHole"])
            rings.LowerThreshold = rings.UpperThreshold = hole  # an argument of 0 would become the array's maximum
            rings.UpdatePipeline()
            lifted = simple.Transform(Input=rings)
            lifted.Transform.Translate = [0, 0, 200]
            show(lifted, views[-1], None, colour, LineWidth=4.0, Ambient=1.0, Diffuse=0.0)
        add_note("blue: outer\nred: holes", views[-1], 10)
    side_by_side(path, *views)


def profile(path):
    points = hills()
    terrain = recipes.dem(points)
    road = recipes.profile(points, (80, 80), (930, 870))
    road.UpdatePipeline()
    above = view(distance=1040, focus=BESIDE)
    show(terrain, above, "Elevation", limits=(0, 90), title="height, m")
    show(road, above, None, [0.85, 0.3, 0.1], LineWidth=6.0, Ambient=1.0, Diffuse=0.0)
    chart = simple.CreateView("XYChartView")
    display = simple.Show(simple.PlotData(Input=road), chart)
    display.UseIndexForXAxis = 0
    display.XArrayName = "arc_length"
    display.SeriesVisibility = ["Elevation"]
    display.SeriesColor = ["Elevation", "0.85", "0.3", "0.1"]
    display.SeriesLineThickness = ["Elevation", "4"]
    chart.BottomAxisTitle = "along the road, metres"
    chart.LeftAxisTitle = "height, metres"
    chart.ShowLegend = 0
    side_by_side(path, above, chart)


def volume(path):
    points = hills()
    surface = simple.AdaptiveHilbertDelaunay2D(Input=points)
    above = simple.Calculator(Input=surface, ResultArrayName="Above", Function="coordsZ - 60")
    part = simple.Clip(Input=above, ClipType="Scalar", Scalars=["POINTS", "Above"], Value=0.0, Invert=0)
    rest = simple.Clip(Input=above, ClipType="Scalar", Scalars=["POINTS", "Above"], Value=0.0, Invert=1)
    level = simple.Plane(Origin=[0, 0, 60], Point1=[1000, 0, 60], Point2=[0, 1000, 60])
    side = view(turned=(500, -1150, 620), focus=(500, 470, 40), angle=17)
    show(rest, side, None, [0.78, 0.83, 0.76])
    show(part, side, None, [0.88, 0.55, 0.25])
    show(level, side, None, [0.35, 0.55, 0.8], Opacity=0.35)
    add_note("orange: above 60 m; blue: that level", side, 8)
    save(path, side)


def change(path):
    bounds = [20, 980, 20, 980]
    made = recipes.change(hills(), hills(2, with_pit=True), bounds)
    made.UpdatePipeline()
    blues = [0.0, 0.1, 0.25, 0.55, 0.45, 0.45, 0.65, 0.85, 0.9, 0.93, 0.93, 0.9, 1.0, 0.95, 0.7, 0.5]
    above = view(distance=1000, focus=BESIDE)
    show(made, above, "Change", blues, (-8, 1), "change, m", Ambient=1.0, Diffuse=0.0)
    terrain = recipes.dem(hills(2, with_pit=True), OutputType="Surface")
    side = view(turned=(250, -700, 900), focus=(260, 260, 220), angle=24)
    show(terrain, side, "Elevation", limits=(0, 90), title="height, m", Scale=[1, 1, 3])
    side_by_side(path, above, side)


def lighter(path):
    """The whole, what is left of it, and the difference."""
    bounds, points = [0, 1000, 0, 1000], recipes.survey(count=1000000)
    light = recipes.lighter(points, 0.5)
    surfaces = [simple.AdaptiveHilbertDelaunay2D(Input=points), light]
    lost = recipes.change(points, light, bounds)
    views = [view(distance=1500, focus=(500.0, 370.0, 45.0)) for _ in range(3)]
    for surface, where, look in zip(surfaces, views, ("Surface", "Surface With Edges")):
        heights = simple.Calculator(Input=surface, ResultArrayName="Elevation", Function="coordsZ")
        heights.UpdatePipeline()
        display = show(heights, where, "Elevation", limits=(0, 90), title="height, m", Representation=look)
        display.EdgeColor = [0.25, 0.3, 0.25]
        add_note("{:,} triangles".format(heights.GetDataInformation().GetNumberOfCells()), where, place="Upper Center")
        lay_down_legend("Elevation", where)
    lost.UpdatePipeline()
    blues = [0.0, 0.1, 0.3, 0.65, 0.5, 0.97, 0.97, 0.95, 1.0, 0.75, 0.2, 0.1]
    show(lost, views[2], "Change", blues, (-0.5, 0.5), "difference, m", Ambient=1.0, Diffuse=0.0)
    bar = lay_down_legend("Change", views[2])
    bar.LabelFormat = bar.RangeLabelFormat = "%.1f"
    layout = simple.CreateLayout(os.path.basename(path))
    layout.SplitHorizontal(0, 1 / 3)
    layout.SplitHorizontal(2, 0.5)
    for where, place in zip(views, (1, 5, 6)):
        simple.AssignViewToLayout(where, layout, place)
    save(path, layout)


def pieces(path):
    """Of the TIN in pieces: each in its colour, where four meet; and all of it, with contours."""
    with tempfile.TemporaryDirectory() as folder:
        lines = recipes.contours_of_pieces(recipes.in_pieces(hills(count=200000), folder), range(10, 90, 10))
        lines.UpdatePipeline()
        left = view(distance=34, focus=(500.0, 500.0, 45.0))
        colours = [(0.72, 0.82, 0.62), (0.95, 0.83, 0.6), (0.67, 0.8, 0.9), (0.9, 0.72, 0.68)]
        parts = [os.path.join(folder, "survey", name) for name in sorted(os.listdir(os.path.join(folder, "survey")))]
        for part, colour in zip(parts, colours):
            piece = simple.OpenDataFile(part)
            display = show(piece, left, colours=colour, Representation="Surface With Edges", Ambient=1.0, Diffuse=0.0)
            display.EdgeColor = [0.35, 0.35, 0.35]
        right = view(distance=1040, focus=BESIDE)
        show(lines.Input, right, "z", limits=(0, 90), title="height, m")
        show(lines, right, colours=(0.2, 0.2, 0.2), LineWidth=2, Position=[0, 0, 1])
        side_by_side(path, left, right)


def mesh(path):
    """All of it with depths, and a part with the edges along the shore and the channel."""
    soundings, shore = recipes.bay()
    made = recipes.mesh(shore, 150.0)
    depths = recipes.depths(made, soundings, shore)
    depths.UpdatePipeline()
    above = view(distance=5200, focus=(3600.0, 1960.0, 0.0))
    blues = [0.0, 0.1, 0.25, 0.5, 0.6, 0.45, 0.65, 0.8, 1.0, 0.9, 0.95, 0.93]
    look = {"Representation": "Surface With Edges", "EdgeColor": [0.35, 0.45, 0.5], "Ambient": 1.0, "Diffuse": 0.0}
    show(depths, above, "Elevation", blues, (-23, 0), "elevation, m", **look)
    near = view(distance=1500, focus=(3200.0, 1500.0, 0.0))
    show(made, near, None, [0.93, 0.95, 0.96], **look)
    for is_boundary, colour in ((0, [0.85, 0.3, 0.1]), (1, [0.1, 0.3, 0.7])):
        lines = recipes.boundary(made, is_boundary)
        lines.UpdatePipeline()
        lifted = simple.Transform(Input=lines)
        lifted.Transform.Translate = [0, 0, 50]
        show(lifted, near, None, colour, LineWidth=4.0, Ambient=1.0, Diffuse=0.0)
    add_note("blue: shore\nred: channel", near, 10, "Lower Left Corner")
    side_by_side(path, above, near)


def slope(path):
    made = recipes.slope_and_aspect(hills(), 4.0)
    made.UpdatePipeline()
    reds = [0.0, 0.97, 0.96, 0.9, 0.5, 0.93, 0.7, 0.35, 1.0, 0.55, 0.12, 0.1]
    around = [0.0, 0.3, 0.45, 0.75, 0.25, 0.55, 0.7, 0.4, 0.5, 0.95, 0.8, 0.35, 0.75, 0.75, 0.4, 0.4,
              1.0, 0.3, 0.45, 0.75]  # fmt: skip
    views = []
    for array, colours, limits, title in (
            ("Slope", reds, (0, 22), "slope, °"), ("Aspect", around, (-180, 180), "aspect, °")):
        views.append(view(distance=1040, focus=BESIDE))
        show(made, views[-1], array, colours, limits, title, Ambient=1.0, Diffuse=0.0)
    side_by_side(path, *views)


def map_of_the_hills(path):
    """Fields, a lake and a road, as an aerial picture might have them."""
    picture = Image.new("RGB", (1000, 1000))
    pen = ImageDraw.Draw(picture)
    for k in range(100):
        x, y = 100 * (k % 10), 100 * (k // 10)
        green = 37 * k % 5 * 9
        pen.rectangle((x, y, x + 97, y + 97), fill=(150 + green, 170 + green // 2, 95 + green))
    pen.ellipse((500, 560, 720, 730), fill=(95, 140, 185))
    pen.line([(0, 930), (180, 800), (330, 560), (520, 420), (760, 330), (1000, 120)], fill=(235, 230, 220), width=16)
    picture.save(path)


def drape(path):
    with tempfile.TemporaryDirectory() as folder:
        plan = os.path.join(folder, "map.png")
        map_of_the_hills(plan)
        made = recipes.drape(hills(), plan, 960.0, (20.0, 20.0))
        made.UpdatePipeline()
        side = view(turned=(500, -1150, 620), focus=(500, 470, 40), angle=17)
        display = show(made, side, "PNGImage")
        display.MapScalars = 0
        add_note("the colours of the picture:\nfields, a road, a lake", side, 8)
        save(path, side)


PICTURES = {function.__name__: function
            for function in (
                contours, flat, outline, profile, volume, change, lighter, pieces, mesh, slope, drape)}  # fmt: skip


def draw(folder, lidar=None, only=None):
    """Draws all pictures, or only those with these names."""
    os.makedirs(folder, exist_ok=True)
    if lidar and (not only or "dem" in only):
        dem(os.path.join(folder, "recipe-dem.png"), lidar)
    for name, picture in PICTURES.items():
        if not only or name in only:
            picture(os.path.join(folder, "recipe-%s.png" % name))


if __name__ == "__main__":
    simple.LoadPlugin(os.path.abspath(sys.argv[1]), remote=False)
    draw(*sys.argv[2:4], only=sys.argv[4:])
