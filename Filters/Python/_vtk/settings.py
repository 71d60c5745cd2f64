# SPDX-License-Identifier: BSD-3-Clause
"""The settings of vtkAdaptiveHilbertDelaunay2D, and VTK's methods for each: SetX, GetX, XOn, XOff, SetXToY,
GetXMinValue, GetXMaxValue."""

import math
import operator
import re

from . import table

INT_MAX = 2**31 - 1
INT64_MAX = 2**63 - 1


class Setting:
    """One setting, of a row of the table. `kind`: bool, flag (a vtkTypeBool: any int), enum, int, int64, double or
    text. `least`, `most`: the range that values are clamped to; None: any value. `names`: of an enum, the ends of
    SetXTo for 0, 1, ... `about`: its description."""

    def __init__(self, name, kind, default, about, least=None, most=None, names=()):
        self.name, self.kind, self.default, self.about, self.names = name, kind, default, about, names
        self.least, self.most = least, most

    def convert(self, value, now):
        """The value as the setting has it. TypeError for what is none, OverflowError for what VTK's type cannot
        hold."""
        if self.kind == "bool":
            return bool(value)
        if self.kind == "double":
            value = _as_double(value)
            return now if value != value else min(max(value, self.least), self.most)
        value = operator.index(value)
        largest = INT64_MAX if self.kind == "int64" else INT_MAX
        if not -largest - 1 <= value <= largest:
            raise OverflowError("value is out of range for %s" % ("long long" if self.kind == "int64" else "int"))
        return value if self.least is None else min(max(value, self.least), self.most)

    def text(self, value):
        """As PrintSelf has it."""
        return ("On" if value else "Off") if self.kind in ("bool", "flag") else "%g" % value if (
            self.kind == "double") else str(value)


def _as_double(value):
    if isinstance(value, (str, bytes)) or not (hasattr(value, "__float__") or hasattr(value, "__index__")):
        raise TypeError("a float is required, not %s" % type(value).__name__)
    return float(value)


class Vector(Setting):
    """Several numbers, each clamped by itself, of kind int or double. SetX takes them one by one or as a sequence."""

    def convert(self, value, now):
        numbers = tuple(value)
        if len(numbers) != len(self.default):
            raise TypeError("Set%s takes %d numbers" % (self.name, len(self.default)))
        if self.kind == "double":
            return tuple(_as_double(number) for number in numbers)
        return tuple(super(Vector, self).convert(number, 0) for number in numbers)

    def text(self, value):
        return ", ".join("%g" % number for number in value)


class Double(Setting):
    """Any double, NaN too: whatever NaN is given, it is the same setting."""

    def convert(self, value, now):
        value = _as_double(value)
        return now if math.isnan(value) and math.isnan(now) else value


class Text(Setting):
    """A name."""

    def convert(self, value, now):
        if not isinstance(value, str):
            raise TypeError("string is required, not %s" % type(value).__name__)
        return value


def settings_of(rows):
    """A Setting of each row."""
    return tuple(_class_of(*row)(*row) for row in rows)


def _class_of(_name, kind, default, _about, least, _most, _names):
    if isinstance(default, tuple):
        return Vector
    return Text if kind == "text" else Double if kind == "double" and least is None else Setting


SETTINGS = settings_of(table.DELAUNAY)
SOURCE = settings_of(table.POINTS)  # of vtkPlanarPointSource
OUTLINE = settings_of(table.OUTLINE)  # of vtkPlanarSurfaceOutline
QUALITY = settings_of(table.QUALITY)  # of vtkAdaptiveHilbertQualityMesh2D
BY_NAME = {setting.name: setting for setting in SETTINGS}
CONSTANTS, COUNTS, SECONDS = table.DELAUNAY_CONSTANTS, table.DELAUNAY_COUNTS, table.DELAUNAY_SECONDS
MEASURES = {name: value for name, value, _about in table.DELAUNAY_MEASURES}


def as_before(measures):
    """Measures as they are before an execution and after one that failed, but for those of all executions."""
    return {name: value for name, value in measures.items() if name not in table.OF_ALL_RUNS}


def _method(name, function, about):
    function.__name__ = name
    function.__doc__ = about
    return function


def _setter(setting):
    def set_it(self, value):
        self._set(setting, value)

    def set_each(self, *values):
        self._set(setting, values[0] if len(values) == 1 else values)

    return set_each if isinstance(setting, Vector) else set_it


def _getter(name):
    return lambda self: self._values[name]


def _sets_to(setting, value):
    return lambda self: getattr(self, "Set" + setting.name)(value)


def _answers(value):
    return lambda self: value


def methods_of(setting):
    """VTK's methods for one setting, by name."""
    name = setting.name
    made = {
        "Set" + name: _method("Set" + name, _setter(setting), setting.about),
        "Get" + name: _method("Get" + name, _getter(name), setting.about)}
    if setting.kind in ("bool", "flag"):
        for end, value in (("On", 1), ("Off", 0)):
            made[name + end] = _method(name + end, _sets_to(setting, value), setting.about)
    elif setting.least is not None and name not in table.WITHOUT_ENDS and not isinstance(setting, Vector):
        for end, value in (("MinValue", setting.least), ("MaxValue", setting.most)):
            made["Get" + name + end] = _method("Get" + name + end, _answers(value), "The %s value of %s." % (
                "smallest" if end == "MinValue" else "largest", name))
    for value, word in enumerate(setting.names):
        full = "Set%sTo%s" % (name, word)
        made[full] = _method(full, _sets_to(setting, value), setting.about)
    return made


def getters_of(measures):
    """VTK's methods for measures, by name."""
    return {"Get" + name: _method("Get" + name, _getter(name), about) for name, _value, about in measures}


def _number(value):
    return "%.3g" % value if isinstance(value, float) else "{:,}".format(value)


def _text_getter(rows, before):
    def get_text(self):
        shown = [self._values[name] != before[name] for _words, name in rows]
        shown[0] = any(shown)
        return "\n".join("%s %s" % (_number(self._values[name]), words)
                         for (words, name), is_shown in zip(rows, shown) if is_shown)

    return get_text


def getters_of_texts(texts, before):
    """VTK's methods for texts of measures, by name. `before`: the measures' values before a run."""
    return {"Get" + name: _method("Get" + name, _text_getter(rows, before), about)
            for name, (about, rows) in texts.items()}


def all_methods():
    """The methods and constants of all settings and measures, by name."""
    made = dict(CONSTANTS, **getters_of(table.DELAUNAY_MEASURES))
    made.update(getters_of_texts(table.DELAUNAY_TEXTS, MEASURES))
    for setting in SETTINGS:
        made.update(methods_of(setting))
    for old, now in table.OLD_NAMES.items():
        for pattern in ("Set%s", "Get%s", "%sOn", "%sOff"):
            made[pattern % old] = _renamed(pattern % old, pattern % now)
    return made


def properties_of(kind, names=tuple(BY_NAME) + tuple(MEASURES) + tuple(table.DELAUNAY_TEXTS) + (
        "Transform", "Source", "SourceData", "SourceConnection", "Input", "InputData", "Output")):
    """VTK's properties for the methods SetX and GetX of a class, by name."""
    made = {}
    for name in names:
        get, set_ = getattr(kind, "Get" + name, None), getattr(kind, "Set" + name, None)
        if name in ("SourceData", "InputData"):
            get = None  # what VTK's algorithms in Python call so is another thing
        made[snake_case(name)] = property(get, set_, doc=(get or set_).__doc__)
    return made


def _renamed(name, now):
    return _method(name, lambda self, *given: getattr(self, now)(*given), "The old name of %s." % now)


def snake_case(name):
    """The name of VTK's property for a setting: alpha_tris."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()
