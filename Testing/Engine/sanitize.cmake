# SPDX-License-Identifier: BSD-3-Clause
#
# Configures, builds and runs the engine's tests under sanitizers:
#   cmake -DSOURCE=Testing/Engine -DBINARY=<build> -DSETTINGS=-DAHD_SANITIZE=<sanitizers>[;...]
#         [-DGENERATOR=..] [-DCOMPILER=..] [-DC_COMPILER=..] [-DLAUNCHER=..] -P sanitize.cmake
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)

set(settings ${SETTINGS})
if (COMPILER)
  list(APPEND settings "-DCMAKE_CXX_COMPILER=${COMPILER}")
endif ()
if (C_COMPILER)
  list(APPEND settings "-DCMAKE_C_COMPILER=${C_COMPILER}")
endif ()
if (LAUNCHER)
  list(APPEND settings "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")
endif ()
if (GENERATOR)
  list(APPEND settings -G "${GENERATOR}")
endif ()

function (run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "Engine tests under sanitizers (${SETTINGS}): ${what} failed (${result}).")
  endif ()
endfunction ()

run("configuring" "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BINARY}" ${settings})
run("building" "${CMAKE_COMMAND}" --build "${BINARY}" --parallel ${cores})
run("testing" "${CMAKE_CTEST_COMMAND}" --test-dir "${BINARY}" --output-on-failure -j ${cores})
