# SPDX-License-Identifier: BSD-3-Clause
"""adaptivehilbertdelaunay, or python -m adaptivehilbertdelaunay: --version; --paraview-plugin, where the plugin for
ParaView is; and `tiles`, rasters and TINs of many files."""

import argparse
import os
import sys

from . import __path__ as _folders

PLUGIN = os.path.join(os.path.abspath(_folders[-1]), "AdaptiveHilbertDelaunayPlugin.py")


def main() -> int:
    if sys.argv[1:2] == ["tiles"]:
        from .tiles._command import main as make_tiles

        return make_tiles(sys.argv[2:])
    parser = argparse.ArgumentParser(
        prog="python -m adaptivehilbertdelaunay", epilog="tiles FILES...: rasters and TINs of many files (--help)")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--version", action="store_true", help="print the version, and where the library is")
    what.add_argument(
        "--paraview-plugin", action="store_true",
        help="print the path of the plugin in Python, to be loaded by ParaView's Manage Plugins",
    )  # fmt: skip
    if parser.parse_args().version:
        from ._interface import __version__, library_path  # which loads NumPy and the library

        print("adaptivehilbertdelaunay %s (%s)" % (__version__, library_path()))
        return 0
    if not os.path.isfile(PLUGIN):
        print("there is no plugin in this package: it was built without", file=sys.stderr)
        return 1
    print(PLUGIN)
    return 0


if __name__ == "__main__":
    sys.exit(main())
