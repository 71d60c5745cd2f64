# SPDX-License-Identifier: BSD-3-Clause
# Made by Filters/Settings/generate.py: change what is there, not this.
"""The settings and measures of the classes as rows. Of a setting: name, kind, default, what it does, least and most of
what values are clamped to, and, of an enum, what follows SetXTo for 0, 1, ... Kinds: bool, flag (a vtkTypeBool: any
int), enum, int, int64, double, text."""

import math

DELAUNAY = (
    ("MergeBlocks", "bool", False,
     'Triangulate the points of all blocks of a multiblock data set together, into one surface without seams: '
     'lidar tiles, for instance. Point arrays that all blocks have are passed on. Without it each block becomes '
     'a surface by itself. Off by default. The points are numbered block after block. Costs a copy of the points '
     'and their data.',
     None, None, ()),
    ("SourceMode", "enum", 0,
     'How the source says where its lines run. Coordinates: by its own points, which are added to the surface (a '
     'point that is there already, at the same x and y, is not added twice). Point ids: its points stand for the '
     "points of the input with the same ids, and their coordinates are not looked at, as in VTK's vtkDelaunay2D. "
     'Default: SOURCE_COORDINATES in ParaView, SOURCE_IDS in VTK. Points of the source are added behind those of '
     'the input.',
     0, 1, ('Ids', 'Coordinates')),
    ("SourceHeights", "enum", 0,
     'Which heights the points of the source have. Own: their own z. A line of two dimensions, as from most '
     'maps, lies at z = 0 and pulls the surface down to it. From Surface: the height, and all point data, of the '
     'surface of the input where they lie, by linear interpolation; outside of it they keep their own z, and a '
     'warning counts them. Not used with Source Mode Point ids. Default: OWN. From Surface triangulates the '
     'input twice: first alone.',
     0, 1, ('Own', 'FromSurface')),
    ("ClosedLines", "enum", 0,
     'What lines of the source are that end where they begin. Lines: edges of the surface, as other lines are; '
     'right for contours. Loops: outlines that bound the surface, as polygons do; right for coastlines, lakes '
     'and borders from GeoJSON, shapefiles and .csv, which come as lines. Default: LINES. A line is closed if '
     'its ends are one point, or have the same x and y in the plane of the triangulation. In the order of the '
     'constraints, loops come after the other lines.',
     0, 1, ('Lines', 'Loops')),
    ("FillRule", "enum", 0,
     'Which side of the outlines (polygons and loops of the source) is kept. Even-odd: what lies inside an odd '
     'number of outlines, whichever way they run. Orientation, as in vtkDelaunay2D: the left side of each, so '
     'counterclockwise outlines are filled, clockwise ones are holes, and they may be nested; outlines of '
     'shapefiles run the other way. Default: EVEN_ODD in ParaView, ORIENTATION in VTK. With Orientation, what no '
     'loop bounds is kept, too. Without loops all is.',
     0, 1, ('Orientation', 'EvenOdd')),
    ("CrossingMode", "enum", 0,
     'What to do where two lines of the source cross each other between their points. Leave out: the later one '
     'of the two segments is left out and counted (Number Of Crossings), and an outline that lacks a segment '
     'bounds nothing. Split: a point is added where they cross, its height and data taken from both lines, and '
     'no segment is left out. Default: LEAVE_OUT. Lines come before polygons; then the order of the cells '
     'counts. The height and data of an added point are the mean of what linear interpolation along either '
     'segment gives.',
     0, 1, ('LeaveOut', 'Split')),
    ("MaximumEdgeLength", "double", 0.0,
     'Leave out every triangle that has an edge longer than this, measured in the plane of the triangulation, in '
     'the units of the points. It gives a survey its concave outline instead of the convex hull. 0: none is left '
     'out. Default 0, at least 0. Lines of Alpha that are longer are left out, too.',
     0.0, 1e+299, ()),
    ("Alpha", "double", 0.0,
     'The alpha shape, as in Delaunay 2D: triangles whose circle through the corners has a radius of at most '
     'Alpha, edges of at most 2 Alpha that are in none of these triangles as lines, and points that are in '
     'neither as vertices. Radius and length are those in space, z included. 0: off, all triangles. Default 0, '
     'at least 0. Where it differs from vtkDelaunay2D: Reference.md.',
     0.0, 1e+299, ()),
    ("AlphaTris", "flag", 1,
     'Put out the triangles of the alpha shape. On by default.',
     None, None, ()),
    ("AlphaLines", "flag", 1,
     'Put out, as lines, the edges of the alpha shape that are in none of its triangles. On by default.',
     None, None, ()),
    ("AlphaVerts", "flag", 1,
     'Put out, as vertices, the points of the alpha shape that are in none of its triangles and lines. On by '
     'default.',
     None, None, ()),
    ("ProjectionPlaneMode", "enum", 0,
     'The plane in which the points are triangulated. XY plane: z is the height. Transform plane: x and y after '
     'the Transform. Best-fitting plane: the plane from which the points are least far, for a rock face or a '
     'scanned wall. The points of the surface stay where they are. Default: VTK_DELAUNAY_XY_PLANE. After a '
     'transform or in a fitted plane, exactness is for the coordinates there, rounded to double precision, and '
     'duplicates are judged there. In the x, y plane a Transform counts if one is set; in the transform plane a '
     'warning says that none is. For the best-fitting plane see ComputeBestFittingPlane; Transform is not used.',
     0, 2, ()),
    ("Rim", "enum", 0,
     'How far the surface reaches where no outline bounds it. Convex hull: all triangles. Trimmed: without the '
     'flat ones along the rim, those with an angle above 153 degrees whose longest edge lies there; in a fitted '
     'plane these stand as walls along a rim that is straight in space. Automatic: the convex hull in the XY '
     'plane, and in the best-fitting plane of points that all have the same z, x or y; else trimmed. No effect '
     'with Alpha, Maximum Edge Length or Bounding Triangulation. Number Of Trimmed Triangles counts what went. '
     'Default: AUTOMATIC. The angle is exactly 180 degrees less the arc tangent of 1/2; of what lies behind, '
     'triangles go likewise. Constraints stay edges. A warning where a point is left without a triangle, or a '
     'tenth of the area goes.',
     0, 2, ('Automatic', 'ConvexHull', 'Trimmed')),
    ("Tolerance", "double", 0.0,
     "Merge points that are closer to each other than this fraction of the diagonal of the points' bounding box, "
     'in the plane of the triangulation. 0: only points with the very same x and y are merged. Number Of Merged '
     'Points counts what more was merged; Generate Point Status says into which point. From 0 to 1. Default 0. '
     'Points are taken in lexicographic order of x, y; one that has vertices within that distance is merged into '
     "the nearest. Constraints follow. vtkDelaunay2D's default is 1e-5, of the diagonal in space.",
     0.0, 1.0, ()),
    ("DuplicatePolicy", "enum", 0,
     'Which of the points with the same x and y becomes the vertex, and so shows its height. First: the one with '
     'the smallest id. Lowest z, highest z: the deepest or the shoalest sounding, for instance. Mean z: the '
     'first, with the mean of the heights. Default: FIRST. Heights that are finite come first; the mean is that '
     'of all that are finite, in a copy of the points. Merged points have no say. Changes ids and z, never the '
     'shape in the plane.',
     0, 3, ('First', 'LowestZ', 'HighestZ', 'MeanZ')),
    ("GeneratePointStatus", "bool", False,
     'Add a point array, Fate, with the status of each point: its own id if it is a vertex of the surface; the '
     'id of another point if it is a duplicate of it or was merged into it; -1 if its x or y is not a finite '
     'number; -2 if it was not inserted, because it is marked as a ghost or hidden, lies beyond the Insertion '
     'Limit, or is a duplicate of a point that does. Switch it on to find the points that are not in the '
     'surface. Off by default. The array is a vtkIdTypeArray.',
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
     'Fill the third output, Voronoi: for each vertex a polygon, the places that are nearer to it than to any '
     'other vertex. The polygons have the point data of their vertices as cell data, and lie at z = 0. ParaView '
     'does not show them at once, as they may cover the surface: click the eye of the output Voronoi. Off by '
     'default. Output port 2: convex counterclockwise polygons, with the vertex\'s id as "OriginalPointIds" '
     '(vtkIdTypeArray). Corners are those of the exact polygons, rounded once to double precision; those that '
     'differ by no more than 4 units in the last place may be one. Constraints have no say.',
     None, None, ()),
    ("VoronoiClip", "enum", 0,
     'Where the Voronoi diagram ends, as its outer polygons are unbounded. Hull: at the convex hull of the '
     'points. Bounds: at their bounding box. Default: CLIP_TO_HULL. Both are those of the vertices, in the plane '
     'of the triangulation.',
     0, 1, ('Hull', 'Bounds')),
    ("InsertionOrder", "enum", 0,
     'In which order the points are inserted. It changes the time, never the triangles. Adaptive Hilbert (HG), '
     'the fastest: boxes that are divided where points are crowded, visited along a Hilbert curve. Multi-grid '
     '(MG): the same boxes, visited line by line. Regular grid (RG): boxes of one size, visited line by line. As '
     'given: the order of the input; very slow where the points come at random. Change it to compare. Default: '
     'ADAPTIVE_HILBERT.',
     0, 3, ('AdaptiveHilbert', 'MultiGrid', 'RegularGrid', 'AsGiven')),
    ("Nmax", "int", 50,
     'A box with more points than this is divided. Su et al. find 50 to 200 good. Smaller boxes follow crowded '
     'points more closely and take longer to sort. It changes the time, never the triangles. It has an effect '
     'with the Insertion Order Multi-grid, and with Adaptive Hilbert if Control Points is Off or First level, '
     'Gene Rotation is off, or Generate Boxes is on, which shows the boxes; else it has none, as the curve goes '
     'on inside the boxes to the single point, and ParaView greys it. Default 50, at least 1.',
     1, 2147483647, ()),
    ("ControlPoints", "enum", 2,
     'A sparse selection of the points, inserted before all others so that long thin triangles are not built '
     'first and removed later. It changes the time, never the triangles. Off: none. First level: one point of '
     'each box of the first division, as Su et al. do. Every level: a sparse selection of the points, of that '
     'selection another, and so on, from coarse to fine. Used by Adaptive Hilbert and Multi-grid. Change it to '
     'compare. Default: EVERY_LEVEL.',
     0, 2, ('None', 'SingleLevel', 'EveryLevel')),
    ("GeneRotation", "bool", True,
     'Turn the Hilbert curve in each divided box so that it enters and leaves where its neighbours on the curve '
     'expect it (the paper\'s "gene"). Switched off, the curve jumps between boxes, and after each jump the next '
     'point is searched from farther away. It changes the time, never the triangles. Used by Adaptive Hilbert. '
     'Change it to compare. On by default.',
     None, None, ()),
    ("InsertionLimit", "int64", 0,
     'Stop after so many points: the surface is the triangulation of these, as it was when the last of them was '
     'inserted. 0, and numbers that are large enough: all points. Which points come first depends on the '
     'settings of the insertion. In ParaView move the slider, or animate it, to see the surface grow: both go '
     'from 3, the first that may give a triangle, to the number of points; for all points type 0. Default 0, at '
     'least 0. Distinct points count. The others are in no triangle and counted by NumberOfPointsBeyondLimit. '
     'With a limit, one thread inserts.',
     0, 9223372036854775807, ()),
    ("GenerateInsertionRank", "bool", False,
     'Add a point array, InsertionRank: the place of each point in the order of insertion, from 0; -1 for '
     'duplicates, rejected and skipped points. Colour by it to see the order. Off by default. The array is a '
     'vtkIdTypeArray; the order is that of one thread.',
     None, None, ()),
    ("GenerateInsertionCurve", "bool", False,
     'Put a line through the inserted points, in the order of their insertion, into the second output, Insertion '
     "order. Its point array InsertionRank counts along the line; OriginalPointIds has the points' ids in the "
     'input. Off by default. Output port 1.',
     None, None, ()),
    ("GenerateBoxes", "bool", False,
     'Put the boxes of the grid that decides the order into the second output, Insertion order: those that are '
     'not divided further, in the order in which they are visited, at the height of the lowest point. Their cell '
     'arrays: Level, the number of divisions that made the box; Count, the points in it. The order As given has '
     'no boxes. Off by default. Output port 1; about 300 bytes a box.',
     None, None, ()),
    ("Offset", "double", 1.0,
     'As in Delaunay 2D: how far away the eight points of Bounding Triangulation lie. It changes nothing else. '
     'Default 1, at least 0.75. In diagonals, in space, of the bounding box.',
     0.75, 1e+299, ()),
    ("BoundingTriangulation", "flag", 0,
     'As in Delaunay 2D: add eight points on a circle around all others, and the triangles that join them. Only '
     'where the points are triangulated in x and y. Off by default. The circle is about the centre of the '
     'bounding box. In other planes a warning.',
     None, None, ()),
    ("RandomPointInsertion", "flag", 0,
     'Does nothing: there for scripts written for vtkDelaunay2D. The order of insertion is set by Insertion '
     'Order and never changes the triangles. Off by default.',
     None, None, ()),
    ("UseHilbertSorter", "flag", 0,
     'Does nothing: there for scripts written for vtkDelaunay2D. Points are inserted along a Hilbert curve '
     'anyway, unless Insertion Order says otherwise. Off by default.',
     None, None, ()),
    ("NumberOfThreads", "int", 0,
     'How many processors the filter works on. It changes the time, never the triangles. 0: all that the program '
     '(ParaView; with a server, the server) may use, unless VTK was told to use fewer, for example by the '
     'environment variable VTK_SMP_MAX_THREADS. 1 to 1024: exactly so many. Set it where others need the '
     'processors too. With Count Work, an Insertion Limit, another Insertion Order than Adaptive Hilbert, or '
     'other insertion settings than the defaults, the points are inserted by one; so are few points. From 0 to '
     '1024. Default 0. The calling thread is one of them; it alone reports progress and is asked for an abort. 0 '
     'heeds vtkSMPTools::Initialize(n), too.',
     0, 1024, ()),
    ("DistributePoints", "bool", False,
     'On a server with several ranks: triangulate the points of all ranks together, into one surface without '
     'seams, exactly the triangles that one rank would give. The points move to the rank that owns their place, '
     'with the point arrays that all ranks have; filters behind get the ghost cells that they ask for. Off: each '
     'rank triangulates its own points. For some settings one rank does it all, which a warning says once. All '
     'ranks have to update the filter: a script of pvbatch --sym that does so on one alone waits for ever. No '
     "effect with one rank, nor in Python's class and plugin, where each rank works on its own. On by default in "
     'ParaView, off in VTK. Off, there is a warning where there are several ranks. The ranks are those of '
     'Controller. The triangles are those of one rank that has all inputs and sources, appended in the order of '
     'the ranks. All ranks have to update alike, with the same settings: where one has to execute, all do. Each '
     'puts out the triangles that it owns, by place; with its points; and behind these the points of others that '
     'are corners, with vtkGhostType DUPLICATEPOINT. Layers of ghost cells are marked as well. The global ids '
     '"GlobalPointIds" number the points as appended, those of sources last; "GlobalCellIds" the triangles. '
     "Counts are of all ranks. Ids in the source's cells are those of the rank's own points. Sources that are "
     'the same on all ranks count once where their points are added. What fails on one rank ends in one error on '
     'each. Settings that ranks have no method for have one rank triangulate all points and put out everything, '
     'if there is room on it; a warning names the first: Reference.md lists them. With MergeBlocks off, block k '
     'of all ranks is triangulated by itself, for each k.',
     None, None, ()),
    ("KeepTriangulation", "bool", True,
     'Triangulate again only what is new: where points, source and settings are those of the last two runs, as '
     'in time steps of which only the arrays change, the triangles are passed on from the third on, with the '
     'arrays of now. Switch it off to triangulate at each run. On by default. Coordinates, ghost marks, source '
     'and settings are compared; point data and field data are those of now.',
     None, None, ()),
    ("MemoryLimit", "int64", 0,
     'The most memory the filter may take beyond its input, in kibibytes (1024 bytes). What is estimated to need '
     'more is refused with an error before anything is computed. 0: what the machine has left. Set it where '
     "others need the machine's memory too. Default 0, at least 0. The output is included. 0 heeds the limits of "
     'the process, too. With GenerateBoxes the error comes before anything is inserted.',
     0, 9223372036854775807, ()),
    ("ReuseLimit", "int64", 262144,
     'The most memory, in kibibytes (1024 bytes), that the filter keeps for its next run, which is then faster: '
     'its working memory, and that of former outputs. What takes more is given back after each run. The default, '
     '256 MiB, is enough for 2 million points. 0 keeps nothing. Raise it where larger data change in time, lower '
     'it where many such filters are in one pipeline. Default 262144, at least 0. Working memory comes first: '
     'what took more, failed or was aborted gives all back. Within it a triangulation stays whole until the next '
     'execution, for filters that interpolate on its surface. What is left of it keeps the memory of outputs '
     'that nobody has any more.',
     0, 9223372036854775807, ()),
    ("CountWork", "bool", False,
     'Count the triangles tested to find where each point goes (NP) and the triangles removed to make room for '
     'it (NR). Switch it on to compare insertion orders by their work, which is the same on every machine, '
     'rather than by seconds. Counting takes time, and one thread inserts; it never changes the triangles. Off '
     'by default.',
     None, None, ()),
)
DELAUNAY_CONSTANTS = {
    "SOURCE_IDS": 0,
    "SOURCE_COORDINATES": 1,
    "OWN": 0,
    "FROM_SURFACE": 1,
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
    ("NumberOfThreadsUsed", 0,
     'Threads that shared the work of the last run; 1 if there was too little to share.'),
    ("NumberOfTriangulations", 0,
     'How often this filter has triangulated since it was made; runs that passed on the triangles of the one '
     'before do not count.'),
    ("MemoryEstimate", 0,
     'The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its input, or was '
     'refused: what Memory Limit is compared with. If there were too many crossings: what one more than fits '
     'would need.'),
    ("NumberOfTriangles", 0,
     'Triangles of the surface, in the last run.'),
    ("NumberOfPointsInserted", 0,
     'Points that are vertices of the surface, in the last run. Counts are 0 if the run was aborted or ended in '
     'an error; else those of points add up to all points, added ones included.'),
    ("NumberOfDuplicates", 0,
     'Points with the same x and y as an earlier point, in the last run. They are not in the surface.'),
    ("NumberOfMergedPoints", 0,
     'Points that were merged into another by the Tolerance, in the last run. Points with the very same x and y '
     'are counted as duplicates.'),
    ("NumberOfAddedPoints", 0,
     'Points of the surface that are not in the input, in the last run: points of the source, where lines cross, '
     'and those of Bounding Triangulation.'),
    ("NumberOfRejectedPoints", 0,
     'Points whose x or y is NaN or infinite, in the last run. They are not in the surface.'),
    ("NumberOfSkippedPoints", 0,
     'Points left out because they are marked as ghosts or hidden, in the last run.'),
    ("NumberOfPointsBeyondLimit", 0,
     'Points that are not in the surface because of the Insertion Limit, in the last run.'),
    ("NumberOfConstraintEdges", 0,
     'Edges of the triangulation that are edges of the source, in the last run. Those of triangles that were '
     'dropped are included.'),
    ("NumberOfCrossings", 0,
     'Segments of the source that were left out as they cross an earlier one, in the last run; with the crossing '
     'mode Split, the points added where segments cross. The field data array Crossings says which lines.'),
    ("NumberOfBentConstraints", 0,
     'With the crossing mode Split: segments of the source that were led, in the last run, through a point that '
     'lies beside them by less than rounding tells apart.'),
    ("NumberOfConstraintsLeftOut", 0,
     'Segments of the source that are no edges of the triangulation, in the last run: they cross another, or '
     'have an end that is no vertex.'),
    ("NumberOfUnfilledLoops", 0,
     'Outlines that bound nothing, as one of their segments was left out, in the last run.'),
    ("NumberOfTrimmedTriangles", 0,
     'Flat triangles that Rim took away, in the last run.'),
    ("NP", -1.0,
     'Triangles tested to find where a point goes, per inserted point, in the last run. The time of finding is '
     'proportional to it. -1 if it was not counted: switch Count Work on. The triangle that the search starts '
     'from is included.'),
    ("NR", -1.0,
     'Triangles removed to make room for a point, per inserted point, in the last run. The time of updating is '
     'proportional to it. -1 if it was not counted: switch Count Work on.'),
    ("SortSeconds", 0.0,
     'Wall-clock seconds of reading the points and sorting them into the order of insertion, in the last run. '
     'Seconds are 0 if triangles were passed on.'),
    ("InsertSeconds", 0.0,
     'Wall-clock seconds of inserting the points, in the last run.'),
    ("ConstrainSeconds", 0.0,
     'Wall-clock seconds of making the lines of the source edges, in the last run.'),
    ("OutputSeconds", 0.0,
     'Wall-clock seconds of putting the triangles out in their canonical order, in the last run.'),
)
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
    "NumberOfConstraintEdges",
    "NumberOfCrossings",
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
    "MaximumEdgeLength",
)
# Measures, and the counts and measures of the job that each is the sum of.
OF_JOB = {
    "NumberOfThreadsUsed": ('threads_used',),
    "NumberOfTriangles": ('triangles',),
    "NumberOfPointsInserted": ('inserted',),
    "NumberOfDuplicates": ('duplicates',),
    "NumberOfMergedPoints": ('merged_points',),
    "NumberOfAddedPoints": ('added_points',),
    "NumberOfRejectedPoints": ('not_finite',),
    "NumberOfSkippedPoints": ('skipped',),
    "NumberOfPointsBeyondLimit": ('beyond_limit',),
    "NumberOfConstraintEdges": ('constraint_edges',),
    "NumberOfBentConstraints": ('bent_segments',),
    "NumberOfConstraintsLeftOut": ('segments_without_vertex', 'segments_crossing'),
    "NumberOfUnfilledLoops": ('unfilled_loops',),
    "NumberOfTrimmedTriangles": ('trimmed_triangles',),
    "NP": ('np',),
    "NR": ('nr',),
    "SortSeconds": ('seconds_merge', 'seconds_read', 'seconds_sort'),
    "InsertSeconds": ('seconds_insert',),
    "ConstrainSeconds": ('seconds_split', 'seconds_constrain'),
    "OutputSeconds": ('seconds_extract', 'seconds_outputs'),
}
# Old names, and those of now.
OLD_NAMES = {
    "GenerateFate": "GeneratePointStatus",
}
# A job's setting and the one of the class that it is.
SAME = {
    "cell_ids": "SourceMode",
    "closed_lines": "ClosedLines",
    "fill_rule": "FillRule",
    "split_crossings": "CrossingMode",
    "maximum_edge_length": "MaximumEdgeLength",
    "alpha": "Alpha",
    "rim": "Rim",
    "tolerance": "Tolerance",
    "duplicates": "DuplicatePolicy",
    "want_point_status": "GeneratePointStatus",
    "want_constraint_edges": "GenerateConstraintEdges",
    "want_regions": "GenerateRegionIds",
    "want_neighbors": "GenerateNeighbors",
    "want_voronoi": "GenerateVoronoi",
    "voronoi_clip": "VoronoiClip",
    "insertion_order": "InsertionOrder",
    "nmax": "Nmax",
    "control_points": "ControlPoints",
    "gene_rotation": "GeneRotation",
    "insertion_limit": "InsertionLimit",
    "want_insertion_ranks": "GenerateInsertionRank",
    "want_curve": "GenerateInsertionCurve",
    "want_boxes": "GenerateBoxes",
    "offset": "Offset",
    "count_work": "CountWork",
}

# Arrays of the surface that a setting adds: the setting, the job's array, name, type, components, of which data.
ARRAYS = (
    ("GeneratePointStatus", "point_status", "Fate", "vtkIdTypeArray", 1, "PointData"),
    ("GenerateInsertionRank", "insertion_ranks", "InsertionRank", "vtkIdTypeArray", 1, "PointData"),
    ("GenerateConstraintEdges", "constraint_edges", "ConstraintEdges", "vtkUnsignedCharArray", 1, "CellData"),
    ("GenerateRegionIds", "regions", "RegionId", "vtkIdTypeArray", 1, "CellData"),
    ("GenerateNeighbors", "neighbors", "Neighbors", "vtkIdTypeArray", 3, "CellData"),
)
# Their settings by the names that callers from PyVista use.
ARRAY_KEYWORDS = {
    "status": "GeneratePointStatus",
    "rank": "GenerateInsertionRank",
    "constraint_edges": "GenerateConstraintEdges",
    "regions": "GenerateRegionIds",
    "neighbors": "GenerateNeighbors",
}

INTERPOLATION = (
    ("Method", "enum", 0,
     'How values come about between the points. Linear: linear in each triangle; the fastest. Natural Neighbor: '
     'of the points around, by the area that the place would take from their Voronoi cells (Sibson); smooth '
     'everywhere but at the points, and for scattered points the best to look at. Laplace: of the same points, '
     'by the lengths of the borders; alike, a little faster. Nearest: the value of the nearest point, its type '
     'kept. Default: LINEAR. Natural Neighbor and Laplace end at constraints, as at the rim. Nearest is there on '
     'the whole plane; of several vertices that are as near, the one of smallest x, then y, counts. Collinear '
     'points: linear between neighbours on their line.',
     0, 3, ('Linear', 'NaturalNeighbor', 'Laplace', 'Nearest')),
    ("RasterSize", "enum", 0,
     'How the number of cells of the raster is given. Dimensions: by their number along x and y. Cell Size: by '
     'the width and height of one cell. Default: BY_DIMENSIONS.',
     0, 1, ('ByDimensions', 'ByCellSize')),
    ("Dimensions", "int", (256, 256),
     'The number of cells along x and y; they fill the area of the raster. Default 256, 256, at least 1.',
     1, 2147483647, ()),
    ("CellSize", "double", (1.0, 1.0),
     'The width and height of a cell, in the units of the points: more than 0. Metres for projected points, '
     'degrees where x and y are longitude and latitude. The raster begins at the lower bound and covers all of '
     'the points; what asks for more memory than there is is refused with figures. Default 1, 1. Any but a '
     'positive finite size is an error of the execution. As many cells as cover the area, at least one. Whether '
     'the last one is needed is judged by the numbers as they are written in decimal (15 digits): 100 cells of '
     '0.1 cover 0 to 10.',
     None, None, ()),
    ("AlignToCellSize", "bool", False,
     'Put the borders between cells at multiples of the cell size, so that rasters of neighbouring tiles and of '
     "different surveys lie cell on cell (as -tap of GDAL). Off by default. Used with BY_CELL_SIZE. The area's "
     'lower bounds are rounded down, the upper ones up.',
     None, None, ()),
    ("UseBounds", "bool", False,
     'Give the raster an area of its own (Bounds) instead of the bounding box of the points: two surveys whose '
     'difference is wanted need the same. Off by default. Off: the bounding box of all points that are '
     'triangulated, in the plane of the triangulation; a side of length 0 makes one cell, as long as the other '
     "side's (or 1).",
     None, None, ()),
    ("Bounds", "double", (0.0, 1.0, 0.0, 1.0),
     'The area of the raster: least x, largest x, least y, largest y, to the outer borders of its cells. Default '
     '0, 1, 0, 1. Bounds that are not finite, or of which the lower is not below the upper, are an error of the '
     'execution.',
     None, None, ()),
    ("OutputType", "enum", 0,
     'What the raster becomes. Image: an image in the plane z = 0 with the heights as an array, small and fast, '
     'for GIS and for calculating. Surface: a grid of points at their heights, to be seen as terrain; points '
     'without a value are hidden. Default: IMAGE.',
     0, 1, ('Image', 'Surface')),
    ("Outside", "enum", 0,
     'What places outside the surface get. No Value: NaN in floating point arrays, 0 in others. Nearest Vertex: '
     'the values of the nearest point of the triangulation. Either way vtkValidPointMask is 0 there. Default: '
     'NO_VALUE. In place of NaN, what NoValue says. Counts of places outside are the same either way.',
     0, 1, ('NoValue', 'NearestVertex')),
    ("NoValue", "double", math.nan,
     'What arrays of floating-point numbers have where there is no value. Arrays of whole numbers (Nearest) have '
     '0 there. Default NaN.',
     None, None, ()),
    ("GenerateGradients", "bool", False,
     'For each array of one component add its gradient, an array of two components: the change per unit of x and '
     'of y (NameGradient). Slope and aspect of a terrain come from that of Elevation. With Linear only, constant '
     'in each triangle. Off by default. With other methods there is a warning. On an edge and at a vertex they '
     'are those of one of its triangles.',
     None, None, ()),
    ("HeightArrayName", "text", 'Elevation',
     'The name of the array of heights: z of the points or, in another plane, the height above it. Default '
     '"Elevation". The array is a vtkDoubleArray; an array of the input of that name is passed over, with a '
     'warning. Empty: no such array. The name of the mask, or "vtkGhostType", is an error of the execution.',
     None, None, ()),
    ("ValidPointMaskArrayName", "text", 'vtkValidPointMask',
     'The name of the array that says where there is a value: 1 on the surface, 0 elsewhere; by default as that '
     'of ParaView\'s own resampling filters. Default "vtkValidPointMask". The array is a vtkCharArray; with '
     'Nearest, 1 for all places with finite x and y. Empty: no mask. The name of the heights or of their '
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
}
INTERPOLATION_MEASURES = (
    ("NumberOfTriangulations", 0,
     'How often this filter has triangulated since it was made. Another method or cell size needs no new '
     'triangulation. A triangulation is kept where KeepTriangulation is on and ReuseLimit is large enough, for '
     'the next execution with the same points, constraints and Triangulation. It stays 0 on a surface whose own '
     'triangulation is there.'),
    ("MemoryEstimate", 0,
     'The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its input, or was '
     'refused: what Memory Limit is compared with. That is the MemoryLimit of Triangulation.'),
    ("NumberOfPlaces", 0,
     'Places, or cells of the raster, in the last run. They are those on the surface, those outside and those '
     'that are not finite. Counts are 0 if the run was aborted or ended in an error; they are field data of the '
     'output, too.'),
    ("NumberOfValidPlaces", 0,
     'Places that lie on the surface, in the last run: those where vtkValidPointMask is 1.'),
    ("NumberOfPlacesOutside", 0,
     'Places outside the surface, in the last run: beyond its hull, in a hole or in a triangle that was left '
     'out.'),
    ("NumberOfNotFinitePlaces", 0,
     'Places whose x or y is NaN or infinite, in the last run. They have no value.'),
    ("NumberOfPlacesWithoutValue", 0,
     'Values that are NaN, though their place is on the surface, as points around them have NaN, in the last '
     'run. A value is one for each component of an array at a valid place.'),
    ("NumberOfPlacesWithNeighborsLeftOut", 0,
     'With Natural Neighbor and Laplace: values that were made without some neighbours, as these have NaN, in '
     'the last run.'),
    ("SampleSeconds", 0.0,
     'Wall-clock seconds of finding the places and interpolating, in the last run; triangulating is not among '
     'them.'),
)
INTERPOLATION_COUNTS = (
    "NumberOfPlaces",
    "NumberOfValidPlaces",
    "NumberOfPlacesOutside",
    "NumberOfNotFinitePlaces",
    "NumberOfPlacesWithoutValue",
    "NumberOfPlacesWithNeighborsLeftOut",
)

POINTS = (
    ("Distribution", "enum", 0,
     'How the points are distributed. Uniform: in the unit square. Line, Cross, Circle, Spiral: in bands about '
     'such curves, with a standard deviation of 0.01. Mixed: half of them uniform, half in 20 clusters. Lattice: '
     'at whole coordinates, row by row. Default: UNIFORM.',
     0, 6, ('Uniform', 'Line', 'Cross', 'Circle', 'Spiral', 'Mixed', 'Lattice')),
    ("NumberOfPoints", "int64", 10000,
     'How many points to make, at most 2^29. Each takes 28 bytes of memory, 16 in single precision; what does '
     'not fit is refused with an error. A square number fills the square of the Lattice. From 0 to 536870912. '
     'Default 10000.',
     0, 536870912, ()),
    ("Seed", "int", 1,
     'Where the sequence of random numbers starts: any whole number, each gives other points. Not used by '
     'Lattice. Default 1.',
     None, None, ()),
    ("OutputPointsPrecision", "int", 1,
     'The type of the coordinates. Single takes less memory, but rounds: a few of many millions of points then '
     'coincide. Default: Double.',
     0, 2, ()),
)
