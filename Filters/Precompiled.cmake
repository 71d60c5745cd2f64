# SPDX-License-Identifier: BSD-3-Clause
#
# ahd_precompile_vtk(<target>)
# Half of the time in which a file of the filter is compiled goes into VTK's headers. Compiles those that most files
# include beforehand. Not with a compiler cache, which could not keep what uses them, and not in somebody else's
# project: so a missing #include is noticed there (Package.Subproject).
function (ahd_precompile_vtk target)
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT MINGW)
    target_precompile_headers(${target} PRIVATE
      <algorithm> <functional> <memory> <string> <vector>
      <vtkCellArray.h> <vtkDataSetAttributes.h> <vtkDoubleArray.h> <vtkIdTypeArray.h> <vtkInformation.h>
      <vtkInformationVector.h> <vtkMultiBlockDataSet.h> <vtkNew.h> <vtkPointData.h> <vtkPoints.h> <vtkPolyData.h>
      <vtkPolyDataAlgorithm.h> <vtkSmartPointer.h>)
  endif ()
endfunction ()
