# SPDX-License-Identifier: BSD-3-Clause
#
# The engine as a part of the project, as in Plugin/Documentation/Installing.md. Nothing of it is compiled here: the
# program is, as part of the project, and linked with what the build has compiled.
#   OUTSIDE_FETCHES  the sources
#   OUTSIDE_LIBRARY  the engine's library
include(FetchContent)
FetchContent_Declare(ahd SOURCE_DIR "${OUTSIDE_FETCHES}" SOURCE_SUBDIR Filters/Engine)
set(CMAKE_UNITY_BUILD ON)
set(CMAKE_CXX_COMPILER_LAUNCHER "env;AHD_OWN=1")
set(AHD_ENGINE_LAUNCHER env)
FetchContent_MakeAvailable(ahd)
add_library(OutsideObject OBJECT main.cxx)
target_link_libraries(OutsideObject PRIVATE AdaptiveHilbertDelaunay::Engine)

find_package(Threads REQUIRED)
add_executable(OutsideEngine $<TARGET_OBJECTS:OutsideObject>)
target_link_libraries(OutsideEngine PRIVATE "${OUTSIDE_LIBRARY}" Threads::Threads)

get_directory_property(tests DIRECTORY "${OUTSIDE_FETCHES}/Filters/Engine" TESTS)
if (CMAKE_BUILD_TYPE OR DEFINED BUILD_TESTING OR tests OR TARGET AdaptiveHilbertDelaunay::C)
  message(FATAL_ERROR "the engine changed this project: ${CMAKE_BUILD_TYPE} ${BUILD_TESTING} ${tests}")
endif ()
get_target_property(unity AdaptiveHilbertDelaunayEngine UNITY_BUILD)
if (unity)
  message(FATAL_ERROR "in this project the engine would be compiled as one file")
endif ()
get_target_property(launcher AdaptiveHilbertDelaunayEngine CXX_COMPILER_LAUNCHER)
if (NOT launcher STREQUAL CMAKE_CXX_COMPILER_LAUNCHER)
  message(FATAL_ERROR "in this project the engine would be compiled by ${launcher}")
endif ()
get_target_property(options AdaptiveHilbertDelaunayEngine COMPILE_OPTIONS)
if (options MATCHES "-Werror" OR (CMAKE_COMPILER_IS_GNUCXX AND NOT options MATCHES "-ffp-contract=off"))
  message(FATAL_ERROR "in this project the engine would be compiled with ${options}")
endif ()
get_target_property(passed_on AdaptiveHilbertDelaunayEngine INTERFACE_COMPILE_OPTIONS)
if (CMAKE_COMPILER_IS_GNUCXX AND NOT passed_on MATCHES "-ffp-contract=off")
  message(FATAL_ERROR "functions in the headers would be compiled with ${passed_on}")
endif ()
