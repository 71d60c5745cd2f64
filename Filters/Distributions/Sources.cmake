# SPDX-License-Identifier: BSD-3-Clause
#
# The makers of points, said once: Filters/CMakeLists.txt compiles them into the VTK module,
# Testing/ into a library of its own that needs no VTK. Sets
#   ahd_distribution_sources   absolute paths: every .cxx file in this directory
#   ahd_rounding_options       compile options without which the bits of the points would depend on
#                              the processor
file(GLOB ahd_distribution_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/*.cxx")
include("${CMAKE_CURRENT_LIST_DIR}/../Engine/Rounding.cmake")
