# SPDX-License-Identifier: BSD-3-Clause
"""delaunay beside scipy.spatial.Delaunay (Qhull), which is fetched from PyPI into a venv of its own, on points that
have one Delaunay triangulation only and are far from rounding.

    with_scipy.py <folder of the venv>

77 if PyPI is out of reach.
"""

import os
import subprocess
import sys
import unittest

import numpy as np


def reached(folder, check="import scipy", packages=("scipy<1.12",), options=("--system-site-packages",)):
    """The Python of a venv made with these options, with these packages in it, so that it passes the check; None if it
    is not available."""
    python = os.path.join(folder, "bin", "python")
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    commands = [
        [python, "-c", check],
        [sys.executable, "-m", "venv", "--clear", *options, folder],
        [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *packages],
    ]  # fmt: skip
    for command in commands:
        try:
            done = subprocess.run(command, env=clean, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  timeout=240, text=True)  # fmt: skip
        except (OSError, subprocess.TimeoutExpired) as error:
            if command is not commands[0]:
                print(error)
                return None
            continue
        if command is commands[0] and done.returncode == 0:
            return python
        if command is not commands[0] and done.returncode:
            print(done.stdout)
            return None
    return python


def run_with(python_in, file):
    """Runs the tests of a file with the Python in the folder that the command names, and exits as they do. Without that
    Python the exit code is 77, skipped; in continuous integration 1."""
    if "--here" in sys.argv:
        sys.argv.remove("--here")
        unittest.main()
    python = python_in(os.path.abspath(sys.argv[1]))
    if python is None:
        sys.exit(1 if os.environ.get("CI") == "true" else 77)
    sys.exit(subprocess.run([python, file, "--here"], check=False).returncode)


class ScipyTest(unittest.TestCase):
    @staticmethod
    def canonical(triangles):
        """As a set: each from its smallest id on, in order."""
        columns = (triangles.argmin(axis=1)[:, None] + np.arange(3)) % 3
        turned = np.take_along_axis(triangles, columns, axis=1)
        return turned[np.lexsort(turned.T[::-1])]

    def test_the_same_triangles(self):
        from adaptivehilbertdelaunay import delaunay
        from scipy.spatial import Delaunay

        for seed in range(100):
            random = np.random.default_rng(seed)
            points = random.random((int(random.integers(4, 3000)), 2)) * 10.0 ** random.integers(-3, 4)
            ours, theirs = delaunay(points), Delaunay(points)
            corners = points[theirs.simplices]
            one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
            turned = one[:, 0] * two[:, 1] < one[:, 1] * two[:, 0]
            simplices = np.where(turned[:, None], theirs.simplices[:, ::-1], theirs.simplices)
            np.testing.assert_array_equal(self.canonical(ours.triangles), self.canonical(simplices), str(seed))
            places = random.random((200, 2)) * np.ptp(points, axis=0)
            found, expected = ours.locate(places).triangle, theirs.find_simplex(places)
            np.testing.assert_array_equal(found < 0, expected < 0)
            inside = found >= 0
            np.testing.assert_array_equal(
                np.sort(ours.triangles[found[inside]]), np.sort(theirs.simplices[expected[inside]]))  # fmt: skip
            self.assertEqual(set(ours.hull), set(theirs.convex_hull.ravel()))

    def test_the_same_values(self):
        from adaptivehilbertdelaunay import LinearInterpolator, NearestInterpolator
        from scipy.interpolate import LinearNDInterpolator, NearestNDInterpolator

        for seed in range(30):
            random = np.random.default_rng(seed)
            points = random.random((int(random.integers(4, 2000)), 2)) * 10.0 ** random.integers(-3, 4)
            kinds = (random.random(len(points)), random.random((len(points), 2, 3)), random.random(len(points)) * 1j)
            places = random.random((20, 10, 2)) * np.ptp(points, axis=0)
            for values in kinds:
                for args in ((places,), (places[..., 0], places[..., 1]), ((places[:, :, 0], places[0, 0, 1]),)):
                    ours = LinearInterpolator(points, values, fill_value=-5)(*args)
                    theirs = LinearNDInterpolator(points, values, fill_value=-5)(*args)
                    self.assertEqual((ours.shape, ours.dtype), (theirs.shape, theirs.dtype))
                    np.testing.assert_allclose(ours, theirs, atol=1e-9)
                    nearest = NearestNDInterpolator(points, values)(*args)
                    np.testing.assert_array_equal(NearestInterpolator(points, values)(*args), nearest)
            ours, theirs = (
                kind(points * [1, 1e4], kinds[0], rescale=True) for kind in (LinearInterpolator, LinearNDInterpolator)
            )
            np.testing.assert_allclose(ours(places * [1, 1e4]), theirs(places * [1, 1e4]), atol=1e-9)


if __name__ == "__main__":
    run_with(reached, __file__)
