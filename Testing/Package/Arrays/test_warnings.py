# SPDX-License-Identifier: BSD-3-Clause
"""Every warning of `delaunay`, word for word as Warnings.json has it, from counts as a run may leave them.
AHD_WRITE_HASHES=1 writes the file anew, to be read and committed with the change.
"""

import collections
import json
import os
import pathlib
import unittest
import warnings

from adaptivehilbertdelaunay import DelaunayWarning, _warnings

FILE = pathlib.Path(__file__).with_name("Warnings.json")
USUAL = {"points": 40, "inserted": 30, "delaunay_triangles": 50, "kept_triangles": 50, "cells": 50, "source_points": 9,
         "segments": 12}  # fmt: skip
NONE = {"delaunay_triangles": 0, "kept_triangles": 0, "cells": 0}
# By name: counts, the trimmed area, are crossings split?
CASES = {
    "nothing to say": ({}, 0.0, False),
    "not finite": ({"not_finite": 3, "first_not_finite": 7}, 0.0, False),
    "not finite in a plane": ({"not_finite": 3, "first_not_finite": 7, "is_projected": 1}, 0.0, False),
    "odd z": ({"odd_z": 2}, 0.0, False),
    "stacked": ({"stacked": 1, "duplicates": 21}, 0.0, False),
    "no triangle yet": ({**NONE, "inserted": 2, "beyond_limit": 38}, 0.0, False),
    "few": ({**NONE, "inserted": 2}, 0.0, False),
    "none at all": ({**NONE, "inserted": 0, "not_finite": 40}, 0.0, False),
    "no points": ({**NONE, "inserted": 0, "points": 0}, 0.0, False),
    "merged": ({**NONE, "inserted": 2, "merged_points": 38}, 0.0, False),
    "three on a line": ({**NONE, "inserted": 3, "on_one_line": 1}, 0.0, False),
    "collinear in the plane alone": ({**NONE, "inserted": 30}, 0.0, False),
    "collinear in a plane that was asked for": ({**NONE, "inserted": 30, "is_projected": 1}, 0.0, False),
    "loops keep none": ({"kept_triangles": 0, "cells": 0}, 0.0, False),
    "limits leave none": ({"cells": 0}, 0.0, False),
    "trimmed little": ({"trimmed_triangles": 8, "kept_triangles": 42}, 0.1, False),
    "trimmed much": ({"trimmed_triangles": 8, "kept_triangles": 42}, 0.11, False),
    "trimmed all": ({"trimmed_triangles": 50, "kept_triangles": 0, "cells": 0, "bare_vertices": 30}, 1.5, False),
    "bare": ({"trimmed_triangles": 8, "kept_triangles": 42, "bare_vertices": 1}, 0.0, False),
    "off the surface": ({"points_off_surface": 4}, 0.0, False),
    "crossing": ({"segments_crossing": 2, "first_crossing_cell": 5, "first_crossed_cell": 1}, 0.0, False),
    "crossing pieces": ({"segments_crossing": 2, "unfilled_loops": 1}, 0.0, True),
    "one bends": ({"bent_segments": 1, "first_bent_cell": 6}, 0.0, True),
    "some bend": ({"bent_segments": 3, "first_bent_cell": 6}, 0.0, True),
    "nothing is constrained": ({"segments": 0}, 0.0, False),
    "without vertex": ({"segments_without_vertex": 2, "unfilled_loops": 3}, 0.0, False),
    "both": ({"segments_crossing": 2, "segments_without_vertex": 2, "unfilled_loops": 3}, 0.0, False),
    "without vertex and triangle": ({**NONE, "inserted": 2, "segments_without_vertex": 2}, 0.0, False),
}  # fmt: skip


def said(counts, area, split):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        _warnings.warn(collections.Counter({**USUAL, **counts}), area, split)
    assert all(one.category is DelaunayWarning and one.filename == __file__ for one in caught)
    return [str(one.message) for one in caught]


class WarningsTest(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.found = {name: said(*case) for name, case in CASES.items()}
        if os.environ.get("AHD_WRITE_HASHES") == "1":
            FILE.write_text(json.dumps(cls.found, indent=1) + "\n", encoding="utf-8")

    def test_they_are_those(self):
        self.assertEqual(self.found, json.loads(FILE.read_text(encoding="utf-8")))


if __name__ == "__main__":
    unittest.main()
