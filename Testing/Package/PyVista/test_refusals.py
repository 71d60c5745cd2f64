# SPDX-License-Identifier: BSD-3-Clause
"""mesh.adaptive: the text of each refusal, word for word; none is left out."""

import inspect
import sys
import unittest
from pathlib import Path

import numpy
import pyvista

import adaptivehilbertdelaunay.pyvista  # noqa: F401 (registers mesh.adaptive)
from adaptivehilbertdelaunay._keywords import MESH_KEYWORDS

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import literals  # noqa: E402

POINTS = numpy.array([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (1, 2, 0), (3, 2, 0)], float)
MESH = pyvista.PolyData(POINTS)
CHOICES = {name: ", ".join(map(repr, row.words)) for name, row in MESH_KEYWORDS.items()
           if row.words and name in inspect.signature(MESH.adaptive.delaunay_2d).parameters}  # fmt: skip
CHOICES["plane"] = "'xy', 'automatic', 'best_fit'"
# (method, arguments, exception, text)
ROWS = [
    ("delaunay_2d", dict(arrays=["fate"]), ValueError,
     "arrays: no 'fate'; there are 'status', 'errors', 'rank', 'constraint_edges', 'regions', 'neighbors'"),
    ("delaunay_2d", dict(weights=3), TypeError, "weights must be the name of a point array, a str, not 3"),
    ("delaunay_2d", dict(weights="w"), ValueError, "weights: the points have no array 'w'; there are []"),
    ("delaunay_2d", dict(threads=1.5), TypeError, "threads must be a whole number, not 1.5"),
    ("delaunay_2d", dict(threads=-1), ValueError, "threads must be from 0 to 1024, not -1"),
    ("delaunay_2d", dict(threads=1025), ValueError, "threads must be from 0 to 1024, not 1025"),
    ("delaunay_2d", dict(memory_limit=-1), ValueError,
     "memory_limit must be from 0 to 9223372036854775807, not -1"),
    ("delaunay_2d", dict(memory_limit="much"), TypeError,
     "memory_limit must be a whole number of bytes, or a text such as '2 GB', not 'much'"),
    ("delaunay_2d", dict(memory_limit=2**63), ValueError,
     "memory_limit must be from 0 to 9223372036854775807, not 9223372036854775808"),
    ("delaunay_2d", dict(edge_source=MESH, constraints=MESH), ValueError,
     "edge_source refers to the mesh's points, constraints have their own: give one of them"),
    ("delaunay_2d", dict(tol="a"), TypeError, "tol must be a number from 0 to 1, not 'a'"),
    ("delaunay_2d", dict(tol=2), ValueError, "tol must be a number from 0 to 1, not 2"),
    ("delaunay_2d", dict(alpha=-1), ValueError, "alpha must be a number from 0 to inf, not -1"),
    ("delaunay_2d", dict(offset=0.5), ValueError, "offset must be a number from 0.75 to 1.7e+308, not 0.5"),
    ("delaunay_2d", dict(maximum_edge_length=numpy.nan), ValueError,
     "maximum_edge_length must be a number from 0 to inf, not nan"),
    ("delaunay_2d", dict(constraints=MESH.cast_to_unstructured_grid()), TypeError,
     "constraints must be a pyvista.PolyData, or a MultiBlock of these, not UnstructuredGrid"),
    ("delaunay_2d", dict(constraints=7), TypeError,
     "constraints must be a geometry (shapely, geopandas, GeoJSON, anything with __geo_interface__), a ring as an "
     "array of shape (k, 2) or (k, 3), or a sequence of these, not int"),
    ("delaunay_2d", dict(edge_source=MESH.cast_to_unstructured_grid()), TypeError,
     "edge_source must be a pyvista.PolyData, or a MultiBlock of these, not UnstructuredGrid"),
    ("delaunay_2d", dict(plane=3), TypeError,
     "plane must be one of 'xy', 'automatic', 'best_fit', or a vtkAbstractTransform, not 3"),
    ("to_raster", dict(), ValueError, "the raster needs a size: give cell_size, or shape=(rows, columns)"),
    ("to_raster", dict(cell_size=1, shape=(2, 2)), ValueError,
     "the raster needs a size: give cell_size, or shape=(rows, columns)"),
    ("to_raster", dict(shape=(2, 2), align=True), ValueError,
     "align needs cell_size, but shape is given"),
    ("to_raster", dict(cell_size=1, bounds=(0, 0, 0, 1)), ValueError, "bounds must have an area, not (0, 0, 0, 1)"),
    ("to_raster", dict(cell_size=1, bounds=(0, 1, 1, 1)), ValueError, "bounds must have an area, not (0, 1, 1, 1)"),
    ("to_raster", dict(cell_size=1, bounds=(1, 0, 0, 1)), ValueError,
     "bounds must be xmin, xmax, ymin, ymax, finite and ascending, not (1, 0, 0, 1)"),
    ("to_raster", dict(cell_size=1, elevation=7), TypeError, "elevation must be a name, a str, not 7"),
    ("to_raster", dict(cell_size=1, colour=7), TypeError,
     "to_raster() got an unexpected keyword argument 'colour'"),
    ("to_raster", dict(cell_size=1, method="cubic"), ValueError,
     "method='cubic': it is one of 'linear', 'natural', 'laplace', 'nearest'"),
    ("to_raster", dict(cell_size=1, outside="far"), ValueError,
     "outside='far': it is one of 'none', 'nearest', 'boundary'"),
    ("voronoi_2d", dict(clip="box"), ValueError, "clip='box': it is one of 'hull', 'bounds'"),
    ("voronoi_2d", dict(clip=(0, 0, 1, 1)), ValueError,
     "clip must be 'hull', 'bounds' or corners, of shape (n, 2); of a box two, not (0, 0, 1, 1)"),
    ("voronoi_2d", dict(clip=[[0, 0], [1, 0], [2, 0]]), ValueError,
     "clip has no area, but it must be two opposite corners of a box, or the corners of a convex polygon in their "
     "order. Nothing was computed."),
    ("refine", dict(sizes="side"), ValueError, "sizes: the points have no array 'side'"),
    ("refine", dict(sizes=[1.0]), ValueError, "sizes must be one number for each of 6 points, not of shape (1,)"),
    ("refine", dict(sizes=[1.0] * 5 + [0.0]), ValueError,
     "The size at point 5 is 0.000000: sizes must be finite and above 0. Nothing was computed."),
    ("refine", dict(minimum_angle=35), ValueError, "minimum_angle must be a number from 0 to 34, not 35"),
    ("refine", dict(maximum_area=0), ValueError, "maximum_area must be a finite number greater than 0, not 0"),
    ("refine", dict(maximum_added=-1), ValueError, "maximum_added must be a whole number, 0 or more, not -1"),
    ("outline", dict(groups="side"), ValueError, "groups: the cells have no array 'side'; there are []"),
    ("sample", dict(places=pyvista.MultiBlock([MESH])), TypeError,
     "places are one mesh or an array, not a MultiBlock: its combine() is one mesh"),
    ("sample", dict(places=numpy.zeros((2, 4))), ValueError,
     "places are a mesh or an array of shape (k, 2) or (k, 3), not (2, 4)"),
    ("sample", dict(places=numpy.zeros(4)), ValueError,
     "places are a mesh or an array of shape (k, 2) or (k, 3), not (4,)"),
]
ROWS += [("delaunay_2d", {name: "?"}, ValueError, "%s='?': it is one of %s" % row) for name, row in zip(
    CHOICES, CHOICES.items())]  # fmt: skip
OF_OTHERS = [  # (mesh, method, arguments, exception, text)
    (pyvista.ImageData(dimensions=(3, 3, 1)), "delaunay_2d", {}, TypeError,
     "a mesh with points of its own is needed, not ImageData; cast_to_structured_grid() or "
     "cast_to_unstructured_grid() give it some"),
    (MESH.cast_to_unstructured_grid(), "delaunay_2d", dict(inplace=True), TypeError,
     "inplace: a pyvista.PolyData can be overwritten, not UnstructuredGrid"),
    (pyvista.MultiBlock([MESH]), "refine", dict(sizes=[1.0] * 6), TypeError,
     "sizes of a MultiBlock are the name of an array that its blocks have"),
    (MESH.cast_to_unstructured_grid(), "outline", {}, TypeError,
     "an outline is that of a pyvista.PolyData, not of UnstructuredGrid: extract_surface() makes one"),
]


class RefusalsTest(unittest.TestCase):
    def test_each_says_why(self):
        for mesh, method, given, error, text in OF_OTHERS + [(MESH, *row) for row in ROWS]:
            with self.assertRaises(error, msg=(method, given)) as caught:
                getattr(mesh.adaptive, method)(**given)
            self.assertEqual(str(caught.exception), text)
        self.assertTrue(numpy.array_equal(MESH.points, POINTS))
        self.assertEqual(MESH.array_names, [])

    def test_none_is_left_out(self):
        said = [row[-1] for row in OF_OTHERS + ROWS]
        pieces = list(literals.pieces_of_refusals("_meshes.py"))
        self.assertGreater(len(pieces), 10)
        for line, piece in pieces:
            self.assertTrue([text for text in said if piece in text], (line, piece))

    def test_every_choice_is_taken(self):
        for name, words in CHOICES.items():
            for word in words.replace("'", "").split(", "):
                self.assertEqual(MESH.adaptive.delaunay_2d(**{name: word}).n_cells, 6, (name, word))

    def test_the_ends_of_ranges_are_taken(self):
        for given in (dict(threads=0), dict(threads=1024), dict(memory_limit=0), dict(memory_limit=2**63 - 1)):
            self.assertEqual(MESH.adaptive.delaunay_2d(**given).n_cells, 6, given)


if __name__ == "__main__":
    outcome = unittest.main(argv=sys.argv[:1], exit=False).result
    sys.exit(not outcome.wasSuccessful())
