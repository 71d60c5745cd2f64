# SPDX-License-Identifier: BSD-3-Clause
#
# Libraries under the sanitizers for the Python package, in place of those it is built with: see
# Testing/Package/Lifetimes. They are loaded into a Python without a sanitizer, so the
# sanitizers' own library comes with LD_PRELOAD; its path is written to watched/runtime.txt.
#   watched/libadaptivehilbertdelaunay.so          the C library
#   watched/libAdaptiveHilbertDelaunayFilters.so   that of the compiled classes, without ranks
set(ahd_watched_folder "${CMAKE_CURRENT_BINARY_DIR}/watched")
execute_process(
  COMMAND "${CMAKE_CXX_COMPILER}" -print-file-name=libclang_rt.asan-${CMAKE_SYSTEM_PROCESSOR}.so
  OUTPUT_VARIABLE ahd_sanitizer OUTPUT_STRIP_TRAILING_WHITESPACE)
file(WRITE "${ahd_watched_folder}/runtime.txt" "${ahd_sanitizer}")
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/watched.cxx" "// all there is comes out of libraries\n")

# ahd_add_watched_library(<target> <name of the file> <static library>...)
function (ahd_add_watched_library target name)
  add_library(${target} SHARED "${CMAKE_CURRENT_BINARY_DIR}/watched.cxx")
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY "${ahd_watched_folder}")
  target_link_options(${target} PRIVATE
    ${ahd_fuzz_sanitizers} -shared-libasan -Wl,-Bsymbolic -Wl,--allow-shlib-undefined)
  foreach (library IN LISTS ARGN)
    target_link_libraries(${target} PRIVATE
      -Wl,--whole-archive $<TARGET_FILE:${library}> -Wl,--no-whole-archive)
    add_dependencies(${target} ${library})
  endforeach ()
  target_link_libraries(${target} PRIVATE Threads::Threads)
endfunction ()

ahd_add_watched_library(ahd_watched_c adaptivehilbertdelaunay ahd_fuzz_engine)
if (TARGET ahd_fuzz_filter)
  ahd_add_watched_library(
    ahd_watched_filters AdaptiveHilbertDelaunayFilters ahd_fuzz_filter ahd_fuzz_engine)
  target_link_libraries(ahd_watched_filters PRIVATE VTK::CommonCore VTK::CommonDataModel
    VTK::CommonExecutionModel VTK::CommonMath VTK::CommonTransforms)
endif ()
