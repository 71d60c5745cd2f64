# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the Python tests of the filter and of the source."""

import sys
import unittest


def check_abort_and_run_again(test, algorithm, size):
    """An abort halfway leaves no output, and the next run is complete. `size(output)`: the amount of output; returns
    that of a complete run."""

    def abort(caller, _):
        if caller.GetProgress() > 0.5:
            caller.SetAbortExecute(1)

    tag = algorithm.AddObserver("ProgressEvent", abort)
    algorithm.Update()
    test.assertEqual(size(algorithm.GetOutput()), 0)
    algorithm.RemoveObserver(tag)
    algorithm.SetAbortExecute(0)
    algorithm.Modified()
    algorithm.Update()
    return size(algorithm.GetOutput())


def run_tests():
    # pvpython and pvbatch leave their own arguments in sys.argv.
    outcome = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    sys.exit(not outcome.wasSuccessful())
