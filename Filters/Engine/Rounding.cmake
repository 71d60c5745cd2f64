# SPDX-License-Identifier: BSD-3-Clause
#
# Sets ahd_rounding_options: compile options of all code that computes results. Each product and each sum is rounded, as
# the error bounds of the predicates assume; a compiler that contracts a * b + c into one operation, as many do where
# the processor has it (every ARM), gives other bits. Lint.Rounding checks that every object has them.
set(ahd_rounding_options)
if (CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND MSVC)
  set(ahd_rounding_options /clang:-ffp-contract=off)
elseif (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(ahd_rounding_options -ffp-contract=off)
elseif (MSVC AND MSVC_VERSION LESS 1930) # whose /fp:precise contracts
  set(ahd_rounding_options /fp:strict)
elseif (MSVC)
  set(ahd_rounding_options /fp:precise)
endif ()
