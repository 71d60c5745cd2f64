# SPDX-License-Identifier: BSD-3-Clause
"""The recipes of Recipes.md, run as a reader would click them, give the numbers that they should."""

import math

from paraview import servermanager, simple

from pluginsupport import *

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
DOCUMENTATION = os.path.join(ROOT, "Plugin", "Documentation")
sys.path.insert(0, os.path.join(DOCUMENTATION, "Scripts"))
sys.path.insert(0, os.path.join(ROOT, "Plugin", "Examples"))

simple.LoadPlugin(PLUGIN, remote=False)
import recipes
import volumes


def ground(x, y):
    """The hills of PlanarPointSource, at its Scale of 1000 and a tenth as high."""
    u, v = math.tau * x / 1000, math.tau * y / 1000
    return 50 + 30 * math.sin(0.8 * u) * math.cos(0.65 * v) + 20 * math.cos(1.3 * u - 0.9 * v)


def fetched(proxy):
    """(its data, function that gives the tuples of a point array)"""
    data = servermanager.Fetch(proxy)

    def tuples(name):
        array = data.GetPointData().GetArray(name)
        check(array, "there is no array %s" % name)
        return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]

    return data, tuples


def is_near(found, expected, error, what):
    check(abs(found - expected) <= error, "%s: found %r, expected %r within %r" % (what, found, expected, error))


def test_dem():
    data, tuples = fetched(recipes.dem(recipes.survey(), 10.0))
    mask = tuples("vtkValidPointMask")
    check_equal(data.GetOrigin()[:2], (5.0, 5.0), "the first centre of aligned cells")
    off = [h[0] - ground(*data.GetPoint(i)[:2]) for i, h in enumerate(tuples("Elevation")) if mask[i][0]]
    check(len(off) > 9900, "only %d of 10000 cells have a height" % len(off))
    is_near(max(map(abs, off)), 0, 0.35, "the largest error, with points some 4 m apart")


def rings_of(proxy):
    """Of each ring: is it a hole, and its signed area."""
    data, found = servermanager.Fetch(proxy), []
    for k in range(data.GetNumberOfCells()):
        points = data.GetCell(k).GetPoints()
        xy = [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]
        area = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(xy, xy[1:])) / 2
        found.append((data.GetCellData().GetArray("IsHole").GetTuple1(k), area))
        check_equal(area < 0, found[-1][0] == 1, "a hole runs clockwise")
    return found


def test_outline():
    rings = rings_of(recipes.outline(recipes.survey(count=9000), 40.0))
    check(1 < len(rings) < 60, "%d rings" % len(rings))
    is_near(sum(area for _, area in rings), 980000, 20000, "area of the surface")


def test_filled_contour():
    rings = rings_of(recipes.filled_contour(recipes.survey(count=20000), 40.0, 60.0))
    step = [(i + 0.5) * 10 for i in range(100)]
    wanted = sum(100.0 for x in step for y in step if 40 < ground(x, y) < 60)
    is_near(sum(area for _, area in rings), wanted, 0.02 * wanted, "area between 40 and 60 metres")
    check(sum(hole for hole, _ in rings) > 0, "no hole")


def test_contours():
    data, tuples = fetched(recipes.contours(recipes.survey(count=5000), range(10, 90, 5), 5.0))
    check(data.GetNumberOfCells() > 1000, "%d pieces of contours" % data.GetNumberOfCells())
    for i in range(data.GetNumberOfPoints()):
        x, y, height = data.GetPoint(i)
        is_near(height, 5 * round(height / 5), 1e-4, "height of a contour")
        if 30 < min(x, y) and max(x, y) < 970:  # along the hull triangles are long
            is_near(ground(x, y), height, 0.5, "the ground below a contour")


def test_contours_alone_are_flat_in_places():
    """A sixth of the area lies between points of one contour; with points in the largest such places, little does."""
    lines = recipes.contours(recipes.survey(), range(10, 90, 10), 10.0)
    for x, y, z in recipes.SPOTS:
        is_near(z, ground(x, y), 0.051, "spot height at %r" % ((x, y),))
    shares = []
    for spots in ((), recipes.SPOTS):
        flat = servermanager.Fetch(recipes.flat_triangles(recipes.from_contours(lines, spots)))
        shares.append(sum(flat.GetCell(k).ComputeArea() for k in range(flat.GetNumberOfCells())) / 1e6)
    check(shares[0] > 0.15 and shares[1] < 0.02, "%r of the area is flat" % shares)


def test_profile():
    start, end = (80.0, 80.0), (930.0, 870.0)
    data, tuples = fetched(recipes.profile(recipes.survey(), start, end))
    heights, way = tuples("Elevation"), tuples("arc_length")
    check_equal(len(heights), 501, "places along the road")
    is_near(way[-1][0], math.dist(start, end), 1e-2, "length of the road")
    for i, (height,) in enumerate(heights):
        is_near(height, ground(*data.GetPoint(i)[:2]), 0.2, "height at %r" % (data.GetPoint(i),))


def test_volume_above():
    """By ParaView's filters, by the function of the example, and by the formula of the hills."""
    points, level = recipes.survey(), 60.0
    data, tuples = fetched(recipes.volume_above(points, level))
    by_filters = tuples("Above")[0][0]
    surface = servermanager.Fetch(simple.AdaptiveHilbertDelaunay2D(Input=points))
    ids = [cell_ids(surface.GetPolys(), i) for i in range(surface.GetNumberOfCells())]
    corners = [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]
    above, below, area = volumes.at_level(corners, ids, level)
    is_near(by_filters / above, 1, 1e-6, "the volume by ParaView's filters, of that by the function")
    is_near(data.GetCellData().GetArray("Area").GetValue(0) / area, 1, 1e-6, "the area above the level")
    exact = sum(max(0, ground(5 * i + 2.5, 5 * k + 2.5) - level) for i in range(200) for k in range(200)) * 25
    is_near(above / exact, 1, 2e-3, "the volume, of that of the hills")
    check(below > 0, "nothing is below the level")


def test_the_function_for_volumes():
    """One triangle with corners above, at and below the level; by prisms and the pyramids of their tops."""
    corners = [(0, 0), (3, 0), (0, 2)]  # area 3
    for heights, above, below, area in (
        ((1, 1, 1), 3, 0, 3),
        ((-1, -2, -3), 0, 6, 0),
        ((2, 0, 0), 2, 0, 3),
        ((1, -1, -1), 3 / 12, 3 / 12 + 1, 3 / 4),
        ((-1, 1, 1), 3 / 12 + 1, 3 / 12, 3 - 3 / 4),
        ((1, 0, -1), 3 / 6, 3 / 6, 3 / 2),
        ((0, 0, 0), 0, 0, None),
    ):
        for turn in range(3):
            points = [(*corners[k], 7 + heights[(k + turn) % 3]) for k in range(3)]
            found = volumes.at_level(points, [(0, 1, 2)], 7)
            for value, right, what in zip(found, (above, below, area), ("above", "below", "area")):
                if right is not None:
                    is_near(value, right, 1e-14, "%s, heights %r" % (what, heights))


def test_lighter():
    """No point is off by more, and few are left, which are those of the input that they say."""
    points, error = recipes.survey(), 0.5
    data, tuples = fetched(recipes.lighter(points, error))
    given = servermanager.Fetch(points)
    check(data.GetNumberOfPoints() < 1000, "%d points are left" % data.GetNumberOfPoints())
    for i, (own,) in enumerate(tuples("OriginalPointIds")):
        check_equal(data.GetPoint(i), given.GetPoint(int(own)), "point %d of the light surface" % i)
    at_points = simple.AdaptiveHilbertInterpolation2D(Input=recipes.lighter(points, error), Places=points)
    _, tuples = fetched(at_points)
    off = [abs(height - given.GetPoint(i)[2]) for i, (height,) in enumerate(tuples("Elevation"))]
    check(0.45 < max(off) <= error * (1 + 1e-6), "the largest error is %r" % max(off))


def test_what_a_lighter_surface_lost():
    """Between the points it is about as much."""
    points = recipes.survey()
    _, tuples = fetched(recipes.change(points, recipes.lighter(points, 0.5), [20, 980, 20, 980]))
    off = [abs(t[0]) for t in tuples("Change")]
    check(0.4 < max(off) < 0.6, "the largest difference on the raster is %r" % max(off))


def test_pieces():
    """They are one surface, with the contours of one; the hull has the only open edges."""
    points, levels = recipes.survey(count=200000), range(10, 90, 10)
    lines = recipes.contours_of_pieces(recipes.in_pieces(points, os.getcwd()), levels)
    whole = simple.AdaptiveHilbertDelaunay2D(Input=points)
    elevations = simple.Calculator(Input=whole, ResultArrayName="z", Function="coordsZ")
    of_whole = simple.Contour(Input=elevations, ContourBy=["POINTS", "z"], Isosurfaces=list(levels))
    counts = [servermanager.Fetch(made).GetNumberOfCells() for made in (lines, of_whole)]
    check_equal(counts[0], counts[1], "pieces of the contours")
    check(counts[0] > 10000, "%d pieces of the contours" % counts[0])
    rims = [simple.FeatureEdges(Input=simple.Clean(Input=made), FeatureEdges=0, NonManifoldEdges=0)
            for made in (lines.Input, whole)]  # fmt: skip
    counts = [servermanager.Fetch(rim).GetNumberOfCells() for rim in rims]
    check_equal(counts[0], counts[1], "open edges")


def test_mesh():
    """Angles and lengths are as wished, of the area within the shore; depths are those of the soundings' surface."""
    soundings, shore = recipes.bay()
    made = recipes.mesh(shore, 150.0)
    data, tuples = fetched(recipes.depths(made, soundings, shore))
    check(made.LeastAngle >= 30 - 1e-9 and made.NumberOfBadTriangles == 0, "an angle of %r" % made.LeastAngle)
    area = 0.0
    for k in range(data.GetNumberOfCells()):
        places = data.GetCell(k).GetPoints()
        a, b, c = (places.GetPoint(i)[:2] for i in range(3))
        check(max(map(math.dist, (a, b, c), (b, c, a))) <= 150 * (1 + 1e-12), "an edge of triangle %d" % k)
        area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
    whole, _ = fetched(simple.IntegrateVariables(
        Input=simple.AdaptiveHilbertDelaunay2D(Input=soundings, Source=shore, SourceMode="Coordinates",
                                               GenerateRegionIds=1)))
    flat = whole.GetCellData().GetArray("Area").GetTuple1(0)  # in space
    check(0.98 * flat < area < flat, "areas %r and %r" % (area, flat))
    depths, known = [t[0] for t in tuples("Elevation")], [t[0] for t in tuples("vtkValidPointMask")]
    check(set(known) == {1} and -24 < min(depths) < -20 and max(depths) == 0, "depths from %r" % min(depths))
    for is_boundary, cells in ((0, {0.0}), (1, set(map(float, range(1, 7))))):  # the channel; shore, islands, lagoon
        of = servermanager.Fetch(recipes.boundary(made, is_boundary)).GetCellData().GetArray("SourceCell")
        check_equal({of.GetTuple1(k) for k in range(of.GetNumberOfTuples())}, cells, "cells of the source")


def test_change():
    """The pit was dug, and nothing else changed by more than the triangles differ."""
    bounds, size = [20, 980, 20, 980], 2.0
    made = recipes.change(recipes.survey(), recipes.survey(seed=2, with_pit=True), bounds, size)
    _, tuples = fetched(made)
    change = [t[0] for t in tuples("Change")]
    check_equal(len(change), 480 * 480, "cells")
    _, _, radius, depth = recipes.PIT
    dug = math.pi * radius**2 * depth / 2
    found = -math.fsum(change) * size * size
    is_near(found, dug, 0.01 * dug, "the volume that was dug")
    with open(os.path.join(DOCUMENTATION, "recipes.html"), encoding="utf-8") as file:
        page = " ".join(file.read().split())
    for number in (dug, found):
        check("{:,.0f} cubic metres".format(number) in page, "recipes.html does not have %.0f cubic metres" % number)
    _, tuples = fetched(recipes.volume_of_change(made))
    is_near(-tuples("Change")[0][0] / found, 1, 1e-5, "the integral")
    # where the surveys do not cover the area, the change is NaN, and nothing is made up
    wider = recipes.change(recipes.survey(), recipes.survey(seed=2, with_pit=True), [-80, 980, 20, 980], size)
    _, tuples = fetched(recipes.volume_of_change(wider))
    is_near(-tuples("Change")[0][0] / found, 1, 1e-2, "the integral, with cells that have no value")


def test_slope_and_aspect():
    """Of a plane they are known; of the hills they point downhill."""
    plane = simple.Calculator(
        Input=simple.PlanarPointSource(NumberOfPoints=500), CoordinateResults=1,
        Function="coordsX*iHat + coordsY*jHat + (3*coordsX - 4*coordsY)*kHat")  # fmt: skip
    _, tuples = fetched(recipes.slope_and_aspect(plane, 0.05))
    mask = tuples("vtkValidPointMask")
    for (slope,), (aspect,), (valid,) in zip(tuples("Slope"), tuples("Aspect"), mask):
        if valid:
            is_near(slope, math.degrees(math.atan(5)), 1e-5, "slope")
            is_near(aspect, math.degrees(math.atan2(-3, 4)), 1e-5, "aspect")
    check(sum(m[0] for m in mask) > 300, "hardly a cell has a slope")
    made = recipes.slope_and_aspect(recipes.survey(2000), 5.0)
    steepest = []
    for rim in ("Convex Hull", "Trimmed"):
        made.Input.Input.Rim = rim
        _, tuples = fetched(made)
        steepest.append(max(slope for (slope,) in tuples("Slope") if slope == slope))
    check(steepest[1] < 0.8 * steepest[0], "slivers along the rim are steep: %r" % steepest)


def test_drape():
    from PIL import Image

    picture = scratch("picture.png")
    Image.new("RGB", (60, 40), (10, 200, 30)).save(picture)
    data, tuples = fetched(recipes.drape(recipes.survey(), picture, 600.0, (200.0, 100.0)))
    check_equal(data.GetNumberOfPoints(), 60 * 40, "pixels")
    check_equal(data.GetPoint(0)[:2], (205.0, 105.0), "centre of the first pixel")
    check_equal(tuples("PNGImage")[7], (10, 200, 30), "colour of a pixel")
    for i in range(data.GetNumberOfPoints()):
        x, y, z = data.GetPoint(i)
        is_near(z, ground(x, y), 0.35, "height of a pixel")


for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
