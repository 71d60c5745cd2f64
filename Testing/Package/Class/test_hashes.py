# SPDX-License-Identifier: BSD-3-Clause
"""The rows of Data/Hashes/Filter.txt: outputs of the filters and the source of points, the same from the classes in
C++ and from those in Python. The cases of Testing/Filters/Output/TestHashes.cxx; hashedsamples.py has those of the
interpolation."""

from classtests import (HASHES, TABLE, Case, Filter, Hash, Random, Said, Source, array, blocks, cloud, core, cross,
                        make_points, mixed, model, run_tests, source, tested_class, tiny, uniform, utm, values_of, vtk)
from hashedsamples import hashed_samples

Mesh = tested_class("vtkAdaptiveHilbertQualityMesh2D")
MEASURES = (
    "NumberOfPointsInserted", "NumberOfDuplicates", "NumberOfRejectedPoints", "NumberOfSkippedPoints",
    "NumberOfPointsBeyondLimit", "NumberOfTriangles", "NumberOfMergedPoints", "NumberOfAddedPoints",
    "NumberOfConstraintEdges", "NumberOfCrossings", "NumberOfConstraintsLeftOut", "NumberOfUnfilledLoops")


def heights(distribution, count):
    random = Random(3)
    result = [[x, y, 0.1 * x - 0.3 * y + 0.01 * random.unit()] for x, y in make_points(distribution, count)]
    for i in range(count // 10):
        x, y, z = result[i]
        result.append([x, y, z + random.unit()])
    return result


def cloud_of(points, number=core.VTK_DOUBLE):
    made = cloud(points, number)
    made.GetPointData().AddArray(array("vtkDoubleArray", "thirds", [i / 3.0 for i in range(len(points))]))
    return made


def some_lines(points, count):
    random = Random(4)
    many = points.GetNumberOfPoints()
    made = source(lines=[(random.below(many), random.below(many)) for _ in range(count)])
    made.SetPoints(points.GetPoints())
    return made


def tilted():
    transform = vtk("vtkCommonTransforms").vtkTransform()
    transform.SetMatrix(
        (0.36, 0.48, -0.8, 1.5, -0.8, 0.6, 0.0, 0.25, 0.48, 0.64, 0.6, -3.0, 0.0, 0.0, 0.0, 1.0))
    return transform


def plain_cases():
    every = cloud_of(heights(mixed, 1500))
    singles = cloud_of(heights(utm, 1500), core.VTK_FLOAT)
    yield "plain", every, {"CountWork": True}
    yield "float", singles, {}
    yield "tiny", cloud_of(heights(tiny, 300)), {"GenerateVoronoi": True}
    yield "arrays", every, {
        "GenerateFate": True, "GenerateNeighbors": True, "GenerateInsertionRank": True,
        "GenerateInsertionCurve": True, "GenerateBoxes": True, "GenerateVoronoi": True}
    yield "voronoiInBox", singles, {"GenerateVoronoi": True, "VoronoiClip": Filter.CLIP_TO_BOUNDS}
    yield "alpha", every, {"Alpha": 0.02}
    yield "maximumEdgeLength", every, {"MaximumEdgeLength": 0.05}
    yield "tolerance", every, {"Tolerance": 0.01}
    yield "bounding", every, {"BoundingTriangulation": True, "Offset": 1.3}
    yield "meanZ", every, {"DuplicatePolicy": Filter.MEAN_Z}
    yield "highestZ", singles, {"DuplicatePolicy": Filter.HIGHEST_Z}


def planes_and_sources():
    even = cloud_of(heights(uniform, 1200))
    singles = cloud_of(heights(cross, 1200), core.VTK_FLOAT)
    lines = some_lines(even, 30)
    yield "bestFit", even, {"ProjectionPlaneMode": 2}
    yield "bestFitFloat", singles, {"ProjectionPlaneMode": 2}
    yield "transform", even, {"ProjectionPlaneMode": 1, "Transform": tilted()}
    yield "constraints", even, {"SourceData": lines, "GenerateConstraintEdges": True, "GenerateRegionIds": True}
    yield "everyOutput", even, {
        "SourceData": lines, **{name: True for name in TABLE["delaunay"]["settings"] if name.startswith("Generate")}}
    yield "split", even, {"SourceData": lines, "CrossingMode": Filter.SPLIT}
    yield "coordinates", singles, {
        "SourceData": lines, "SourceMode": Filter.SOURCE_COORDINATES, "CrossingMode": Filter.SPLIT}
    yield "blocks", blocks(even, singles), {"MergeBlocks": True}


def add_field_data(sum_, data):
    sum_.add(data.GetNumberOfArrays())
    for i in range(data.GetNumberOfArrays()):
        member = data.GetArray(i)
        sum_.add(*map(ord, member.GetName()))
        sum_.add_doubles(values_of(member))


def add_output(sum_, data):
    sum_.add(data.GetNumberOfPoints())
    for i in range(data.GetNumberOfPoints()):
        sum_.add_doubles(data.GetPoint(i))
    ids = core.vtkIdList()
    for cell in range(data.GetNumberOfCells()):
        data.GetCellPoints(cell, ids)
        many = ids.GetNumberOfIds()
        sum_.add(data.GetCellType(cell), many, *[ids.GetId(k) for k in range(many)])
    add_field_data(sum_, data.GetPointData())
    add_field_data(sum_, data.GetCellData())


def hash_of(given, settings):
    """Run twice, the second time on the kept triangulation."""
    algorithm = Filter()
    Said(algorithm)  # its messages are not printed
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.SetInputDataObject(given)
    algorithm.KeepTriangulationOn()
    sum_ = Hash()
    for _ in range(2):
        algorithm.Update()
        for port in range(algorithm.GetNumberOfOutputPorts()):
            output = algorithm.GetOutputDataObject(port)
            assert isinstance(output, model.vtkPolyData)
            add_output(sum_, output)
        sum_.add(*[getattr(algorithm, "Get" + name)() for name in MEASURES])
        sum_.add_doubles([algorithm.GetNP(), algorithm.GetNR()])
        given.Modified()
    return sum_.text()


def hash_of_source(distribution):
    """Every second with floats."""
    points = Source()
    points.SetDistribution(distribution)
    points.SetOutputPointsPrecision(distribution % 2)
    points.SetNumberOfPoints(40000)
    points.Update()
    sum_ = Hash()
    add_output(sum_, points.GetOutput())
    return sum_.text()


def meshes():
    even = cloud_of(heights(uniform, 400))
    singles = cloud_of(heights(cross, 400), core.VTK_FLOAT)
    even.GetPointData().AddArray(
        array("vtkDoubleArray", "sizes", [0.02 + i / 5000.0 for i in range(even.GetNumberOfPoints())]))
    yield "angle", singles, {"MinimumAngle": 28}, {}
    yield "split", even, {"SourceData": some_lines(even, 12), "MaximumLength": 0.05}, {"CrossingMode": Filter.SPLIT}
    yield "sizes", even, {"SizeArrayName": "sizes", "MaximumNumberOfAddedPoints": 150}, {}
    yield "bestFit", even, {"MaximumArea": 0.002}, {"ProjectionPlaneMode": 2}


def hash_of_mesh(given, settings, of_triangulation):
    algorithm = Mesh()
    Said(algorithm)  # its messages are not printed
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)
    for name, value in of_triangulation.items():
        getattr(algorithm.GetTriangulation(), "Set" + name)(value)
    algorithm.SetInputDataObject(given)
    algorithm.Update()
    sum_ = Hash()
    for port in (0, 1):
        add_output(sum_, algorithm.GetOutput(port))
    add_field_data(sum_, algorithm.GetOutput(0).GetFieldData())
    sum_.add_doubles([algorithm.GetLeastAngle()])
    return sum_.text()


class HashTest(Case):
    def test_rows_of_the_file(self):
        with open(HASHES, encoding="utf-8") as file:
            rows = dict(reversed(line.split()) for line in file if not line.startswith("#"))
        found = {"source/%d" % distribution: hash_of_source(distribution) for distribution in range(7)}
        for cases in (plain_cases(), planes_and_sources()):
            for name, given, settings in cases:
                found["surface/" + name] = hash_of(given, settings)
        found.update(hashed_samples())
        for name, given, settings, of_triangulation in meshes():
            found["mesh/" + name] = hash_of_mesh(given, settings, of_triangulation)
        self.assertEqual(found, rows)


if __name__ == "__main__":
    run_tests()
