# SPDX-License-Identifier: BSD-3-Clause
"""The installed plugin loads in pvpython and triangulates. Usage: pvpython <this> <prefix> <directory>

The directory is the plugin's, below the prefix of the installation.
"""

import glob
import os
import sys

from paraview.simple import LoadPlugin, Sphere

prefix, directory = sys.argv[1:3]
found = glob.glob(os.path.join(prefix, directory, "AdaptiveHilbertDelaunay.*"))
assert len(found) == 1, "one plugin expected in %s, found %s" % (directory, found)
LoadPlugin(found[0], remote=False, ns=globals())

surface = AdaptiveHilbertDelaunay2D(Input=Sphere())  # noqa: F821 (LoadPlugin brings it)
surface.UpdatePipeline()
cells = surface.GetDataInformation().GetNumberOfCells()
assert cells > 20, "%d triangles" % cells

# It must have used the installed library, not the one of the build tree.
if os.path.exists("/proc/self/maps"):
    with open("/proc/self/maps") as maps:
        loaded = {line.split()[-1] for line in maps if "AdaptiveHilbertDelaunay" in line}
    assert loaded and all(name.startswith(prefix) for name in loaded), (prefix, loaded)
