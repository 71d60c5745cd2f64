# SPDX-License-Identifier: BSD-3-Clause
"""The settings and measures of vtkAdaptiveHilbertInterpolation2D, and VTK's methods for each."""

from . import table
from .settings import getters_of, getters_of_texts, methods_of, properties_of, settings_of

SETTINGS = settings_of(table.INTERPOLATION)
CONSTANTS, COUNTS = table.INTERPOLATION_CONSTANTS, table.INTERPOLATION_COUNTS
MEASURES = {name: value for name, value, _about in table.INTERPOLATION_MEASURES}


def all_methods():
    """The methods and constants of all settings and measures, by name."""
    made = dict(CONSTANTS, **getters_of(table.INTERPOLATION_MEASURES))
    made.update(getters_of_texts(table.INTERPOLATION_TEXTS, MEASURES))
    for setting in SETTINGS:
        made.update(methods_of(setting))
    return made


def all_properties(kind):
    """VTK's properties of the class, by name."""
    names = [setting.name for setting in SETTINGS] + list(MEASURES) + list(table.INTERPOLATION_TEXTS)
    return properties_of(kind, names + ["Triangulation"])
