# SPDX-License-Identifier: BSD-3-Clause
#
# The filter on several ranks of pvbatch, against one.
function (ahd_add_rank_test ranks script label)
  get_filename_component(name "${script}" NAME_WE)
  set(test "Filter.Ranks.${name}.${ranks}")
  set(own "${CMAKE_BINARY_DIR}/Testing/Temporary/${test}")
  file(MAKE_DIRECTORY "${own}")
  add_test(NAME "${test}"
    COMMAND "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_PREFLAGS} ${MPIEXEC_NUMPROC_FLAG} ${ranks}
      "$<TARGET_FILE:ParaView::pvbatch>" --sym "${CMAKE_CURRENT_SOURCE_DIR}/Ranks/${script}" ${ARGN})
  set(environment "PYTHONPATH=${ahd_python_path}:${ahd_vtk_python_path}" PYTHONDONTWRITEBYTECODE=1
    "AHD_SCRATCH=${own}" ${ahd_mpi_environment})
  set_tests_properties("${test}" PROPERTIES
    ENVIRONMENT "${environment}" LABELS "${label}" TIMEOUT 300 PROCESSORS 2)
endfunction ()

ahd_add_rank_test(2 RanksCompare.py filter)
ahd_add_rank_test(4 RanksCompare.py filter)
ahd_add_rank_test(2 RanksSurvey.py filter 500000)
ahd_add_rank_test(3 RanksGathered.py filter)
ahd_add_rank_test(2 RanksSample.py filter)
ahd_add_rank_test(3 RanksSample.py filter)
ahd_add_rank_test(3 RanksBlocks.py filter)
ahd_add_rank_test(3 RanksSeam.py filter)
ahd_add_rank_test(4 RanksSurvey.py filter)
if (AHD_LONG_TESTS)
  ahd_add_rank_test(3 RanksCompare.py long)
  ahd_add_rank_test(8 RanksCompare.py long)
  ahd_add_rank_test(5 RanksSample.py long)
  ahd_add_rank_test(2 RanksGathered.py long)
  ahd_add_rank_test(8 RanksGathered.py long)
endif ()
