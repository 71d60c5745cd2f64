# SPDX-License-Identifier: BSD-3-Clause
#
# The C library exports the functions of its headers and nothing else:
#   cmake -DLIBRARY=<file> -DHEADERS=<file>,<file> -DNM=<program> -P exports.cmake
execute_process(COMMAND "${NM}" -D --defined-only "${LIBRARY}" OUTPUT_VARIABLE listed RESULT_VARIABLE failed)
if (failed)
  message(FATAL_ERROR "${NM} cannot read ${LIBRARY}")
endif ()
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
set(exported)
foreach (line IN LISTS lines)
  string(REGEX REPLACE "^.* " "" name "${line}")
  string(REGEX REPLACE "@.*" "" name "${name}")
  list(APPEND exported "${name}")
endforeach ()

set(declared)
string(REPLACE "," ";" headers "${HEADERS}")
foreach (header IN LISTS headers)
  file(STRINGS "${header}" lines REGEX "^AHD_API ")
  foreach (line IN LISTS lines)
    string(REGEX MATCH "ahd_[a-z0-9_]+\\(" name "${line}")
    string(REPLACE "(" "" name "${name}")
    list(APPEND declared "${name}")
  endforeach ()
endforeach ()

list(SORT exported)
list(SORT declared)
list(LENGTH declared count)
if (count LESS 20 OR NOT "${exported}" STREQUAL "${declared}")
  message(FATAL_ERROR "exported:\n${exported}\ndeclared:\n${declared}")
endif ()
message(STATUS "${count} functions are exported, and nothing else")
