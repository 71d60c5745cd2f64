# SPDX-License-Identifier: BSD-3-Clause
"""What tests know of the tables: Testing/Support/settings.json."""

import json

import rows as tables


def table(read):
    """By the name of a table: settings and measures by name, and the names of those that are exposed."""
    found = {name: {"settings": {row.name: _of_setting(row) for row in tables.settings(rows)},
                    "measures": {row.name: _of_measure(row) for row in tables.measures(rows)},
                    "exposed": [row.name for row in rows if row.type == "exposed"]}
             for name, rows in read.items()}
    return json.dumps({"mark": tables.MARK, **found}, indent=1) + "\n"


def _of_setting(row):
    default = None if row.default != row.default else row.default  # JSON has no NaN
    told = {"type": row.type, "default": default, "least": row.least, "most": row.most, "panel": row.panel,
            "values": [value.label for value in row.values], "ranks": row.ranks}
    if row.panel_default is not None:
        told["panel_default"] = row.panel_default
    return told


def _of_measure(row):
    return {"type": row.type, "default": row.default}
