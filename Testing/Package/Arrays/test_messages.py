# SPDX-License-Identifier: BSD-3-Clause
"""The engine's catalogue of messages (Filters/Engine/Job/Catalogue.h), word for word as in Messages.json, in the words
of each door; none is left out. AHD_WRITE_HASHES=1 writes the file anew, to be read and committed with the change.
"""

import json
import os
import pathlib
import re
import unittest
import warnings

from adaptivehilbertdelaunay import DelaunayWarning, _interface as engine, delaunay
from adaptivehilbertdelaunay._input import DEFAULTS
import arraysupport

FILE = pathlib.Path(__file__).with_name("Messages.json")
ROOT = pathlib.Path(arraysupport.ROOT)
CATALOGUE = (ROOT / "Filters" / "Engine" / "Job" / "Catalogue.h").read_text(encoding="utf-8")
NAMES = re.findall(r'\{ Topic::\w+, "([^"]+)"', CATALOGUE)
WORDS = {"C": engine.WORDS_OF_C, "class": engine.WORDS_OF_CLASS, "NumPy": engine.WORDS_OF_NUMPY}
MEMORY = {"is_in_kib": 1, "points": 40, "memory_estimate": 9300, "memory_allowed": 5200, "most_boxes": 77,
          "most_crossings": 3, "own_points": 36}  # fmt: skip
LIMIT = {**MEMORY, "memory_limit": 5200, "memory_allowed": 5200}
MEANS = ("cell_width", "cell_height", "columns", "rows", "bounds", "bad_cell", "begin", "end", "ids", "triangles")
SAMPLED = {"sampled_places": 30, "sampled_valued": 20, "triangles": 50}
MISSING = {"missing": [("", 2), ("Flow", 1), ("Class", 0)], "of_points": [1, 0, 1], "of_added": [0, 1, 1]}
USUAL = {"points": 40, "inserted": 30, "delaunay_triangles": 50, "kept_triangles": 50, "cells": 50, "source_points": 9,
         "segments": 12}  # fmt: skip
BOXES = {"source_box": [0.5, 1.0, 2.0, 3e9], "input_box": [-7.25, -7.0, 0.0, 1.0]}
NONE = {"delaunay_triangles": 0, "kept_triangles": 0, "cells": 0}
# Facts of a run of any door, by name: counts, the trimmed area, are crossings split?
CASES = {
    "nothing to say": ({}, 0.0, False),
    "not finite": ({"not_finite": 3, "first_not_finite": 7}, 0.0, False),
    "not finite in a plane": ({"not_finite": 3, "first_not_finite": 7, "is_projected": 1}, 0.0, False),
    "odd z": ({"odd_z": 2}, 0.0, False),
    "stacked": ({"stacked": 1, "duplicates": 21}, 0.0, False),
    "steep plane": ({"steep_plane": 1, "is_projected": 1}, 0.0, False),
    "wall in its plane": ({"plane_was_chosen": 1, "is_projected": 1}, 0.0, False),
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
    "off a surface with heights of the source": ({"points_off_surface": 4, "heights_are_mixed": 1}, 0.0, False),
    "apart": ({"source_apart": 1, "points_off_surface": 9, **BOXES}, 0.0, False),
    "apart in a plane": ({"source_apart": 1, "is_projected": 1, **BOXES}, 0.0, False),
    "loops around no point": ({"loops_miss_input": 1, **BOXES}, 0.0, False),
    "a line without heights": ({"lines_at_zero": 1, "lowest_z": -2.5, "highest_z": -1}, 0.0, False),
    "lines without heights": ({"lines_at_zero": 3, "lowest_z": 1e3, "highest_z": 1234.5}, 0.0, False),
    "open lines": ({"lines_unclosed": 1}, 0.0, False),
    "crossing": ({"segments_crossing": 2, "first_crossing_cell": 5, "first_crossed_cell": 1}, 0.0, False),
    "crossing pieces": ({"segments_crossing": 2, "unfilled_loops": 1}, 0.0, True),
    "one bends": ({"bent_segments": 1, "first_bent_cell": 6}, 0.0, True),
    "some bend": ({"bent_segments": 3, "first_bent_cell": 6}, 0.0, True),
    "nothing is constrained": ({"segments": 0}, 0.0, False),
    "without vertex": ({"segments_without_vertex": 2, "unfilled_loops": 3}, 0.0, False),
    "both": ({"segments_crossing": 2, "segments_without_vertex": 2, "unfilled_loops": 3}, 0.0, False),
    "without vertex and triangle": ({**NONE, "inserted": 2, "segments_without_vertex": 2}, 0.0, False),
}  # fmt: skip


def facts_of_runs():
    for name, (counts, area, split) in CASES.items():
        yield name, {**USUAL, "trimmed_area": area, "splits": split, **counts}


def facts_of_class():
    """Facts of a run of a class."""
    source = {"segments": 0, "source_points": 2, "source_vertices": 1, "source_strips": 3}
    for name, more in (
        ("planes", {"transform_is_missing": 1, "bounding_is_missing": 1, "diagram_in_plane": 1}),
        ("marks", {"marks_are_unfit": 1, "input_points": 38}),
        ("numbers", {"unfit_numbers": ["Heat", "Flow"]}),
        ("emptied", {**NONE, "may_be_emptied_by_loops": 1}),
        ("collinear so far", {**NONE, "beyond_limit": 7}),
        ("one triangle", {"kept_triangles": 1, "cells": 0}),
        ("areas beyond doubles", {"bare_vertices": 2, "trimmed_area": float("nan")}),
        ("strips alone", {**source, "source_points": 0, "source_vertices": 0, "source_strips": 1}),
        ("all kinds", source), ("one strip too many", {"source_strips": 1}), ("strips", {"source_strips": 2}),
        ("unfit ids", {"segments_without_vertex": 2, "unfit_ids": 1, "first_unfit_id": 2**62, "first_unfit_cell": 4}),
        ("unfit ids of the source", {"segments_without_vertex": 1, "unfit_ids": 1, "cell_ids": 1, "unfilled_loops": 1}),
        ("unfit ids and crossings", {"segments_crossing": 1, "unfit_ids": 1, "unfilled_loops": 1}),
    ):  # fmt: skip
        yield name, {**USUAL, **more}


def refusals():
    for status in (engine.TOO_MANY_POINTS, engine.TOO_MANY_BOXES, engine.OUT_OF_MEMORY, engine.MEMORY_LIMIT,
                   engine.TOO_MANY_CROSSINGS, engine.CANCELLED):  # fmt: skip
        for given in (MEMORY, LIMIT):
            yield {"reason": status, **given}
    yield {"reason": engine.OUT_OF_MEMORY, **LIMIT, "memory_allowed": 9300}
    yield {"reason": engine.MEMORY_LIMIT, **LIMIT, "memory_estimate": 2**62}
    yield {"reason": engine.MEMORY_LIMIT, **LIMIT, "is_in_kib": 0}
    for doing, more in (("interpolating", {"places": 2.0**62, "of_triangulation": 1}), ("merging", {}), ("making", {}),
                        ("outlining", {"polygons": 50}), ("refining", {}), ("editing", {}),
                        ("sampling", {"places": 30, "memory_needed": 700}),
                        ):  # fmt: skip
        yield {"reason": engine.MEMORY_LIMIT, "doing": doing, **LIMIT, **more}
    on_rank = {"reason": engine.MEMORY_LIMIT, **LIMIT, "of_rank": 1, "rank": 2}
    for share in ("", " (of its own)"):
        yield {**on_rank, "doing": "distributing", "work": "Triangulating", "ranks": 3, "share": share}
    for sent in (0, 1):
        yield {**on_rank, "doing": "gathering", "setting": "Alpha", "are_sent": sent}
    yield {"reason": engine.OUT_OF_MEMORY, "doing": "interpolating", **MEMORY, "places": -1.0}
    yield {"reason": engine.OUT_OF_MEMORY, "doing": "making", **MEMORY}
    yield {"reason": engine.OUT_OF_MEMORY, "doing": "outlining", **MEMORY, "polygons": 50}
    yield {"reason": engine.OUT_OF_MEMORY, "doing": "refining", **MEMORY}
    bad = {"bad_cell": 4, "begin": -1, "end": 7, "ids": 6}
    yield {"reason": engine.BAD_ARRAY, "cells": "polygons of the source", **bad}
    yield {"reason": engine.BAD_ARRAY}
    yield {"reason": engine.BAD_ARRAY, "polygon_fault": "is not convex"}
    for other in ("limit", "alpha", "mean"):
        yield {"reason": engine.BAD_VALUE, "conflict": 1, "conflict_with_" + other: 1}
    yield {"folded_triangles": 3, "triangles": 50}
    yield {"triangulation_is_null": 1}
    yield {"not_to_refine": "Alpha"}
    yield {"unfit_sizes": "Size"}
    yield {"mesh_ranks": 2}
    yield {"input_is_changed": 1}
    for fault in ("cell_size", "bounds", "too_many", "too_wide", "out_of_numbers", "no_area"):
        yield {"raster": fault, "cell_width": 0.1, "cell_height": 1e-12, "columns": 4e12, "rows": 3.0,
               "bounds": [0.0, 0.25, -1e300, float("inf")]}  # fmt: skip
    for heights, mask, gradients in (("vtkGhostType", "", ""), ("z", "vtkGhostType", ""), ("z", "z", ""),
                                     ("z", "zGradient", "zGradient"), ("", "", "")):  # fmt: skip
        yield {"heights_name": heights, "mask_name": mask, "gradients_name": gradients}


def facts_of_places():
    yield {**SAMPLED, "sampled_not_finite": 3}
    yield {**SAMPLED, "sampled_outside": 30, "sampled_valued": 0, "wanted": [0.5, 1.0, 2.0, 3e9],
           "surface": "nowhere"}  # fmt: skip
    yield {"sampled_places": 1, "sampled_outside": 1, "surface": [0.1, 1.0, 2.0, 3.0], "wanted": "nowhere"}
    yield {**SAMPLED, "sampled_without_value": 3, "sampled_left_out": 4, **MISSING}
    yield {**SAMPLED, "sampled_without_value": 1, "missing": [("", 1)], "of_points": [1], "of_added": [0]}
    yield {**SAMPLED, "sampled_without_value": 1, "missing": [("Flow", 1)], "of_points": [1], "of_added": [0]}


def cases():
    """Messages that NumPy does not have: (topic, name, facts)."""
    for name, facts in facts_of_class():
        yield engine.SAY_TRIANGULATION, name, facts
    for facts in refusals():
        told = ["%s=%s" % row for row in facts.items() if MEMORY.get(row[0]) != row[1] and row[0] not in MEANS]
        yield engine.SAY_REFUSAL, ", ".join(told), facts
    names = ["a", "b", "c", "d", "e", "f", "ä"]
    yield engine.SAY_COLUMNS, "arrays", {"unfit_array": names, "replaced_array": names[:5], "gradients_are_missing": 1}
    for k, facts in enumerate(facts_of_places()):
        yield engine.SAY_PLACES, "places %d" % k, facts
    for count in (1, 2):
        yield engine.SAY_OUTLINE, "outline %d" % count, {
            "unfit_cells": count, "unfit_edges": count, "has_no_polygon": 1, "polygon_strips": count,
            "outlined_blocks": count,
            "unfit_group": "Flow"}  # fmt: skip
        yield engine.SAY_BLOCKS, "blocks %d" % count, {
            "other_blocks": count, "first_other": "vtkTable", "unfit_marks": count, "without_points": "vtkImageData",
            "other_sources": count, "first_other_source": "vtkImageData"}  # fmt: skip
    yield engine.SAY_BLOCKS, "a table", {"without_points": "vtkTable"}
    yield engine.SAY_BLOCKS, "ranks", {"mesh_ranks": 2}


class MessagesTest(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        runs = [(engine.SAY_TRIANGULATION, *row) for row in facts_of_runs()]
        cls.found = {
            words: {
                name: engine.say(topic, number, facts)
                for topic, name, facts in runs + list(cases() if words != "NumPy" else ())
            }
            for words, number in WORDS.items()
        }
        for name, said in list(cls.found["C"].items()):  # equal texts are listed once
            if said == cls.found["class"][name]:
                del cls.found["C"][name]
        if os.environ.get("AHD_WRITE_HASHES") == "1":
            rows = [
                ",\n".join("  %s: %s" % (json.dumps(name), json.dumps(said)) for name, said in cls.found[words].items())
                for words in WORDS
            ]
            text = ",\n".join(' "%s": {\n%s\n }' % row for row in zip(WORDS, rows))
            FILE.write_text("{\n%s\n}\n" % text, encoding="utf-8")

    def test_they_are_those(self):
        """In this order."""
        wanted = json.loads(FILE.read_text(encoding="utf-8"))
        self.assertEqual(json.dumps(self.found, indent=1), json.dumps(wanted, indent=1))

    def test_none_is_left_out(self):
        self.assertGreater(len(NAMES), 50)
        self.assertEqual(len(NAMES), len(set(NAMES)))
        said = {name for found in self.found.values() for names in found.values() for name in names}
        self.assertEqual(said, set(NAMES))

    def test_settings_that_are_named_are_there(self):
        tables = json.loads((ROOT / "Testing/Support/settings.json").read_text(encoding="utf-8"))
        of_class = {name for table in ("delaunay", "interpolation") for name in tables[table]["settings"]}
        others = {"NaN", "KiB", "zGradient"}
        for text in self.texts("class"):
            self.assertEqual(set(re.findall(r"\b(?!vtk)\w*[a-z][A-Z]\w*", text)) - of_class - others, set(), text)
            self.assertNotRegex(text, r"AHD_|\w=|`")
        of_c = {*engine.names(engine.INT_SETTINGS), *engine.names(engine.DOUBLE_SETTINGS),
                *engine.names(engine.INPUT_ARRAYS)}  # fmt: skip
        for text in self.texts("C"):
            quoted = set(re.findall(r'(?<!is )(?<!both )"(\w+)"', text))
            self.assertEqual(quoted - of_c, set(), text)
        for text in self.texts("NumPy"):
            named = re.findall(r"`(\w+)`|(\w+)='|\b([a-z]+_[a-z_]+)", text)
            known = {*DEFAULTS, "source_points", "plane", "best_fit", "convex_hull"}
            self.assertEqual({name for row in named for name in row if name} - known, set(), text)

    def test_each_is_a_warning(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            delaunay([[float("nan"), 0]] * 40)
        self.assertEqual([str(one.message) for one in caught], list(self.found["NumPy"]["none at all"].values()))
        self.assertEqual({(one.category, one.filename) for one in caught}, {(DelaunayWarning, __file__)})

    def texts(self, words):
        return [text for said in self.found[words].values() for text in said.values()]


if __name__ == "__main__":
    unittest.main()
