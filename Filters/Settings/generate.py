#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Generates files from the tables of settings and measures (*.toml), after a change in one of them.

    generate.py            writes the files that are not up to date, and names them
    generate.py --check    writes nothing; exit code 1 if a file is not up to date

The files are committed, so that a build needs no Python.
"""

import argparse
import pathlib
import re
import sys

import arrays
import classes
import doors
import job
import panel
import pythontable
import rows as tables
import testing

ROOT = tables.HERE.parents[1]
# Files generated from a template of the same name and .in: their place in the project, and the template's.
MADE = {
    "Plugin/AdaptiveHilbertDelaunay.xml": "Plugin/AdaptiveHilbertDelaunay.xml.in",
    "Filters/vtkAdaptiveHilbertAlgorithm.h": "Filters/Settings/vtkAdaptiveHilbertAlgorithm.h.in",
    "Filters/vtkAdaptiveHilbertAlgorithm.cxx": "Filters/Settings/vtkAdaptiveHilbertAlgorithm.cxx.in",
    "Filters/vtkAdaptiveHilbertInterpolationAlgorithm.h":
        "Filters/Settings/vtkAdaptiveHilbertInterpolationAlgorithm.h.in",
    "Filters/vtkAdaptiveHilbertInterpolationAlgorithm.cxx":
        "Filters/Settings/vtkAdaptiveHilbertInterpolationAlgorithm.cxx.in",
    "Filters/vtkAdaptiveHilbertQualityMeshAlgorithm.h": "Filters/Settings/vtkAdaptiveHilbertQualityMeshAlgorithm.h.in",
    "Filters/vtkAdaptiveHilbertQualityMeshAlgorithm.cxx":
        "Filters/Settings/vtkAdaptiveHilbertQualityMeshAlgorithm.cxx.in",
    "Filters/Pipeline/vtkAHDOutputArrays.h": "Filters/Settings/vtkAHDOutputArrays.h.in",
    "Filters/Engine/Job/SettingRows.h": "Filters/Settings/JobSettingRows.h.in",
    "Filters/Engine/Job/ArrayRows.h": "Filters/Settings/JobArrayRows.h.in",
    "Filters/Engine/Job/ReadSettings.cxx": "Filters/Settings/ReadSettings.cxx.in",
    "Testing/Support/Run/SettingRows.h": "Filters/Settings/SettingRows.h.in",
    "Filters/Python/_arrays.py": "Filters/Settings/_arrays.py.in",
    "Filters/Python/_keywords.py": "Filters/Settings/keywords.py.in",
    "Filters/Python/_vtk/table.py": "Filters/Settings/table.py.in",
    "Filters/Python/pyvista.py": "Filters/Settings/pyvista.py.in",
}
# The header for C has the list of a job's settings; the rest of it is written by hand.
C_HEADER = pathlib.Path("Filters/Engine/Interface/ahd.h")
C_LIST = re.compile(r"^ \* int \(made of .*?\n(?= \*\n)", re.MULTILINE | re.DOTALL)
# A comment that stands for a generated part.
PLACE = re.compile(r"^ *(?:<!--|//|#) @(\w+) (\w+)((?: \w+)*)(?: -->)?$", re.MULTILINE)
# One that stands for the first element of this name.
AGAIN = re.compile(r"^ *<!-- @again (\w+) -->$", re.MULTILINE)
PARTS = {
    **{part.__name__: part for part in (panel.properties, panel.measures, panel.groups)},
    **{part.__name__: lambda rows, _, part=part: part(rows) for part in (
        panel.exposed, classes.enums, classes.accessors, classes.members, classes.printed,
        classes.cleared, classes.taken, classes.added, classes.job_counts, classes.text_getters, classes.texts,
        classes.seconds, classes.counts, classes.compared_numbers, classes.compared_texts, classes.job_values,
        classes.on_one_rank, classes.setters, pythontable.setting_rows, pythontable.constants,
        pythontable.measure_rows, pythontable.text_rows, pythontable.job_rows, pythontable.measures_of_job)},
    "count_names": lambda rows, _: pythontable.names_of(tables.counts(rows)),
    "second_names": lambda rows, _: pythontable.names_of(tables.seconds(rows)),
    "endless_names": lambda rows, _: pythontable.names_of([row for row in tables.settings(rows) if not row.ends]),
    "old_names": lambda rows, _: [f'    "{row.old_name}": "{row.name}",' for row in rows if row.old_name],
    "job_ints": lambda rows, _: job.constants(rows, False),
    "job_doubles": lambda rows, _: job.constants(rows, True),
    **{part.__name__: part for part in (
        doors.numpy_rows, doors.mesh_rows, doors.wanted, doors.numpy_parameters, doors.mesh_parameters,
        doors.numpy_paragraphs, doors.mesh_paragraphs, doors.mesh_names, doors.numpy_want, doors.mesh_arrays)},
    "ints_on_surface": lambda rows, _: job.on_surface(rows, False),
    "doubles_on_surface": lambda rows, _: job.on_surface(rows, True),
    "used_up": lambda rows, _: pythontable.used_up(rows),
    "int_rows": lambda rows, _: job.rows(rows, False),
    "double_rows": lambda rows, _: job.rows(rows, True),
    "test_rows": lambda rows, _: testing.cxx_rows(rows),
    "array_constants": lambda rows, _: arrays.constants(rows),
    "array_dtypes": lambda rows, _: arrays.dtypes(rows),
    "run_members": lambda rows, _: job.run_members(rows),
    "wanted_names": lambda rows, _: arrays.wanted_names(rows),
    "wanted_rows": lambda rows, _: arrays.wanted_rows(rows),
    "visited": lambda rows, _: arrays.visited(rows),
    "array_rows": lambda rows, _: arrays.python_rows(rows),
    "array_keywords": lambda rows, _: arrays.keywords(rows),
    "all_run_names": lambda rows, _: pythontable.names_of([row for row in tables.measures(rows) if row.of_all_runs]),
}


def fill(template, read):
    """The text generated from a template."""

    def part(found):
        return "\n".join(PARTS[found[1]](read[found[2]], found[2], *found[3].split())).rstrip()

    path = ROOT / template
    text = path.read_text(encoding="utf-8").replace("@mark@", tables.MARK)
    text = AGAIN.sub(lambda found: re.search(rf' *<(\w+) name="{found[1]}".*?</\1>', text, re.DOTALL)[0], text)
    return PLACE.sub(part, text).replace("@CLASS@", path.name.split(".")[0])


def check_header(names):
    """ValueError for a count, measure or array that the headers for C do not describe."""
    text = "".join((ROOT / C_HEADER).with_name(name).read_text(encoding="utf-8") for name in ("ahd.h", "ahd_sample.h"))
    for name in names:
        if not re.search(rf"^ \*  .*\b{name}\b", text, re.MULTILINE):
            raise ValueError(f"{C_HEADER.name} has no {name}")


def has_effect_on_mesh(row):
    """Does the setting of the triangulation change a quality mesh, which keeps nothing for the next run? Limits of size
    are refused."""
    return row.group != "Outline" and row.name not in ("KeepTriangulation", "ReuseLimit")


def all_files():
    """The generated texts, by their path below the project's folder."""
    read = {"delaunay": tables.read("delaunay.toml")}
    read["interpolation"] = tables.read("interpolation.toml", read["delaunay"])
    read["quality"] = tables.read("quality.toml", [row for row in read["delaunay"] if has_effect_on_mesh(row)])
    read["points"] = tables.read("points.toml")
    read["outline"] = tables.read("outline.toml")
    read["arrays"] = arrays.read("arrays.toml", read["delaunay"])
    read["job"] = job.read("job.toml", read["delaunay"])
    reported = tables.reported()
    check_header([one.job for one in read["arrays"] if one.job] + sum(reported.values(), []))
    tables.check_measures(read["delaunay"], reported["kCountRows"], reported["kMeasureRows"])
    tables.check_measures(read["interpolation"], reported["kSampleRows"], ())
    made = {pathlib.Path(made): fill(template, read) for made, template in MADE.items()}
    made[pathlib.Path("Testing/Support/settings.json")] = testing.table(read)
    said = "\n".join(job.said(read["job"])) + "\n"
    made[C_HEADER] = C_LIST.sub(lambda _: said, (ROOT / C_HEADER).read_text(encoding="utf-8"))
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    only_checks = parser.parse_args().check
    try:
        made = all_files()
    except ValueError as error:
        print(f"Filters/Settings: {error}")
        return 1
    old = [path for path, text in made.items()
           if not (ROOT / path).exists() or (ROOT / path).read_text(encoding="utf-8") != text]
    for path in old:
        print(f"{path}: " + ("not up to date: run Filters/Settings/generate.py" if only_checks else "written"))
        if not only_checks:
            (ROOT / path).write_text(made[path], encoding="utf-8")
    return 1 if only_checks and old else 0


if __name__ == "__main__":
    sys.exit(main())
