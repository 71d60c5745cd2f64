# SPDX-License-Identifier: BSD-3-Clause
"""Which files of a folder the demo wrote: it replaces and removes these and no others.

They stand in a file of the folder, with size and time: a file that somebody changed since is not the demo's.
"""

import json
import os

from pointfiles import InputError

LIST = ".demo-results.json"


class Folder:
    """Where results go. is_ours: everything in it counts as the demo's, as in build/demo."""

    def __init__(self, path, is_ours=False):
        self.list, self.is_ours = os.path.join(path, LIST), is_ours

    def check(self, paths):
        """Raises InputError if one of these files is there and somebody else's."""
        for path in paths:
            if os.path.lexists(path) and not self.is_own(path):
                raise InputError(
                    "%s is there, and is not as this program wrote it, so it stays; move it, or choose another folder "
                    "with --output" % path)

    def is_own(self, path):
        return self.is_ours or self.known().get(os.path.basename(path), ()) == state(path)

    def remove(self, paths):
        """Removes those that the demo wrote."""
        for path in paths:
            if (os.path.isfile(path) or os.path.islink(path)) and self.is_own(path):
                os.remove(path)

    def add(self, path):
        """The demo has written this file."""
        known = {name: was for name, was in self.known().items()
                 if os.path.exists(os.path.join(os.path.dirname(self.list), name))}
        known[os.path.basename(path)] = state(path)
        with open(self.list, "w", encoding="utf-8") as file:
            json.dump(known, file, indent=1, sort_keys=True)

    def known(self):
        try:
            with open(self.list, encoding="utf-8") as file:
                known = json.load(file)
        except (OSError, ValueError, RecursionError):
            return {}
        return known if isinstance(known, dict) else {}


def state(path):
    """What tells whether a file was changed; None if there is none. A link is not the file that it leads to."""
    try:
        there = os.lstat(path)
    except OSError:
        return None
    return [there.st_size, there.st_mtime_ns]
