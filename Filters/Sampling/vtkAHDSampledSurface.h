// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampledSurface_h
#define vtkAHDSampledSurface_h

#include "Engine/Core/Fingerprint.h"
#include "Engine/Core/Uninitialised.h"
#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDLentTriangulation.h"
#include "Input/vtkAHDInput.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Sampling/vtkAHDGivenSurface.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

/// When what says how to triangulate was changed last: the filter with the settings itself, and its
/// transform. No two changes, whatever of, have one time; the later of the two alone would hide a
/// change of the other.
using vtkAHDSettingsTimes = std::array<vtkMTimeType, 2>;

/**
 * A triangulation to interpolate on, which can be kept for the next execution. It holds the arrays
 * that the triangulation borrows; their memory it cannot hold, so IsOf() looks whether it is where
 * it was. Or it borrows the triangulation itself, from the filter that made the surface.
 */
class vtkAHDSampledSurface
{
public:
  /// `surface`: null, or the input, if its own triangles are to be used. Throws vtkAHDStop and
  /// std::bad_alloc.
  vtkAHDSampledSurface(const vtkAHDSettings& settings, vtkPointSet* input, vtkPolyData* source,
    vtkPolyData* surface, const vtkAHDContext& context);
  /// `lent`: the triangulation that `surface` was written from, given back to `lender` in the end.
  vtkAHDSampledSurface(const vtkAHDSettings& settings, vtkPolyData* surface,
    vtkAHDLentTriangulation::ContentPointer lent, vtkSmartPointer<vtkAHDLentTriangulation> lender);
  ~vtkAHDSampledSurface();
  vtkAHDSampledSurface(const vtkAHDSampledSurface&) = delete;
  void operator=(const vtkAHDSampledSurface&) = delete;

  /// Is the triangulation only borrowed?
  bool IsLent() const { return this->Lent != nullptr; }

  /// Points and segments as they are known before, for estimates.
  vtkAHDInput& GetInput() { return *this->View; }

  /// Triangulates: see vtkAHDExecution::Triangulate(). Of a surface it finds the triangles.
  vtkAHDReport Make(
    vtkAHDExecution& execution, std::size_t bytesBehind, const std::vector<double>& stagesBehind);

  /// Finds which triangles count, and tells the report. After Make(), once.
  void Select(const vtkAHDSettings& settings, const vtkAHDContext& context, vtkAHDReport& report);

  /// Remembers what it was made of, as the settings were changed last at `settings`.
  void Remember(const vtkAHDSettingsTimes& settings, const vtkAHDContext& context);

  /// Is it the surface of these, with settings of those times, and all that it reads where it was?
  /// False if the filter is to abort. Nobody may be told of progress before MakeHeights().
  bool IsOf(const vtkAHDSettingsTimes& settings, vtkPointSet* input, vtkPolyData* source,
    vtkPolyData* surface, const vtkAHDContext& context) const;

  /// The point data that interpolation is to work on from now on, of the same points.
  void TakeData(vtkPointSet* input, vtkPolyData* source);

  /// Point data with a value for each point, added ones included.
  vtkSmartPointer<vtkPointData> MakePointData(const vtkAHDContext& context) const;

  /// The height of each point above the plane of the triangulation. After this, places and heights
  /// of points are not read from the input any more.
  ahd::UninitialisedVector<double> MakeHeights(
    const vtkAHDSettings& settings, const vtkAHDContext& context);

  const ahd::PreparedInput& GetPoints() const { return this->GetMade().points; }
  ahd::Triangulation& GetTriangulation()
  {
    return this->Lent ? this->Lent->Made.triangulation : this->Made.triangulation;
  }
  std::size_t GetTriangleCount() const { return this->GetMade().triangleCount(); }
  /// As a Sampler wants it.
  const unsigned char* GetKept() const
  {
    const std::vector<unsigned char>& kept = this->GetMade().selection.kept;
    return kept.empty() ? nullptr : kept.data();
  }

  /// Lets go of all data of points and cells until the next TakeData(): between executions only
  /// what the triangulation was made of is held.
  void DropData();

  /// Bytes of what it was made of, which nobody else may hold.
  std::size_t CountInputBytes() const;

  /// Lets the workspace have the memory, unless the triangulation is only borrowed.
  void GiveBack(ahd::Workspace& workspace);

private:
  /// Arrays: what they are, and where.
  struct Identity
  {
    std::vector<ahd::Fingerprint> Prints;
    std::vector<const void*> Places;
  };
  const ahd::RunResult& GetMade() const { return this->Lent ? this->Lent->Made : this->Made; }
  static std::vector<vtkDataArray*> ArraysOf(
    vtkPointSet* input, vtkPolyData* source, vtkPolyData* surface);
  static bool Identify(vtkPointSet* input, vtkPolyData* source, vtkPolyData* surface,
    const vtkAHDContext& context, Identity& found);

  vtkSmartPointer<vtkPointSet> Input; // shallow copies
  vtkSmartPointer<vtkPolyData> Source;
  vtkSmartPointer<vtkPolyData> Surface; // null, or a shallow copy
  vtkSmartPointer<vtkPointSet> Corners; // of the surface: the input, others marked as hidden
  vtkSmartPointer<vtkUnsignedCharArray> GivenMarks; // those of the input; null: none
  vtkSmartPointer<vtkUnsignedCharArray> Marks;      // of the corners
  std::unique_ptr<vtkAHDGivenSurface> Given;        // of the surface, until its triangles are found
  std::unique_ptr<vtkAHDInput> View;
  ahd::RunResult Made;
  vtkAHDLentTriangulation::ContentPointer Lent; // null: Made is to be used
  vtkSmartPointer<vtkAHDLentTriangulation> Lender;
  vtkAHDSettingsTimes Settings = {};
  bool IsKnown = false;
  Identity Known;
};

#endif
