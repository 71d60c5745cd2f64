# SPDX-License-Identifier: BSD-3-Clause
#
# The programs of peers.py, and the tests of the tools that judge and report. Sets
# ahd_peer_programs. For Testing/Benchmarks/CMakeLists.txt, which has looked for CGAL.
set(ahd_peers_dir "${CMAKE_CURRENT_LIST_DIR}")
set(ahd_peer_programs PeerInputs PeerJudge PeerOurs)

add_library(ahd_peer_tools STATIC EXCLUDE_FROM_ALL
  "${ahd_peers_dir}/PeerFiles.cxx" "${ahd_peers_dir}/TriangleJudge.cxx")
target_compile_options(ahd_peer_tools PRIVATE ${ahd_engine_options} ${ahd_warnings})
target_include_directories(ahd_peer_tools PUBLIC "${ahd_peers_dir}")
target_link_libraries(ahd_peer_tools PUBLIC ahd_test_support ${AHD_GMPXX_LIBRARY} ${AHD_GMP_LIBRARY})

foreach (program IN LISTS ahd_peer_programs)
  add_executable(${program} "${ahd_peers_dir}/${program}.cxx")
  target_compile_options(${program} PRIVATE ${ahd_engine_options} ${ahd_warnings})
  target_link_libraries(${program} PRIVATE ahd_peer_tools)
endforeach ()

if (AHD_CGAL_INCLUDE_DIR AND AHD_MPFR_LIBRARY)
  add_executable(PeerCgal "${ahd_peers_dir}/PeerCgal.cxx")
  target_compile_options(PeerCgal PRIVATE -frounding-math -w)
  target_include_directories(PeerCgal SYSTEM PRIVATE "${AHD_CGAL_INCLUDE_DIR}")
  target_compile_definitions(PeerCgal PRIVATE CGAL_NDEBUG)
  target_link_libraries(PeerCgal PRIVATE ahd_peer_tools ${AHD_MPFR_LIBRARY} ${AHD_GMP_LIBRARY})
  list(APPEND ahd_peer_programs PeerCgal)
endif ()

find_package(GTest)
if (GTest_FOUND)
  add_executable(PeerJudgeFaults "${ahd_peers_dir}/JudgeFaults.cxx")
  target_compile_options(PeerJudgeFaults PRIVATE ${ahd_engine_options} ${ahd_warnings})
  target_link_libraries(PeerJudgeFaults PRIVATE ahd_peer_tools GTest::gtest_main)
  list(APPEND ahd_peer_programs PeerJudgeFaults)
endif ()

# REQUIRES: enable_testing(), Python3_EXECUTABLE
function (ahd_add_peer_tests)
  if (TARGET PeerJudgeFaults)
    add_test(NAME Benchmark.PeerJudge COMMAND PeerJudgeFaults --gtest_brief=1)
    set_tests_properties(Benchmark.PeerJudge PROPERTIES LABELS benchmark TIMEOUT 60)
  endif ()
  add_test(NAME Benchmark.PeerTools
    COMMAND "${Python3_EXECUTABLE}" "${ahd_peers_dir}/test_peers.py" "$<TARGET_FILE_DIR:PeerOurs>")
  set_tests_properties(Benchmark.PeerTools PROPERTIES LABELS benchmark TIMEOUT 120)
endfunction ()
