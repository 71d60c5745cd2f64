# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DFOLDER=<scratch> -P run.cmake
# Makes the package of CMakeLists.txt, sees it refused, mended, mended once more in the same build tree, and
# left alone.
set(faulty "${FOLDER}/faulty")
set(files "${faulty}/lib/cmake/paraview-5.13")
file(REMOVE_RECURSE "${FOLDER}")
file(WRITE "${faulty}/lib/python3/x.cpython-313-any.so" "")
file(WRITE "${files}/paraview-config-version.cmake" "set(PACKAGE_VERSION 5.13.2)\nset(PACKAGE_VERSION_COMPATIBLE ON)\n")
file(WRITE "${files}/paraview-config.cmake" [=[
include("${CMAKE_CURRENT_LIST_DIR}/paraview-prefix.cmake")
set(ParaView_PREFIX "${_vtk_module_import_prefix}")
include("${CMAKE_CURRENT_LIST_DIR}/ParaViewPython-targets.cmake")
]=])
set(ups "")
foreach (up RANGE 1 3)
  string(APPEND ups "get_filename_component(VARIABLE \"\${VARIABLE}\" DIRECTORY)\n")
endforeach ()
string(REPLACE VARIABLE _vtk_module_import_prefix prefix_ups "${ups}")
file(WRITE "${files}/paraview-prefix.cmake"
  "set(_vtk_module_import_prefix \"\${CMAKE_CURRENT_LIST_DIR}\")\n${prefix_ups}")
string(REPLACE VARIABLE _IMPORT_PREFIX import_ups "${ups}")
file(WRITE "${files}/ParaViewPython-targets.cmake"
  "add_library(ParaView::xPython MODULE IMPORTED)\n"
  "get_filename_component(_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\" PATH)\n${import_ups}"
  "include(\"\${CMAKE_CURRENT_LIST_DIR}/ParaViewPython-targets-debug.cmake\")\n"
  "if (NOT EXISTS \"\${file}\")\n  message(FATAL_ERROR \"but this file does not exist: \${file}\")\nendif ()\n")
file(WRITE "${files}/ParaViewPython-targets-debug.cmake" [=[
set_target_properties(ParaView::xPython PROPERTIES
  IMPORTED_LOCATION_DEBUG "${_IMPORT_PREFIX}/lib/python3/x.so"
  )
set(file "${_IMPORT_PREFIX}/lib/python3/x.so" )
]=])

function (hash_of_all result)
  file(GLOB_RECURSE all "${faulty}/*")
  set(hashes "")
  foreach (file IN LISTS all)
    file(SHA256 "${file}" hash)
    list(APPEND hashes "${file} ${hash}")
  endforeach ()
  set(${result} "${hashes}" PARENT_SCOPE)
endfunction ()

hash_of_all(before)
foreach (case IN ITEMS refused mended mended)
  set(as_it_is OFF)
  if (case STREQUAL "refused")
    set(as_it_is ON)
  endif ()
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${FOLDER}/${case}" -G "${GENERATOR}"
      "-DFAULTY=${faulty}"
      "-DLEAVE_AS_IT_IS=${as_it_is}"
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if (case STREQUAL "refused" AND NOT said MATCHES "but this file does not exist")
    message(FATAL_ERROR "the faulty package was not refused:\n${said}")
  elseif (case STREQUAL "mended" AND NOT status EQUAL 0)
    message(FATAL_ERROR "the package could not be mended:\n${said}")
  endif ()
endforeach ()
hash_of_all(after)
if (NOT before STREQUAL after)
  message(FATAL_ERROR "the package itself was touched")
endif ()
