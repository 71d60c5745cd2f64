# SPDX-License-Identifier: BSD-3-Clause
#
# FilterFuzz, where there is VTK (that of ParaView first): the filter's sources instrumented, with VTK's own libraries
# unchanged.
file(GLOB ahd_paraviews "/usr/lib/${CMAKE_CXX_LIBRARY_ARCHITECTURE}/cmake/paraview-*/vtk")
find_package(VTK 9.1 QUIET
  COMPONENTS CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  PATHS ${ahd_paraviews})
if (NOT VTK_FOUND)
  message(STATUS "No VTK: the filter is not fuzzed")
  return ()
endif ()
message(STATUS "FilterFuzz with VTK ${VTK_VERSION} in ${VTK_DIR}")

# normally made by vtk_module_build()
set(ahd_fuzz_export "${CMAKE_CURRENT_BINARY_DIR}/export")
file(WRITE "${ahd_fuzz_export}/AdaptiveHilbertDelaunayFiltersModule.h"
  "#define ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT\n")

include("${ahd_root_dir}/Filters/Distributions/Sources.cmake")
include("${ahd_root_dir}/Filters/Precompiled.cmake")
file(GLOB ahd_fuzz_filter_sources CONFIGURE_DEPENDS "${ahd_root_dir}/Filters/vtk*.cxx"
  "${ahd_root_dir}/Filters/Input/*.cxx" "${ahd_root_dir}/Filters/Output/*.cxx"
  "${ahd_root_dir}/Filters/Pipeline/*.cxx" "${ahd_root_dir}/Filters/Execution/*.cxx"
  "${ahd_root_dir}/Filters/Sampling/*.cxx")
add_library(ahd_fuzz_filter STATIC ${ahd_fuzz_filter_sources} ${ahd_distribution_sources})
target_compile_features(ahd_fuzz_filter PUBLIC cxx_std_17)
set_target_properties(ahd_fuzz_filter PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD ON)
# for VTK's classes, which are not instrumented, type information is missing in parts of the program
target_compile_options(ahd_fuzz_filter PRIVATE
  ${ahd_fuzz_watched} -O0 -fno-sanitize=vptr ${ahd_rounding_options}
  -Wno-ignored-optimization-argument)
target_include_directories(ahd_fuzz_filter PUBLIC "${ahd_root_dir}/Filters" "${ahd_fuzz_export}")
target_link_libraries(ahd_fuzz_filter PUBLIC
  ahd_fuzz_engine VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel VTK::CommonMath
  VTK::CommonTransforms)
ahd_precompile_vtk(ahd_fuzz_filter)

add_library(ahd_fuzz_filter_common OBJECT FilterArrays.cxx FilterCase.cxx FilterSettings.cxx FilterJudge.cxx
  MeshJudge.cxx SimplifiedJudge.cxx)
target_compile_options(ahd_fuzz_filter_common PRIVATE ${ahd_fuzz_quiet} ${ahd_engine_options}
  ${ahd_warnings} -Wno-ignored-optimization-argument)
target_link_libraries(ahd_fuzz_filter_common PUBLIC ahd_fuzz_filter ahd_fuzz_support GTest::gtest)

ahd_add_fuzz_target(FilterFuzz FilterFuzz.cxx $<TARGET_OBJECTS:ahd_fuzz_filter_common>)
target_link_libraries(FilterFuzz PRIVATE ahd_fuzz_filter)

ahd_add_fuzz_target(LifetimeFuzz
  LifetimeFuzz.cxx LifetimeData.cxx LifetimeSteps.cxx LifetimeWorld.cxx $<TARGET_OBJECTS:ahd_fuzz_filter_common>)
target_link_libraries(LifetimeFuzz PRIVATE ahd_fuzz_filter)
