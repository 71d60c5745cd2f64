# SPDX-License-Identifier: BSD-3-Clause
#
# ahd_filter_insides: all of the VTK module, to be linked in place of its library by programs that call what the
# library does not export. The objects are those of the library: nothing is compiled again.
if (NOT TARGET ahd_filter_insides)
  add_library(ahd_filter_insides INTERFACE)
  target_sources(ahd_filter_insides INTERFACE $<TARGET_OBJECTS:AdaptiveHilbertDelaunay::Filters>)
  target_include_directories(ahd_filter_insides INTERFACE
    "${PROJECT_SOURCE_DIR}/Filters" $<TARGET_PROPERTY:AdaptiveHilbertDelaunay::Filters,INTERFACE_INCLUDE_DIRECTORIES>)
  target_compile_definitions(ahd_filter_insides INTERFACE
    $<TARGET_PROPERTY:AdaptiveHilbertDelaunay::Filters,INTERFACE_COMPILE_DEFINITIONS>)
  target_link_libraries(ahd_filter_insides INTERFACE
    AdaptiveHilbertDelaunay::Engine VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel VTK::CommonMath
    VTK::CommonTransforms $<$<TARGET_EXISTS:VTK::ParallelCore>:VTK::ParallelCore>)
endif ()
