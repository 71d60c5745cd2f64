# SPDX-License-Identifier: BSD-3-Clause
"""Installs the build to /usr/local below a folder (DESTDIR), looks at what came there, and moves it elsewhere.

    python3 stage.py CMAKE BUILD CONFIG PYTHON_FOLDER FOLDER

Afterwards FOLDER/moved holds what would be in /usr/local; what uses it must not miss the place it was made for.
PYTHON_FOLDER: where the Python package is, below /usr/local; empty if there is none.
"""

import os
import pathlib
import shutil
import subprocess
import sys

PREFIX = "/usr/local"


def install(cmake, build, config, folder):
    """The files that were installed, below FOLDER/usr/local."""
    shutil.rmtree(folder, ignore_errors=True)
    before = set(pathlib.Path(PREFIX).rglob("*daptive*ilbert*"))
    subprocess.run(
        [cmake, "--install", build, "--prefix", PREFIX, "--config", config], check=True, stdout=subprocess.DEVNULL,
        env={**os.environ, "DESTDIR": folder})  # fmt: skip
    assert set(pathlib.Path(PREFIX).rglob("*daptive*ilbert*")) == before, "%s itself was touched" % PREFIX
    files = [path for path in pathlib.Path(folder).rglob("*") if path.is_file()]
    staged = pathlib.Path(folder + PREFIX)
    outside = [path for path in files if staged not in path.parents]
    assert files and not outside, "installed elsewhere: %s" % outside
    return files


def check_nothing_leads_back(files, build):
    """No installed file refers to the build tree: neither CMake's files nor search paths of libraries."""
    for path in files:
        assert build.encode() not in path.read_bytes(), "%s leads to %s" % (path, build)


def check_python(files, folder):
    """The package is on this interpreter's path."""
    place = os.path.join(PREFIX, folder)
    assert place in sys.path, "%s is not on the interpreter's path: %s" % (place, sys.path)
    wanted = os.path.join(place, "adaptivehilbertdelaunay", "__init__.py")
    assert any(str(path).endswith(wanted) for path in files), "no %s" % wanted


def main():
    cmake, build, config, python_folder, folder = sys.argv[1:]
    files = install(cmake, build, config, folder)
    check_nothing_leads_back(files, build)
    # Debian's interpreter searches below /usr/local, a virtual environment's or another's may not
    if python_folder and os.path.realpath(sys.executable).startswith("/usr/bin/"):
        check_python(files, python_folder)
    os.rename(folder + PREFIX, os.path.join(folder, "moved"))
    print("%d files" % len(files))


if __name__ == "__main__":
    main()
