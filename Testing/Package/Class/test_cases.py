# SPDX-License-Identifier: BSD-3-Clause
"""The results of many inputs and settings, good and bad, as in Cases.json by the compiled class: messages word
for word, measures, and of each output the points, cells and arrays with their types and a hash of their values.
AHD_WRITE_HASHES=1 with the compiled class writes the file anew."""

import json
import re

import cases
import heightcases
import simplifiedcases
import sourcecases
from classtests import (BACKEND, FOLDER, TABLE, WRITES, Case, Filter, Hash, Said, core, model, run_tests, values_of,
                        write_rows)

FILE = FOLDER / "Cases.json"
# Counts are in the field data, too: these rows are to be read.
COUNTS = (
    "NumberOfPointsInserted", "NumberOfDuplicates", "NumberOfRejectedPoints", "NumberOfSkippedPoints",
    "NumberOfPointsBeyondLimit", "NumberOfPointsWithinError", "NumberOfTriangles", "NumberOfMergedPoints",
    "NumberOfAddedPoints",
    "NumberOfConstraintEdges", "NumberOfCrossings", "NumberOfConstraintsLeftOut", "NumberOfUnfilledLoops",
    "NumberOfTrimmedTriangles", "NumberOfTriangulations")
MEANS = tuple(name for name, row in TABLE["delaunay"]["measures"].items()
              if row["type"] == "double" and not name.endswith("Seconds"))


def type_name(data):
    if not data.IsNumeric():
        return data.GetDataTypeAsString()
    size = data.GetDataTypeSize() * 8
    if data.GetDataType() == core.VTK_ID_TYPE:
        return "id"
    names = r"^(unsigned )?(int|long|long long|short|char|signed char|float|double)$"  # one type in several names
    word = re.sub(names, r"\1number", data.GetDataTypeAsString())
    return word + str(size) + ("f" if data.GetDataType() in (core.VTK_FLOAT, core.VTK_DOUBLE) else "")


def of_array(data):
    """Type, components, tuples, hash of its values."""
    sum_ = Hash()
    if data.IsNumeric():
        sum_.add_doubles(values_of(data))
    else:
        sum_.add_bytes("|".join(data.GetValue(i) for i in range(data.GetNumberOfValues())).encode())
    return "%s %dx%d %s" % (type_name(data), data.GetNumberOfTuples(), data.GetNumberOfComponents(), sum_.text())


def of_attributes(data):
    rows = {}
    for i in range(data.GetNumberOfArrays()):
        member = data.GetAbstractArray(i)
        use = data.IsArrayAnAttribute(i) if hasattr(data, "IsArrayAnAttribute") else -1
        rows[member.GetName()] = of_array(member) + (" attribute %d" % use if use >= 0 else "")
    return rows


def of_output(data):
    if not isinstance(data, model.vtkPolyData):
        if not hasattr(data, "GetNumberOfBlocks"):
            return str(type(data).__name__)
        return [of_output(data.GetBlock(i)) for i in range(data.GetNumberOfBlocks())]
    found = {"points": of_array(data.GetPoints().GetData()) if data.GetNumberOfPoints() else 0}
    for kind in ("Verts", "Lines", "Polys", "Strips"):
        cells = getattr(data, "Get" + kind)()
        if cells.GetNumberOfCells():
            found[kind] = of_array(cells.GetOffsetsArray()) + ", " + of_array(cells.GetConnectivityArray())
    for kind in ("PointData", "CellData", "FieldData"):
        if kind == "FieldData" and "points" in found and not found["points"]:
            continue  # its rest in an output that was initialized depends on VTK
        rows = of_attributes(getattr(data, "Get" + kind)())
        found.update({kind: rows} if rows else {})
    return found


def masked(text):
    """Without sizes of memory, which another layout of it changes."""
    text = re.sub(r"[\d.]+ (bytes|KB|MB|GB|TB|PB|EB)\b", "# bytes", text)
    return re.sub(r"\d+ (boxes|places|or more)", r"# \1", text)


def record(given, settings):
    algorithm = Filter()
    said = Said(algorithm)
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    algorithm.SetInputDataObject(given)
    algorithm.Update()
    measures = {name: getattr(algorithm, "Get" + name)() for name in COUNTS + MEANS}
    found = {
        "warnings": [masked(text) for text in said.warnings], "errors": [masked(text) for text in said.errors],
        "pipeline": len(said.pipeline),
        "measures": {name: value for name, value in measures.items() if value not in (0, -1.0)},
        "outputs": outputs_of(algorithm)}
    algorithm.Modified()
    algorithm.Update()
    found["again"] = outputs_of(algorithm) == found["outputs"] and len(said.warnings) == 2 * len(found["warnings"])
    return found


def outputs_of(algorithm):
    return [of_output(algorithm.GetOutputDataObject(port)) for port in range(3)]


class CasesTest(Case):
    def test_all(self):
        found = {}
        for name, make in {**cases.CASES, **heightcases.CASES, **sourcecases.CASES, **simplifiedcases.CASES}.items():
            try:
                given = make()
            except AttributeError as error:  # cvista leaves out some classes
                self.assertIn("has no attribute 'vtk", str(error))
                continue
            found[name] = json.loads(json.dumps(record(*given)))
        if WRITES:
            write_rows(FILE, {"cases": found})
        expected = json.loads(FILE.read_text(encoding="utf-8"))["cases"]
        self.assertGreaterEqual(len(found), len(expected) - 3 * (BACKEND == "cvista"))
        for name, row in found.items():
            with self.subTest(name):
                self.assertEqual(row, expected[name])
                self.assertTrue(row["again"])


if __name__ == "__main__":
    run_tests()
