# SPDX-License-Identifier: BSD-3-Clause
"""The tables of settings and measures: rows, and values derived from them."""

import dataclasses
import math
import pathlib
import re
import textwrap
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = 120
REPORT_ROWS = HERE.parent / "Engine/Job/ReportRows.h"
MARK = "Made by Filters/Settings/generate.py: change what is there, not this."
# The type of a default in the table, by type.
TYPES = {"bool": bool, "flag": bool, "enum": int, "int": int, "id": int, "int64": int, "double": float, "text": str}
PLACEHOLDERS = ("object", "exposed", "measures")
INPUTS = ["Input", "Places"]  # of which conditions may be, too
SWITCHES = ("bool", "flag")
RANKS = ("same", "one", "effect", "own")
PANELS = ("default", "advanced", "never", "none")
FILTERS = ("surface", "voronoi", "order", "interpolation")  # ParaView's, with settings of the first table
PANEL_RANGES = ("", "points", "point arrays", "any", "without a most")
VECTORS = (2, 3, 4, 6)  # so many numbers VTK's macros take


@dataclasses.dataclass
class Value:
    """One value of an enum: the end of SetXTo ("": no such method), its constant, its name in the panel, and its
    meaning."""

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
    said: str = ""
    default: object = None
    panel_default: object = None
    values: tuple = ()
    least: object = None
    most: object = None
    panel_least: object = None
    ends: bool = True
    panel: object = "default"
    on_in: str = ""
    panel_range: str = ""
    animateable: bool = False
    of_all_runs: bool = False
    old_name: str = ""
    job: str = ""
    on_surface: object = None
    exposed: bool = False
    ranks: str = "same"
    visible: tuple = ()
    enabled: tuple = ()

    @property
    def label(self):
        """The name in the panel. ParaView makes a property's name in Python of it: this one again."""
        return spaced(self.name)

    @property
    def panels(self):
        """The visibility in the panels of filters, by their names; of one that is not said, there is no property."""
        return self.panel if isinstance(self.panel, dict) else {"surface": self.panel}

    @property
    def elements(self):
        return len(self.default) if isinstance(self.default, list) else 1

    @property
    def is_switch(self):
        return self.type in SWITCHES

    @property
    def terms(self):
        """Of a measure: the job's counts and measures whose sum it is."""
        return self.job.split(" + ") if self.job else []

    @property
    def is_clamped(self):
        return self.least is not None or self.most is not None

    @property
    def shown_default(self):
        """The default in ParaView's panel."""
        return self.default if self.panel_default is None else self.panel_default

    def check(self):
        """ValueError for a row that says what none can."""
        for wrong, text in self._complaints():
            if wrong:
                raise ValueError(f"[{self.name}]: {text}")

    def _complaints(self):
        yield self.type not in (*TYPES, *PLACEHOLDERS), f"there is no type {self.type}"
        for field in dataclasses.fields(self):
            kind = type(field.default)
            of_another = field.name != "panel" and not isinstance(getattr(self, field.name), kind)
            yield kind in (str, bool, tuple) and of_another, (
                f"{field.name} is of another type")
        yield not {*self.panels.values()} <= {*PANELS}, f"panel is one of {PANELS}"
        yield not {*self.panels} <= {*FILTERS}, f"panel is of {FILTERS}"
        yield self.on_in and not (self.is_switch and self.on_in in self.panels), "on_in is a panel of a switch"
        yield self.panel_range not in PANEL_RANGES, f"panel_range is one of {PANEL_RANGES}"
        yield self.ranks not in RANKS, f"ranks is one of {RANKS}"
        yield self.measure != bool(self.said), "a measure, and nothing else, has words in a text"
        yield self.measure and (self.panel != "default" or self.visible or self.enabled), (
            "the panel has a text of measures")
        yield self.ranks == "one" and (self.values or self.elements > 1), "one rank: of a number or a switch only"
        if self.type in PLACEHOLDERS:
            return
        yield not self.help.strip(), "no help"
        yield (self.type == "enum") != bool(self.values) and self.type != "int", "an enum has values"
        yield self.old_name and not self.is_switch, "an old name is one of a bool or a flag"
        yield from self._complaints_about_numbers()

    def _complaints_about_numbers(self):
        kind = TYPES[self.type]
        for name in ("default", "panel_default", "least", "most", "panel_least", "on_surface"):
            for value in _as_list(getattr(self, name)):
                yield value is not None and type(value) is not kind, f"{name} is no {kind.__name__}"
        yield self.default is None, "no default"
        for name in ("default", "on_surface"):
            value = getattr(self, name)
            yield self.values and value is not None and not 0 <= value < len(self.values), f"{name} is no value"
        if isinstance(self.default, list):
            yield self.elements not in VECTORS or kind not in (int, float), "no list of so many of these"
            yield kind is float and not all(map(math.isfinite, self.default)), "default is not finite"
            yield self.most is not None or (kind is float and self.least is not None), (
                "lists are clamped by a least whole number only")


def spaced(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def constant(name):
    """Of a name in C that in C++."""
    return "".join(word.capitalize() for word in name.split("_"))


def numbers(value):
    """As text, whole numbers without a point: "0 1", "0.75"."""
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
    text = f"Default {_said_numbers(row.default)}"
    if row.shown_default is not row.default:
        text = f"Default {_said_numbers(row.shown_default)} in ParaView, {_said_numbers(row.default)} in VTK"
    return _said_range(row, text)


def _said_numbers(value):
    return ", ".join("NaN" if one != one else numbers(one)[0] for one in _as_list(value))


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
    ends = [f", {word} {numbers(end)[0]}" for word, end in (("at least", row.least), ("at most", row.most))
            if end is not None]
    return text + "".join(ends) + "."


def wrapped(text, indent, columns=COLUMNS):
    """The paragraph in lines, each with the indent."""
    return textwrap.wrap(" ".join(text.split()), columns, initial_indent=indent, subsequent_indent=indent,
                         break_on_hyphens=False, break_long_words=False)


def _row(name, group, said):
    place = f"[{group}.{name}]" if group else f"[{name}]"
    if not isinstance(said, dict) or "type" not in said:
        raise ValueError(f"{place}: no type")
    unknown = said.keys() - {field.name for field in dataclasses.fields(Row)}
    if unknown:
        raise ValueError(f"{place}: there is no field {', '.join(sorted(unknown))}")
    if any(len(value) != len(dataclasses.fields(Value)) for value in said.get("values", ())):
        raise ValueError(f"{place}: a value is four texts")
    said = {field: _converted(value, said["type"]) for field, value in said.items()}
    if said.get("measure"):
        said.setdefault("default", TYPES.get(said["type"], int)())
    said["values"] = tuple(Value(*value) for value in said.get("values", ()))
    row = Row(name=name, group=group, **said)
    row.check()
    return row


def _converted(value, kind):
    """Lists of texts as tuples; whole numbers of a double as such."""
    if isinstance(value, list):
        value = [_converted(one, kind) for one in value]
        return tuple(value) if value and isinstance(value[0], str) else value
    return float(value) if kind == "double" and type(value) is int else value


def read(file, within=()):
    """The rows of a table, in their order: a row outside of a group is a table with a type. `within`: the rows of the
    filter within this one, of which some are exposed."""
    with open(HERE / file, "rb") as opened:
        table = tomllib.load(opened)
    rows = []
    for name, said in table.items():
        if "type" in said:
            rows.append(_row(name, "", said))
        else:
            rows += [_row(below, name, more) for below, more in said.items()]
    rows = [more for row in rows for more in (_exposed(within, row.group) if row.type == "exposed" else [row])]
    _check_names(rows)
    hidden = [row for row in within if row.exposed and row.name not in [one.name for one in rows]]
    if hidden:
        raise ValueError(f"[{hidden[0].name}]: exposed, but {file} has no [{hidden[0].group}.Triangulation]")
    return rows


def twice(names):
    """Those that are there more than once."""
    return sorted({name for name in names if names.count(name) > 1})


def _exposed(within, group):
    found = [Row(row.name, group, "exposed", panel=row.panel) for row in within if row.exposed and row.group == group]
    if not found:
        raise ValueError(f"[{group}]: nothing is exposed in this group")
    return found


def _check_names(rows):
    names = [row.name for row in rows]
    texts_of = [text.group for text, _measures in texts(rows)]
    for row in rows:
        if row.measure and row.group not in texts_of:
            raise ValueError(f"[{row.name}]: there is no text of [{row.group}]")
        if names.count(row.name) > 1:
            raise ValueError(f"[{row.name}]: there are two")
        for condition in row.visible + row.enabled:
            for name in re.findall(r"(\w+) (?:=|!=|in|is) ", condition):
                if name not in names + INPUTS:
                    raise ValueError(f"[{row.name}]: {condition}: there is no {name}")


def settings(rows):
    return [row for row in rows if row.type in TYPES and not row.measure]


def measures(rows):
    return [row for row in rows if row.measure]


def texts(rows):
    """The texts of measures, each with the measures in it: those of its group."""
    return [(row, [one for one in measures(rows) if one.group == row.group]) for row in rows if row.type == "measures"]


def check_measures(rows, whole, real):
    """ValueError for a measure that is a sum of others than those whole or real numbers of a job."""
    for row in measures(rows):
        for name in row.terms:
            if name not in (real if row.type == "double" else whole):
                raise ValueError(f"[{row.name}]: a job has no {name} of this kind, in {REPORT_ROWS.name}")


def reported():
    """The numbers that reports of a job have: names by the name of their list."""
    text = REPORT_ROWS.read_text(encoding="utf-8")
    lists = re.findall(r"^constexpr [^;]* (k\w+Rows)\[\] = \{(.*?)^\};", text, re.MULTILINE | re.DOTALL)
    return {name: re.findall(r'^  \{ "(\w+)"', rows, re.MULTILINE) for name, rows in lists}


def counts(rows):
    """Measures of whole numbers of points, triangles, segments, places: they are field data of the output, too."""
    return [row for row in measures(rows) if row.type == "id"]


def seconds(rows):
    return [row for row in measures(rows) if row.name.endswith("Seconds")]
