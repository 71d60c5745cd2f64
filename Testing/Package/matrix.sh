#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
#
# The Python package on all pairs of a Python that is found here and a VTK or cvista that PyPI has wheels for: prints
# which ran, and the outcome. An hour; needs PyPI and a gigabyte in build/pairs.
#
#   Testing/Package/matrix.sh [<wheel, or folder that holds the package>] [<pair>...]
#
# Without a wheel one is built from this tree (pip wheel). Pairs: pairs.py --list.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

package=${1:-}
if [ $# -gt 0 ]; then
  shift
fi
if [ -z "$package" ]; then
  mkdir -p build/pairs
  rm -f build/pairs/*.whl
  python3 -m pip wheel --quiet --no-deps --wheel-dir build/pairs .
  package=$(echo build/pairs/*.whl)
fi
exec python3 Testing/Package/pairs.py --package "$package" --work build/pairs "$@"
