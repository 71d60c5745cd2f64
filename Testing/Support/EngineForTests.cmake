# SPDX-License-Identifier: BSD-3-Clause
#
# The engine and the tests' tools as static libraries without VTK, for the tests and benchmarks:
#   AdaptiveHilbertDelaunay::Engine   the engine, unless it exists already
#   ahd_point_makers    Testing/Support/Points/Distributions.cxx and Filters/Distributions, no engine
#   ahd_test_support    Testing/Support: point makers, oracle, certifier, one-call runs
# and, in every folder that includes this, the variables ahd_root_dir, ahd_engine_options,
# ahd_rounding_options, ahd_warnings, AHD_GMP_LIBRARY and AHD_GMPXX_LIBRARY, and the sources of ahd_point_makers, to
# build it in other ways: ahd_point_maker_sources, ahd_point_maker_includes. ahd_engine_dir, if it is set: where the
# engine's headers are.
find_package(Threads REQUIRED)
find_library(AHD_GMP_LIBRARY gmp REQUIRED)
find_library(AHD_GMPXX_LIBRARY gmpxx REQUIRED)
mark_as_advanced(AHD_GMP_LIBRARY AHD_GMPXX_LIBRARY)

get_filename_component(ahd_testing_dir "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
get_filename_component(ahd_root_dir "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(AHD_WARNINGS_ARE_ERRORS ON)
include("${ahd_root_dir}/Filters/Engine/Sources.cmake")
include("${ahd_root_dir}/Filters/Distributions/Sources.cmake")
if (NOT ahd_engine_dir)
  set(ahd_engine_dir "${ahd_root_dir}/Filters/Engine")
endif ()

set(ahd_warnings)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(ahd_warnings -Wall -Wextra -Wconversion -Wshadow)
endif ()

set(ahd_point_maker_sources
  "${ahd_testing_dir}/Support/Points/Distributions.cxx" ${ahd_distribution_sources})
set(ahd_support_includes "${ahd_testing_dir}/Support/Certify" "${ahd_testing_dir}/Support/Oracle"
  "${ahd_testing_dir}/Support/Points" "${ahd_testing_dir}/Support/Run")
set(ahd_point_maker_includes ${ahd_support_includes}
  "${ahd_root_dir}/Filters/Distributions" "${ahd_engine_dir}")

if (TARGET ahd_test_support)
  return ()
endif ()

include("${CMAKE_CURRENT_LIST_DIR}/QuickToCompile.cmake")
if (NOT TARGET AdaptiveHilbertDelaunay::Engine)
  add_subdirectory("${ahd_root_dir}/Filters/Engine" "${CMAKE_CURRENT_BINARY_DIR}/engine")
  ahd_precompile_engine(AdaptiveHilbertDelaunayEngine)
  if (AHD_SANITIZE)
    ahd_unite_engine(AdaptiveHilbertDelaunayEngine)
  endif ()
endif ()

add_library(ahd_point_makers STATIC EXCLUDE_FROM_ALL ${ahd_point_maker_sources})
target_compile_features(ahd_point_makers PUBLIC cxx_std_17)
target_compile_options(ahd_point_makers PRIVATE ${ahd_rounding_options} ${ahd_warnings})
target_include_directories(ahd_point_makers PUBLIC ${ahd_point_maker_includes})

file(GLOB ahd_support_sources CONFIGURE_DEPENDS "${ahd_testing_dir}/Support/*/*.cxx")
list(FILTER ahd_support_sources EXCLUDE REGEX "/Distributions\\.cxx$")
add_library(ahd_test_support STATIC EXCLUDE_FROM_ALL ${ahd_support_sources})
target_compile_options(ahd_test_support PRIVATE ${ahd_engine_options} ${ahd_warnings})
if (AHD_SANITIZE MATCHES "address") # the certifiers are not under test: faster without
  target_compile_options(ahd_test_support PRIVATE -fno-sanitize=all)
endif ()
target_include_directories(ahd_test_support PUBLIC ${ahd_support_includes})
ahd_precompile_engine(ahd_test_support)
target_link_libraries(ahd_test_support
  PUBLIC ahd_point_makers AdaptiveHilbertDelaunay::Engine
  PRIVATE ${AHD_GMPXX_LIBRARY} ${AHD_GMP_LIBRARY})
