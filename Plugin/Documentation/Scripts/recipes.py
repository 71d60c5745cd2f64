# SPDX-License-Identifier: BSD-3-Clause
"""The recipes of Recipes.md, as pipelines of ParaView: what a reader clicks together, in the same order and with the
same settings. Each function takes points (a proxy) and returns the last filter. recipe_pictures.py draws them,
Testing/Plugin/TestRecipes.py compares their numbers with what they have to be.
"""

import os

from paraview import simple

#: The pit that the second survey found: its centre and radius in metres, its depth. A paraboloid.
PIT = (170.0, 180.0, 120.0, 8.0)

#: Spot heights (x, y, z), where contours every ten metres leave flat stretches: tops, hollows, ridges and valleys.
SPOTS = [
    (745, 900, 75.5), (140, 145, 85.1), (255, 825, 5.0), (445, 580, 51.9), (200, 255, 82.4),
    (690, 50, 52.5), (275, 935, 7.1), (510, 605, 51.9), (975, 475, 71.3), (950, 885, 58.1),
    (200, 750, 7.5), (870, 750, 59.0), (20, 550, 28.5), (735, 510, 37.7),
]  # fmt: skip


def survey(count=50000, seed=1, with_pit=False):
    """Points on made-up hills, 1 km by 1 km, heights in metres; another seed is another flight."""
    hills = simple.PlanarPointSource(NumberOfPoints=count, Seed=seed, Scale=1000.0)
    if not with_pit:
        return hills
    x, y, radius, depth = PIT
    dug = "%r*max(0, 1 - ((coordsX-%r)^2 + (coordsY-%r)^2)/%r)" % (depth, x, y, radius**2)
    function = "coordsX*iHat + coordsY*jHat + (coordsZ - %s)*kHat" % dug
    return simple.Calculator(Input=hills, CoordinateResults=1, Function=function)


def dem(points, size=2.0, **more):
    """A raster of the heights, its cells on multiples of their size."""
    return simple.AdaptiveHilbertInterpolation2D(
        Input=points, RasterSize="Cell Size", CellSize=[size, size], AlignToCellSize=1, **more
    )


def contours(points, levels, size=2.0):
    """Lines of equal height, smooth ones, at their heights."""
    terrain = dem(points, size, OutputType="Surface", Method="Natural Neighbor")
    return simple.Contour(Input=terrain, ContourBy=["POINTS", "Elevation"], Isosurfaces=list(levels))


def from_contours(lines, spots=()):
    """The surface of the points of contour lines, and of single points (x, y, z) between them."""
    points = lines
    if spots:
        single = simple.PolyPointSource(Points=[coordinate for spot in spots for coordinate in spot])
        points = simple.AppendGeometry(Input=[lines, single])
    return simple.AdaptiveHilbertDelaunay2D(Input=points)


def flat_triangles(surface):
    """Those between three points of one height."""
    # its name since ParaView 5.12, and before
    make = getattr(simple, "SurfaceNormals" if hasattr(simple, "SurfaceNormals") else "GenerateSurfaceNormals")
    normals = make(Input=surface, ComputeCellNormals=1, Splitting=0)
    upward = simple.Calculator(Input=normals, AttributeType="Cell Data", ResultArrayName="Up", Function="Normals_Z")
    return simple.Threshold(Input=upward, Scalars=["CELLS", "Up"], LowerThreshold=0.9999999, UpperThreshold=1.1)


def outline(points, longest):
    """The outline of a surface without triangles with an edge longer than this."""
    surface = simple.AdaptiveHilbertDelaunay2D(Input=points, MaximumEdgeLength=longest)
    return simple.PlanarSurfaceOutline(Input=surface)


def filled_contour(points, low, high):
    """The polygons of what lies between two heights."""
    surface = simple.AdaptiveHilbertDelaunay2D(Input=points, Rim="Trimmed")
    heights = simple.Calculator(Input=surface, ResultArrayName="Elevation", Function="coordsZ")
    band = simple.IsoVolume(Input=heights, InputScalars=["POINTS", "Elevation"], ThresholdRange=[low, high])
    return simple.PlanarSurfaceOutline(Input=simple.ExtractSurface(Input=band))


def profile(points, start, end, pieces=500):
    """The heights along a straight road, with the way along it (arc_length)."""
    road = simple.Line(Point1=[*start, 0.0], Point2=[*end, 0.0], Resolution=pieces)
    heights = simple.AdaptiveHilbertInterpolation2D(Input=points, Places=road)
    # its name since ParaView 5.13, and before
    length = "PolylineLength" if hasattr(simple, "PolylineLength") else "AppendArcLength"
    return getattr(simple, length)(Input=heights)


def volume_above(points, level):
    """What lies above a level, exactly that of the triangles. The volume is the array Above of the one point."""
    surface = simple.AdaptiveHilbertDelaunay2D(Input=points)
    above = simple.Calculator(Input=surface, ResultArrayName="Above", Function="coordsZ - %r" % level)
    part = simple.Clip(Input=above, ClipType="Scalar", Scalars=["POINTS", "Above"], Value=0.0, Invert=0)
    flat = simple.Calculator(Input=part, CoordinateResults=1, Function="coordsX*iHat + coordsY*jHat")
    return simple.IntegrateVariables(Input=flat)


def change(before, after, bounds, size=2.0):
    """Two surveys on the same raster, and what changed between them: array Change."""
    one, two = (
        dem(points, size, UseBounds=1, Bounds=list(bounds), HeightArrayName=name)
        for points, name in ((before, "Before"), (after, "After"))
    )
    both = simple.AppendAttributes(Input=[one, two])
    return simple.Calculator(Input=both, ResultArrayName="Change", Function="After - Before")


def volume_of_change(made, bounds=(-1000.0, 1000.0)):
    """The volume between the surveys, of what change() made: the array Change of the one point. Where Change is NaN, or
    outside the bounds, nothing counts."""
    known = simple.Threshold(Input=made, Scalars=["POINTS", "Change"])
    known.LowerThreshold, known.UpperThreshold = bounds
    return simple.IntegrateVariables(Input=known)


def lighter(points, error):
    """A surface of fewer points: it differs at none of them by more. Fate has their ids in the input."""
    return simple.AdaptiveHilbertDelaunay2D(Input=points, MaximumError=error)


def in_pieces(points, folder):
    """The path of the .pvtp that the command `adaptivehilbertdelaunay tiles` makes of these points in a folder.
    Requires: the Python package is on Python's path."""
    import numpy
    from adaptivehilbertdelaunay import tiles
    from paraview import servermanager
    from vtkmodules.util.numpy_support import vtk_to_numpy

    given, made = os.path.join(folder, "survey.npy"), os.path.join(folder, "survey.pvtp")
    numpy.save(given, vtk_to_numpy(servermanager.Fetch(points).GetPoints().GetData()))
    tiles.make([given], tin=made, leaf=5000, piece=50000, overwrite=True)
    return made


def contours_of_pieces(path, levels):
    """Lines of equal height on the surface of a .pvtp, which is their Input."""
    surface = simple.OpenDataFile(path)
    return simple.Contour(Input=surface, ContourBy=["POINTS", "z"], Isosurfaces=list(levels))


def bay():
    """Soundings and shore of the sources' Data/Bay."""
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3, "Data", "Bay")
    table = simple.CSVReader(FileName=[os.path.join(folder, "soundings.csv")])
    soundings = simple.TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="elevation")
    return soundings, simple.XMLPolyDataReader(FileName=[os.path.join(folder, "coastline.vtp")])


def mesh(shore, longest, angle=30.0):
    """A mesh to compute on, within a shore."""
    return simple.AdaptiveHilbertQualityMesh2D(Input=shore, Source=shore, MinimumAngle=angle, MaximumLength=longest)


def depths(made, soundings, shore):
    """The mesh with the array Elevation: what the soundings say at its points."""
    return simple.AdaptiveHilbertInterpolation2D(Input=soundings, Source=shore, SourceMode="Coordinates", Places=made)


def boundary(made, is_boundary=1):
    """The edges of a mesh that bound it, or those along lines within, with the cell of the source (SourceCell)."""
    found = simple.Threshold(Input=simple.OutputPort(made, 1), Scalars=["CELLS", "IsBoundary"])
    found.LowerThreshold = found.UpperThreshold = is_boundary
    return found


def slope_and_aspect(points, size=2.0):
    """Arrays Slope, degrees from level, and Aspect, the compass bearing of downhill, in degrees."""
    terrain = dem(points, size, GenerateGradients=1, Rim="Trimmed")
    slope = simple.Calculator(
        Input=terrain, ResultArrayName="Slope",
        Function="57.29577951308232*atan(sqrt(ElevationGradient_X^2 + ElevationGradient_Y^2))")  # fmt: skip
    return simple.Calculator(
        Input=slope, ResultArrayName="Aspect",
        Function="57.29577951308232*atan2(-ElevationGradient_X, -ElevationGradient_Y)")  # fmt: skip


def drape(points, picture, width, corner=(0.0, 0.0)):
    """A picture (.png) of the ground, `width` metres wide, laid over the terrain."""
    image = simple.PNGSeriesReader(FileNames=[picture])
    image.UpdatePipeline()
    columns = image.GetDataInformation().GetExtent()[1] + 1
    pixel = width / columns
    placed = simple.Transform(Input=image, TransformAllInputVectors=0)  # colours are no directions
    placed.Transform.Scale = [pixel, pixel, 1.0]
    placed.Transform.Translate = [corner[0] + pixel / 2, corner[1] + pixel / 2, 0.0]
    heights = simple.AdaptiveHilbertInterpolation2D(Input=points, Places=placed)
    return simple.WarpByScalar(Input=heights, Scalars=["POINTS", "Elevation"])
