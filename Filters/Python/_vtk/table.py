# SPDX-License-Identifier: BSD-3-Clause
# Made by Filters/Settings/generate.py: change what is there, not this.
"""The settings and measures of the classes as rows. Of a setting: name, kind, default, what it does, least and most of
what values are clamped to, and, of an enum, what follows SetXTo for 0, 1, ... Kinds: bool, flag (a vtkTypeBool: any
int), enum, int, int64, double, text."""

import math

DELAUNAY = (
    ("MergeBlocks", "bool", False,
     'Triangulate the points of all blocks of a multiblock data set together, into one surface without seams, '
     'for example of lidar tiles. Point arrays that all blocks have are passed on. If off, each block becomes a '
     'surface of its own. Off by default. The points are numbered block after block. The points and their data '
     'are copied.',
     None, None, ()),
    ("SourceMode", "enum", 0,
     'How the source gives its lines. Coordinates: by its own points, which are added to the surface (a point '
     'with the same x and y as one of the input is not added again). Point ids: its points stand for the points '
     "of the input with the same ids, and their coordinates are ignored, as in VTK's vtkDelaunay2D. Default: "
     'SOURCE_COORDINATES in ParaView, SOURCE_IDS in VTK. Points of the source are numbered after those of the '
     'input.',
     0, 1, ('Ids', 'Coordinates')),
    ("SourceHeights", "enum", 0,
     "The heights of the source's points. Own: their own z. Two-dimensional lines, as in most maps, lie at z = 0 "
     'and pull the surface down to it. From Surface: height and point data are interpolated linearly on the '
     'surface of the input; points outside it keep their own z, and a warning counts them. Mixed: points with a '
     'z keep it; those without (NaN, see Zero Is Missing) take theirs from the surface of the input and of the '
     'lines between points with z. Not used with Source Mode Point ids. Default: OWN. From Surface and Mixed '
     'triangulate twice: first without the points that take their heights from there, then all.',
     0, 2, ('Own', 'FromSurface', 'Mixed')),
    ("ZeroIsMissing", "bool", False,
     'With Source Heights Mixed, points of the source with z = 0 have no height, too. For files and readers that '
     'give 0 where there is none. Off by default.',
     None, None, ()),
    ("SourceLinesOnSurface", "bool", True,
     'With Source Heights From Surface or Mixed, add a point where a line of the source crosses an edge of the '
     'surface that its heights come from, so that the line follows the terrain. If off, it runs straight from '
     'point to point, through the air and below ground. With Mixed, a line between two points with z is '
     'straight. On by default. A place is the exact crossing, rounded once, as with CrossingMode SPLIT; lines '
     'with a point at one place share it.',
     None, None, ()),
    ("MaximumSegmentLength", "double", 0.0,
     'Divide segments of the source that are longer than this, in the plane of the triangulation, into equal '
     'parts, by points that are added. 0: none is divided. Default 0, at least 0. After points were added on the '
     'surface (SourceLinesOnSurface), each piece is divided by itself. The new points take heights and data as '
     'the line does: from the surface, or linearly between the ends of the piece.',
     0.0, 1e+299, ()),
    ("ClosedLines", "enum", 0,
     'How lines of the source that end where they begin are treated. Lines: as edges of the surface, like other '
     'lines; right for contours. Loops: as outlines that bound the surface, like polygons; right for coastlines, '
     'lakes and borders from GeoJSON, shapefiles and .csv, which come as lines. Lines that meet end to end, as '
     'those of Extract Surface and Feature Edges, are joined to such outlines. Default: LINES. A line is closed '
     'if its ends are the same point or have the same x and y in the plane of the triangulation. Others are '
     'joined where two of them end, and no third; those that do not close then stay lines of their own. In the '
     'order of the constraints, loops come after the other lines.',
     0, 1, ('Lines', 'Loops')),
    ("PointsAsLine", "bool", False,
     'Take the points of a source that has nothing but points as one line, in their order: a table of points '
     'along a shore or a road. If the first and the last have the same x and y, the line is closed (see Closed '
     'Lines). A source with lines, polygons or triangle strips has its own. Not used with Source Mode Point ids. '
     'Off by default.',
     None, None, ()),
    ("FillRule", "enum", 0,
     'Which side of the outlines (polygons and loops of the source) is kept. Even-odd: the inside of an odd '
     'number of outlines, whatever their direction. Orientation, as in vtkDelaunay2D: the left side of each, so '
     'counterclockwise outlines are filled, clockwise ones are holes, and they may be nested; outlines in '
     'shapefiles run the other way. Default: EVEN_ODD in ParaView, ORIENTATION in VTK. With Orientation, regions '
     'that no loop bounds are kept, too. Without loops, all triangles are kept.',
     0, 1, ('Orientation', 'EvenOdd')),
    ("CrossingMode", "enum", 0,
     'How two lines of the source that cross between their points are treated. Leave out: the later of the two '
     'segments is left out and counted (Number Of Crossings), and an outline that lacks a segment bounds '
     'nothing. Split: a point is added at the crossing, with height and data from both lines, and no segment is '
     'left out. Default: LEAVE_OUT. Lines come before polygons, then cells in their order. The height and data '
     'of an added point are the mean of those interpolated linearly along the two segments.',
     0, 1, ('LeaveOut', 'Split')),
    ("MaximumEdgeLength", "double", 0.0,
     'Remove every triangle with an edge longer than this, measured in the plane of the triangulation, in the '
     'units of the points. A survey then gets its concave outline instead of the convex hull. 0: no limit. '
     'Default 0, at least 0. Longer lines of Alpha are removed, too.',
     0.0, 1e+299, ()),
    ("Alpha", "double", 0.0,
     'The alpha shape, as in Delaunay 2D: triangles with a circumradius of at most Alpha; as lines, edges of at '
     'most 2 Alpha that belong to none of these triangles; as vertices, points that belong to neither. Radii and '
     'lengths are measured in space, z included. 0: off, all triangles. Default 0, at least 0. Reference.md says '
     'where it differs from vtkDelaunay2D.',
     0.0, 1e+299, ()),
    ("AlphaTris", "flag", 1,
     'Output the triangles of the alpha shape. On by default.',
     None, None, ()),
    ("AlphaLines", "flag", 1,
     'Output, as lines, the edges of the alpha shape that belong to none of its triangles. On by default.',
     None, None, ()),
    ("AlphaVerts", "flag", 1,
     'Output, as vertices, the points of the alpha shape that belong to none of its triangles and lines. On by '
     'default.',
     None, None, ()),
    ("MaximumError", "double", 0.0,
     'Leave out points as long as the surface differs at none of them by more than this, vertically (in a fitted '
     'plane: along its normal), in the units of z. Corners of the convex hull and points of lines and outlines '
     'stay. Largest Error is the largest that is left, Number Of Points Within Error the number left out. 0: '
     'off, all points. Default 0, at least 0. The bound holds at all points that represent a place, and is '
     'checked in wider arithmetic. It is not combined with Insertion Limit, Alpha, or the mean of '
     'DuplicatePolicy: these are refused.',
     0.0, 1e+299, ()),
    ("MaximumNumberOfVertices", "int64", 0,
     'The best surface of so many points: those are left out without which it differs least from all. Largest '
     'Error says by how much. With Maximum Error, too, it ends at whichever comes first. 0: no limit. Default 0, '
     'at least 0. Points that stay in any case, see MaximumError, are never too many.',
     0, 9223372036854775807, ()),
    ("SecondPass", "bool", False,
     'With Maximum Error or Maximum Number Of Vertices: at the end take points out again as long as the error '
     'stays within the bound. It takes longer, and leaves 5 to 20 % fewer. Off by default.',
     None, None, ()),
    ("KeptPointsOnly", "bool", True,
     'With Maximum Error or Maximum Number Of Vertices: the surface has the points of its triangles only, with '
     'their ids in the input as the point array OriginalPointIds. With the status of points or errors, which are '
     'about all points, it has all. On by default.',
     None, None, ()),
    ("ValueArrayName", "text", '',
     'The point array, of one number for each point, of which Maximum Error is the error, in place of z. Where '
     'it is NaN the point stays. Points of the source have the values of their own array of this name. Empty or '
     '"None": z. Default "". DuplicatePolicy still chooses by z which of several points at one place is the '
     'vertex.',
     None, None, ()),
    ("WeightArrayName", "text", '',
     'The point array of weights: numbers times which the errors of points count. Where one is negative or NaN '
     'the point stays. Points that are added have the weight 1. Empty or "None": all have. Default "".',
     None, None, ()),
    ("KeepArrayName", "text", '',
     'The point array of marks: where one is not 0 the point stays. Empty or "None": no marks. Default "".',
     None, None, ()),
    ("ProjectionPlaneMode", "enum", 0,
     'The plane in which the points are triangulated. XY plane: z is the height. Transform plane: x and y after '
     'the Transform. Best-fitting plane: the plane with the least sum of squared distances from the points, for '
     'a rock face or a scanned wall. The output has the points at their original positions. Default: '
     'VTK_DELAUNAY_XY_PLANE. After a transform or in a fitted plane, the triangulation is exact for the '
     'coordinates there, rounded to double precision, and duplicates are determined there. In the x, y plane a '
     'Transform is applied if one is set; in the transform plane a missing Transform causes a warning. For the '
     'best-fitting plane see ComputeBestFittingPlane; Transform is not used.',
     0, 2, ()),
    ("Rim", "enum", 0,
     'Where the surface ends if no outline bounds it. Convex hull: it has all triangles. Trimmed: without the '
     'flat triangles along the rim, those with an angle above 158 degrees whose longest edge lies there; in a '
     'fitted plane these stand as walls along a rim that is straight in space. Automatic: the convex hull in the '
     'XY plane, and in the best-fitting plane of points that all have the same z, x or y; otherwise trimmed. No '
     'effect with Alpha, Maximum Edge Length or Bounding Triangulation. Number Of Trimmed Triangles counts the '
     'triangles removed. Default: AUTOMATIC. The angle is exactly 180 degrees less the arc tangent of 2/5. '
     'Triangles that thereby come to the rim are trimmed likewise. Constraints stay edges. A warning appears if '
     'a point is left without a triangle or a tenth of the area is removed.',
     0, 2, ('Automatic', 'ConvexHull', 'Trimmed')),
    ("Tolerance", "double", 0.0,
     "Merge points that are closer to each other than this fraction of the diagonal of the points' bounding box, "
     'in the plane of the triangulation. 0: only points with exactly the same x and y are merged. Number Of '
     'Merged Points counts the points merged beyond these; Generate Point Status shows into which point. From 0 '
     'to 1. Default 0. Points are processed in lexicographic order of x, y; a point within that distance of '
     "vertices is merged into the nearest. Constraints follow. vtkDelaunay2D's default is 1e-5, of the diagonal "
     'in space.',
     0.0, 1.0, ()),
    ("DuplicatePolicy", "enum", 0,
     'Which of the points with the same x and y becomes the vertex and gives the surface its height. First: the '
     'point with the smallest id. Lowest z, highest z: the deepest or the shoalest sounding, for example. Mean '
     'z: the first point, at the mean of the heights. Default: FIRST. Finite heights take precedence; the mean '
     'is that of all finite heights, in a copy of the points. Merged points do not count. Changes ids and z, '
     'never the shape in the plane.',
     0, 3, ('First', 'LowestZ', 'HighestZ', 'MeanZ')),
    ("GeneratePointStatus", "bool", False,
     'Add a point array, Fate, with the status of each point: its own id if it is a vertex of the surface; the '
     'id of another point if it is a duplicate of it or was merged into it; -1 if it was rejected, because x or '
     'y is NaN or infinite; -2 if it was not inserted, because it is marked as a ghost or hidden, is beyond the '
     'Insertion Limit, or is a duplicate of a point beyond it; -3 if it is within Maximum Error. Switch it on to '
     'find the points that are not in the surface. Off by default. The array is a vtkIdTypeArray.',
     None, None, ()),
    ("GenerateErrors", "bool", False,
     'Add a point array, Error: how far the surface is from each point, vertically, or in a fitted plane along '
     'its normal. 0 for vertices; NaN where there is no surface, and for points that were rejected or skipped. '
     'With Value Array Name it is the difference of these values. Off by default. A vtkDoubleArray. Weights do '
     'not change it. The largest of all points that MaximumError left out is LargestError, if there are no '
     'weights.',
     None, None, ()),
    ("GenerateConstraintEdges", "bool", False,
     'Add a cell array, ConstraintEdges: which edges of a triangle are edges of the source. The sum of 1 (from '
     'the first corner to the second), 2 (from the second to the third) and 4 (from the third to the first). Off '
     'by default. The array is a vtkUnsignedCharArray. Lines and vertices have 0.',
     None, None, ()),
    ("GenerateRegionIds", "bool", False,
     'Add a cell array, RegionId: triangles that can be reached from each other without crossing a line of the '
     'source have the same number, from 0. Off by default. The array is a vtkIdTypeArray. Lines and vertices '
     'have -1.',
     None, None, ()),
    ("GenerateNeighbors", "bool", False,
     'Add a cell array, Neighbors, of three numbers: the triangles on the other side of the edges from the first '
     'corner to the second, from the second to the third, and from the third to the first; -1 where there is '
     'none. Off by default. The array is a vtkIdTypeArray. Lines and vertices have -1.',
     None, None, ()),
    ("GenerateVoronoi", "bool", False,
     'Fill the third output, Voronoi, with a polygon for each vertex: the region that is nearer to it than to '
     'any other vertex. The polygons lie at z = 0 and have the point data of their vertices as cell data. In '
     'ParaView: the filter Voronoi Cells 2D (Adaptive Hilbert). Off by default. Output port 2: convex '
     'counterclockwise polygons, with the vertex\'s id as "OriginalPointIds" (vtkIdTypeArray). Corners are those '
     'of the exact polygons, rounded once to double precision; corners that differ by at most 4 units in the '
     'last place may be merged. Constraints are ignored.',
     None, None, ()),
    ("VoronoiClip", "enum", 0,
     'Where the polygons of the Voronoi diagram, of which the outer ones are unbounded, are clipped. Hull: at '
     'the convex hull of the points. Bounds: at their bounding box. Polygon: at Voronoi Polygon. Default: '
     'CLIP_TO_HULL. Hull and bounds are those of the vertices, in the plane of the triangulation.',
     0, 2, ('Hull', 'Bounds', 'Polygon')),
    ("VoronoiPolygon", "text", '',
     'Two opposite corners of a box, or the corners of a convex polygon in their order: x y, x y, ... in the '
     'plane of the triangulation. The Voronoi polygon of each vertex is the part of it that is nearer to that '
     'vertex than to any other, however few or collinear the vertices are; vertices without a part have none. '
     'Used if Voronoi Clip is Polygon. Default "". Numbers are separated by blanks, commas or semicolons. '
     'Corners that are no convex polygon are an error of the execution.',
     None, None, ()),
    ("InsertionOrder", "enum", 0,
     'The order in which the points are inserted. It changes the time, never the triangles. Adaptive Hilbert '
     '(HG), the fastest: boxes, divided where points are crowded, visited along a Hilbert curve. Multi-grid '
     '(MG): the same boxes, visited line by line. Regular grid (RG): boxes of one size, visited line by line. As '
     'given: the order of the input; very slow for points in random order. Change it to compare. Default: '
     'ADAPTIVE_HILBERT.',
     0, 3, ('AdaptiveHilbert', 'MultiGrid', 'RegularGrid', 'AsGiven')),
    ("Nmax", "int", 50,
     'A box with more points than this is divided. Su et al. find 50 to 200 good. Smaller boxes follow crowded '
     'points more closely and take longer to sort. It changes the time, never the triangles. It has an effect '
     'with the Insertion Order Multi-grid, and with Adaptive Hilbert if Control Points is Off or First level, '
     'Gene Rotation is off, or Generate Boxes is on, which outputs the boxes. Otherwise it has none, since the '
     'curve continues inside the boxes down to single points, and ParaView greys it out. Default 50, at least 1.',
     1, 2147483647, ()),
    ("ControlPoints", "enum", 2,
     'A sparse subset of the points, inserted before all others so that fewer long thin triangles are built and '
     'removed again. It changes the time, never the triangles. Off: none. First level: one point of each box of '
     'the first division, as Su et al. do. Every level: a sparse subset of the points, a sparser subset of that, '
     'and so on, inserted from coarse to fine. Used by Adaptive Hilbert and Multi-grid. Change it to compare. '
     'Default: EVERY_LEVEL.',
     0, 2, ('None', 'SingleLevel', 'EveryLevel')),
    ("GeneRotation", "bool", True,
     'Turn the Hilbert curve in each divided box so that it connects to the curve in the boxes before and after '
     '(the paper\'s "gene"). If off, the curve jumps between boxes, and after each jump the search for the next '
     'point starts farther away. It changes the time, never the triangles. Used by Adaptive Hilbert. Change it '
     'to compare. On by default.',
     None, None, ()),
    ("CountWork", "bool", False,
     'Count the triangles tested to locate each point (NP) and the triangles removed to insert it (NR). Switch '
     'it on to compare insertion orders by their work, which is the same on every machine, rather than by '
     'seconds. Counting takes time, and one thread inserts; it never changes the triangles. Off by default.',
     None, None, ()),
    ("InsertionLimit", "int64", 0,
     'Stop after this number of points: the surface is the triangulation of these alone. 0, or any number that '
     'is large enough: all points. The insertion settings determine which points come first. In ParaView move '
     'the slider, or animate it, to watch the surface grow: both go from 3, the fewest points that can form a '
     'triangle, to the number of points; for all points type 0. Default 0, at least 0. Only distinct points '
     'count. The others are in no triangle; NumberOfPointsBeyondLimit counts them. With a limit, one thread '
     'inserts.',
     0, 9223372036854775807, ()),
    ("GenerateInsertionRank", "bool", False,
     'Add a point array, InsertionRank: the position of each point in the order of insertion, from 0; -1 for '
     'duplicates, rejected and skipped points. Colour by it to see the order. Off by default. The array is a '
     'vtkIdTypeArray; the order is that of one thread.',
     None, None, ()),
    ("GenerateInsertionCurve", "bool", False,
     'Add a line through the inserted points, in the order of insertion, to the second output, Insertion order. '
     "Its point array InsertionRank counts along the line; OriginalPointIds has the points' ids in the input. "
     'Off by default. Output port 1.',
     None, None, ()),
    ("GenerateBoxes", "bool", False,
     'Add the boxes of the grid that determines the order to the second output, Insertion order: the boxes that '
     'are not divided further, in the order in which they are visited, at the height of the lowest point. Cell '
     'arrays: Level, the number of divisions that made the box; Count, the number of points in it. The order As '
     'given has no boxes. Off by default. Output port 1; about 300 bytes a box.',
     None, None, ()),
    ("Offset", "double", 1.0,
     'As in Delaunay 2D: how far away the eight points of Bounding Triangulation are. No other effect. Default '
     '1, at least 0.75. In multiples of the diagonal, in space, of the bounding box.',
     0.75, 1e+299, ()),
    ("BoundingTriangulation", "flag", 0,
     'As in Delaunay 2D: add eight points on a circle around all others, and the triangles that connect them. '
     'Only if the points are triangulated in x and y. Off by default. The circle is centred on the bounding box. '
     'In other planes there is a warning.',
     None, None, ()),
    ("RandomPointInsertion", "flag", 0,
     'No effect: present for scripts written for vtkDelaunay2D. Insertion Order sets the order of insertion, '
     'which never changes the triangles. Off by default.',
     None, None, ()),
    ("UseHilbertSorter", "flag", 0,
     'No effect: present for scripts written for vtkDelaunay2D. Points are inserted along a Hilbert curve '
     'anyway, unless Insertion Order says otherwise. Off by default.',
     None, None, ()),
    ("NumberOfThreads", "int", 0,
     'The number of threads. It changes the time, never the triangles. 0: one for each processor that the '
     'program (ParaView; with a server, the server) may use, unless VTK is limited to fewer, for example by the '
     'environment variable VTK_SMP_MAX_THREADS. 1 to 1024: exactly this number. Set it if other programs need '
     'processors, too. With Count Work, an Insertion Limit, another Insertion Order than Adaptive Hilbert, or '
     'insertion settings other than the defaults, one thread inserts the points; also if there are few points. '
     'From 0 to 1024. Default 0. The calling thread is one of them; only there is progress reported and an abort '
     'checked. 0 also respects vtkSMPTools::Initialize(n).',
     0, 1024, ()),
    ("DistributePoints", "bool", False,
     'On a server with several ranks: triangulate the points of all ranks together, into one surface without '
     'seams, with exactly the triangles that one rank would give. Each point moves to the rank that owns its '
     'location, with the point arrays that all ranks have; downstream filters get the ghost cells they request. '
     'If off, each rank triangulates its own points. With some settings one rank computes the whole surface; a '
     'warning says so once. All ranks must update the filter: a script of pvbatch --sym that updates it on one '
     'rank alone never returns. No effect with one rank, nor in the class and plugin in Python, where each rank '
     'works on its own. On by default in ParaView, off in VTK. If off, there is a warning with several ranks. '
     'The ranks are those of Controller. The triangles are those of one rank that has all inputs and sources, '
     'appended in the order of the ranks. All ranks must update with the same settings: if one executes, all do. '
     'Each outputs the triangles that it owns, by location, with its points, and after these the points of other '
     'ranks that are corners, with vtkGhostType DUPLICATEPOINT. Layers of ghost cells are marked as well. The '
     'global ids "GlobalPointIds" number the points as appended, those of sources last; "GlobalCellIds" the '
     "triangles. Counts are those of all ranks. Ids in the source's cells refer to the rank's own points. "
     'Sources that are the same on all ranks count once if their points are added. A failure on one rank is one '
     'error on each. With settings that have no method for several ranks, one rank triangulates all points and '
     'outputs the whole surface, if its memory suffices; a warning names the first such setting, and '
     'Reference.md lists them. With MergeBlocks off, block k of all ranks is triangulated by itself, for each k.',
     None, None, ()),
    ("KeepTriangulation", "bool", True,
     'Reuse triangles while points, source and settings stay the same, as in time steps in which only the arrays '
     'change: from the third run on, the triangles are passed on, with the current arrays. Switch it off to '
     'triangulate in each run. On by default. Coordinates, ghost marks, source and settings are compared; point '
     'data and field data are the current ones.',
     None, None, ()),
    ("MemoryLimit", "int64", 0,
     'The most memory the filter may use beyond its input, in kibibytes (1024 bytes). A run that is estimated to '
     'need more is refused with an error before anything is computed. 0: the memory that the machine has left. '
     'Set it if other programs need memory, too. Default 0, at least 0. The output is included. 0 also respects '
     'the limits of the process. With GenerateBoxes the error comes before any point is inserted.',
     0, 9223372036854775807, ()),
    ("ReuseLimit", "int64", 262144,
     'The most memory, in kibibytes (1024 bytes), that the filter keeps to make its next run faster: working '
     'memory, and the memory of former outputs. Memory beyond that is freed after each run. The default, 256 '
     'MiB, is enough for 2 million points. 0 keeps nothing. Raise it for larger data that change in time, lower '
     'it if many such filters are in one pipeline. Default 262144, at least 0. Working memory comes first: a run '
     'that took more, failed or was aborted frees all of it. Within the limit a triangulation stays whole until '
     'the next execution, for filters that interpolate on its surface. The rest of the limit is for the memory '
     'of outputs that have been released.',
     0, 9223372036854775807, ()),
)
DELAUNAY_CONSTANTS = {
    "SOURCE_IDS": 0,
    "SOURCE_COORDINATES": 1,
    "OWN": 0,
    "FROM_SURFACE": 1,
    "MIXED": 2,
    "LINES": 0,
    "LOOPS": 1,
    "ORIENTATION": 0,
    "EVEN_ODD": 1,
    "LEAVE_OUT": 0,
    "SPLIT": 1,
    "AUTOMATIC": 0,
    "CONVEX_HULL": 1,
    "TRIMMED": 2,
    "FIRST": 0,
    "LOWEST_Z": 1,
    "HIGHEST_Z": 2,
    "MEAN_Z": 3,
    "CLIP_TO_HULL": 0,
    "CLIP_TO_BOUNDS": 1,
    "CLIP_TO_POLYGON": 2,
    "ADAPTIVE_HILBERT": 0,
    "MULTI_GRID": 1,
    "REGULAR_GRID": 2,
    "AS_GIVEN": 3,
    "NO_CONTROL_POINTS": 0,
    "SINGLE_LEVEL": 1,
    "EVERY_LEVEL": 2,
}
# In the order in which PrintSelf has them: name, what it is before an execution and after one that failed, what it is.
DELAUNAY_MEASURES = (
    ("NumberOfTriangles", 0,
     'Triangles of the surface, in the last run.'),
    ("NumberOfPointsInserted", 0,
     'Points that are vertices of the surface, in the last run. Counts are 0 if the run was aborted or failed; '
     'otherwise those of points add up to all points, added ones included.'),
    ("NumberOfDuplicates", 0,
     'Points with the same x and y as an earlier point, in the last run. They are not in the surface.'),
    ("NumberOfMergedPoints", 0,
     'Points that were merged into another by Tolerance, in the last run. Points with exactly the same x and y '
     'are counted as duplicates.'),
    ("NumberOfAddedPoints", 0,
     'Points of the surface that are not in the input, in the last run: points of the source, points at '
     'crossings, and those of Bounding Triangulation.'),
    ("NumberOfRejectedPoints", 0,
     'Points rejected because x or y is NaN or infinite, in the last run. They are not in the surface.'),
    ("NumberOfSkippedPoints", 0,
     'Points skipped because they are marked as ghosts or hidden, in the last run.'),
    ("NumberOfPointsBeyondLimit", 0,
     'Points that are not in the surface because of the Insertion Limit, in the last run.'),
    ("NumberOfPointsWithinError", 0,
     'Points that Maximum Error or Maximum Number Of Vertices left out, in the last run.'),
    ("NumberOfConstraintEdges", 0,
     'Edges of the triangulation that are edges of the source, in the last run. Edges of removed triangles are '
     'included.'),
    ("NumberOfCrossings", 0,
     'Segments of the source left out because they cross an earlier one, in the last run; with Crossing Mode '
     'Split, the points added where segments cross. The field data array Crossings lists the lines.'),
    ("NumberOfAddedLinePoints", 0,
     'Points added to lines of the source, in the last run, where they cross edges of the surface (Source Lines '
     'On Surface) or are divided (Maximum Segment Length).'),
    ("NumberOfBentConstraints", 0,
     'With Crossing Mode Split: segments of the source that bend by rounding, in the last run, because they pass '
     'through a point that is not exactly on them.'),
    ("NumberOfConstraintsLeftOut", 0,
     'Segments of the source left out of the triangulation, in the last run: they cross another, or an end is '
     'not a vertex.'),
    ("NumberOfUnfilledLoops", 0,
     'Outlines that bound nothing because one of their segments was left out, in the last run.'),
    ("NumberOfTrimmedTriangles", 0,
     'Flat triangles that Rim removed, in the last run.'),
    ("LargestError", 0.0,
     'The largest vertical distance from the surface of a point that Maximum Error or Maximum Number Of Vertices '
     'left out, in the last run.'),
    ("NP", -1.0,
     'Triangles tested to locate a point, per inserted point, in the last run. The time to locate points is '
     'proportional to it. -1 if it was not counted: switch Count Work on. The triangle where the search starts '
     'is included.'),
    ("NR", -1.0,
     'Triangles removed to insert a point, per inserted point, in the last run. The time to update the triangles '
     'is proportional to it. -1 if it was not counted: switch Count Work on.'),
    ("SortSeconds", 0.0,
     'Wall-clock seconds to read the points and sort them into the order of insertion, in the last run. Seconds '
     'are 0 if triangles were passed on.'),
    ("InsertSeconds", 0.0,
     'Wall-clock seconds to insert the points, in the last run.'),
    ("ConstrainSeconds", 0.0,
     'Wall-clock seconds to insert the lines of the source as edges, in the last run.'),
    ("OutputSeconds", 0.0,
     'Wall-clock seconds to write the triangles in their canonical order, in the last run.'),
    ("NumberOfThreadsUsed", 0,
     'Threads that shared the work of the last run; 1 if there was too little work to share.'),
    ("NumberOfTriangulations", 0,
     'How often this filter has triangulated since it was created; runs that passed on existing triangles do not '
     'count.'),
    ("MemoryEstimate", 0,
     'The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its input, or was '
     'refused: the number that is compared with Memory Limit. After too many crossings: the estimate for one '
     'more than fits.'),
)
# Texts of measures: what each is, and of each measure in it the words after the number, and its name.
DELAUNAY_TEXTS = {
    "Measures": (
     'What the last run found, as a text with a line for each number. Numbers that are 0 are left out, but for '
     'the first. Empty before a run.', (
         ("triangles", "NumberOfTriangles"),
         ("points in the surface", "NumberOfPointsInserted"),
         ("duplicates left out", "NumberOfDuplicates"),
         ("points merged", "NumberOfMergedPoints"),
         ("points added", "NumberOfAddedPoints"),
         ("points rejected (NaN or infinite)", "NumberOfRejectedPoints"),
         ("points skipped (ghost or hidden)", "NumberOfSkippedPoints"),
         ("points beyond the limit", "NumberOfPointsBeyondLimit"),
         ("points left out within the error", "NumberOfPointsWithinError"),
         ("edges of the source", "NumberOfConstraintEdges"),
         ("crossings in the source", "NumberOfCrossings"),
         ("points added to lines", "NumberOfAddedLinePoints"),
         ("bent segments", "NumberOfBentConstraints"),
         ("segments left out", "NumberOfConstraintsLeftOut"),
         ("outlines that bound nothing", "NumberOfUnfilledLoops"),
         ("flat triangles trimmed", "NumberOfTrimmedTriangles"),
         ("largest error of the points left out", "LargestError"),
         ("triangles tested a point (NP)", "NP"),
         ("removed a point (NR)", "NR"),
     )),
    "Resources": (
     'What the last run took, as a text with a line for each number: seconds of wall-clock time, threads, '
     'memory. Numbers that are 0 are left out, but for the first. Empty before a run.', (
         ("s to sort", "SortSeconds"),
         ("s to insert", "InsertSeconds"),
         ("s to constrain", "ConstrainSeconds"),
         ("s to write", "OutputSeconds"),
         ("threads", "NumberOfThreadsUsed"),
         ("triangulations so far", "NumberOfTriangulations"),
         ("KiB of memory at most", "MemoryEstimate"),
     )),
}
# What is also field data of the output.
DELAUNAY_COUNTS = (
    "NumberOfTriangles",
    "NumberOfPointsInserted",
    "NumberOfDuplicates",
    "NumberOfMergedPoints",
    "NumberOfAddedPoints",
    "NumberOfRejectedPoints",
    "NumberOfSkippedPoints",
    "NumberOfPointsBeyondLimit",
    "NumberOfPointsWithinError",
    "NumberOfConstraintEdges",
    "NumberOfCrossings",
    "NumberOfAddedLinePoints",
    "NumberOfBentConstraints",
    "NumberOfConstraintsLeftOut",
    "NumberOfUnfilledLoops",
    "NumberOfTrimmedTriangles",
)
# What are 0 where the triangles were passed on.
DELAUNAY_SECONDS = (
    "SortSeconds",
    "InsertSeconds",
    "ConstrainSeconds",
    "OutputSeconds",
)
# Not set back by an execution that failed.
OF_ALL_RUNS = (
    "NumberOfTriangulations",
)
# What has no GetXMinValue and GetXMaxValue.
WITHOUT_ENDS = (
    "MaximumSegmentLength",
    "MaximumEdgeLength",
    "MaximumError",
)
# Measures, and the counts and measures of the job that each is the sum of.
OF_JOB = {
    "NumberOfTriangles": ('triangles',),
    "NumberOfPointsInserted": ('inserted',),
    "NumberOfDuplicates": ('duplicates',),
    "NumberOfMergedPoints": ('merged_points',),
    "NumberOfAddedPoints": ('added_points',),
    "NumberOfRejectedPoints": ('not_finite',),
    "NumberOfSkippedPoints": ('skipped',),
    "NumberOfPointsBeyondLimit": ('beyond_limit',),
    "NumberOfPointsWithinError": ('within_error',),
    "NumberOfConstraintEdges": ('constraint_edges',),
    "NumberOfCrossings": ('crossings',),
    "NumberOfAddedLinePoints": ('points_added_to_lines',),
    "NumberOfBentConstraints": ('bent_segments',),
    "NumberOfConstraintsLeftOut": ('segments_without_vertex', 'segments_crossing'),
    "NumberOfUnfilledLoops": ('unfilled_loops',),
    "NumberOfTrimmedTriangles": ('trimmed_triangles',),
    "LargestError": ('largest_error',),
    "NP": ('np',),
    "NR": ('nr',),
    "SortSeconds": ('seconds_merge', 'seconds_read', 'seconds_sort'),
    "InsertSeconds": ('seconds_insert',),
    "ConstrainSeconds": ('seconds_split', 'seconds_constrain'),
    "OutputSeconds": ('seconds_extract', 'seconds_outputs'),
    "NumberOfThreadsUsed": ('threads_used',),
}
# Old names, and those of now.
OLD_NAMES = {
    "GenerateFate": "GeneratePointStatus",
}
# A job's setting and the one of the class that it is.
SAME = {
    "cell_ids": "SourceMode",
    "zero_is_missing": "ZeroIsMissing",
    "lines_on_surface": "SourceLinesOnSurface",
    "maximum_segment_length": "MaximumSegmentLength",
    "closed_lines": "ClosedLines",
    "points_as_line": "PointsAsLine",
    "fill_rule": "FillRule",
    "split_crossings": "CrossingMode",
    "maximum_edge_length": "MaximumEdgeLength",
    "alpha": "Alpha",
    "maximum_error": "MaximumError",
    "maximum_vertices": "MaximumNumberOfVertices",
    "second_pass": "SecondPass",
    "rim": "Rim",
    "tolerance": "Tolerance",
    "duplicates": "DuplicatePolicy",
    "want_point_status": "GeneratePointStatus",
    "want_errors": "GenerateErrors",
    "want_constraint_edges": "GenerateConstraintEdges",
    "want_regions": "GenerateRegionIds",
    "want_neighbors": "GenerateNeighbors",
    "want_voronoi": "GenerateVoronoi",
    "voronoi_clip": "VoronoiClip",
    "insertion_order": "InsertionOrder",
    "nmax": "Nmax",
    "control_points": "ControlPoints",
    "gene_rotation": "GeneRotation",
    "count_work": "CountWork",
    "insertion_limit": "InsertionLimit",
    "want_insertion_ranks": "GenerateInsertionRank",
    "want_curve": "GenerateInsertionCurve",
    "want_boxes": "GenerateBoxes",
    "offset": "Offset",
}
# Settings that a surface made before has used up, and the values that count for values on it.
USED_UP = {
    "SourceMode": 0,
    "SourceHeights": 0,
    "ZeroIsMissing": 0,
    "SourceLinesOnSurface": 1,
    "MaximumSegmentLength": 0.0,
    "PointsAsLine": 0,
    "CrossingMode": 0,
    "MaximumEdgeLength": 0.0,
    "Alpha": 0.0,
    "AlphaTris": 1,
    "AlphaLines": 1,
    "AlphaVerts": 1,
    "MaximumError": 0.0,
    "MaximumNumberOfVertices": 0,
    "SecondPass": 0,
    "Rim": 1,
    "Tolerance": 0.0,
    "DuplicatePolicy": 0,
    "InsertionLimit": 0,
    "BoundingTriangulation": 0,
}

# Arrays of the surface that a setting adds: the setting, the job's array, name, type, components, of which data.
ARRAYS = (
    ("GeneratePointStatus", "point_status", "Fate", "vtkIdTypeArray", 1, "PointData"),
    ("GenerateErrors", "errors", "Error", "vtkDoubleArray", 1, "PointData"),
    ("GenerateInsertionRank", "insertion_ranks", "InsertionRank", "vtkIdTypeArray", 1, "PointData"),
    ("GenerateConstraintEdges", "constraint_edges", "ConstraintEdges", "vtkUnsignedCharArray", 1, "CellData"),
    ("GenerateRegionIds", "regions", "RegionId", "vtkIdTypeArray", 1, "CellData"),
    ("GenerateNeighbors", "neighbors", "Neighbors", "vtkIdTypeArray", 3, "CellData"),
)
# Their settings by the names that callers from PyVista use.
ARRAY_KEYWORDS = {
    "status": "GeneratePointStatus",
    "errors": "GenerateErrors",
    "rank": "GenerateInsertionRank",
    "constraint_edges": "GenerateConstraintEdges",
    "regions": "GenerateRegionIds",
    "neighbors": "GenerateNeighbors",
}

INTERPOLATION = (
    ("Method", "enum", 0,
     'The method of interpolation. Linear: linear in each triangle; the fastest. Natural Neighbor: the '
     'surrounding points, weighted by the areas that the place would take from their Voronoi cells (Sibson); '
     'smooth everywhere except at the points, and the best-looking for scattered points. Laplace: the same '
     'points, weighted by the lengths of the common borders over the distances; similar, a little faster. '
     "Nearest: the value of the nearest point, in the array's own type. Default: LINEAR. Constraint edges and "
     'the rim end the reach of Natural Neighbor and Laplace. Nearest has values on the whole plane; of several '
     'vertices at the same distance it takes the one with the smallest x, then y. It does not look across holes '
     'and outlines: the straight line to the vertex does not leave the surface through a constraint edge that '
     'bounds it. Collinear points: linear between neighbours on their line.',
     0, 3, ('Linear', 'NaturalNeighbor', 'Laplace', 'Nearest')),
    ("RasterSize", "enum", 0,
     'How the number of cells of the raster is set. Dimensions: by their number along x and y. Cell Size: by the '
     'width and height of a cell. Default: BY_CELL_SIZE in ParaView, BY_DIMENSIONS in VTK. Where the numbers of '
     'that are 0, the cells are squares, chosen from the points: about as many as there are points in the input, '
     'or 65536 if these are fewer, and no more than about 4096 along a side. Their size is 1, 2 or 5 times a '
     'power of ten.',
     0, 1, ('ByDimensions', 'ByCellSize')),
    ("Dimensions", "int", (256, 256),
     'The number of cells along x and y; they fill the area of the raster. 0: square cells, chosen from the '
     'points. Default 0, 0 in ParaView, 256, 256 in VTK, at least 0.',
     0, 2147483647, ()),
    ("CellSize", "double", (1.0, 1.0),
     'The width and height of a cell in the units of the points: metres for projected points, degrees if x and y '
     'are longitude and latitude. Both 0: square cells, chosen from the points: about as many, or 65536 if these '
     'are fewer, of 1, 2 or 5 times a power of ten. The raster begins at the lower bounds and covers all points; '
     'one that needs more memory than available is refused with an error that says how much. Default 0, 0 in '
     'ParaView, 1, 1 in VTK. Other sizes that are not positive and finite are an error of the execution. The '
     'raster has as many cells as cover the area, at least one. Whether the last one is needed is decided on the '
     'numbers as written in decimal (15 digits): 100 cells of 0.1 cover 0 to 10.',
     None, None, ()),
    ("AlignToCellSize", "bool", False,
     'Align the borders between cells with multiples of the cell size, so that the cells of neighbouring tiles '
     "and of different surveys coincide (like -tap of GDAL). Off by default. Used with BY_CELL_SIZE. The area's "
     'lower bounds are rounded down, the upper ones up.',
     None, None, ()),
    ("UseBounds", "bool", False,
     'Use Bounds as the area of the raster instead of the bounding box of the points: two surveys to be '
     'subtracted from each other need the same area. Off by default. If off, the area is the bounding box of all '
     'triangulated points, in the plane of the triangulation; a side of length 0 makes one cell, as long as the '
     "other side's (or 1).",
     None, None, ()),
    ("Bounds", "double", (0.0, 1.0, 0.0, 1.0),
     'The area of the raster, to the outer borders of its cells: least x, greatest x, least y, greatest y. '
     'Default 0, 1, 0, 1. Bounds that are not finite, or with a lower bound that is not below the upper, are an '
     'error of the execution.',
     None, None, ()),
    ("OutputType", "enum", 0,
     'The type of the raster. Image: an image in the plane z = 0 with the heights as an array, small and fast, '
     'for GIS and for calculations. Surface: a grid of points at their heights, to show terrain. Points without '
     'a value are hidden. Default: IMAGE. Points are hidden by vtkGhostType (HIDDENPOINT). An image has this '
     'array only where there is such a point: one without a value in any array. In a surface those outside and '
     'those without a finite height are hidden.',
     0, 1, ('Image', 'Surface')),
    ("Outside", "enum", 0,
     'The values at places outside the surface. No Value: NaN in floating-point arrays, 0 in others. Nearest '
     'Vertex: the values of the nearest point of the triangulation, as with Nearest. Boundary: the values at the '
     'nearest place of the surface, without a jump along its border. Always vtkValidPointMask is 0 there. Places '
     'outside by no more than rounding have values like those inside. Default: NO_VALUE. NoValue replaces NaN. '
     'Counts of places outside do not depend on this. Rounding: 16 units in the last place of the largest '
     'coordinate of place and edge.',
     0, 2, ('NoValue', 'NearestVertex', 'Boundary')),
    ("NoValue", "double", math.nan,
     'The number in floating-point arrays where there is no value. Integer arrays (Nearest) have 0 there. '
     'Default NaN.',
     None, None, ()),
    ("GenerateGradients", "bool", False,
     'For each array of one component add its gradient, an array of two components: the change per unit of x and '
     'of y (NameGradient). The gradient of Elevation gives the slope and aspect of a terrain. Only with Linear; '
     'constant in each triangle. Off by default. With other methods there is a warning. On an edge or at a '
     'vertex it is that of one of its triangles.',
     None, None, ()),
    ("HeightArrayName", "text", 'Elevation',
     'The name of the array of heights: z of the points or, in another plane, the height above it. Default '
     '"Elevation". The array is a vtkDoubleArray; an array of the input with that name is not interpolated, and '
     'there is a warning. Empty: no such array. The name of the mask, or "vtkGhostType", is an error of the '
     'execution.',
     None, None, ()),
    ("ValidPointMaskArrayName", "text", 'vtkValidPointMask',
     'The name of the array that marks where there is a value: 1 on the surface, 0 elsewhere. The default is the '
     'name that ParaView\'s own resampling filters use. Default "vtkValidPointMask". The array is a vtkCharArray; '
     'with Nearest, 1 for all places with finite x and y. Empty: no mask. The name of the heights or of their '
     'gradients, or "vtkGhostType", is an error of the execution.',
     None, None, ()),
)
INTERPOLATION_CONSTANTS = {
    "LINEAR": 0,
    "NATURAL_NEIGHBOR": 1,
    "LAPLACE": 2,
    "NEAREST": 3,
    "BY_DIMENSIONS": 0,
    "BY_CELL_SIZE": 1,
    "IMAGE": 0,
    "SURFACE": 1,
    "NO_VALUE": 0,
    "NEAREST_VERTEX": 1,
    "BOUNDARY": 2,
}
INTERPOLATION_MEASURES = (
    ("NumberOfPlaces", 0,
     'Places, or cells of the raster, in the last run. The sum of those on the surface, those outside it and '
     'those that are not finite. Counts are 0 if the run was aborted or failed; they are field data of the '
     'output, too.'),
    ("NumberOfValidPlaces", 0,
     'Places on the surface, in the last run: those where vtkValidPointMask is 1.'),
    ("NumberOfPlacesOutside", 0,
     'Places outside the surface, in the last run: beyond its hull, in a hole or in a removed triangle.'),
    ("NumberOfNotFinitePlaces", 0,
     'Places whose x or y is NaN or infinite, in the last run. They have no value.'),
    ("NumberOfPlacesWithoutValue", 0,
     'Values that are NaN at places on the surface, because points around them have NaN, in the last run. There '
     'is one value for each component of an array at a valid place.'),
    ("NumberOfPlacesWithNeighborsLeftOut", 0,
     'With Natural Neighbor and Laplace: values interpolated without some natural neighbours, because these have '
     'NaN, in the last run.'),
    ("SampleSeconds", 0.0,
     'Wall-clock seconds to locate the places and interpolate, in the last run, without the triangulation.'),
    ("NumberOfTriangulations", 0,
     'How often this filter has triangulated since it was created. Another method or cell size needs no new '
     'triangulation. A triangulation is kept if KeepTriangulation is on and ReuseLimit is large enough, for the '
     'next execution with the same points, constraints and Triangulation. It stays 0 on a surface whose own '
     'triangulation is available.'),
    ("MemoryEstimate", 0,
     'The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its input, or was '
     'refused: the number that is compared with Memory Limit. That is the MemoryLimit of Triangulation.'),
)
INTERPOLATION_TEXTS = {
    "Measures": (
     'What the last run found, as a text with a line for each number. Numbers that are 0 are left out, but for '
     'the first. Empty before a run.', (
         ("places", "NumberOfPlaces"),
         ("on the surface", "NumberOfValidPlaces"),
         ("outside", "NumberOfPlacesOutside"),
         ("NaN or infinite", "NumberOfNotFinitePlaces"),
         ("values missing (NaN around them)", "NumberOfPlacesWithoutValue"),
         ("values lacking neighbours", "NumberOfPlacesWithNeighborsLeftOut"),
     )),
    "Resources": (
     'What the last run took, as a text with a line for each number: seconds of wall-clock time, threads, '
     'memory. Numbers that are 0 are left out, but for the first. Empty before a run.', (
         ("s to interpolate", "SampleSeconds"),
         ("triangulations so far", "NumberOfTriangulations"),
         ("KiB of memory at most", "MemoryEstimate"),
     )),
}
INTERPOLATION_COUNTS = (
    "NumberOfPlaces",
    "NumberOfValidPlaces",
    "NumberOfPlacesOutside",
    "NumberOfNotFinitePlaces",
    "NumberOfPlacesWithoutValue",
    "NumberOfPlacesWithNeighborsLeftOut",
)
INTERPOLATION_OF_JOB = {
    "NumberOfPlaces": ('sampled_places',),
    "NumberOfValidPlaces": ('sampled_valued',),
    "NumberOfPlacesOutside": ('sampled_outside',),
    "NumberOfNotFinitePlaces": ('sampled_not_finite',),
    "NumberOfPlacesWithoutValue": ('sampled_without_value',),
    "NumberOfPlacesWithNeighborsLeftOut": ('sampled_left_out',),
}

QUALITY = (
    ("MinimumAngle", "double", 20.0,
     'The smallest angle that triangles may have, in degrees. 0: any. From 0 to 34. Default 20. It ends by '
     'theorem up to 20.7, where segments meet in 60 degrees or more, and in practice up to 34: set '
     'MaximumNumberOfAddedPoints above 30. Angles between segments stay as they are.',
     0.0, 34.0, ()),
    ("MaximumArea", "double", 0.0,
     'The largest area that triangles may have, in the plane of the triangulation. 0: any. Default 0, at least '
     '0.',
     0.0, 1e+299, ()),
    ("MaximumLength", "double", 0.0,
     'The largest length that edges may have, in the plane of the triangulation. 0: any. Default 0, at least 0.',
     0.0, 1e+299, ()),
    ("SizeArrayName", "text", '',
     'The point array with the longest edge wished at each point, linear between the points; all its numbers '
     'must be finite and greater than 0. Empty or "None": edges may have any length. Default "". One number for '
     'each point. With a source whose points are added, the source has an array of this name, too; without one, '
     'the execution ends with an error.',
     None, None, ()),
    ("MaximumNumberOfAddedPoints", "int64", -1,
     'Stop after so many added points. Triangles that are not as wished by then are marked in BadReason. -1: as '
     'many as it takes. Default -1, at least -1.',
     -1, 9223372036854775807, ()),
)
QUALITY_MEASURES = (
    ("NumberOfTriangles", 0,
     'Triangles of the mesh, in the last run. Counts are 0 if the run was aborted or failed; they are field data '
     'of the mesh, too.'),
    ("NumberOfAddedPoints", 0,
     'Points added by the refinement, in the last run: the last ones of the mesh.'),
    ("NumberOfPointsAddedToSegments", 0,
     'Those of the added points that divide segments, in the last run.'),
    ("NumberOfBadTriangles", 0,
     'Triangles that are not as wished, in the last run; BadReason says why.'),
    ("NumberOfEncroachedPieces", 0,
     'Pieces of segments that could not be split though a point lies close to them, in the last run.'),
    ("LeastAngle", 0.0,
     'The least angle of all triangles in degrees, in the plane of the triangulation, in the last run.'),
    ("MemoryEstimate", 0,
     'The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its input, or was '
     'refused: the number that is compared with Memory Limit.'),
)
QUALITY_TEXTS = {
    "Measures": (
     'What the last run found, as a text with a line for each number. Numbers that are 0 are left out, but for '
     'the first. Empty before a run.', (
         ("triangles", "NumberOfTriangles"),
         ("points added", "NumberOfAddedPoints"),
         ("of these on segments", "NumberOfPointsAddedToSegments"),
         ("triangles not as wished", "NumberOfBadTriangles"),
         ("pieces of segments not split", "NumberOfEncroachedPieces"),
         ("degrees in the least angle", "LeastAngle"),
     )),
    "Resources": (
     'What the last run took, as a text with a line for each number. Numbers that are 0 are left out, but for '
     'the first. Empty before a run.', (
         ("KiB of memory at most", "MemoryEstimate"),
     )),
}
QUALITY_COUNTS = (
    "NumberOfTriangles",
    "NumberOfAddedPoints",
    "NumberOfPointsAddedToSegments",
    "NumberOfBadTriangles",
    "NumberOfEncroachedPieces",
)

POINTS = (
    ("Distribution", "enum", 0,
     'The distribution of the points. Uniform: in the unit square. Line, Cross, Circle, Spiral: in bands about '
     'these curves, with a standard deviation of 0.01. Mixed: half of them uniform, half in 20 clusters. '
     'Lattice: at integer coordinates, row by row. Default: UNIFORM.',
     0, 6, ('Uniform', 'Line', 'Cross', 'Circle', 'Spiral', 'Mixed', 'Lattice')),
    ("NumberOfPoints", "int64", 10000,
     'The number of points, at most 2^29. Each takes 28 bytes of memory, 16 in single precision; a number that '
     'does not fit is refused with an error. A square number fills the square of the Lattice. From 0 to '
     '536870912. Default 10000.',
     0, 536870912, ()),
    ("Seed", "int", 1,
     'The seed of the random numbers: any integer, each gives other points. Not used by Lattice. Default 1.',
     None, None, ()),
    ("HillHeight", "double", 0.0,
     'The height of the hills, z, as a part of the width of the set, which is 1, or the side of the Lattice. 0: '
     'all points in the plane z = 0. From 0 to 1000. Default 0.1 in ParaView, 0 in VTK.',
     0.0, 1000.0, ()),
    ("Scale", "double", 1.0,
     "The factor of all coordinates: 1000 makes hills of a kilometre's width. From 1e-09 to 1000000000. Default "
     '1.',
     1e-09, 1000000000.0, ()),
    ("OutputPointsPrecision", "int", 1,
     'The type of the coordinates. Single takes less memory, but rounds: of many millions of points a few then '
     'coincide. Default: Double.',
     0, 2, ()),
)

OUTLINE = (
    ("GroupArrayName", "text", '',
     'The cell array by which polygons are told apart, with one number for each cell; a cell with NaN is left '
     'out. Empty or "None": all cells are alike. Default "".',
     None, None, ()),
    ("MemoryLimit", "int64", 0,
     'The most memory the filter may use beyond its input, in kibibytes (1024 bytes). More is refused with an '
     'error. 0: the memory that the machine has left. Default 0, at least 0.',
     0, 9223372036854775807, ()),
)
