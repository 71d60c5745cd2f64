# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the filter and of the source in Python share."""

import sys
import unittest


def check_abort_and_run_again(test, algorithm, size):
    """An abort halfway leaves nothing, and the next run gives all. `size(output)` says how much there is; what a
    whole run gives is returned."""

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
    # pvpython and pvbatch leave their own words in sys.argv.
    outcome = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    sys.exit(not outcome.wasSuccessful())
