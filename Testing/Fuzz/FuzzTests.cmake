# SPDX-License-Identifier: BSD-3-Clause
#
# The tests that fuzz: Fuzz.Build makes all targets, then each runs its corpus and continues for some seconds, with
# AHD_LONG_TESTS for minutes; the engine with small thresholds.
find_program(AHD_CLANGXX NAMES clang++-14 clang++)
mark_as_advanced(AHD_CLANGXX)
if (NOT AHD_CLANGXX)
  message(STATUS "No clang++: no fuzzing")
  return ()
endif ()

string(REPLACE "clang++" "clang" ahd_clang "${AHD_CLANGXX}")
set(ahd_fuzz_folder "${CMAKE_CURRENT_BINARY_DIR}/targets")
set(ahd_fuzz_command
  ${CMAKE_COMMAND} -E env
  CC=${ahd_clang}
  CXX=${AHD_CLANGXX}
  CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
  "${CMAKE_CURRENT_SOURCE_DIR}/fuzz.sh" --folder "${ahd_fuzz_folder}")

add_test(NAME Fuzz.Build COMMAND ${ahd_fuzz_command} --build -- -DVTK_DIR=${VTK_DIR})
set_tests_properties(Fuzz.Build PROPERTIES
  LABELS fuzz TIMEOUT 1800 PROCESSORS 2 COST 1000 FIXTURES_SETUP ahd_fuzz_targets)

# Code that fuzzing does not reach: memory that runs out, single bits, larger inputs.
cmake_host_system_information(RESULT ahd_cores QUERY NUMBER_OF_LOGICAL_CORES)
add_test(NAME Engine.Sanitized
  COMMAND "${CMAKE_CTEST_COMMAND}" --test-dir "${ahd_fuzz_folder}/build" --output-on-failure --no-tests=error
    -E "^Engine\\.Hashes$" -j ${ahd_cores})
set_tests_properties(Engine.Sanitized PROPERTIES
  LABELS sanitize TIMEOUT 900 COST 900 PROCESSORS 2 FIXTURES_REQUIRED ahd_fuzz_targets)

# The engine's hashes by another compiler with other flags.
add_test(NAME Determinism.Clang COMMAND "${ahd_fuzz_folder}/build/engine-tests/EngineHashes"
  --gtest_brief=1 --gtest_filter=Hashes.AreThose*)
set_tests_properties(Determinism.Clang PROPERTIES
  LABELS determinism TIMEOUT 900 COST 800 FIXTURES_REQUIRED ahd_fuzz_targets)

# ahd_add_fuzz_test(<test> <target's name for fuzz.sh> <seconds> <minutes of the long test>)
function (ahd_add_fuzz_test test target seconds minutes)
  add_test(NAME Fuzz.${test}
    COMMAND ${ahd_fuzz_command} --built --target ${target} --seconds ${seconds} --seed 1)
  set_tests_properties(Fuzz.${test} PROPERTIES
    LABELS fuzz TIMEOUT 600 FIXTURES_REQUIRED ahd_fuzz_targets)
  if (AHD_LONG_TESTS)
    set(how --small)
    if (target STREQUAL "filter") # with the unchanged engine
      set(how --built)
    endif ()
    add_test(NAME FuzzLong.${test}
      COMMAND ${ahd_fuzz_command} ${how} --target ${target} --minutes ${minutes})
    math(EXPR limit "${minutes} * 60 + 1200")
    set_tests_properties(FuzzLong.${test} PROPERTIES LABELS long TIMEOUT ${limit}
      RESOURCE_LOCK ahd_fuzz_small FIXTURES_REQUIRED ahd_fuzz_targets)
  endif ()
endfunction ()

ahd_add_fuzz_test(Engine engine 15 20)
ahd_add_fuzz_test(Constraints constraints 20 20)
ahd_add_fuzz_test(Filter filter 8 20)

# Sequences by number, after those of the corpus: each run is the same.
find_package(Python3 COMPONENTS Interpreter)
if (Python3_Interpreter_FOUND)
  add_test(NAME Fuzz.Lifetimes
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/../Package/Lifetimes/lifetimes.py" program --quick
      --program "${ahd_fuzz_folder}/build/LifetimeFuzz")
  set_tests_properties(Fuzz.Lifetimes PROPERTIES
    LABELS fuzz TIMEOUT 3600 FIXTURES_REQUIRED ahd_fuzz_targets ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")
endif ()
if (AHD_LONG_TESTS)
  add_test(NAME FuzzLong.Lifetimes COMMAND ${ahd_fuzz_command} --built --target lifetime --minutes 20)
  set_tests_properties(FuzzLong.Lifetimes PROPERTIES LABELS long TIMEOUT 2400 FIXTURES_REQUIRED ahd_fuzz_targets)
endif ()
