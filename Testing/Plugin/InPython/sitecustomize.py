# SPDX-License-Identifier: BSD-3-Clause
"""For Debian 12 only: its ParaView 5.11 loads no plugin in Python, as it imports inspect.getargspec, which Python 3.11
has removed. Python runs this file when it starts, if it is on its path."""

import inspect

if not hasattr(inspect, "getargspec"):
    inspect.getargspec = inspect.getfullargspec
