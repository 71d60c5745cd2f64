# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's delaunay_2d on vtkAdaptiveHilbertDelaunay2D. Run by with_pyvista.py."""

import contextlib
import io
import unittest

import numpy
import pyvista

from adaptivehilbertdelaunay import drop_in  # after PyVista has taken the name
from algorithmtests import run_tests

STAR = [(1, 1), (5, 0), (1, -1), (0, -5), (-1, -1), (-5, 0), (-1, 1), (0, 5)]  # clockwise


def signed_area(loop):
    x, y = numpy.array(loop, float).T
    return 0.5 * float(numpy.sum(x * numpy.roll(y, -1) - y * numpy.roll(x, -1)))


def flat(*loops):
    """The loops as polygons of one mesh, z = 0."""
    points = [(x, y, 0.0) for loop in loops for x, y in loop]
    faces, first = [], 0
    for loop in loops:
        faces += [len(loop), *range(first, first + len(loop))]
        first += len(loop)
    return pyvista.PolyData(numpy.array(points, float), faces=faces)


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def triangles(mesh):
    return {frozenset(face) for face in mesh.faces.reshape(-1, 4)[:, 1:].tolist()}


def scattered(count, seed=3):
    """Points in a disc and seven around it, so that no triangle at the hull is flat."""
    numbers = numpy.random.default_rng(seed)
    radius, turn = 500 * numpy.sqrt(numbers.random(count)), 2 * numpy.pi * numbers.random(count)
    inner = numpy.c_[radius * numpy.cos(turn), radius * numpy.sin(turn)]
    turn = 2 * numpy.pi * (numpy.arange(7) + 0.1 * numbers.random(7)) / 7
    both = numpy.r_[inner, 1000 * numpy.c_[numpy.cos(turn), numpy.sin(turn)]]
    return numpy.c_[both, 20 * numbers.random(len(both))]


def spiky(numbers, corners, radius, center=(0.0, 0.0)):
    """A counterclockwise polygon that sees all of itself from its center, its corners at 0.2 to 1 radius."""
    turn = 2 * numpy.pi * (numpy.arange(corners) + 0.9 * numbers.random(corners)) / corners
    out = radius * (0.2 + 0.8 * numbers.random(corners))
    return numpy.c_[center[0] + out * numpy.cos(turn), center[1] + out * numpy.sin(turn)]


class ParameterTest(unittest.TestCase):
    def both(self, points, **parameters):
        """The mesh by the adapter and the one by the original."""
        ours = pyvista.PolyData(points).delaunay_2d(**parameters)
        with drop_in.suspended():
            theirs = pyvista.PolyData(points).delaunay_2d(**parameters)
        return ours, theirs

    def test_pyvista_uses_it(self):
        self.assertIs(pyvista.core.filters.poly_data._vtk.vtkDelaunay2D, drop_in.vtkDelaunay2D)

    def test_defaults(self):
        ours, theirs = self.both(scattered(400))
        self.assertEqual(ours.n_cells, 2 * 407 - 2 - 7)
        self.assertEqual(triangles(ours), triangles(theirs))
        self.assertTrue(numpy.array_equal(ours.points, theirs.points))
        self.assertEqual(ours.array_names, theirs.array_names)

    def test_arrays_are_carried_along(self):
        mesh = pyvista.PolyData(scattered(50))
        mesh["height"] = mesh.points[:, 2]
        surface = mesh.delaunay_2d()
        self.assertEqual(surface.array_names, ["height"])
        self.assertTrue(numpy.array_equal(surface["height"], mesh["height"]))

    def test_a_grid_on_a_hill(self):
        """PyVista's own test of delaunay_2d, for more seeds: 722 triangles, none of them a wall."""
        for seed in range(20):
            draw = numpy.random.default_rng(seed).uniform
            x, y = (numpy.linspace(-200, 200, num=20) + draw(-5, 5, size=20) for _ in range(2))
            x, y = numpy.meshgrid(x, y)
            z = 100 * numpy.exp(-0.5 * ((x / 100) ** 2 + (y / 100) ** 2))
            points = numpy.c_[x.ravel(), y.ravel(), z.ravel()]
            self.assertEqual(pyvista.PolyData(points).delaunay_2d().n_cells, 722, seed)

    def test_grids_have_no_walls(self):
        """Elsewhere than in x, y: the triangles of the squares, and no others."""
        noise = numpy.random.default_rng(0).random((10, 10))
        for side, height in (
            (4, lambda x, y: x * y % 3),
            (10, lambda x, y: 0.1 * x),
            (10, lambda x, y: (x + y) // (y + 1)),
            (10, lambda x, y: x * y / 10),
            (10, lambda x, y: noise[x, y]),
        ):
            points = [(x, y, height(x, y)) for x in range(side) for y in range(side)]
            mesh = pyvista.PolyData(numpy.array(points, float))
            for parameters in ({}, {"tol": 1e-3}):
                self.assertEqual(mesh.delaunay_2d(**parameters).n_cells, 2 * (side - 1) ** 2)

    def test_offset(self):
        ours, theirs = self.both(scattered(100), offset=4.0)
        self.assertEqual(triangles(ours), triangles(theirs))

    def test_alpha(self):
        for alpha in (40.0, 80.0):
            ours, theirs = self.both(scattered(300), alpha=alpha)
            self.assertEqual(triangles(ours), triangles(theirs))
            self.assertGreater(ours.n_cells, 10)

    def test_tol(self):
        corners = box(0, 0, 100, 100) + [(50, 40), (50, 41)]
        points = numpy.array([(x, y, 0) for x, y in corners], float)
        for tol, cells in ((0.0, 6), (1e-5, 6), (0.02, 4)):  # of the diagonal, 141.4
            surface = pyvista.PolyData(points).delaunay_2d(tol=tol)
            self.assertEqual((surface.n_cells, surface.n_points), (cells, 6), tol)

    def test_inplace(self):
        mesh = pyvista.PolyData(scattered(50))
        self.assertIs(mesh.delaunay_2d(inplace=True), mesh)
        self.assertEqual(mesh.n_cells, 2 * 57 - 2 - 7)

    def test_progress_bar(self):
        said = io.StringIO()
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
            surface = pyvista.PolyData(scattered(3000)).delaunay_2d(progress_bar=True)
        self.assertEqual(surface.n_cells, 2 * 3007 - 2 - 7)
        self.assertIn("Computing 2D Triangulation", said.getvalue())
        self.assertIn("100%", said.getvalue())

    def test_bound(self):
        """delaunay_2d always requests the best-fitting plane, where there is no bounding triangulation (documented by
        the original, which outputs triangles of points that do not exist)."""
        points = scattered(100)
        surface = pyvista.PolyData(points).delaunay_2d(bound=True)
        self.assertEqual(surface.n_points, len(points))
        self.assertEqual(triangles(surface), triangles(pyvista.PolyData(points).delaunay_2d()))

    def test_edge_source_with_ids_of_some_points(self):
        points = scattered(200)
        mesh = pyvista.PolyData(points)
        a, b = 11, 144
        self.assertFalse(any({a, b} <= corners for corners in triangles(mesh.delaunay_2d())))
        edge = pyvista.PolyData(points, lines=[2, a, b])
        surface = mesh.delaunay_2d(edge_source=edge)
        self.assertEqual(sum({a, b} <= corners for corners in triangles(surface)), 2)
        self.assertEqual(surface.n_cells, 2 * 207 - 2 - 7)


class IssueTest(unittest.TestCase):
    """Constraints reported by users of PyVista; shapes of our own where theirs are long."""

    def check(self, mesh, cells, area):
        surface = mesh.delaunay_2d(edge_source=mesh)
        self.assertEqual((surface.n_cells, surface.n_points), (cells, mesh.n_points))
        self.assertAlmostEqual(surface.area, area, delta=1e-9 * area)

    def test_4097_polygon_with_two_holes(self):
        """An angle with a slit in each arm. VTK 9.1: "Edge not recovered", 11 triangles, area 73.5."""
        angle = [(0, 0), (20, 0), (20, 4), (4, 4), (4, 20), (0, 20)]
        slits = [box(1, 1, 17, 1)[::-1], box(1, 5, 1, 13)[::-1]]
        area = signed_area(angle) + sum(map(signed_area, slits))
        self.check(flat(angle, *slits), 14 - 2 + 2 * 2, area)

    def test_4097_more_holes_than_any(self):
        holes = [box(3 * i + 1, 3 * j + 1, 1, 2)[::-1] for i in range(8) for j in range(8)]
        self.check(flat(box(0, 0, 25, 25), *holes), 4 * 65 - 2 + 2 * 64, 625 - 2 * 64)

    def test_random_polygons_with_holes_on_slopes(self):
        numbers = numpy.random.default_rng(4097)
        for _ in range(60):
            loops = [spiky(numbers, int(numbers.integers(8, 50)), 100)]
            for hole in range(numbers.integers(0, 4)):
                center = (numpy.cos(2.1 * hole), numpy.sin(2.1 * hole))  # all within 2 of (0, 0): inside
                loops.append(spiky(numbers, int(numbers.integers(4, 9)), 0.8, center)[::-1])
            slope = numbers.uniform(-0.6, 0.6, 2)
            mesh = flat(*loops)
            mesh.points[:, 2] = mesh.points[:, :2] @ slope
            area = sum(map(signed_area, loops)) * numpy.sqrt(1 + slope @ slope)
            self.check(mesh, mesh.n_points - 2 + 2 * (len(loops) - 1), area)

    def test_4623_star(self):
        """As reported, clockwise: by the right-hand rule all but the star is kept. VTK 9.1 with the first
        point repeated at the end, as reported: 8 triangles, area 42."""
        star = flat(STAR)
        repeated = pyvista.PolyData(star.points, faces=[9, *range(8), 0])
        for mesh in (star, repeated):
            self.check(mesh, 4, 50 - 20)

    def test_4623_star_counterclockwise(self):
        star = flat(STAR[::-1])
        repeated = pyvista.PolyData(star.points, faces=[9, *range(8), 0])
        for mesh in (star, repeated):
            self.check(mesh, 6, 20)

    def test_4623_star_of_lines(self):
        star = flat(STAR)
        lines = numpy.array([(2, i, (i + 1) % 8) for i in range(8)]).ravel()
        mesh = pyvista.PolyData(star.points, lines=lines)
        self.check(mesh, 10, 50)

    def test_1806_ribbon_in_space(self):
        """A winding ribbon, not quite flat. VTK 9.1 turns its plane upside down and so keeps the outside: 22
        triangles, area 225."""
        turn = numpy.linspace(0, 2 * numpy.pi, 20)
        lower = numpy.c_[10 * turn, 3 * numpy.sin(2 * turn)]
        loop = numpy.r_[lower, lower[::-1] + (0, 1)]
        points = numpy.c_[loop, 0.05 * numpy.sin(loop[:, 0])] + (145, -0.06, 611)
        mesh = pyvista.PolyData(points, faces=[40, *range(40)])
        surface = mesh.delaunay_2d(edge_source=mesh)
        self.assertEqual(surface.n_cells, 38)
        self.assertAlmostEqual(surface.area, signed_area(loop), delta=0.1)

    def test_example_of_the_manual(self):
        square = pyvista.Polygon(n_sides=4, radius=8, fill=False).rotate_z(45, inplace=False)
        centers = ((2, 3, 0), (-2, -3, 0))
        circles = [pyvista.Polygon(center=center, n_sides=30, radius=1) for center in centers]
        both = circles[0] + circles[1] + square
        area = square.bounds[1] ** 2 * 4 - sum(circle.area for circle in circles)
        surface = both.delaunay_2d(edge_source=both)
        self.assertEqual((surface.n_cells, surface.n_points), (66, 64))
        self.assertAlmostEqual(surface.area, area, delta=1e-5 * area)


if __name__ == "__main__":
    run_tests()
