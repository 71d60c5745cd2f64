# SPDX-License-Identifier: BSD-3-Clause
"""scipy's and matplotlib's own tests on this package's names (substitute.py), and this package beside both. Run by
with_pyvista.py."""

import os
import sys

import pytest

FOLDER = os.path.dirname(os.path.abspath(__file__))
FOREIGN = (
    "scipy.spatial.tests.test_qhull", "scipy.interpolate.tests.test_interpnd",
    "scipy.interpolate.tests.test_ndgriddata", "matplotlib.tests.test_triangulation",
)  # fmt: skip

if __name__ == "__main__":
    os.environ["MPLBACKEND"] = "agg"
    options = ["-q", "-rx", "--tb=short", "-p", "no:cacheprovider", "--rootdir", os.getcwd()]
    beside = pytest.main([*options, os.path.join(FOLDER, "beside.py"), "-o", "python_files=beside.py"])
    own = pytest.main([*options, "-p", "substitute", "--pyargs", *FOREIGN])
    sys.exit(beside or own)
