# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of vtkAdaptiveHilbertDelaunay2D in Python. They are the same for the compiled class and for
the class in Python, on VTK or on cvista.

Environment: AHD_TEST_VTK, the package that VTK's modules are taken from (vtkmodules, the default, or cvista);
AHD_TEST_CLASS, python for the class in Python where the package has the compiled one too.
"""

import importlib
import json
import os
import re
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from numbered import Hash, Random  # noqa: E402,F401 (for those who import this file)

BACKEND = os.environ.get("AHD_TEST_VTK", "vtkmodules")
FOLDER = Path(__file__).resolve().parent
TABLE = json.loads((FOLDER.parents[1] / "Support" / "settings.json").read_text(encoding="utf-8"))
HASHES = FOLDER.parents[2] / "Data" / "Hashes" / "Filter.txt"
WRITES = os.environ.get("AHD_WRITE_HASHES") == "1"


def vtk(module):
    """A module of the VTK under test, such as vtkCommonCore."""
    return importlib.import_module(BACKEND + "." + module)


core, model = vtk("vtkCommonCore"), vtk("vtkCommonDataModel")
calldata_type = vtk("util.misc").calldata_type


def tested_class(name):
    import adaptivehilbertdelaunay

    if os.environ.get("AHD_TEST_CLASS") == "python":
        return importlib.import_module("adaptivehilbertdelaunay._vtk").python_class(BACKEND, name)
    return getattr(adaptivehilbertdelaunay, name)


Filter = tested_class("vtkAdaptiveHilbertDelaunay2D")
Source = tested_class("vtkPlanarPointSource")
IN_PYTHON = hasattr(Filter, "_backend")


def place_of_set(of_set, k):
    random = Random(of_set ^ ((0x5851F42D4C957F2D * (k + 1)) & 0xFFFFFFFFFFFFFFFF))
    x = random.unit()
    return x, random.unit()


def uniform(random, _seed):
    x = random.unit()
    return x, random.unit()


def line(random, _seed):
    x = random.unit()
    return x, x + 0.01 * random.bell()


def cross(random, seed):
    x, y = line(random, seed)
    return (x, y) if random.bits() >> 63 else (x, 1.0 - y)


def mixed(random, seed):
    if random.bits() >> 63:
        return uniform(random, seed)
    x, y = place_of_set(seed, random.below(20))
    dx = 0.01 * random.bell()
    return x + dx, y + 0.01 * random.bell()


def utm(random, seed):
    x, y = uniform(random, seed)
    return (50000000.0 + float(int(x * 200000.0))) / 100.0, (450000000.0 + float(int(y * 200000.0))) / 100.0


def tiny(random, _seed):
    x = 1e-300 * (2.0 * random.unit() - 1.0)
    return x, 1e-300 * (2.0 * random.unit() - 1.0)


def make_points(distribution, count, seed=5):
    """makePoints of Testing/Support/Points/Distributions.h."""
    random = Random(seed)
    return [distribution(random, seed) for _ in range(count)]


def cloud(points, number=core.VTK_DOUBLE):
    """A vtkPolyData of points and no cells."""
    made = core.vtkPoints()
    made.SetDataType(number)
    made.SetNumberOfPoints(len(points))
    for i, point in enumerate(points):
        made.SetPoint(i, *point)
    data = model.vtkPolyData()
    data.SetPoints(made)
    return data


def cells_of(lists):
    cells = model.vtkCellArray()
    for ids in lists:
        cells.InsertNextCell(len(ids))
        for point in ids:
            cells.InsertCellPoint(point)
    return cells


def source(points=(), lines=(), polygons=(), verts=(), strips=()):
    data = cloud(points)
    for given, use in (
            (verts, data.SetVerts), (lines, data.SetLines), (polygons, data.SetPolys), (strips, data.SetStrips)):
        if given:
            use(cells_of(given))
    return data


def array(kind, name, values, components=1):
    made = getattr(core, kind)()
    made.SetName(name)
    made.SetNumberOfComponents(components)
    for value in values:
        made.InsertNextValue(value)
    return made


def blocks(*members):
    made = model.vtkMultiBlockDataSet()
    for i, member in enumerate(members):
        made.SetBlock(i, member)
    return made


def ids_of(cells):
    """The ids in each cell of a vtkCellArray."""
    found, ids = [], core.vtkIdList()
    for cell in range(cells.GetNumberOfCells()):
        cells.GetCellAtId(cell, ids)
        found.append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
    return found


def triangles(surface):
    return [tuple(ids) for ids in ids_of(surface.GetPolys())]


def values_of(data):
    """All numbers of a vtkDataArray, tuple after tuple, as doubles."""
    if data.GetNumberOfTuples() == 0:
        return []
    if data.GetDataType() == core.VTK_BIT or not hasattr(data, "GetTuple"):
        return [data.GetValue(i) for i in range(data.GetNumberOfValues())]
    return [number for i in range(data.GetNumberOfTuples()) for number in data.GetTuple(i)]


class Said:
    """Records the warnings and errors of a filter, without file, line and address; `pipeline`, those of its
    executive."""

    def __init__(self, algorithm):
        self.warnings, self.errors, self.pipeline = [], [], []
        lists = {"WarningEvent": self.warnings, "ErrorEvent": self.errors}

        @calldata_type(core.VTK_STRING)
        def keep(_caller, event, text):
            lists[event].append(re.sub(r"^(Warning|ERROR|Error): In .*\n.*?\((0x)?[0-9A-Fa-f]+\): ", "", text).strip())

        @calldata_type(core.VTK_STRING)
        def keep_of_pipeline(_caller, _event, text):
            self.pipeline.append(text)

        for event in lists:
            algorithm.AddObserver(event, keep)
            algorithm.GetExecutive().AddObserver(event, keep_of_pipeline)


def run(data, **settings):
    """A filter with these settings, updated, and its messages."""
    algorithm = Filter()
    said = Said(algorithm)
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    algorithm.SetInputDataObject(data)
    algorithm.Update()
    return algorithm, said


class Case(unittest.TestCase):
    maxDiff = None

    def assertSaid(self, said, warnings=0, errors=0):
        self.assertEqual((len(said.warnings), len(said.errors), said.pipeline), (warnings, errors, []),
                         said.warnings + said.errors)


def write_rows(path, data):
    """As JSON with one line for each row of the first two levels."""
    parts = []
    for key, value in sorted(data.items()):
        if isinstance(value, dict):
            rows = ",\n".join("  %s: %s" % (json.dumps(k), json.dumps(v)) for k, v in sorted(value.items()))
            parts.append("%s: {\n%s\n}" % (json.dumps(key), rows))
        else:
            parts.append("%s: %s" % (json.dumps(key), json.dumps(value)))
    path.write_text("{%s}\n" % ",\n".join(parts), encoding="utf-8")


def run_tests():
    # pvpython and pvbatch leave their own arguments in sys.argv.
    outcome = unittest.main(argv=sys.argv[:1], exit=False).result
    sys.exit(not outcome.wasSuccessful())
