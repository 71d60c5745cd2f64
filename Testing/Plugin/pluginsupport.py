# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the plugin's tests: the plugin's path, small inputs, and checks with clear messages.

CTest sets the environment (see CMakeLists.txt):
    AHD_PLUGIN       the plugin's shared library, or the plugin in Python
    AHD_PLUGIN_CONF  the file for PV_PLUGIN_CONFIG_FILE
    AHD_SCRATCH      a directory of this test's own, below the build tree
"""

import glob
import hashlib
import json
import math
import os
import pathlib
import random
import subprocess
import sys

PLUGIN = os.environ["AHD_PLUGIN"]
PLUGIN_CONF = os.environ["AHD_PLUGIN_CONF"]
SCRATCH = os.environ["AHD_SCRATCH"]
IS_PYTHON = PLUGIN.endswith(".py")

TABLE = json.loads(
    (pathlib.Path(__file__).resolve().parents[1] / "Support" / "settings.json").read_text(encoding="utf-8")
)


def names_of(table, kind, only=lambda row: row["panel"] != "none"):
    return [name for name, row in TABLE[table][kind].items() if only(row)]


def another(row):
    """A value that is not the panel's default."""
    default = row.get("panel_default", row["default"])
    if row["values"]:
        return row["values"][1 - default if default < 2 else 0]
    if row["type"] in ("bool", "flag"):
        return 0 if default else 1
    if row["type"] == "text":
        return default + "x"
    if isinstance(default, list):
        return [number + 1 for number in default]
    return default + 0.5 if row["type"] == "double" else default + 3


def others(table, names):
    """Of each of these settings such a value."""
    return {name: another(TABLE[table]["settings"][name]) for name in names}


# The properties: settings, measures, those measures that are counts, and the texts of measures in the panel.
SETTINGS = names_of("delaunay", "settings")
MEASURES = names_of("delaunay", "measures", lambda row: True)
COUNTS = names_of("delaunay", "measures", lambda row: row["type"] == "id")
TEXTS = list(TABLE["delaunay"]["texts"])
# Attributes of the plugin in Python alone: in no panel, state or trace.
HIDDEN = ["InsertionLimitRange", "MaximumNumberOfVerticesRange"] if IS_PYTHON else []
# The same of the interpolation: its own settings, those of its triangulation that have an effect, and its measures.
RASTER_SETTINGS = names_of("interpolation", "settings")
RASTER_MEASURES = names_of("interpolation", "measures", lambda row: True)
EXPOSED = [name for name in TABLE["interpolation"]["exposed"] if name != "Transform"]


def class_in_paraview(name):
    """ParaView's name of the class of a proxy with this name."""
    if IS_PYTHON:
        return "%s.%s" % (os.path.splitext(os.path.basename(PLUGIN))[0], name)
    return "vtk" + name


def scratch(name):
    """The path of a file in the test's own directory."""
    os.makedirs(SCRATCH, exist_ok=True)
    return os.path.join(SCRATCH, name)


def check_equal(found, expected, what):
    if found != expected:
        raise AssertionError("%s: found %r, expected %r" % (what, found, expected))


def set_properties(proxy, **values):
    """In this order. (ParaView's own SetProperties is deprecated in 6.1, the method in its place is new.)"""
    for name, value in values.items():
        setattr(proxy, name, value)


def check(condition, what):
    if not condition:
        raise AssertionError(what)


def hill_points(count=400, duplicates=7, seed=1):
    """Points on a hill, x and y in [-2, 2]; the last `duplicates` repeat x and y of the first."""
    draw = random.Random(seed)
    points = [(draw.uniform(-2, 2), draw.uniform(-2, 2)) for _ in range(count - duplicates)]
    points += points[:duplicates]
    return [(x, y, 2.0 / (1.0 + x * x + y * y)) for x, y in points]


def ring(radius, corners=8, clockwise=False, centre=(0.0, 0.0)):
    """The corners of a regular polygon at z = 0, as points; the first is to the right of the centre."""
    turn = (-2 if clockwise else 2) * math.pi / corners
    x, y = centre
    return [(x + radius * math.cos(turn * k), y + radius * math.sin(turn * k), 0.0) for k in range(corners)]


def write_csv(name, points):
    """Writes x, y, z with a header line; returns the path."""
    path = scratch(name)
    with open(path, "w") as file:
        file.write("x,y,z\n")
        file.writelines("%r,%r,%r\n" % point for point in points)
    return path


def write_vtp(name, points, loops=(), lines=()):
    """Writes a .vtp in double precision, with a point array "Height", and polygons and polylines, each a
    list of point ids; returns the path.

    Through VTK's writer, which keeps NaN and infinity."""
    from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    data, heights = vtkPolyData(), vtkDoubleArray()
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    heights.SetName("Height")
    for point in points:
        coordinates.InsertNextPoint(point)
        heights.InsertNextValue(point[2])
    data.SetPoints(coordinates)
    data.GetPointData().AddArray(heights)
    for cells, set_cells in ((loops, data.SetPolys), (lines, data.SetLines)):
        array = vtkCellArray()
        for ids in cells:
            array.InsertNextCell(len(ids), ids)
        set_cells(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(scratch(name))
    # VTK 9.2 cannot read appended data, the default, with newer versions of libexpat.
    writer.SetDataModeToBinary()
    writer.SetInputData(data)
    check(writer.Write(), "could not write " + scratch(name))
    return scratch(name)


def triangles(source):
    """The triangles of a source, as a list of triples of point ids, brought to the client."""
    from paraview import servermanager

    cells = servermanager.Fetch(source).GetPolys()
    result = []
    for i in range(cells.GetNumberOfCells()):
        check_equal(cells.GetCellSize(i), 3, "corners of cell %d" % i)
        result.append(tuple(cell_ids(cells, i)))
    return result


def cell_ids(cells, i):
    from vtkmodules.vtkCommonCore import vtkIdList

    ids = vtkIdList()
    cells.GetCellAtId(i, ids)
    return [ids.GetId(k) for k in range(ids.GetNumberOfIds())]


def fingerprint(source):
    """A hash of the triangles in their order."""
    return hashlib.sha256(repr(triangles(source)).encode()).hexdigest()


def properties(of):
    """The properties of a proxy (an SMProxy) by name."""
    iterator = of.NewPropertyIterator()
    iterator.Begin()
    found = {}
    while not iterator.IsAtEnd():
        found[iterator.GetKey()] = iterator.GetProperty()
        iterator.Next()
    return found


def nested(element):
    return [element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements())] if element else []


def _is_so(decorator, proxy):
    """Is the condition of a decorator met? (An input of several blocks: no test here has one.)"""
    kind = decorator.GetAttribute("type")
    if decorator.GetName() == "Expression":
        return (all if kind == "and" else any)(_is_so(one, proxy) for one in nested(decorator))
    if kind == "CompositeDecorator":
        return all(_is_so(one, proxy) for one in nested(decorator))
    if kind == "InputDataTypeDecorator":
        return False
    item, proxies = proxy.GetProperty(decorator.GetAttribute("property")), []
    if item.IsA("vtkSMProxyProperty"):
        proxies = [item.GetProxy(0).GetXMLName()] if item.GetNumberOfProxies() and item.GetProxy(0) else ["null"]
    shown = proxies or ["%g" % item.GetElement(0)]
    wanted = (decorator.GetAttribute("values") or decorator.GetAttribute("value")).split()
    return (shown[0] in wanted) != (decorator.GetAttribute("inverse") == "1")


def rows_of_panel(proxy):
    """The names of what the panel shows without its advanced properties, by the XML and the values now."""
    shown = []
    for name, item in properties(proxy).items():
        conditions = [one for one in nested(item.GetHints()) if one.GetName() == "PropertyWidgetDecorator"]
        conditions = [one for one in conditions if "visibility" in _modes(one)]
        if name != "Input" and item.GetPanelVisibility() == "default" and all(_is_so(one, proxy) for one in conditions):
            shown.append(name)
    return sorted(shown)


def _modes(decorator):
    return {decorator.GetAttribute("mode")}.union(*map(_modes, nested(decorator)))


def choices(proxy, name):
    domain = proxy.GetProperty(name).FindDomain("vtkSMEnumerationDomain")
    return {domain.GetEntryValue(i): domain.GetEntryText(i) for i in range(domain.GetNumberOfEntries())}


def with_choices(proxy):
    """The names of the properties that have choices."""
    return {name for name, item in properties(proxy).items() if item.FindDomain("vtkSMEnumerationDomain")}


def measures(proxy):
    """The measures of the last run, as ParaView shows them: the update itself must fetch them."""
    proxy.UpdatePipeline()
    return {name: getattr(proxy, name) for name in MEASURES}


def outputs_of_ranks(forget=False):
    """The output so far of each rank that own_output.sh started, one text a rank; or discards it."""
    texts = []
    for path in sorted(glob.glob(scratch("rank.*.log"))):
        if forget:
            os.remove(path)
            continue
        with open(path, errors="replace") as log:
            texts.append(log.read())
    return texts


def run(command, timeout=100, **environment):
    """Runs a command to its end; returns its exit status and its output."""
    done = subprocess.run(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        timeout=timeout,
        env=dict(os.environ, **environment),
        universal_newlines=True,
        errors="replace",
    )
    sys.stdout.write(done.stdout)
    return done.returncode, done.stdout
