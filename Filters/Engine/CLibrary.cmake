# SPDX-License-Identifier: BSD-3-Clause
#
# The C interface as a shared library, AdaptiveHilbertDelaunay::C: libadaptivehilbertdelaunay, which
# exports the functions of Interface/ahd.h and of the headers that it includes, and nothing else. REQUIRES: the engine's
# target.
#
# Package.cmake installs it; built by scikit-build-core (pyproject.toml) it goes into the Python package.
add_library(AdaptiveHilbertDelaunayC SHARED
  "${CMAKE_CURRENT_LIST_DIR}/Interface/ahd.cxx" "${CMAKE_CURRENT_LIST_DIR}/Interface/ahd_edit.cxx"
  "${CMAKE_CURRENT_LIST_DIR}/Interface/ahd_refine.cxx" "${CMAKE_CURRENT_LIST_DIR}/Interface/ahd_tiles.cxx")
add_library(AdaptiveHilbertDelaunay::C ALIAS AdaptiveHilbertDelaunayC)
set_target_properties(AdaptiveHilbertDelaunayC PROPERTIES
  EXPORT_NAME               C
  OUTPUT_NAME               adaptivehilbertdelaunay
  CXX_STANDARD              17
  CXX_EXTENSIONS            OFF
  CXX_VISIBILITY_PRESET     hidden
  VISIBILITY_INLINES_HIDDEN ON)
target_compile_definitions(AdaptiveHilbertDelaunayC PRIVATE AHD_BUILDING_LIBRARY)
target_compile_options(AdaptiveHilbertDelaunayC PRIVATE
  ${ahd_engine_options} ${ahd_engine_warnings} ${ahd_engine_errors})
target_include_directories(AdaptiveHilbertDelaunayC INTERFACE
  "$<BUILD_INTERFACE:${CMAKE_CURRENT_LIST_DIR}/Interface>"
  "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/adaptivehilbertdelaunay/Engine/Interface>")
target_link_libraries(AdaptiveHilbertDelaunayC PRIVATE AdaptiveHilbertDelaunayEngine)

# Symbols of the standard library's templates stay hidden.
if (WIN32)
  # The same name with every compiler, and one file: without the compiler's own DLLs.
  set_target_properties(AdaptiveHilbertDelaunayC PROPERTIES PREFIX "")
  if (MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # zig links its own statically anyway
    target_link_options(AdaptiveHilbertDelaunayC PRIVATE -static)
  endif ()
elseif (APPLE)
  include(CheckLinkerFlag)
  check_linker_flag(CXX "LINKER:-exported_symbol,_ahd_*" AHD_EXPORTED_SYMBOL)
  if (AHD_EXPORTED_SYMBOL)
    target_link_options(AdaptiveHilbertDelaunayC PRIVATE "LINKER:-exported_symbol,_ahd_*")
  else () # zig's has neither that option nor lists of symbols, and would export the operators of its standard library
    set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/Interface/HiddenOperators.cxx" PROPERTIES
      COMPILE_DEFINITIONS AHD_HIDDEN_OPERATORS
      COMPILE_OPTIONS     -fvisibility-global-new-delete=force-hidden)
  endif ()
elseif (UNIX)
  set(ahd_exports "${CMAKE_CURRENT_LIST_DIR}/Interface/exports.map")
  target_link_options(AdaptiveHilbertDelaunayC PRIVATE
    "LINKER:--version-script=${ahd_exports}" "LINKER:--no-undefined")
  set_target_properties(AdaptiveHilbertDelaunayC PROPERTIES LINK_DEPENDS "${ahd_exports}")
endif ()

if (SKBUILD)
  install(TARGETS AdaptiveHilbertDelaunayC
    LIBRARY DESTINATION adaptivehilbertdelaunay
    RUNTIME DESTINATION adaptivehilbertdelaunay)
  get_filename_component(ahd_python_sources "${CMAKE_CURRENT_LIST_DIR}/../Python" ABSOLUTE)
  if (SKBUILD_STATE STREQUAL "editable")
    configure_file("${ahd_python_sources}/editable.py.in" "editable/__init__.py" @ONLY)
    install(FILES "${CMAKE_CURRENT_BINARY_DIR}/editable/__init__.py" DESTINATION adaptivehilbertdelaunay)
  else ()
    install(DIRECTORY "${ahd_python_sources}/" DESTINATION adaptivehilbertdelaunay
      FILES_MATCHING PATTERN "*.py" PATTERN "py.typed"
      PATTERN "__pycache__" EXCLUDE PATTERN "_compiled.py" EXCLUDE) # which needs a VTK of its own
  endif ()
  set(AHD_PYTHON_DIR ".")
  add_subdirectory("${CMAKE_CURRENT_LIST_DIR}/../../Plugin/Python" PythonPlugin) # one file, for ParaView
  return ()
endif ()

file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/Interface/ahd.h" ahd_abi_version REGEX "define AHD_ABI_VERSION")
string(REGEX REPLACE "[^0-9]" "" ahd_abi_version "${ahd_abi_version}")
set_target_properties(AdaptiveHilbertDelaunayC PROPERTIES
  VERSION   "${ahd_engine_version}"
  SOVERSION "${ahd_abi_version}")
