// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDInput_h
#define vtkAHDInput_h

#include "Engine/Job/Run.h"
#include "Input/vtkAHDProjection.h"
#include "Pipeline/vtkAHDCellsView.h"
#include "Pipeline/vtkAHDPointsView.h"
#include "Pipeline/vtkAHDSettings.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <string>
#include <vector>

/**
 * The data sets of one execution as the engine reads them: points, ghost marks and cells, in
 * place. Holds the data sets and the arrays that it reads; that their memory is
 * not replaced while the opened views are in use, the progress looks (vtkAHDProgress::Watch()).
 */
class vtkAHDInput
{
public:
  /// `source` may be null. Nothing is allocated.
  vtkAHDInput(const vtkAHDSettings& settings, vtkPointSet* input, vtkPolyData* source);

  /// The engine's request: counts from the beginning, points and cells once they are open.
  const ahd::InputRequest& GetRequest() const { return this->Request; }

  /// Opens points and cells; converts points that are neither floats nor doubles, and ids that are
  /// not whole numbers of one size in memory. Throws vtkAHDStop on an abort, and
  /// std::bad_alloc.
  void Open(const vtkAHDContext& context);

  /// Triangles of a surface, or their number alone, which the run is to have. Borrows them.
  void GiveTriangles(const ahd::GivenTriangles& surface) { this->Request.surface = surface; }

  vtkPointSet* GetInput() const { return this->Input; }

  /// The source whose points are added; null if none are.
  vtkPolyData* GetSourceOfPoints() const;

  /// The content of the source besides lines and polygons; empty without a source.
  struct SourceContent
  {
    vtkIdType Points = 0;
    vtkIdType Vertices = 0;
    vtkIdType Strips = 0;
  };
  const SourceContent& GetSourceContent() const { return this->Found; }

  /// Is there an array vtkGhostType without one value per point? It is ignored.
  bool GetMarksAreUnfit() const { return this->MarksAreUnfit; }

  /// Are points neither floats nor doubles in memory? Then Open() converts them.
  bool MustConvertPoints() const { return this->InputPoints.MustBeConverted(); }

  /// Which of the input's arrays these points are a view of: places, marks; null where of none.
  std::array<vtkDataArray*, 2> FindBorrowed(const ahd::PointView& points) const;

  /// Have these arrays their numbers where the points read them? No more if they were given other
  /// memory since.
  bool AreInPlace(const ahd::PointView& points) const;

  /// Do the settings name arrays of numbers, which it reads beside places and marks?
  bool NamesNumbers() const
  {
    return this->Values || this->Weights || this->Keep || !this->UnfitNumbers.empty();
  }

  /// The names of arrays in the settings that are not there with one number for each point.
  const std::vector<std::string>& GetUnfitNumbers() const { return this->UnfitNumbers; }

  /// Copies of the values, weights and marks of points that the settings name; those of the points
  /// of the source behind. @pre Open()
  const ahd::PointNumbers& GetNumbers() const { return this->Numbers; }

  /// Bytes that Open() takes.
  std::size_t EstimateBytes() const;

private:
  void ReadMarks();
  void ReadCells(vtkPolyData* source);
  vtkSmartPointer<vtkDataArray> FindNumbers(bool areNamed, const std::string& name);
  void OpenNumbers(const vtkAHDContext& context);

  const vtkSmartPointer<vtkPointSet> Input;
  const vtkSmartPointer<vtkPolyData> Source;
  vtkAHDPointsView InputPoints;
  vtkAHDPointsView SourcePoints;
  vtkAHDCellsView Lines;
  vtkAHDCellsView Polygons;
  vtkSmartPointer<vtkUnsignedCharArray> Marks; // null: none that fit
  vtkAHDProjection Projection;
  ahd::InputRequest Request;
  SourceContent Found;
  bool MarksAreUnfit = false;
  vtkSmartPointer<vtkDataArray> Values, Weights, Keep; // null: none
  vtkSmartPointer<vtkDataArray> SourceValues;
  std::vector<std::string> UnfitNumbers;
  std::vector<double> ValueCopies, WeightCopies;
  std::vector<unsigned char> KeepCopies;
  ahd::PointNumbers Numbers;
};

#endif
