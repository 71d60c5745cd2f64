# SPDX-License-Identifier: BSD-3-Clause
"""Configures the project of this folder with a VTK like that of Debian's paraview-dev 5.13, whose CMake files name
Python modules that are installed under another name. Its prefix is made of links; this VTK's modules are renamed there.

    python3 misnamed.py <VTK_DIR> <sources> <folder> <cmake> <generator> <compiler>
"""

import os
import shutil
import subprocess
import sys

vtk, sources, folder, cmake, generator, compiler = sys.argv[1:]
prefix, _, below = vtk.partition("/lib/")
farm = os.path.join(folder, "prefix")


def open_up(path):
    """A folder of the farm, which is a link or below one, becomes a folder of links."""
    if path != farm:
        open_up(os.path.dirname(path))
    if os.path.islink(path):
        there = os.readlink(path)
        os.unlink(path)
        os.mkdir(path)
        for name in os.listdir(there):
            os.symlink(os.path.join(there, name), os.path.join(path, name))


shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
os.symlink(prefix, farm)
mine = os.path.join(farm, "lib", below)
modules = os.path.join(farm, "lib", "python3", "dist-packages", "vtkmodules")
open_up(os.path.dirname(mine))
open_up(modules)
os.unlink(mine)
shutil.copytree(vtk, mine)  # not links: the package itself must not be mended
for name in os.listdir(modules):
    if name.endswith(".so"):
        os.rename(os.path.join(modules, name), os.path.join(modules, name[:-3] + ".cpython-any.so"))

done = subprocess.run(
    [cmake, "-S", os.path.dirname(os.path.abspath(__file__)), "-B", os.path.join(folder, "build"), "-G", generator,
     "-DCMAKE_CXX_COMPILER=" + compiler, "-DVTK_DIR=" + mine, "-DAHD_SOURCE=" + sources],
    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)  # fmt: skip
print(done.stdout)
if "Python modules are misnamed in %s" % mine not in done.stdout:
    sys.exit("the package was not a misnamed one")
sys.exit(done.returncode)
