# SPDX-License-Identifier: BSD-3-Clause
#
# The engine as a package, from the build tree and from the install tree: find_package(AdaptiveHilbertDelaunay COMPONENTS
# Engine C) and, for other builds, adaptivehilbertdelaunay.pc of the C library. The project adds the filter to it (Filters).
# REQUIRES: the engine's targets, GNUInstallDirs. Sets
#   ahd_cmake_dir  where CMake's files go, below the build tree and below the install prefix
include(CMakePackageConfigHelpers)
set(ahd_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/AdaptiveHilbertDelaunay")
set(ahd_built "${CMAKE_BINARY_DIR}/${ahd_cmake_dir}")
set(ahd_headers_dir "${CMAKE_INSTALL_INCLUDEDIR}/adaptivehilbertdelaunay/Engine")
set(ahd_c_library)
if (AHD_BUILD_C_LIBRARY)
  set(ahd_c_library AdaptiveHilbertDelaunayC)
  # relative, as an installation may be moved
  set(ahd_pc_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
  file(RELATIVE_PATH ahd_headers_from_pc "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig"
    "${CMAKE_INSTALL_FULL_INCLUDEDIR}/adaptivehilbertdelaunay/Engine/Interface")
  configure_file("${CMAKE_CURRENT_LIST_DIR}/adaptivehilbertdelaunay.pc.in" "${ahd_built}/adaptivehilbertdelaunay.pc" @ONLY)
  install(FILES "${ahd_built}/adaptivehilbertdelaunay.pc" DESTINATION "${ahd_pc_dir}")
endif ()

install(TARGETS AdaptiveHilbertDelaunayEngine ${ahd_c_library}
  EXPORT  AdaptiveHilbertDelaunayEngine
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
foreach (header IN LISTS ahd_engine_headers)
  get_filename_component(folder "${header}" DIRECTORY)
  install(FILES "${CMAKE_CURRENT_LIST_DIR}/${header}" DESTINATION "${ahd_headers_dir}/${folder}")
endforeach ()
install(EXPORT AdaptiveHilbertDelaunayEngine
  NAMESPACE   AdaptiveHilbertDelaunay::
  FILE        AdaptiveHilbertDelaunayEngine-targets.cmake
  DESTINATION "${ahd_cmake_dir}")
export(EXPORT AdaptiveHilbertDelaunayEngine
  NAMESPACE AdaptiveHilbertDelaunay::
  FILE      "${ahd_built}/AdaptiveHilbertDelaunayEngine-targets.cmake")

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/AdaptiveHilbertDelaunayConfig.cmake.in" "${ahd_built}/AdaptiveHilbertDelaunayConfig.cmake"
  INSTALL_DESTINATION "${ahd_cmake_dir}")
write_basic_package_version_file("${ahd_built}/AdaptiveHilbertDelaunayConfigVersion.cmake"
  VERSION "${ahd_engine_version}" COMPATIBILITY SameMajorVersion)
configure_file("${CMAKE_CURRENT_LIST_DIR}/Rounding.cmake" "${ahd_built}/Rounding.cmake" COPYONLY)
install(FILES "${ahd_built}/AdaptiveHilbertDelaunayConfig.cmake" "${ahd_built}/AdaptiveHilbertDelaunayConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/Rounding.cmake"
  DESTINATION "${ahd_cmake_dir}")
