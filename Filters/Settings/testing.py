# SPDX-License-Identifier: BSD-3-Clause
"""What tests know of the tables: Testing/Support/settings.json, SettingRows.h."""

import json
import math

import classes
import rows as tables


def table(read):
    """By the name of a table: settings and measures by name, and the names of those that are exposed; the job's
    settings; the arrays."""
    found = {name: {"settings": {row.name: _of_setting(row) for row in tables.settings(rows)},
                    "measures": {row.name: _of_measure(row) for row in tables.measures(rows)},
                    "texts": {text.name: [row.name for row in found] for text, found in tables.texts(rows)},
                    "exposed": [row.name for row in rows if row.type == "exposed"]}
             for name, rows in read.items() if name not in ("arrays", "job")}
    found["job"] = {one.name: _of_job(one) for one in read["job"]}
    found["arrays"] = {array.name: {"of": array.of, "type": array.type, "components": array.components,
                                    "setting": array.setting, "job": array.job} for array in read["arrays"]}
    return json.dumps({"mark": tables.MARK, **found}, indent=1) + "\n"


def _of_setting(row):
    default = None if row.default != row.default else row.default  # JSON has no NaN
    told = {"type": row.type, "default": default, "least": row.least, "most": row.most,
            "panel": row.panels.get("surface", ""), "values": [value.label for value in row.values], "ranks": row.ranks}
    for name in ("panel_default", "on_surface"):
        if getattr(row, name) is not None:
            told[name] = getattr(row, name)
    return told


def _of_job(one):
    least, most = (None if end == math.inf else end for end in one.ends)
    told = {"type": one.type, "default": one.value, "least": least, "most": most}
    if one.on_surface is not None:
        told["on_surface"] = one.on_surface
    return told


def _of_measure(row):
    return {"type": row.type, "default": row.default}


def cxx_rows(rows):
    """The settings with one number, for C++."""
    lines = []
    for row in tables.settings(rows):
        if row.type == "text" or row.elements > 1:
            continue
        kind = classes.CXX[row.type]
        value = "v" if kind == "double" else "v != 0" if kind == "bool" else f"static_cast<{kind}>(v)"
        least, most = (0, 1) if row.is_switch else (0, len(row.values) - 1) if row.values else (row.least, row.most)
        ends = ", ".join(f"{sign}kNoEnd" if end is None else repr(end) for end, sign in ((least, "-"), (most, "")))
        head = f'  {{ "{row.name}", {str(kind == "double").lower()}, {tables.numbers(row.default)[0]}, {ends},'
        setter = f"[](Filter* f, double v) {{ f->Set{row.name}({value}); }} }},"
        lines += [f"{head} {setter}"] if len(head + setter) < classes.COLUMNS else [head, "    " + setter]
    return lines
