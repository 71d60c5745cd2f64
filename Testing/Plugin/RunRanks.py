# SPDX-License-Identifier: BSD-3-Clause
"""On several ranks each triangulates its own points, and that is said once, clearly.

    RunRanks.py COMMAND...   runs the command (mpiexec -n 2 pvbatch --sym RanksScript.py) and reads
                             what it prints
"""

import re
import sys

from pluginsupport import check, check_equal, run

status, printed = run(sys.argv[1:])
check_equal(status, 0, "exit status")

ranks = {rank: int(count) for rank, count in re.findall(r"rank (\d) of 2: (\d+) triangles", printed)}
check_equal(set(ranks), {"0", "1"}, "ranks that reported")
for rank, count in ranks.items():
    check(count > 10, "rank %s has %d triangles, but it has half a sphere's points" % (rank, count))

warnings = [line for line in printed.splitlines() if "triangulates its own points" in line]
check_equal(len(warnings), 1, "number of warnings about the ranks")
check("2 ranks" in warnings[0], "the warning does not say how many ranks there are: " + warnings[0])
print("passed: ranks")
