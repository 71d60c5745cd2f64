# SPDX-License-Identifier: BSD-3-Clause
#
# The engine and the tests' tools as static libraries without VTK, for the tests and benchmarks:
#   ahd_engine_static   the engine: as compiled for the filter where there is one, else from its
#                       sources; then the engine's own warnings are errors, with the compilers that
#                       are known to give none
#   ahd_point_makers    Testing/Support/Distributions.cxx and Filters/Distributions, no engine
#   ahd_test_support    Testing/Support: point makers, oracle, certifier, one-call runs
# and, in every folder that includes this, the variables ahd_root_dir, ahd_engine_options,
# ahd_distribution_options, ahd_warnings, AHD_GMP_LIBRARY and AHD_GMPXX_LIBRARY, and what
# ahd_point_makers is made of, to make it otherwise: ahd_point_maker_sources, ahd_point_maker_includes.
find_package(Threads REQUIRED)
find_library(AHD_GMP_LIBRARY gmp REQUIRED)
find_library(AHD_GMPXX_LIBRARY gmpxx REQUIRED)
mark_as_advanced(AHD_GMP_LIBRARY AHD_GMPXX_LIBRARY)

get_filename_component(ahd_testing_dir "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
get_filename_component(ahd_root_dir "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
include("${ahd_root_dir}/Filters/Engine/Sources.cmake")
include("${ahd_root_dir}/Filters/Distributions/Sources.cmake")

set(ahd_warnings)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(ahd_warnings -Wall -Wextra -Wconversion -Wshadow)
endif ()

set(ahd_engine_errors)
if ((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^12\\.") OR
    (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^14\\."))
  set(ahd_engine_errors -Werror)
endif ()

set(ahd_point_maker_sources
  "${ahd_testing_dir}/Support/Distributions.cxx" ${ahd_distribution_sources})
set(ahd_point_maker_includes "${ahd_testing_dir}/Support"
  "${ahd_root_dir}/Filters/Distributions" "${ahd_root_dir}/Filters/Engine")

if (TARGET ahd_engine_static)
  return ()
endif ()

if (TARGET AdaptiveHilbertDelaunay::Filters)
  get_target_property(ahd_filters AdaptiveHilbertDelaunay::Filters ALIASED_TARGET)
  add_library(ahd_engine_static STATIC EXCLUDE_FROM_ALL
    $<FILTER:$<TARGET_OBJECTS:${ahd_filters}>,INCLUDE,/Engine/>)
  set_target_properties(ahd_engine_static PROPERTIES LINKER_LANGUAGE CXX)
else ()
  add_library(ahd_engine_static STATIC EXCLUDE_FROM_ALL ${ahd_engine_sources})
  target_compile_options(ahd_engine_static PRIVATE
    ${ahd_engine_options} ${ahd_engine_warnings} ${ahd_engine_errors})
endif ()
target_compile_features(ahd_engine_static PUBLIC cxx_std_17)
target_include_directories(ahd_engine_static PUBLIC "${ahd_root_dir}/Filters/Engine")

add_library(ahd_point_makers STATIC EXCLUDE_FROM_ALL ${ahd_point_maker_sources})
target_compile_features(ahd_point_makers PUBLIC cxx_std_17)
target_compile_options(ahd_point_makers PRIVATE ${ahd_distribution_options} ${ahd_warnings})
target_include_directories(ahd_point_makers PUBLIC ${ahd_point_maker_includes})

file(GLOB ahd_support_sources CONFIGURE_DEPENDS "${ahd_testing_dir}/Support/*.cxx")
list(FILTER ahd_support_sources EXCLUDE REGEX "/Distributions\\.cxx$")
add_library(ahd_test_support STATIC EXCLUDE_FROM_ALL ${ahd_support_sources})
target_compile_options(ahd_test_support PRIVATE ${ahd_engine_options} ${ahd_warnings})
if (AHD_SANITIZE MATCHES "address") # the judges are not what is judged: faster without
  target_compile_options(ahd_test_support PRIVATE -fno-sanitize=all)
endif ()
target_include_directories(ahd_test_support PUBLIC "${ahd_testing_dir}/Support")
target_link_libraries(ahd_test_support
  PUBLIC ahd_point_makers ahd_engine_static Threads::Threads
  PRIVATE ${AHD_GMPXX_LIBRARY} ${AHD_GMP_LIBRARY})
