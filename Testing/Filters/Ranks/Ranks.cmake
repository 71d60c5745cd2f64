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
    ENVIRONMENT "${environment}" LABELS "${label};slow" TIMEOUT 300 PROCESSORS 2)
endfunction ()

ahd_add_rank_test(3 RanksUpdates.py filter)
ahd_add_rank_test(2 RanksCompare.py filter)
ahd_add_rank_test(4 RanksCompare.py filter)
ahd_add_rank_test(2 RanksSurvey.py filter 500000)
ahd_add_rank_test(3 RanksGathered.py filter)
ahd_add_rank_test(2 RanksSample.py filter)
ahd_add_rank_test(3 RanksSample.py filter)
ahd_add_rank_test(3 RanksBlocks.py filter)
ahd_add_rank_test(3 RanksInputs.py filter)
ahd_add_rank_test(3 RanksMemory.py filter)
ahd_add_rank_test(3 RanksSeam.py filter)
ahd_add_rank_test(3 RanksOutline.py filter)
ahd_add_rank_test(3 RanksQuality.py filter)
ahd_add_rank_test(4 RanksSurvey.py filter)
if (AHD_LONG_TESTS)
  ahd_add_rank_test(3 RanksCompare.py long)
  ahd_add_rank_test(8 RanksCompare.py long)
  ahd_add_rank_test(5 RanksSample.py long)
  ahd_add_rank_test(2 RanksGathered.py long)
  ahd_add_rank_test(8 RanksGathered.py long)
endif ()

# Memory that runs out on one rank, in a program of its own: by the GNU C library's means.
if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND BUILD_SHARED_LIBS AND TARGET VTK::ParallelMPI)
  add_executable(FaultsRanks Support/FailingMemory.cxx Ranks/FaultsRanks.cxx)
  ahd_quick_to_compile(FaultsRanks 0)
  target_include_directories(FaultsRanks PRIVATE "${PROJECT_SOURCE_DIR}/Filters" "${CMAKE_CURRENT_SOURCE_DIR}/Support")
  target_link_libraries(FaultsRanks PRIVATE
    AdaptiveHilbertDelaunay::Filters VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel VTK::CommonMath
    VTK::CommonTransforms VTK::ParallelCore VTK::ParallelMPI ahd_point_makers GTest::gtest ${CMAKE_DL_LIBS})
  function (ahd_add_rank_faults ranks label)
    set(test "Filter.Ranks.Faults.${ranks}.${label}")
    add_test(NAME "${test}"
      COMMAND "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_PREFLAGS} ${MPIEXEC_NUMPROC_FLAG} ${ranks}
        "$<TARGET_FILE:FaultsRanks>" --gtest_brief=1 ${ARGN})
    set_tests_properties("${test}" PROPERTIES
      ENVIRONMENT "${ahd_mpi_environment}" LABELS "${label};slow" TIMEOUT 300 PROCESSORS 2)
  endfunction ()
  ahd_add_rank_faults(2 filter --gtest_filter=-Long*)
  if (AHD_LONG_TESTS)
    ahd_add_rank_faults(3 long --gtest_filter=-Long*)
    ahd_add_rank_faults(2 long --gtest_filter=Long*)
    set_tests_properties(Filter.Ranks.Faults.2.long PROPERTIES TIMEOUT 3600)
  endif ()
endif ()
