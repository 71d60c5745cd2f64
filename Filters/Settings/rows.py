# SPDX-License-Identifier: BSD-3-Clause
"""The tables of settings and measures: what a row says, and what follows from it."""

import dataclasses
import pathlib
import re
import textwrap
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = 120
MARK = "Made by Filters/Settings/generate.py: change what is there, not this."
TYPES = ("bool", "flag", "enum", "int", "id", "int64", "double", "text")
PLACEHOLDERS = ("object", "exposed")
SWITCHES = ("bool", "flag")


@dataclasses.dataclass
class Value:
    """One value of an enum: what follows SetXTo ("": no such method), its constant, its name in the panel, and what it
    means."""

    name: str
    constant: str
    label: str
    about: str


@dataclasses.dataclass
class Row:
    """README.md says what each field means; None: the row does not say."""

    name: str
    group: str
    type: str
    help: str = ""
    details: str = ""
    measure: bool = False
    default: object = 0
    panel_default: object = None
    values: tuple = ()
    least: object = None
    most: object = None
    panel_least: object = None
    ends: bool = True
    panel: str = "default"
    panel_range: str = ""
    animateable: bool = False
    of_all_runs: bool = False
    old_name: str = ""
    job: str = ""
    ranks: str = "same"
    visible: tuple = ()
    enabled: tuple = ()

    @property
    def label(self):
        """The name in the panel. ParaView makes a property's name in Python of it: this one again."""
        return spaced(self.name)

    @property
    def elements(self):
        return len(self.default) if isinstance(self.default, list) else 1

    @property
    def is_switch(self):
        return self.type in SWITCHES

    @property
    def shown_default(self):
        """The default in ParaView's panel."""
        return self.default if self.panel_default is None else self.panel_default

    def check(self):
        """ValueError for a row that says what none can."""
        if self.type not in TYPES + PLACEHOLDERS:
            raise ValueError(f"{self.name}: there is no type {self.type}")
        if self.type in TYPES and not self.help.strip():
            raise ValueError(f"{self.name} has no help")
        if (self.type == "enum") != bool(self.values) and self.type != "int":
            raise ValueError(f"{self.name}: an enum has values, and nothing else has")
        if self.ranks not in ("same", "own"):
            raise ValueError(f"{self.name}: ranks are \"same\" or \"own\"")


def spaced(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def numbers(value):
    """As text, without what a whole number does not need: "0 1", "0.75"."""
    each = value if isinstance(value, list) else [value]
    return [str(int(one)) if isinstance(one, bool) or float(one).is_integer() else repr(float(one)) for one in each]


def said_default(row, by_constants):
    """The sentences on range and default; of an enum with the names of constants, or with those of the panel."""
    if row.measure:
        return ""
    if row.is_switch:
        on = {True: "On", False: "Off"}
        if row.shown_default != row.default:
            return f"{on[row.shown_default]} by default in ParaView, {on[row.default].lower()} in VTK."
        return f"{on[row.default]} by default."
    if row.values:
        return _said_value(row, by_constants)
    if row.type == "text":
        return f'Default "{row.default}".'
    text = "Default " + ", ".join("NaN" if one != one else numbers(one)[0] for one in _as_list(row.default))
    return _said_range(row, text)


def _as_list(value):
    return value if isinstance(value, list) else [value]


def _said_value(row, by_constants):
    def named(index):
        value = row.values[index]
        return value.constant if by_constants and value.constant else value.label

    if row.shown_default != row.default:
        return f"Default: {named(row.shown_default)} in ParaView, {named(row.default)} in VTK."
    return f"Default: {named(row.default)}."


def _said_range(row, text):
    if row.least is not None and row.most is not None:
        return f"From {numbers(row.least)[0]} to {numbers(row.most)[0]}. {text}."
    return f"{text}, at least {numbers(row.least)[0]}." if row.least is not None else text + "."


def wrapped(text, indent, columns=COLUMNS):
    """The paragraph in lines, each with the indent."""
    return textwrap.wrap(" ".join(text.split()), columns, initial_indent=indent, subsequent_indent=indent,
                         break_on_hyphens=False, break_long_words=False)


def _row(name, group, said):
    said = dict(said)
    said["values"] = tuple(Value(*value) for value in said.get("values", ()))
    for field in ("visible", "enabled"):
        said[field] = tuple(said.get(field, ()))
    row = Row(name=name, group=group, **said)
    row.check()
    return row


def read(file):
    """The rows of a table, in their order: a row outside of a group is a table with a type."""
    with open(HERE / file, "rb") as opened:
        table = tomllib.load(opened)
    rows = []
    for name, said in table.items():
        if "type" in said:
            rows.append(_row(name, "", said))
        else:
            rows += [_row(below, name, more) for below, more in said.items()]
    return rows


def settings(rows):
    return [row for row in rows if row.type in TYPES and not row.measure]


def measures(rows):
    return [row for row in rows if row.measure]


def counts(rows):
    """Measures of whole numbers of points, triangles, segments, places: they are field data of the output, too."""
    return [row for row in measures(rows) if row.type == "id"]


def seconds(rows):
    return [row for row in measures(rows) if row.name.endswith("Seconds")]
