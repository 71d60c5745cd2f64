# SPDX-License-Identifier: BSD-3-Clause
"""adaptivehilbertdelaunay.scipy beside scipy, and what to_matplotlib() makes in matplotlib."""

import doctest
import pathlib
import re
import subprocess
import sys

import matplotlib.figure
import matplotlib.pyplot
import matplotlib.tri
import numpy as np
import pytest
import scipy.interpolate
import scipy.spatial

import adaptivehilbertdelaunay.scipy as ours
from adaptivehilbertdelaunay import delaunay

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "Filters" / "Python" / "ComingFrom.md"
CASES = [(seed, count) for seed in range(2) for count in (3, 4, 10, 100, 800)]


def case(seed, count):
    """Points, values of two columns, one of them complex, and places in and around them."""
    random = np.random.default_rng(seed)
    points = random.random((count, 2)) * [3, 1] + [0, 5]
    values = np.stack((np.sin(4 * points[:, 0]), points[:, 1] ** 2 * 1j + random.random(count)), axis=1)
    return points, values, random.random((600, 2)) * [3.4, 1.4] + [-0.2, 4.8]


@pytest.mark.parametrize("rescale", (False, True))
@pytest.mark.parametrize("seed, count", CASES)
def test_the_same_values(seed, count, rescale):
    points, values, places = case(seed, count)
    for name, more in (("LinearND", {}), ("CloughTocher2D", {"tol": 1e-11})):
        mine, theirs = (
            getattr(module, name + "Interpolator")(points, values, fill_value=-7, rescale=rescale, **more)(places)
            for module in (ours, scipy.interpolate)
        )
        assert mine.dtype == theirs.dtype
        np.testing.assert_allclose(mine, theirs, rtol=1e-7, atol=1e-7)
    mine, theirs = (
        module.NearestNDInterpolator(points, values, rescale=rescale)(places) for module in (ours, scipy.interpolate)
    )
    np.testing.assert_array_equal(mine, theirs)
    for method in ("linear", "nearest", "cubic"):
        mine, theirs = (
            module.griddata(points, values.real, places.reshape(20, 30, 2), method, rescale=rescale)
            for module in (ours, scipy.interpolate)
        )
        np.testing.assert_allclose(mine, theirs, rtol=1e-4, atol=1e-4)


@pytest.mark.parametrize("seed, count", CASES)
def test_the_same_triangulation(seed, count):
    points, _, places = case(seed, count)
    mine, theirs = ours.Delaunay(points), scipy.spatial.Delaunay(points)
    key, found = ([frozenset(row) for row in made.simplices.tolist()] for made in (mine, theirs))
    row_of = {corners: row for row, corners in enumerate(found)}
    rows = np.array([row_of[corners] for corners in key] + [-1])
    assert sorted(rows[:-1]) == list(range(theirs.nsimplex)), "the triangles"
    np.testing.assert_array_equal(rows[mine.find_simplex(places)], theirs.find_simplex(places))
    for row, corners, beyond in zip(rows, mine.simplices, mine.neighbors):
        at = dict(zip(theirs.simplices[row].tolist(), theirs.neighbors[row].tolist()))
        assert [at[corner] for corner in corners.tolist()] == rows[beyond].tolist()
    assert set(map(frozenset, mine.convex_hull.tolist())) == set(map(frozenset, theirs.convex_hull.tolist()))
    for name in ("simplices", "neighbors", "transform", "equations", "vertex_to_simplex", "coplanar", "min_bound"):
        assert getattr(mine, name).dtype == getattr(theirs, name).dtype, name
        assert getattr(mine, name).shape == getattr(theirs, name).shape, name
    centres = points[mine.simplices].mean(axis=1)
    for made in (mine, theirs):
        at = centres if made is mine else points[made.simplices].mean(axis=1)
        weights = np.einsum("ijk,ik->ij", made.transform[:, :2], at - made.transform[:, 2])
        np.testing.assert_allclose(weights, 1 / 3, atol=1e-6)
    for own, other in zip(mine.vertex_neighbor_vertices, theirs.vertex_neighbor_vertices):
        assert own.dtype == other.dtype and own.shape == other.shape
    np.testing.assert_array_equal(mine.max_bound, theirs.max_bound)


def test_shapes_of_results():
    points, values, _ = case(1, 50)
    for name in ("LinearNDInterpolator", "CloughTocher2DInterpolator", "NearestNDInterpolator"):
        for rows in (values.real[:, 0], values.real, values.real.reshape(50, 2, 1), np.arange(50)):
            mine, theirs = (getattr(module, name)(points, rows) for module in (ours, scipy.interpolate))
            for place in ((1, 5), ([1, 5],), ((1, 5),), ([[1, 5]],), ([1, 2], 5), (([1, 2], 5),), ([1, 5, 2, 5.5],),
                          (np.ones((2, 3)), np.full((2, 1), 5.5)), ([],), (np.empty((0, 2)),)):  # fmt: skip
                own, other = mine(*place), theirs(*place)
                assert (own.shape, own.dtype) == (other.shape, other.dtype), (name, rows.shape, place)


def test_gradients_within_tolerance():
    """For the tolerance that users have, the same gradients to it."""
    points, values, _ = case(2, 2000)
    made = ours.estimate_gradients_2d_global(ours.Delaunay(points), values.real)
    exact = scipy.interpolate.CloughTocher2DInterpolator(points, values.real, tol=1e-12).grad
    assert (abs(made - exact) / np.maximum(1, abs(exact))).max() < 3e-6


def in_order(array):
    """Rows, each in order, in order."""
    rows = np.sort(np.atleast_2d(array), axis=1)
    return rows[np.lexsort(rows.T)]


def size(places, isArea):
    steps = np.diff(places, axis=0)
    if isArea:
        return (places[:-1, 0] * steps[:, 1] - places[:-1, 1] * steps[:, 0]).sum() / 2
    return np.hypot(*steps.T).sum()


def drawn_sizes(drawn):
    """The area of each band, or the length of each level's lines, that matplotlib draws."""
    parts = [path.to_polygons(closed_only=drawn.filled) for path in drawn.get_paths()]
    return [abs(sum(size(part, drawn.filled) for part in level)) for level in parts]


def sizes(contours):
    """The same of contours()."""
    features = contours.__geo_interface__["features"]
    isArea = "lower" in features[0]["properties"]
    levels = [one["geometry"]["coordinates"] for one in features]
    levels = [[part for polygon in level for part in polygon] for level in levels] if isArea else levels
    return [sum(size(np.array(part), isArea) for part in level) for level in levels]


def test_the_page_for_users_of_others():
    """Both sides of each row of its tables of scipy and matplotlib."""
    text = PAGE.read_text(encoding="utf-8")
    names = {"scipy": scipy, "matplotlib": matplotlib}
    for example in doctest.DocTestParser().get_examples(text):
        exec(example.source, names)
    compared = 0
    for heading, rows in re.findall(r"^\| (?:scipy|matplotlib) \(`(.*)`\) \|.*\n((?:\|.*\n)*)", text, re.MULTILINE):
        exec(heading, names)
        for theirs, own, remark in re.findall(r"^\| `(.*?)` \| `(.*?)` \|(.*)\|$", rows, re.MULTILINE):
            left, right = eval(theirs, names), eval(own, names)
            if remark.startswith(" in another order"):
                left, right = in_order(left), in_order(right)
                if "neighbors" in theirs:  # are numbers of triangles
                    left, right = left.shape, right.shape
            if remark.startswith(" from another point on"):
                left, right = np.sort(left), np.sort(right)
            if "contour" in theirs:
                left, right = drawn_sizes(left), sizes(right)
            if not remark.startswith(" other triangles"):
                close = 1e-4 if "CubicTri" in theirs else 1e-9  # its gradients depend on the order of triangles
                np.testing.assert_allclose(left, right, rtol=close, err_msg=theirs)
                compared += 1
    assert compared == 21


def test_flat_areas_at_a_level():
    """As the page says: of the band below, with lines where it is higher; matplotlib's are of the band above."""
    points = np.array([[0, 0], [1, 0], [0, 1], [2, 2], [-1, -1]], float)
    values = [1, 1, 1, 2, 0]
    made = delaunay(points)
    tri = made.to_matplotlib()
    bands, lines = made.contours(values, [0, 1, 2], filled=True), made.contours(values, [1])
    theirs = matplotlib.pyplot.tricontourf(tri, values, levels=[0, 1, 2])
    np.testing.assert_allclose(np.subtract(drawn_sizes(theirs), sizes(bands)), [-0.5, 0.5])
    np.testing.assert_allclose(sizes(lines), [2**0.5])
    np.testing.assert_allclose(drawn_sizes(matplotlib.pyplot.tricontour(tri, values, levels=[1])), [2])


# --- matplotlib ---------------------------------------------------------------------------------------------


def rotated(side, degrees=30):
    """A rotated grid: slivers along its sides."""
    angle = np.radians(degrees)
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    return np.stack((x.ravel(), y.ravel()), axis=1) @ [[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]


@pytest.mark.parametrize("side", (10, 20, 40))
def test_slivers_along_the_rim(side):
    points = rotated(side)
    made = delaunay(points)
    shown = made.to_matplotlib()
    assert isinstance(shown, matplotlib.tri.Triangulation)
    centre, places = points.mean(axis=0), np.random.default_rng(1).random((500, 2)) * side * 2 - side
    height = points @ [2, 3]
    for kind in (matplotlib.tri.LinearTriInterpolator, matplotlib.tri.CubicTriInterpolator):
        inside = kind(shown, height)(*(centre + (places - places.mean(axis=0)) / 8).T)
        np.testing.assert_allclose(inside, (centre + (places - places.mean(axis=0)) / 8) @ [2, 3], rtol=1e-9)
    np.testing.assert_array_equal(shown.get_trifinder()(*places.T), made.locate(places).triangle)
    np.testing.assert_array_equal(shown.neighbors, made.neighbors)


def test_matplotlibs_own_finder_refuses_them():
    """Else there is no need for the exact one."""
    points = rotated(10)
    theirs = matplotlib.tri.Triangulation(*points.T, delaunay(points).triangles)
    with pytest.raises(RuntimeError, match="invalid"):
        theirs.get_trifinder()


def test_masks():
    x, y = (a.ravel() for a in np.meshgrid(np.arange(6.0), np.arange(6.0)))
    made = delaunay(np.stack((x, y), axis=1))
    random = np.random.default_rng(3)
    places = random.integers(-1, 12, (400, 2)) / 2  # corners, middles of edges, insides
    around = {tuple(place): [] for place in places}
    for row, corners in enumerate(made.triangles):
        a, b, c = made.points[corners]
        for place in around:
            turns = [(q - p)[0] * (place - p)[1] - (q - p)[1] * (place - p)[0] for p, q in ((a, b), (b, c), (c, a))]
            if min(turns) >= 0:
                around[place].append(row)
    shown = made.to_matplotlib(np.zeros(len(made.triangles), bool))
    finder = shown.get_trifinder()
    for _ in range(20):
        mask = random.random(len(made.triangles)) < 0.7
        shown.set_mask(mask)
        for place, row in zip(places, finder(*places.T)):
            left = [k for k in around[tuple(place)] if not mask[k]]
            assert row in left if left else row == -1
    assert finder(*places.T.reshape(2, 20, 20)).shape == (20, 20)


def test_points_that_are_not_finite():
    points = np.random.default_rng(1).random((50, 2))
    points[7], points[9, 0] = np.nan, np.inf
    with pytest.warns(UserWarning, match="rejected"):
        shown = delaunay(points).to_matplotlib()
    axes = matplotlib.figure.Figure().add_subplot()
    for plot in (axes.tripcolor, axes.tricontourf):
        plot(shown, np.arange(50))
        assert axes.get_xlim() == pytest.approx((0, 1), abs=0.2) and axes.get_xlim()[1] > 0.8


def test_plots_and_refusals():
    figure = matplotlib.figure.Figure()
    axes = figure.add_subplot()
    points = np.random.default_rng(5).random((300, 2))
    made = delaunay(points, loops=[[0, 1, 2]])
    shown = made.to_matplotlib()
    axes.tripcolor(shown, points[:, 0])
    axes.triplot(shown)
    whole = delaunay(points)
    axes.tricontourf(whole.to_matplotlib(mask=np.arange(len(whole.triangles)) % 7 == 0), points[:, 1])
    figure.canvas.draw()
    with pytest.raises(ValueError, match="same length"):
        made.to_matplotlib(mask=[True])
    with pytest.warns(UserWarning), pytest.raises(ValueError, match="no triangles"):
        delaunay(points[:2]).to_matplotlib()
    with pytest.raises(ValueError, match="of one shape"):
        shown.get_trifinder()([1, 2], [1])


def test_the_example(tmp_path):
    """With scipy's imports it says the same, up to what scipy does not have."""
    bay, picture = ROOT / "Data" / "Bay", tmp_path / "bay.png"
    example = ROOT / "Plugin" / "Examples" / "bay_scipy.py"
    command = [sys.executable, example, bay / "soundings.csv", bay / "coastline.vtp", picture]
    said = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    assert len(said) == 3 and picture.stat().st_size > 30000
    text, imports = example.read_text(encoding="utf-8"), re.compile("from adaptivehilbertdelaunay.scipy import .*")
    theirs = "\n".join(re.findall("^    (from scipy.* import .*)$", text, re.MULTILINE))
    program = imports.sub(theirs, text).split("# What scipy does not have")[0]
    command = [sys.executable, "-c", program, bay / "soundings.csv", bay / "coastline.vtp", picture]
    assert subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines() == said[:2]
