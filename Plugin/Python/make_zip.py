#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes of each wheel the .zip that users of ParaView's official binaries extract: the package with the plugin in it.

    make_zip.py FOLDER WHEEL...      writes FOLDER/adaptivehilbertdelaunay-VERSION-paraview-SYSTEM.zip

A wheel is such a file, too, but Windows opens only what is called .zip, and pip's part of it would not be understood.
"""

import pathlib
import sys
import zipfile

PACKAGE = "adaptivehilbertdelaunay"
TOP = "AdaptiveHilbertDelaunay"
TEXT = """The plugin in Python of Adaptive Hilbert Delaunay 2D, for ParaView 5.11 to 6.1, version %s (%s).

1. Extract this file into a folder that you keep.
2. In ParaView: Tools > Manage Plugins... > Load New..., and choose in that folder
   AdaptiveHilbertDelaunay / adaptivehilbertdelaunay / AdaptiveHilbertDelaunayPlugin.py
   Tick Auto Load there to have it next time.
3. Filters > Adaptive Hilbert > Delaunay 2D (Adaptive Hilbert).
"""


def make_zip(folder, wheel):
    """Returns the file's path."""
    name, version, *_, system = wheel.stem.split("-")
    path = folder / ("%s-%s-paraview-%s.zip" % (name, version, system))
    with zipfile.ZipFile(wheel) as given, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr(TOP + "/README.txt", (TEXT % (version, system)).replace("\n", "\r\n"))
        for item in given.namelist():
            if item.startswith(PACKAGE + "/"):
                made.writestr("%s/%s" % (TOP, item), given.read(item))
            elif item.endswith("/LICENSE"):
                made.writestr(TOP + "/LICENSE.txt", given.read(item))
        plugin = "%s/%s/%sPlugin.py" % (TOP, PACKAGE, TOP)
        assert plugin in made.namelist(), "there is no plugin in %s" % wheel
    return path


if __name__ == "__main__":
    for argument in sys.argv[2:]:
        print(make_zip(pathlib.Path(sys.argv[1]), pathlib.Path(argument)))
