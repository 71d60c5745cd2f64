# SPDX-License-Identifier: BSD-3-Clause
"""No point, one, two, three, some at one place: the results of filter and interpolation, with every method, with and
without values outside, for arrays of several kinds, against the definition.
"""

import itertools
import math

from classtests import Case, Filter, Said, array, cloud, core, run_tests, tested_class, values_of

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
LINEAR, NATURAL, LAPLACE, NEAREST = range(4)
SETS = {
    "none": [], "one": [(3.0, 4.0, 5.0)], "two": [(0.0, 0.0, 1.0), (4.0, 0.0, 2.0)],
    "three": [(0.0, 0.0, 1.0), (4.0, 0.0, 2.0), (0.0, 4.0, 4.0)], "at one place": [(1.0, 1.0, 7.0)] * 3,
    "on a line": [(0.0, 0.0, 1.0), (1.0, 1.0, 2.0), (2.0, 2.0, 3.0), (4.0, 4.0, 9.0)],
}  # fmt: skip
PLACES = [(3.0, 4.0), (0.0, 0.0), (4.0, 0.0), (1.0, 1.0), (-9.0, 2.0), (5.0, 5.0), (3.5, 0.25),
          (math.nan, 1.0)]
KINDS = {"vtkDoubleArray": float, "vtkFloatArray": float, "vtkIntArray": int, "vtkStringArray": str}


def made_of(points):
    data = cloud(points)
    for k, (kind, number) in enumerate(KINDS.items()):
        made = array(kind, "a%d" % k, [number(10 + i) for i in range(len(points))])
        data.GetPointData().AddArray(made)
    return data


def nearest(points, place):
    """The index of the nearest point, of several at one place the first, of several as near that of smallest (x, y)."""
    return min(range(len(points)), key=lambda i: (math.dist(points[i][:2], place), points[i][:2], i))


class FewPointsTest(Case):
    def test_active_attributes_of_empty_arrays(self):
        """Arrays without a value keep their attributes, in each piece."""
        for name in ("none", "two", "three"):
            given = made_of(SETS[name])
            given.GetPointData().SetActiveScalars("a0")
            ids = array("vtkIdTypeArray", "ids", range(len(SETS[name])))
            given.GetPointData().SetGlobalIds(ids)
            for piece in (1, 0, 1):
                for algorithm in (Filter(), Interpolation()):
                    Said(algorithm)
                    algorithm.SetInputDataObject(given)
                    algorithm.UpdatePiece(piece, 2, 0)
                    data = algorithm.GetOutputDataObject(0).GetPointData()
                    active = {data.GetArrayName(i): data.IsArrayAnAttribute(i) for i in range(data.GetNumberOfArrays())
                              if data.IsArrayAnAttribute(i) >= 0}
                    expected = {"a0": 0, "ids": 5} if isinstance(algorithm, Filter) else {"a0": 0}
                    self.assertEqual(active, expected, (name, piece))

    def test_surfaces(self):
        for name, points in SETS.items():
            algorithm = Filter()
            said = Said(algorithm)
            algorithm.SetInputDataObject(made_of(points))
            algorithm.Update()
            output = algorithm.GetOutput()
            self.assertEqual(output.GetNumberOfCells(), 1 if name == "three" else 0, name)
            self.assertEqual(output.GetNumberOfPoints(), len(points), name)
            self.assertEqual((said.errors, said.pipeline), ([], []), name)

    def expected(self, points, place, method, fills):
        """The index of the point whose value is there; None: none; "between"."""
        if not points or math.isnan(place[0]):
            return None
        if method == NEAREST or place in [point[:2] for point in points]:
            return nearest(points, place)
        if self.has_triangle(points) and place[0] >= 0 and place[1] >= 0 and sum(place) <= 4:
            return "between"
        return nearest(points, place) if fills else None

    @staticmethod
    def has_triangle(points):
        return len(points) == 3 and len(set(points)) == 3

    def test_values_between(self):
        for (name, points), method, fills in itertools.product(SETS.items(), range(4), (0, 1)):
            algorithm = Interpolation()
            said = Said(algorithm)
            algorithm.SetInputDataObject(made_of(points))
            algorithm.SetPlacesData(cloud([(*place, 0.0) for place in PLACES]))
            algorithm.SetMethod(method)
            algorithm.SetOutside(fills)
            algorithm.Update()
            self.assertEqual((said.errors, said.pipeline), ([], []), (name, method, fills))
            output = algorithm.GetOutputDataObject(0).GetPointData()
            heights = values_of(output.GetAbstractArray("Elevation"))
            numbers = [values_of(output.GetAbstractArray("a%d" % k)) for k in range(3)] if points else []
            for i, place in enumerate(PLACES):
                about = (name, method, fills, place)
                where = self.expected(points, place, method, fills)
                if where is None:
                    self.assertTrue(math.isnan(heights[i]), about)
                elif where != "between":
                    self.assertEqual(heights[i], points[where][2], about)
                    for values in numbers:
                        self.assertEqual(values[i], 10 + where, about)
                else:
                    self.assertAlmostEqual(heights[i], 1 + place[0] / 4 + 3 * place[1] / 4, delta=1e-12, msg=about)
            self.assertEqual(core.VTK_DOUBLE, output.GetAbstractArray("Elevation").GetDataType())


if __name__ == "__main__":
    run_tests()
