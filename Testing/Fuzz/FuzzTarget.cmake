# SPDX-License-Identifier: BSD-3-Clause
#
# How a fuzz target is compiled. Sets
#   ahd_fuzz_watched   compile options of code under test: sanitizers, and libFuzzer's instrumentation
#   ahd_fuzz_quiet compile options of code that checks it: none of these, so that it is fast and the libraries
#   ahd_fuzz_engine    the engine, watched
#   ahd_fuzz_support   the cases, and Testing/Support
find_package(GTest REQUIRED)
find_package(Threads REQUIRED)
get_filename_component(ahd_root_dir "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(ahd_engine_dir "${ahd_root_dir}/Filters/Engine")
include("${ahd_engine_dir}/Sources.cmake")
if (AHD_FUZZ_SMALL)
  include("${CMAKE_CURRENT_LIST_DIR}/SmallThresholds.cmake")
  set(ahd_engine_dir "${CMAKE_CURRENT_BINARY_DIR}/engine")
  ahd_copy_with_small_thresholds("${ahd_engine_dir}")
  list(TRANSFORM ahd_engine_sources REPLACE "^.*/Filters/Engine/" "${ahd_engine_dir}/")
endif ()

if (AHD_FUZZ_COVERAGE)
  set(ahd_fuzz_watched -O1 -fprofile-instr-generate -fcoverage-mapping)
  set(ahd_fuzz_link -fsanitize=fuzzer -fprofile-instr-generate)
else ()
  set(ahd_fuzz_sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all)
  set(ahd_fuzz_watched
    -O1 -gline-tables-only -fno-omit-frame-pointer ${ahd_fuzz_sanitizers}
    # not fuzzer-no-link, which watches comparisons too: nine tenths of the time for nothing, as
    # what is compared here are coordinates and not magic numbers
    -fsanitize-coverage=inline-8bit-counters,pc-table)
  set(ahd_fuzz_link -fsanitize=fuzzer ${ahd_fuzz_sanitizers})
endif ()
set(ahd_fuzz_quiet -O1)

add_library(ahd_fuzz_engine STATIC ${ahd_engine_sources})
add_library(AdaptiveHilbertDelaunay::Engine ALIAS ahd_fuzz_engine) # for what EngineForTests.cmake makes
set_source_files_properties("${ahd_engine_dir}/Interface/ahd.cxx" PROPERTIES
  COMPILE_DEFINITIONS "AHD_VERSION=\"${ahd_engine_version}\"")
target_compile_features(ahd_fuzz_engine PUBLIC cxx_std_17)
set_target_properties(ahd_fuzz_engine PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_compile_options(ahd_fuzz_engine PRIVATE
  ${ahd_fuzz_watched} ${ahd_engine_options} -Wno-ignored-optimization-argument)
target_include_directories(ahd_fuzz_engine PUBLIC "${ahd_engine_dir}")
target_link_libraries(ahd_fuzz_engine PUBLIC Threads::Threads)

include("${CMAKE_CURRENT_LIST_DIR}/../Support/EngineForTests.cmake")
ahd_precompile_engine(ahd_fuzz_engine)
ahd_unite_engine(ahd_fuzz_engine)
foreach (library IN ITEMS ahd_point_makers ahd_test_support)
  target_compile_options(${library} PRIVATE ${ahd_fuzz_quiet} -Wno-ignored-optimization-argument)
endforeach ()
target_compile_definitions(ahd_test_support PRIVATE AHD_REDUCED_TESTS) # reduced(), for Engine.Sanitized

add_library(ahd_fuzz_support STATIC FuzzCase.cxx)
target_compile_options(ahd_fuzz_support PRIVATE
  ${ahd_fuzz_quiet} ${ahd_engine_options} ${ahd_warnings} -Wno-ignored-optimization-argument)
target_include_directories(ahd_fuzz_support PUBLIC "${CMAKE_CURRENT_LIST_DIR}")
target_link_libraries(ahd_fuzz_support PUBLIC ahd_test_support ahd_fuzz_engine)

# ahd_add_fuzz_target(<name> <sources>...)
# A libFuzzer program: the sources have LLVMFuzzerTestOneInput, and are compiled quietly; code under test beyond the
# engine must be compiled with ahd_fuzz_watched.
function (ahd_add_fuzz_target name)
  add_executable(${name} ${ARGN})
  target_compile_options(${name} PRIVATE
    ${ahd_fuzz_quiet} ${ahd_engine_options} ${ahd_warnings} -Wno-ignored-optimization-argument)
  target_link_options(${name} PRIVATE ${ahd_fuzz_link})
  # the engine first: of functions in both the linker takes the instrumented ones
  target_link_libraries(${name} PRIVATE ahd_fuzz_engine ahd_fuzz_support GTest::gtest)
endfunction ()
