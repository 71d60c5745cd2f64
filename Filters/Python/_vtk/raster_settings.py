# SPDX-License-Identifier: BSD-3-Clause
"""The settings of vtkAdaptiveHilbertInterpolation2D, and VTK's methods for each: those of settings.py, and
of settings that are several numbers or a text."""

import math

from . import table
from .settings import Setting, _method, methods_of, properties_of


class Vector(Setting):
    """Several numbers, each clamped by itself, of kind int or double. SetX takes them one by one or as a sequence."""

    def convert(self, value, now):
        numbers = tuple(value)
        if len(numbers) != len(self.default):
            raise TypeError("Set%s takes %d numbers" % (self.name, len(self.default)))
        if self.kind == "int":
            return tuple(super(Vector, self).convert(number, 0) for number in numbers)
        return tuple(as_double(number) for number in numbers)

    def text(self, value):
        return ", ".join("%g" % number for number in value)


class Double(Setting):
    """Any double, NaN too: whatever NaN is given, it is the same setting."""

    def convert(self, value, now):
        value = as_double(value)
        return now if math.isnan(value) and math.isnan(now) else value


class Text(Setting):
    """A name."""

    def convert(self, value, now):
        if not isinstance(value, str):
            raise TypeError("string is required, not %s" % type(value).__name__)
        return value

    def text(self, value):
        return value


def as_double(value):
    return Setting("", "double", 0.0, "", -math.inf, math.inf).convert(value, math.nan)


def _made_of(row):
    _name, kind, default = row[:3]
    made = Text if kind == "text" else Vector if isinstance(default, tuple) else (
        Double if kind == "double" else Setting)
    return made(*row)


SETTINGS = tuple(_made_of(row) for row in table.INTERPOLATION)
CONSTANTS, COUNTS = table.INTERPOLATION_CONSTANTS, table.INTERPOLATION_COUNTS
MEASURES = table.INTERPOLATION_MEASURES


def _vector_setter(setting):
    def set_it(self, *values):
        self._set(setting, values[0] if len(values) == 1 else values)

    return set_it


def all_methods():
    """The methods and constants of all settings and measures, by name."""
    made = dict(CONSTANTS)
    for setting in SETTINGS:
        own = methods_of(setting)
        if isinstance(setting, (Vector, Double, Text)):
            own = {name: own[name] for name in ("Set" + setting.name, "Get" + setting.name)}
        if isinstance(setting, Vector):
            own["Set" + setting.name] = _method("Set" + setting.name, _vector_setter(setting), setting.about)
        made.update(own)
    for name in MEASURES:
        made["Get" + name] = _method("Get" + name, lambda self, name=name: self._values[name],
                                     "%s of the last execution." % name)
    return made


def all_properties(kind):
    """VTK's properties of the class, by name."""
    return properties_of(kind, [setting.name for setting in SETTINGS] + list(MEASURES) + ["Triangulation"])
