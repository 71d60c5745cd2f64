# SPDX-License-Identifier: BSD-3-Clause
"""The rows of vtkAdaptiveHilbertInterpolation2D in Data/Hashes/Filter.txt: the cases of
Testing/Filters/Sampling/HashedSamples.cxx."""

import math

from classtests import (Filter, Hash, Said, array, cloud, core, cross, line, make_points, mixed, source, tested_class,
                        uniform, utm, values_of)

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
COUNT = 1500


def points_of(distribution, number=core.VTK_DOUBLE):
    made = cloud([(x, y, 0.1 * x - 0.3 * y) for x, y in make_points(distribution, COUNT)], number)
    data = made.GetPointData()
    data.AddArray(array("vtkFloatArray", "f", [i % 7 / 3.0 for i in range(COUNT)]))
    data.AddArray(array("vtkIntArray", "i", [i % 5 for i in range(COUNT)]))
    data.AddArray(array("vtkDoubleArray", "odd", [math.nan if i % 100 == 3 else float(i) for i in range(COUNT)]))
    return made


def cases():
    """Name, input, settings of the interpolation, settings of its triangulation."""
    many, even = points_of(mixed), points_of(uniform)
    breaklines = source(lines=[(0, 700), (5, 900, 30)], polygons=[(11, 222, 333, 444)])
    places = points_of(cross, core.VTK_FLOAT)
    cells = {"RasterSize": [1], "CellSize": [17.3, 21.9], "AlignToCellSize": [True]}
    yield "linear", many, {"GenerateGradients": [True]}, {}
    yield "natural", many, {"Method": [1]}, {}
    yield "laplace", many, {"Method": [2]}, {}
    yield "nearest", many, {"Method": [3]}, {}
    yield "utm", points_of(utm, core.VTK_FLOAT), cells, {}
    yield "surface", many, {"OutputType": [1], "NoValue": [-9999.0]}, {}
    yield "outside", many, {"Outside": [1], "UseBounds": [True], "Bounds": [-1, 2, -1, 2]}, {}
    yield "alpha", many, {}, {"Alpha": 0.05}
    yield "meanZ", many, {}, {"DuplicatePolicy": Filter.MEAN_Z}
    yield "constraints", even, {"SourceData": [breaklines], "Method": [1]}, {}
    yield "split", even, {"SourceData": [breaklines]}, {"CrossingMode": Filter.SPLIT}
    yield "places", even, {"PlacesData": [places], "GenerateGradients": [True]}, {}
    yield "bestFit", even, {"PlacesData": [places]}, {"ProjectionPlaneMode": 2}
    yield "line", points_of(line), {"Method": [2]}, {}


def add_arrays(sum_, data):
    sum_.add(data.GetNumberOfArrays())
    for i in range(data.GetNumberOfArrays()):
        member = data.GetArray(i)
        sum_.add(*map(ord, member.GetName()), member.GetDataType())
        sum_.add_doubles([0.5e-300 if math.isnan(value) else value for value in values_of(member)])


def hash_of(given, settings, of_triangulation):
    """Run twice, the second time on the kept triangulation."""
    algorithm = Interpolation()
    algorithm.SetTriangulation(Filter())
    Said(algorithm)  # its messages are not printed
    for name, values in settings.items():
        getattr(algorithm, "Set" + name)(*values)
    for name, value in of_triangulation.items():
        getattr(algorithm.GetTriangulation(), "Set" + name)(value)
    algorithm.SetInputDataObject(given)
    algorithm.SetDimensions(61, 47)
    sum_ = Hash()
    for _ in range(2):
        algorithm.Update()
        output = algorithm.GetOutputDataObject(0)
        sum_.add(output.GetNumberOfPoints())
        for i in range(output.GetNumberOfPoints()):
            sum_.add_doubles(output.GetPoint(i))
        add_arrays(sum_, output.GetPointData())
        add_arrays(sum_, output.GetFieldData())
        given.Modified()
    return sum_.text()


def hashed_samples():
    return {"sample/" + name: hash_of(*given) for name, *given in cases()}
