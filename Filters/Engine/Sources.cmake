# SPDX-License-Identifier: BSD-3-Clause
#
# The engine's sources, and how they are compiled. Sets
#   ahd_engine_sources   absolute paths: every .cxx file below this directory
#   ahd_engine_version   the version of the project
#   ahd_engine_headers   the headers of its C++ interface, relative to this directory, to be installed
#   ahd_engine_options   compile options without which the predicates are not exact
#   ahd_engine_warnings  options for the compiler's warnings
#   ahd_engine_errors    makes warnings errors, where tests are built (AHD_WARNINGS_ARE_ERRORS) and with the compilers
#                        that are known to give none
file(GLOB_RECURSE ahd_engine_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/*.cxx")

set(ahd_engine_headers Triangulate.h Options.h Constraints.h Result.h
  Core/AskedMemory.h Core/Border.h Core/Buffer.h Core/Chunks.h Core/Clock.h Core/Context.h Core/Executor.h
  Core/Fields.h Core/Fingerprint.h Core/FloatingPoint.h Core/Memory.h Core/Prefetch.h Core/Processors.h
  Core/Progress.h Core/SizeInWords.h Core/Stages.h Core/Threads.h Core/Uninitialised.h
  Crossings/Crossings.h Distribute/BlockBytes.h Distribute/BlockCuts.h Distribute/BlockTransport.h
  Distribute/BlockChains.h Distribute/BlockGhosts.h Distribute/BlockNeeds.h Distribute/BlockRim.h Distribute/BlockRoute.h
  Distribute/BlockStars.h Distribute/BlockTriangulation.h Distribute/Share.h Distribute/Steps.h
  Edit/Edit.h Edit/Hints.h Living/LivingMesh.h Mesh/Mesh.h
  Merge/Merge.h Outline/Outline.h Points/JoinedBounds.h Points/Points.h Prepare/ClosedLines.h Prepare/Prepare.h
  Prepare/Stacks.h
  Surface/CellArrays.h Surface/FindTriangles.h Surface/Footprint.h Surface/Means.h Surface/OrderDrawing.h Surface/Plane.h Surface/PlaneFit.h
  Surface/Selection.h Surface/Vectors.h Predicates/Predicates.h Refine/Refine.h Refine/RefinedMesh.h
  Interface/ahd.h Interface/ahd_edit.h Interface/ahd_messages.h Interface/ahd_outline.h Interface/ahd_refine.h Interface/ahd_sample.h Interface/ahd_tiles.h Job/ArrayRows.h Job/CheckedMemory.h Job/Messages.h Job/OutlineRun.h Job/RefineRun.h Job/Run.h Job/RunMemory.h
  Job/ReportRows.h
  Job/RunProgress.h Job/RunReport.h Job/RunSettings.h Job/SettingRows.h Job/Settings.h Job/SpacePoints.h
  Job/WantedArrays.h Job/Words.h
  Sample/BoxNeighbors.h Sample/Outside.h Sample/Sample.h Simplify/Simplify.h
  Triangulation/Triangulation.h Voronoi/Voronoi.h)

file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/../../CMakeLists.txt" ahd_engine_version
  REGEX "^project\\(AdaptiveHilbertDelaunay VERSION ")
string(REGEX REPLACE "^[^0-9]*([0-9.]+).*" "\\1" ahd_engine_version "${ahd_engine_version}")
set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/Interface/ahd.cxx" PROPERTIES
  COMPILE_DEFINITIONS "AHD_VERSION=\"${ahd_engine_version}\"")

include("${CMAKE_CURRENT_LIST_DIR}/Rounding.cmake")
set(ahd_engine_options ${ahd_rounding_options})
set(ahd_engine_warnings)
set(ahd_engine_errors)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT MSVC)
  # Without SLP vectorization, which packs the kernel's scalars into vectors and unpacks them again:
  # 2 to 4 % of the time of the insertion.
  list(APPEND ahd_engine_options -fno-tree-slp-vectorize)
  set(ahd_engine_warnings -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Wmissing-declarations)
endif ()
if (AHD_WARNINGS_ARE_ERRORS AND (
    (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^12\\.") OR
    (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^14\\.")))
  set(ahd_engine_errors -Werror)
endif ()

# One program for all processors, or code for several instruction sets, chosen at run time. GCC does not align the
# stack for those on Windows (its PR 54412).
set(ahd_portable OFF)
if (WIN32 AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(ahd_portable ON)
endif ()
option(AHD_PORTABLE "Leave out the code for processors that know more instructions" ${ahd_portable})
# MSVC has neither that nor 128-bit integers; clang-cl would need a runtime library for them.
set(ahd_portable OFF)
if (MSVC)
  set(ahd_portable ON)
endif ()
option(AHD_PORTABLE_ARITHMETIC "Of C++17 alone: AHD_PORTABLE, and no 128-bit integers" ${ahd_portable})
mark_as_advanced(AHD_PORTABLE AHD_PORTABLE_ARITHMETIC)
if (AHD_PORTABLE OR AHD_PORTABLE_ARITHMETIC)
  list(APPEND ahd_engine_options -DAHD_PORTABLE)
endif ()
if (AHD_PORTABLE_ARITHMETIC)
  list(APPEND ahd_engine_options -DAHD_WITHOUT_INT128)
endif ()
