# SPDX-License-Identifier: BSD-3-Clause
#
# The makers of points, said once: Filters/CMakeLists.txt compiles them into the VTK module,
# Testing/ into a library of its own that needs no VTK. Sets
#   ahd_distribution_sources   absolute paths: every .cxx file in this directory
#   ahd_distribution_options   compile options without which the bits of the points would depend on
#                              the processor: a fused multiply-add rounds once, not twice
file(GLOB ahd_distribution_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/*.cxx")
set(ahd_distribution_options)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(ahd_distribution_options -ffp-contract=off)
elseif (MSVC)
  set(ahd_distribution_options /fp:precise)
endif ()
