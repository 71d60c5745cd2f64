# SPDX-License-Identifier: BSD-3-Clause
"""A plugin of pytest: scipy's and matplotlib's own tests, of the installed packages, with this package's names in place
of theirs. Each test that fails is listed with its reason, and must fail (but for images)."""

import fnmatch
import importlib
import os
import sys
import types

import adaptivehilbertdelaunay.scipy as ours
import matplotlib
import numpy as np
import pytest

#: Of tests whose names these are, as in "test_qhull.TestDelaunay.test_joggle".
FAIL = {
    "Qhull's diagonal, or its order of triangles and corners": (
        "test_qhull.TestUtilities.test_find_simplex", "test_qhull.TestUtilities.test_convex_hull",
        "test_qhull.TestDelaunay.test_2d_square", "test_triangulation.test_tricontour*_path",
    ),
    "three and more dimensions (test_more_barycentric_transforms: after two, which pass)": (
        "test_qhull.TestUtilities.test_more_barycentric_transforms", "test_qhull.TestDelaunay.test_nd_simplex",
        "test_qhull.TestDelaunay.test_incremental[[]random-[3-8]d-*",
        "test_qhull.TestConvexHull.test_hull_consistency_tri[[]random-[3-8]d*",
        "test_ndgriddata.TestNearestNDInterpolator.test_nearest_options",
        "test_ndgriddata.TestNearestNDInterpolator.test_concurrency",
    ),
    "one dimension": ("test_ndgriddata.TestGriddata.test_1d*",),
    "the hull is exact: 31 slivers along the sides of a rotated grid, of which Qhull leaves 22": (
        "test_qhull.TestUtilities.test_degenerate_barycentric_transforms",
    ),
    "QJ moves no points here, so equal ones stay equal": ("test_qhull.TestDelaunay.test_joggle",),
    "furthest_site is refused": ("test_qhull.TestDelaunay.test_furthest_site",),
    "the nearest in another norm than Euclid's is refused": (
        "test_ndgriddata.TestNearestNDInterpolator.test_nearest_query_options",
    ),
    "a number in place of places is a ValueError, not an IndexError": ("test_qhull.test_gh_21286",),
    "the words of a message": (
        "test_interpnd.*.test_tri_input_rescale",
        "test_interpnd.TestEstimateGradients2DGlobal.test_regression_2359",
        "test_qhull.test_gh_20623[[]Delaunay]",
    ),
}  # fmt: skip
IMAGES = "an image, which the installed package does not have, is compared"
IMAGE_TESTS = ("test_tripcolor", "test_tri_smooth_contouring", "test_tri_smooth_gradient")
LEFT_OUT = {
    "of Qhull's other things": ("TestVoronoi", "Test_HalfspaceIntersection", "Test_Qhull"),
    "needs 10 GB": ("test_threading",),
}


class Names:
    """A module, some names of which are ours."""

    def __init__(self, theirs):
        self._theirs = theirs

    def __getattr__(self, name):
        return getattr(ours if name in ours.__all__ else self._theirs, name)


def triangulated(x, y, _):
    """In place of matplotlib._qhull.delaunay: triangles and neighbours of points, with its exceptions."""
    points = np.stack((np.asarray(x, float), np.asarray(y, float)), axis=1)
    if len(np.unique(points, axis=0)) < 3:
        raise ValueError("fewer than three points")
    made = ours.Delaunay(points).triangulation
    return made.triangles.copy(), made.neighbors.copy()


def substitute():
    """Before any test is collected."""
    interpolators = ("griddata", "NearestNDInterpolator", "LinearNDInterpolator", "CloughTocher2DInterpolator")
    for module, names in (("scipy.interpolate", interpolators), ("scipy.spatial", ("Delaunay",))):
        for name in names:
            setattr(importlib.import_module(module), name, getattr(ours, name))
    importlib.import_module("matplotlib._qhull").delaunay = triangulated
    # Without the images that tests compare with it refuses to be imported.
    folder = os.path.join(os.path.dirname(matplotlib.__file__), "tests")
    package = sys.modules["matplotlib.tests"] = types.ModuleType("matplotlib.tests")
    package.__path__, package.__file__ = [folder], os.path.join(folder, "__init__.py")
    for package, module in (("scipy.spatial", "_qhull"), ("scipy.interpolate", "_interpnd")):
        setattr(importlib.import_module(package), module, Names(importlib.import_module(package + "." + module)))


def name_of(item):
    parts = (item.module.__name__.rpartition(".")[2], item.cls and item.cls.__name__, item.name)
    return ".".join(part for part in parts if part)


def pytest_collection_modifyitems(config, items):
    out = [item for item in items for names in LEFT_OUT.values() if any(name in name_of(item) for name in names)]
    config.hook.pytest_deselected(items=out)
    items[:] = [item for item in items if item not in out]
    for reason, patterns in FAIL.items():
        for pattern in patterns:
            found = [item for item in items if fnmatch.fnmatchcase(name_of(item), pattern)]
            assert found, "no test is called %s" % pattern
            for item in found:
                item.add_marker(pytest.mark.xfail(reason=reason, strict=True))
    for item in items:
        if item.module.__name__ == "matplotlib.tests.test_triangulation" and item.originalname in IMAGE_TESTS:
            item.add_marker(pytest.mark.xfail(reason=IMAGES, raises=OSError))


substitute()
