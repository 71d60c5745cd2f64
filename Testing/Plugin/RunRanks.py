# SPDX-License-Identifier: BSD-3-Clause
"""On several ranks all make one surface; without DistributePoints each its own, with one warning.

    RunRanks.py COMMAND...   runs the command (mpiexec -n 2 own_output.sh pvbatch --sym RanksScript.py) and reads
                             what each rank prints
"""

import re
import sys

from pluginsupport import check, check_equal, outputs_of_ranks, run

outputs_of_ranks(forget=True)
status, _ = run(sys.argv[1:])
outputs = outputs_of_ranks()
for text in outputs:
    print(text)
check_equal(status, 0, "exit status")
check_equal(len(outputs), 2, "ranks")

alone, together, warnings = {}, {}, {}
for text in outputs:
    found = re.findall(r"^rank (\d) of 2: (\d+) triangles$", text, re.MULTILINE)
    check_equal(len(found), 1, "times that a rank reported of its own surface")
    rank = found[0][0]
    alone[rank] = int(found[0][1])
    found = re.findall(r"^rank %s of 2: (\d+) of (\d+) triangles together$" % rank, text, re.MULTILINE)
    check_equal(len(found), 1, "times that rank %s reported of one surface" % rank)
    together[rank] = [int(number) for number in found[0]]
    warnings[rank] = [line for line in text.splitlines() if "triangulates its own points" in line]

check_equal(set(alone), {"0", "1"}, "ranks that reported")
for rank, count in alone.items():
    check(count > 10, "rank %s has %d triangles, but it has half a sphere's points" % (rank, count))
for rank, (own, all_) in together.items():
    check(own > 0, "rank %s has nothing of the surface" % rank)
    check_equal(all_, sum(count for count, _ in together.values()), "triangles of all, says rank " + rank)

check_equal([len(warnings[rank]) for rank in "01"], [1, 0], "warnings about the ranks, from each")
check("2 ranks" in warnings["0"][0], "the warning does not say how many ranks there are: " + warnings["0"][0])
print("passed: ranks")
