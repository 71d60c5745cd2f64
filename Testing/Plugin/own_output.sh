#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
#
# own_output.sh PROGRAM...: what each of several ranks prints goes to a file of its own in AHD_SCRATCH, as mpiexec's
# single stream mixes the output of ranks. Read by pluginsupport.outputs_of_ranks.
exec "$@" >"$AHD_SCRATCH/rank.$$.log" 2>&1
