# SPDX-License-Identifier: BSD-3-Clause
# Made by Filters/Settings/generate.py: change what is there, not this.
"""The keywords that are one number or word each, and results."""

import math
from typing import Any, Literal, NamedTuple, Tuple, get_args


class Keyword(NamedTuple):
    """The setting, and what it may be: True or False, where neither words nor numbers are said."""

    setting: str
    default: Any
    words: Tuple[str, ...] = ()  # in the order of the setting's numbers
    least: Any = None
    most: Any = None


#: Of `delaunay`: settings of a job.
KEYWORDS = {
    "source_heights": Keyword("source_heights", "own", words=("own", "surface", "mixed")),
    "zero_is_missing": Keyword("zero_is_missing", False),
    "lines_on_surface": Keyword("lines_on_surface", True),
    "maximum_segment_length": Keyword("maximum_segment_length", 0.0, least=0.0, most=math.inf),
    "closed_lines_are_loops": Keyword("closed_lines", False),
    "points_as_line": Keyword("points_as_line", False),
    "fill_rule": Keyword("fill_rule", "even_odd", words=("orientation", "even_odd")),
    "crossings": Keyword("split_crossings", "leave_out", words=("leave_out", "split")),
    "maximum_edge_length": Keyword("maximum_edge_length", 0.0, least=0.0, most=math.inf),
    "alpha": Keyword("alpha", 0.0, least=0.0, most=math.inf),
    "maximum_error": Keyword("maximum_error", 0.0, least=0.0, most=1.7e+308),
    "maximum_vertices": Keyword("maximum_vertices", 0, least=0, most=9223372036854775807),
    "second_pass": Keyword("second_pass", False),
    "rim": Keyword("rim", "automatic", words=("automatic", "convex_hull", "trimmed")),
    "tolerance": Keyword("tolerance", 0.0, least=0.0, most=1.0),
    "duplicates": Keyword("duplicates", "first", words=("first", "lowest_z", "highest_z", "mean_z")),
    "voronoi_clip": Keyword("voronoi_clip", "hull", words=("hull", "bounds")),
    "insertion_order": Keyword("insertion_order",
        "adaptive_hilbert", words=("adaptive_hilbert", "multi_grid", "regular_grid", "as_given")),
    "nmax": Keyword("nmax", 50, least=1, most=2147483647),
    "control_points": Keyword("control_points", "every_level", words=("off", "single_level", "every_level")),
    "gene_rotation": Keyword("gene_rotation", True),
    "count_work": Keyword("count_work", False),
    "insertion_limit": Keyword("insertion_limit", 0, least=0, most=9223372036854775807),
    "offset": Keyword("offset", 1.0, least=0.75, most=1.7e+308),
    "bounding": Keyword("bounding", False),
    "threads": Keyword("threads", 0, least=0, most=1024),
    "memory_limit": Keyword("memory_limit", 0, least=0, most=4611686018427387904),
}
#: Of mesh.adaptive: settings of vtkAdaptiveHilbertDelaunay2D.
MESH_KEYWORDS = {
    "heights": Keyword("SourceHeights", "own", words=("own", "surface", "mixed")),
    "zero_is_missing": Keyword("ZeroIsMissing", False),
    "lines_on_surface": Keyword("SourceLinesOnSurface", True),
    "max_segment_length": Keyword("MaximumSegmentLength", 0.0, least=0.0, most=math.inf),
    "closed_lines": Keyword("ClosedLines", "loops", words=("lines", "loops")),
    "points_as_line": Keyword("PointsAsLine", False),
    "fill_rule": Keyword("FillRule", "even_odd", words=("orientation", "even_odd")),
    "crossings": Keyword("CrossingMode", "leave_out", words=("leave_out", "split")),
    "maximum_edge_length": Keyword("MaximumEdgeLength", 0.0, least=0.0, most=math.inf),
    "alpha": Keyword("Alpha", 0.0, least=0.0, most=math.inf),
    "maximum_error": Keyword("MaximumError", 0.0, least=0.0, most=1.7e+308),
    "maximum_vertices": Keyword("MaximumNumberOfVertices", 0, least=0, most=9223372036854775807),
    "second_pass": Keyword("SecondPass", False),
    "rim": Keyword("Rim", "automatic", words=("automatic", "convex_hull", "trimmed")),
    "tol": Keyword("Tolerance", 0.0, least=0.0, most=1.0),
    "duplicates": Keyword("DuplicatePolicy", "first", words=("first", "lowest_z", "highest_z", "mean_z")),
    "clip": Keyword("VoronoiClip", "hull", words=("hull", "bounds")),
    "offset": Keyword("Offset", 1.0, least=0.75, most=1.7e+308),
    "bound": Keyword("BoundingTriangulation", False),
    "threads": Keyword("NumberOfThreads", 0, least=0, most=1024),
    "memory_limit": Keyword("MemoryLimit", 0, least=0, most=4611686018427387904),
}
#: What `delaunay` can compute at once, attributes of its result.
Wanted = Literal[
    "point_status",
    "errors",
    "constraint_edges",
    "regions",
    "neighbors",
    "voronoi",
    "order",
    "boxes",
    "insertion_ranks",
]
WANTED: Tuple[str, ...] = get_args(Wanted)
#: The types of arrays of results that are no ids.
ARRAY_DTYPES = {
    "errors": "float64",
    "constraint_edges": "uint8",
}
