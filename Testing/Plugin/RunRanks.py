# SPDX-License-Identifier: BSD-3-Clause
"""On several ranks all make one surface; without DistributePoints each its own, which is said once, clearly.

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

together = {rank: (int(own), int(all_)) for rank, own, all_ in
            re.findall(r"rank (\d) of 2: (\d+) of (\d+) triangles together", printed)}
check_equal(set(together), {"0", "1"}, "ranks that reported of one surface")
for rank, (own, all_) in together.items():
    check(own > 0, "rank %s has nothing of the surface" % rank)
    check_equal(all_, sum(count for count, _ in together.values()), "triangles of all, says rank " + rank)

warnings = [line for line in printed.splitlines() if "triangulates its own points" in line]
check_equal(len(warnings), 1, "number of warnings about the ranks")
check("2 ranks" in warnings[0], "the warning does not say how many ranks there are: " + warnings[0])
print("passed: ranks")
