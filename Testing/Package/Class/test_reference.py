# SPDX-License-Identifier: BSD-3-Clause
"""The Reference names every setting, measure and array of the classes and every property of ParaView's panel, as these
themselves list them."""

import re
import unittest
import xml.etree.ElementTree

from classtests import FOLDER, TABLE, Filter, Source, cloud, run_tests, source, tested_class, vtk

ROOT = FOLDER.parents[2]
REFERENCE = (ROOT / "Plugin" / "Documentation" / "Reference.md").read_text(encoding="utf-8")
Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
QualityMesh = tested_class("vtkAdaptiveHilbertQualityMesh2D")
BASES = vtk("vtkCommonExecutionModel").vtkPolyDataAlgorithm, vtk("vtkCommonExecutionModel").vtkDataSetAlgorithm
# Of a property of ParaView that is none of a class: how the panel shows others, and the inputs.
OF_PANEL = {"Input", "Surface", "Voronoi", "Values"}


def members(kind, start):
    """The rest after `start` of the names of methods that the class has beyond VTK's."""
    names = {name[len(start):] for name in dir(kind) if re.match(start + "[A-Z]", name) and not any(
        hasattr(base, name) for base in BASES)}  # fmt: skip
    return {name for name in names if not re.search("(M(ax|in)Value|Input|Output|(In|Out)putData)$", name)}


def is_named(name):
    """In code or in quotes, by itself."""
    return re.search(r"`[^`\n]*\b%s\b[^`\n]*`|\"%s\"" % (name, name), REFERENCE) is not None


def names_of(data):
    return {data.GetArrayName(i) for i in range(data.GetNumberOfArrays())}


def all_arrays():
    """The names of all arrays of an execution with everything on."""
    points = [(0, 0, 0), (4, 0, 1), (4, 4, 2), (0, 4, 3), (1, 2, 4), (3, 1, 5), (1, 2, 6)]
    made = []
    for algorithm in (Filter(), Interpolation(), QualityMesh()):
        given = cloud(points)
        for name in members(type(algorithm), "Set"):
            if name.startswith("Generate"):
                getattr(algorithm, "Set" + name)(True)
        algorithm.SetInputDataObject(given)
        algorithm.SetSourceData(source(points, lines=[(0, 2), (1, 3)]))
        algorithm.AddObserver("WarningEvent", lambda *_: None)
        algorithm.Update()
        made += [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]
    assert all(output.GetNumberOfPoints() for output in made)
    return set().union(*(
        names_of(data) for output in made for data in (
            output.GetPointData(), output.GetCellData(), output.GetFieldData())))


class ReferenceTest(unittest.TestCase):
    def check(self, names, least):
        self.assertGreaterEqual(len(names), least)
        self.assertEqual(sorted(name for name in names if not is_named(name)), [])

    def test_settings_and_measures(self):
        for kind, least in ((Filter, 55), (Interpolation, 20), (QualityMesh, 14), (Source, 4)):
            self.check(members(kind, "Get"), least)

    def test_arrays(self):
        names = {name[:-len("Gradient")] if name.endswith("Gradient") else name for name in all_arrays()}
        rows = TABLE["arrays"]
        self.assertLessEqual({name for name in rows if rows[name]["of"] != "ranks"} | {"Elevation"}, names)
        self.check(names | set(rows) | {"Gradient"}, 30)

    def test_settings_that_one_rank_computes(self):
        said = re.search(r"once per filter\.\s+These are: (.*?), and, with constraints", REFERENCE, re.DOTALL)
        rows = TABLE["delaunay"]["settings"]
        self.assertEqual(sorted(re.findall(r"`(\w+)`", said[1])),
                         sorted(name for name in rows if rows[name]["ranks"] == "one"))

    def test_properties_of_the_panel(self):
        tree = xml.etree.ElementTree.parse(ROOT / "Plugin" / "AdaptiveHilbertDelaunay.xml")
        found = set()
        for group in tree.getroot().iter("ProxyGroup"):
            for proxy in group if group.get("name") in ("filters", "sources") else ():
                found |= {item.get("name") for item in proxy if item.tag.endswith("Property")}
        self.check(found - OF_PANEL, 60)


if __name__ == "__main__":
    run_tests()
