# SPDX-License-Identifier: BSD-3-Clause
#
# ahd_mend_package(<package>)
# REQUIRES: to be called before find_package(<package>), ParaView or VTK.
#
# Debian's paraview-dev 5.13 and 6.1 name Python modules in their CMake files that are installed under
# another name (vtkCommonCore.so for vtkCommonCore.cpython-313-x86_64-linux-gnu.so), and CMake refuses
# a package whose files are missing. Where the package that find_package would take is such a one, its
# CMake files are copied to the build tree, with the names that are there, and <package>_DIR is set to
# the copy; AHD_<package>_DIR is where the package is, mended or not (unset if there is none).
# Nothing outside the build tree is touched, and other packages are left as they are.
function (ahd_mend_package package)
  string(TOLOWER "${package}" name)
  set(mended "${CMAKE_BINARY_DIR}/mended/${package}")
  if ("${${package}_DIR}" STREQUAL mended) # by an earlier run of CMake
    set(${package}_DIR "${AHD_${package}_DIR}" CACHE PATH "Where ${package} is" FORCE)
    set(${package}_DIR "${AHD_${package}_DIR}")
  endif ()
  # The version file stands for the package, which would fail to load.
  find_package(${package} QUIET CONFIG
    CONFIGS ${name}-config-version.cmake ${package}ConfigVersion.cmake)
  set(folder "${${package}_DIR}")
  if (NOT folder)
    unset(AHD_${package}_DIR CACHE)
    return ()
  endif ()
  set(AHD_${package}_DIR "${folder}" CACHE INTERNAL "Where ${package} is")
  ahd_misnamed_modules(misnamed "${folder}" "${name}")
  if (NOT misnamed)
    return ()
  endif ()
  list(LENGTH misnamed count)
  message(STATUS "${count} Python modules are misnamed in ${folder}: a mended copy is in ${mended}")
  file(REMOVE_RECURSE "${mended}")
  file(COPY "${folder}/" DESTINATION "${mended}")
  ahd_rename_modules("${mended}" "${folder}" "${misnamed}")
  set(${package}_DIR "${mended}" CACHE PATH "Where ${package} is" FORCE)
  set(${package}_DIR "${mended}" PARENT_SCOPE) # whoever has set a variable of that name
endfunction ()

# The misnamed modules of a package, as "name in the file|name that is there", below its prefix.
function (ahd_misnamed_modules result folder name)
  set(${result} "" PARENT_SCOPE)
  if (NOT EXISTS "${folder}/${name}-prefix.cmake")
    return ()
  endif ()
  include("${folder}/${name}-prefix.cmake") # sets this:
  set(prefix "${_vtk_module_import_prefix}")
  set(misnamed)
  file(GLOB lists "${folder}/*Python*-targets-*.cmake" "${folder}/vtk/*Python*-targets-*.cmake")
  foreach (list IN LISTS lists)
    file(STRINGS "${list}" lines REGEX "IMPORTED_LOCATION.*{_IMPORT_PREFIX}/.*\\.so\"")
    foreach (line IN LISTS lines)
      string(REGEX REPLACE ".*{_IMPORT_PREFIX}/(.*)\\.so\".*" "\\1" module "${line}")
      if (EXISTS "${prefix}/${module}.so")
        continue ()
      endif ()
      file(GLOB there RELATIVE "${prefix}" "${prefix}/${module}.cpython-*.so")
      if (there)
        list(GET there 0 there)
        list(APPEND misnamed "${module}.so|${there}")
      endif ()
    endforeach ()
  endforeach ()
  list(REMOVE_DUPLICATES misnamed)
  set(${result} "${misnamed}" PARENT_SCOPE)
endfunction ()

# Puts the names that are there into the copy of a package's files, which go on to find everything
# from where the originals are.
function (ahd_rename_modules copy folder misnamed)
  file(GLOB_RECURSE files RELATIVE "${copy}" "${copy}/*.cmake")
  foreach (file IN LISTS files)
    file(READ "${copy}/${file}" text)
    set(before "${text}")
    get_filename_component(origin "${folder}/${file}" DIRECTORY)
    # how a file finds the package's prefix
    string(REPLACE "_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\"" "_IMPORT_PREFIX \"${folder}/${file}\""
      text "${text}")
    string(REPLACE "_vtk_module_import_prefix \"\${CMAKE_CURRENT_LIST_DIR}\""
      "_vtk_module_import_prefix \"${origin}\"" text "${text}")
    string(REPLACE "\"\${CMAKE_CURRENT_LIST_DIR}/../" "\"${origin}/../" text "${text}")
    if (file MATCHES "Python.*-targets-")
      foreach (pair IN LISTS misnamed)
        string(REPLACE "|" ";" pair "${pair}")
        list(GET pair 0 wrong)
        list(GET pair 1 right)
        string(REPLACE "/${wrong}\"" "/${right}\"" text "${text}")
      endforeach ()
    endif ()
    if (NOT text STREQUAL before)
      file(WRITE "${copy}/${file}" "${text}")
    endif ()
  endforeach ()
endfunction ()
