# SPDX-License-Identifier: BSD-3-Clause
# Made by Filters/Settings/generate.py: change what is there, not this.
"""The keywords of `delaunay` that are one number or word each."""

import math
from typing import Any, NamedTuple, Tuple


class Keyword(NamedTuple):
    """The job's setting, and what it may be: True or False, where neither words nor numbers are said."""

    setting: str
    default: Any
    words: Tuple[str, ...] = ()  # in the order of the header's numbers
    least: Any = None
    most: Any = None


KEYWORDS = {
    "insertion_order": Keyword("insertion_order",
        "adaptive_hilbert", words=("adaptive_hilbert", "multi_grid", "regular_grid", "as_given")),
    "nmax": Keyword("nmax", 50, least=1, most=2147483647),
    "control_points": Keyword("control_points", "every_level", words=("off", "single_level", "every_level")),
    "gene_rotation": Keyword("gene_rotation", True),
    "count_work": Keyword("count_work", False),
    "insertion_limit": Keyword("insertion_limit", 0, least=0, most=9223372036854775807),
    "duplicates": Keyword("duplicates", "first", words=("first", "lowest_z", "highest_z", "mean_z")),
    "closed_lines_are_loops": Keyword("closed_lines", False),
    "crossings": Keyword("split_crossings", "leave_out", words=("leave_out", "split")),
    "source_heights": Keyword("source_heights", "own", words=("own", "surface")),
    "fill_rule": Keyword("fill_rule", "even_odd", words=("orientation", "even_odd")),
    "rim": Keyword("rim", "automatic", words=("automatic", "convex_hull", "trimmed")),
    "bounding": Keyword("bounding", False),
    "voronoi_clip": Keyword("voronoi_clip", "hull", words=("hull", "bounds")),
    "threads": Keyword("threads", 0, least=0, most=1024),
    "memory_limit": Keyword("memory_limit", 0, least=0, most=4611686018427387904),
    "tolerance": Keyword("tolerance", 0.0, least=0.0, most=1.0),
    "offset": Keyword("offset", 1.0, least=0.75, most=1.7e+308),
    "alpha": Keyword("alpha", 0.0, least=0.0, most=math.inf),
    "maximum_edge_length": Keyword("maximum_edge_length", 0.0, least=0.0, most=math.inf),
}
