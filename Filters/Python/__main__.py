# SPDX-License-Identifier: BSD-3-Clause
"""python -m adaptivehilbertdelaunay --paraview-plugin: where the plugin for ParaView is, for Manage Plugins."""

import argparse
import os
import sys

from . import __path__ as _folders

PLUGIN = os.path.join(os.path.abspath(_folders[-1]), "AdaptiveHilbertDelaunayPlugin.py")


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m adaptivehilbertdelaunay")
    parser.add_argument(
        "--paraview-plugin", action="store_true", required=True,
        help="print the path of the plugin in Python, to be loaded by ParaView's Manage Plugins",
    )  # fmt: skip
    parser.parse_args()
    if not os.path.isfile(PLUGIN):
        print("there is no plugin in this package: it was built without", file=sys.stderr)
        return 1
    print(PLUGIN)
    return 0


if __name__ == "__main__":
    sys.exit(main())
