// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_MeshJudge_h
#define ahd_MeshJudge_h

#include <string>

class vtkAdaptiveHilbertQualityMesh2D;

namespace ahd
{
namespace fuzz
{

/// Both outputs.
std::string outputsOf(vtkAdaptiveHilbertQualityMesh2D* mesh);

/// The faults of the outputs, by the filter's documentation; empty if none. Angles, areas and
/// lengths of triangles that are as wished are measured in long double, in the plane of x and y.
/// `said`: the filter ended in an error.
std::string faultOf(vtkAdaptiveHilbertQualityMesh2D* mesh, bool said);

} // namespace fuzz
} // namespace ahd

#endif
