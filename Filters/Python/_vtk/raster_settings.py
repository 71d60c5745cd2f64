# SPDX-License-Identifier: BSD-3-Clause
"""The settings of vtkAdaptiveHilbertInterpolation2D as a table, and VTK's methods for each: those of settings.py, and
of settings that are several numbers or a text."""

import math

from .settings import INT_MAX, Setting, _method, methods_of, properties_of


class Vector(Setting):
    """Several numbers, each clamped by itself, of kind int or double. SetX takes them one by one or as a sequence."""

    def __init__(self, name, kind, default, about, least=None, most=None):
        super().__init__(name, kind, default, about, least, most)
        self.each = Setting(name, "any" if kind == "double" else kind, default[0], about, least, most)

    def convert(self, value, now):
        numbers = tuple(value)
        if len(numbers) != len(self.default):
            raise TypeError("Set%s takes %d numbers" % (self.name, len(self.default)))
        if self.kind == "int":
            return tuple(self.each.convert(number, 0) for number in numbers)
        return tuple(as_double(number) for number in numbers)

    def text(self, value):
        return ", ".join("%g" % number for number in value)


class Double(Setting):
    """Any double, NaN too: whatever NaN is given, it is the same setting."""

    def __init__(self, name, default, about):
        super().__init__(name, "double", default, about, -math.inf, math.inf)

    def convert(self, value, now):
        value = as_double(value)
        return now if math.isnan(value) and math.isnan(now) else value


class Text(Setting):
    """A name."""

    def __init__(self, name, default, about):
        super().__init__(name, "text", default, about)

    def convert(self, value, now):
        if not isinstance(value, str):
            raise TypeError("string is required, not %s" % type(value).__name__)
        return value

    def text(self, value):
        return value


def as_double(value):
    return Setting("", "double", 0.0, "", -math.inf, math.inf).convert(value, math.nan)


SETTINGS = (
    Setting("Method", "enum", 0, "How values are interpolated: linear in the triangle, by natural neighbours with "
            "Sibson's or Laplace's weights, or that of the nearest vertex.",
            names=("Linear", "NaturalNeighbor", "Laplace", "Nearest")),
    Setting("RasterSize", "enum", 0, "What says how many cells the raster has: Dimensions or CellSize.",
            names=("ByDimensions", "ByCellSize")),
    Vector("Dimensions", "int", (256, 256), "The number of cells along x and y.", 1, INT_MAX),
    Vector("CellSize", "double", (1.0, 1.0), "The size of a cell along x and y, in the unit of the points."),
    Setting("AlignToCellSize", "bool", False, "Lay the borders between cells on multiples of CellSize."),
    Setting("UseBounds", "bool", False, "The raster's area is Bounds, and not the bounding box of the points."),
    Vector("Bounds", "double", (0.0, 1.0, 0.0, 1.0), "The raster's area: xmin, xmax, ymin, ymax."),
    Setting("OutputType", "enum", 0, "What is put out without places: an image, or its points at their heights.",
            names=("Image", "Surface")),
    Setting("Outside", "enum", 0, "What places outside of the surface get: no value, or that of the nearest vertex.",
            names=("NoValue", "NearestVertex")),
    Double("NoValue", math.nan, "What arrays of floating-point numbers have where there is no value."),
    Setting("GenerateGradients", "bool", False, "Add the slopes, d/dx and d/dy, of arrays of one component."),
    Text("HeightArrayName", "Elevation", "The name of the array of heights; empty: none."),
    Text("ValidPointMaskArrayName", "vtkValidPointMask", "The name of the mask of places with a value; empty: none."),
)

CONSTANTS = {
    "LINEAR": 0, "NATURAL_NEIGHBOR": 1, "LAPLACE": 2, "NEAREST": 3, "BY_DIMENSIONS": 0, "BY_CELL_SIZE": 1,
    "IMAGE": 0, "SURFACE": 1, "NO_VALUE": 0, "NEAREST_VERTEX": 1}

COUNTS = (
    "NumberOfPlaces", "NumberOfValidPlaces", "NumberOfPlacesOutside", "NumberOfNotFinitePlaces",
    "NumberOfPlacesWithoutValue", "NumberOfPlacesWithNeighborsLeftOut")
MEASURES = {**dict.fromkeys(COUNTS, 0), "SampleSeconds": 0.0, "MemoryEstimate": 0, "NumberOfTriangulations": 0}


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
            own["Set" + setting.name] = _method("Set" + setting.name, _vector_setter(setting), "%s Default %s." % (
                setting.about, ", ".join("%g" % number for number in setting.default)))
        made.update(own)
    for name in MEASURES:
        made["Get" + name] = _method("Get" + name, lambda self, name=name: self._values[name],
                                     "%s of the last execution." % name)
    return made


def all_properties(kind):
    """VTK's properties of the class, by name."""
    return properties_of(kind, [setting.name for setting in SETTINGS] + list(MEASURES) + ["Triangulation"])
