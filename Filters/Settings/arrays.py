# SPDX-License-Identifier: BSD-3-Clause
"""The table of output arrays, and the parts generated from it."""

import dataclasses
import tomllib

import rows as tables

VTK = {"id": "vtkIdTypeArray", "int": "vtkIntArray", "uint8": "vtkUnsignedCharArray", "double": "vtkDoubleArray"}
# In the engine, and their bytes there; ids have 64 bits or 32.
ENGINE = {"id": ("kInt64", 8), "int": ("kInt32", 4), "uint8": ("kUint8", 1), "double": ("kFloat64", 8)}
NUMPY = {"int": "int32", "uint8": "uint8", "double": "float64"}  # ids: as the caller asks
# Which data of an output has them; of those that the code places by itself, none.
DATA = {"points": "PointData", "cells": "CellData", "field": "FieldData", "other outputs": "", "ranks": ""}


@dataclasses.dataclass
class Array:
    """README.md says what each field means."""

    name: str
    of: str
    type: str
    help: str
    components: int = 1
    setting: str = ""
    job: str = ""
    time: float = 0.0
    keyword: str = ""

    def check(self, settings):
        """ValueError for a row that says what none can."""
        for wrong, text in ((self.of not in DATA, f"of is one of {tuple(DATA)}"),
                            (self.type not in VTK, f"type is one of {tuple(VTK)}"),
                            (not self.help.strip(), "no help"),
                            (bool(DATA.get(self.of)) != bool(self.job), "job: of the surface's arrays only"),
                            (self.setting and settings.get(self.setting) != f"want_{self.job}",
                             f"there is no setting {self.setting} with the job want_{self.job}"),
                            (self.setting and self.of not in ("points", "cells"), "setting: of points or cells"),
                            (bool(self.setting) != bool(self.time), "time: of an array with a setting, and not 0")):
            if wrong:
                raise ValueError(f"[{self.name}]: {text}")


def read(file, rows):
    """The arrays in their order; `rows`: the settings of their filter."""
    with open(tables.HERE / file, "rb") as opened:
        table = tomllib.load(opened)
    settings = {row.name: row.job for row in tables.settings(rows)}
    known = {field.name for field in dataclasses.fields(Array)}
    found = []
    for name, said in table.items():
        if said.keys() - known or not {"of", "type", "help"} <= said.keys():
            raise ValueError(f"[{name}]: fields are of, type, help, and perhaps {', '.join(sorted(known))}")
        found.append(Array(name=name, **said))
        found[-1].check(settings)
    for keyword in tables.twice([array.keyword for array in found if array.keyword]):
        raise ValueError(f"{file}: two rows have the keyword {keyword}")
    return found


def constants(arrays):
    """One for each array, for C++."""
    lines = []
    for array in arrays:
        lines += tables.wrapped(array.help, "/// ", 100)
        lines.append(f'constexpr vtkAHDOutputArray<{VTK[array.type]}> {array.name} = {{ "{array.name}", '
                     f"{array.components} }};")
    return lines


def wanted(arrays):
    """Those that a setting adds."""
    return [array for array in arrays if array.setting]


def wanted_names(arrays):
    names = [tables.constant(array.job) for array in wanted(arrays)]
    return [f"  {name}," for name in names[:-1]] + [f"  {names[-1]}"]


def wanted_rows(arrays):
    """For the engine."""
    return [f'  {{ "{array.job}", IntSetting::{tables.constant("want_" + array.job)}, '
            f"{str(array.of == 'cells').lower()}, {ENGINE[array.type][0]}, {array.components}, "
            f"{array.components * ENGINE[array.type][1]}, {array.time} }}," for array in wanted(arrays)]


def visited(arrays):
    """The calls of a visitor, one for each."""
    return [f"  visit({array.name}, ahd::WantedArray::{tables.constant(array.job)});" for array in wanted(arrays)]


def python_rows(arrays):
    """Arrays that the class in Python adds to the surface, if a setting is on."""
    return [f'    ("{array.setting}", "{array.job}", "{array.name}", "{VTK[array.type]}", {array.components}, '
            f'"{DATA[array.of]}"),' for array in wanted(arrays)]


def dtypes(arrays):
    """NumPy's types of the job's arrays that are no ids."""
    return [f'    "{array.job}": "{NUMPY[array.type]}",' for array in arrays if array.job and array.type != "id"]


def keywords(arrays):
    """How PyVista's callers name them."""
    return [f'    "{array.keyword}": "{array.setting}",' for array in arrays if array.keyword]
