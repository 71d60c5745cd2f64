# SPDX-License-Identifier: BSD-3-Clause
#
# Most of the compile time of a test run is that of test programs.
#
# ahd_quick_to_compile(<target> <level> [<header>...])
# Compiles a program of tests with the optimisation -O<level>, whatever the build type: only the code under test must be
# compiled as for users. The headers, all of them other projects', are compiled beforehand, once for all targets of one
# folder: these name the same headers and level, and have the same definitions and options. A compiler cache cannot keep
# objects that use such headers: with one they are left out.
function (ahd_quick_to_compile target level)
  if (NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    return ()
  endif ()
  target_compile_options(${target} PRIVATE -O${level})
  if (CMAKE_CXX_COMPILER_LAUNCHER OR NOT ARGN)
    return ()
  endif ()
  get_property(first DIRECTORY PROPERTY ahd_first_quick_target)
  if (first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else ()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(DIRECTORY PROPERTY ahd_first_quick_target ${target})
  endif ()
endfunction ()

# ahd_precompile_engine(<target>)
# Compiles the standard library's headers that most files of the engine include beforehand: for builds of the engine
# that are only tested. Installed builds are compiled without, so that a missing #include is noticed.
function (ahd_precompile_engine target)
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <atomic> <cmath> <cstddef> <cstdint> <functional>
      <limits> <memory> <string> <utility> <vector>)
  endif ()
endfunction ()

# ahd_unite_engine(<target>)
# Compiles the engine's files of a folder as one, in about half of the time: for builds under sanitizers. Files for
# one instruction set each stay alone.
function (ahd_unite_engine target)
  get_target_property(sources ${target} SOURCES)
  foreach (source IN LISTS sources)
    string(REGEX REPLACE ".*/([^/]+)/[^/]+$" "\\1" folder "${source}")
    if (NOT folder MATCHES "^(Insert|Predicates)$")
      set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${folder})
    endif ()
  endforeach ()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # which takes the file's own types for a header's
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif ()
endfunction ()
