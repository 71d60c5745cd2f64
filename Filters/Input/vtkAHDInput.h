// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDInput_h
#define vtkAHDInput_h

#include "Engine/Prepare/Prepare.h"
#include "Input/vtkAHDProjection.h"
#include "Pipeline/vtkAHDCellsView.h"
#include "Pipeline/vtkAHDPointsView.h"
#include "Pipeline/vtkAHDSettings.h"

#include <array>

class vtkPointSet;
class vtkPolyData;

/**
 * The data sets of one execution as the engine takes them: points, ghost marks and cells, looked at
 * where they lie. Borrows the data sets, which must outlive it.
 */
class vtkAHDInput
{
public:
  /// `source` may be null. Nothing is allocated.
  vtkAHDInput(const vtkAHDSettings& settings, vtkPointSet* input, vtkPolyData* source);

  /// What is asked of the engine: counts from the beginning, points and cells once they are open.
  const ahd::InputRequest& GetRequest() const { return this->Request; }

  /// Opens points and cells; converts points that are neither floats nor doubles, and ids that are
  /// not whole numbers of one size in memory. Throws vtkAHDStop if the filter is to abort, and
  /// std::bad_alloc.
  void Open(const vtkAHDContext& context);

  vtkPointSet* GetInput() const { return this->Input; }

  /// The source whose points are added; null if none are.
  vtkPolyData* GetSourceOfPoints() const;

  /// What there is in the source besides lines and polygons; none in no source.
  struct SourceContent
  {
    vtkIdType Points = 0;
    vtkIdType Vertices = 0;
    vtkIdType Strips = 0;
  };
  const SourceContent& GetSourceContent() const { return this->Found; }

  /// Is there an array vtkGhostType that has not one value per point? It is ignored.
  bool GetMarksAreUnfit() const { return this->MarksAreUnfit; }

  /// Are points neither floats nor doubles in memory? Then Open() converts them.
  bool MustConvertPoints() const { return this->InputPoints.MustBeConverted(); }

  /// Which of the input's arrays these points are a view of: places, marks; null where of none.
  std::array<vtkDataArray*, 2> FindBorrowed(const ahd::PointView& points) const;

  /// Bytes that Open() takes.
  std::size_t EstimateBytes() const
  {
    return this->InputPoints.EstimateBytes() + this->SourcePoints.EstimateBytes() +
      this->Lines.EstimateBytes() + this->Polygons.EstimateBytes();
  }

private:
  void ReadMarks();
  void ReadCells(vtkPolyData* source);

  vtkPointSet* const Input;
  vtkPolyData* const Source;
  vtkAHDPointsView InputPoints;
  vtkAHDPointsView SourcePoints;
  vtkAHDCellsView Lines;
  vtkAHDCellsView Polygons;
  vtkAHDProjection Projection;
  ahd::InputRequest Request;
  SourceContent Found;
  bool MarksAreUnfit = false;
};

#endif
