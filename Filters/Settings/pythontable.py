# SPDX-License-Identifier: BSD-3-Clause
"""The parts of the tables for the classes in Python: rows for Setting, constants, measures."""

import rows as tables

COLUMNS = 116
# As VTK's methods take and return them.
KINDS = {"id": "int64"}
LEAST = {"int": -2**31, "int64": -2**63, "double": -1.0e299}
MOST = {"int": 2**31 - 1, "int64": 2**63 - 1, "double": 1.0e299}  # VTK_INT_MAX, VTK_TYPE_INT64_MAX, VTK_DOUBLE_MAX


def setting_rows(rows):
    """(name, kind, default, description, least, most, the ends of SetXTo for 0, 1, ...) of each."""
    lines = []
    for row in tables.settings(rows):
        kind = KINDS.get(row.type, row.type)
        names = tuple(value.name for value in row.values if value.name)
        lines.append(f'    ("{row.name}", "{kind}", {_default(row)},')
        lines += _text(_about(row)) + [f"     {', '.join(map(_literal, _range(row, kind)))}, {_names(names)}),"]
    return lines


def _about(row):
    return " ".join(f"{row.help} {tables.said_default(row, by_constants=True)} {row.details}".split())


def _default(row):
    value = tuple(row.default) if isinstance(row.default, list) else row.default
    return repr(int(value)) if row.type == "flag" else _literal(value)


def _literal(value):
    return "math.nan" if value != value else repr(value)


def _range(row, kind):
    if kind == "enum":
        return 0, len(row.values) - 1
    if not row.is_clamped:
        return None, None
    return LEAST[kind] if row.least is None else row.least, MOST[kind] if row.most is None else row.most


def _names(names):
    return repr(names)


def _text(text):
    """The text as literals, one a line."""
    lines = tables.wrapped(text, "", COLUMNS - 10)
    literals = [repr(line + (" " if line is not lines[-1] else "")) for line in lines]
    return ["     " + one + ("," if number == len(literals) - 1 else "") for number, one in enumerate(literals)]


def constants(rows):
    """The names of the values of enums."""
    return [f'    "{value.constant}": {number},' for row in tables.settings(rows)
            for number, value in enumerate(row.values) if value.name]


def measure_rows(rows):
    """(name, value before an execution and after a failed one, description) of each."""
    lines = []
    for row in tables.measures(rows):
        *text, last = _text(_about(row))
        lines += [f'    ("{row.name}", {_default(row)},', *text, last.rstrip(",") + "),"]
    return lines


def text_rows(rows):
    """By the name of a text: what it is, and (words, name) of each measure in it."""
    lines = []
    for text, found in tables.texts(rows):
        *about, last = _text(f"{text.help} Empty before a run.")
        lines += [f'    "{text.name}": (', *about, last.rstrip(",") + ", ("]
        lines += [f'         ("{row.said}", "{row.name}"),' for row in found] + ["     )),"]
    return lines


def measures_of_job(rows):
    """The terms of a measure, in the job."""
    return [f'    "{row.name}": {tuple(row.terms)!r},' for row in tables.measures(rows) if row.job]


def used_up(rows):
    """The settings that a surface has used up, and the values in place of theirs."""
    return [f'    "{row.name}": {int(row.on_surface) if row.is_switch else row.on_surface!r},'
            for row in tables.settings(rows) if row.on_surface is not None]


def names_of(rows):
    """Of these, one a line."""
    return [f'    "{row.name}",' for row in rows]


def job_rows(rows):
    """The class's setting with the values of a job's. A flag may be any int."""
    return [f'    "{row.job}": "{row.name}",' for row in tables.settings(rows) if row.job and row.type != "flag"]
