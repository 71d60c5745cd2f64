// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
/**
 * @class   vtkAdaptiveHilbertQualityMeshAlgorithm
 * @brief   settings and measures of vtkAdaptiveHilbertQualityMesh2D
 *
 * The superclass of vtkAdaptiveHilbertQualityMesh2D: its numeric settings, the name of an array and
 * its measures. The filter's Triangulation has the settings of the triangulation.
 *
 * @sa
 * vtkAdaptiveHilbertQualityMesh2D
 */

#ifndef vtkAdaptiveHilbertQualityMeshAlgorithm_h
#define vtkAdaptiveHilbertQualityMeshAlgorithm_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for names and texts

class vtkFieldData;

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertQualityMeshAlgorithm
  : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkAdaptiveHilbertQualityMeshAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The smallest angle that triangles may have, in degrees. 0: any. From 0 to 34. Default 20.
  /// It ends by theorem up to 20.7, where segments meet in 60 degrees or more, and in practice up
  /// to 34: set MaximumNumberOfAddedPoints above 30. Angles between segments stay as they are.
  virtual void SetMinimumAngle(double value);
  virtual double GetMinimumAngleMinValue() { return 0.0; }
  virtual double GetMinimumAngleMaxValue() { return 34.0; }
  vtkGetMacro(MinimumAngle, double);
  ///@}

  ///@{
  /// The largest area that triangles may have, in the plane of the triangulation. 0: any. Default
  /// 0, at least 0.
  virtual void SetMaximumArea(double value);
  virtual double GetMaximumAreaMinValue() { return 0.0; }
  virtual double GetMaximumAreaMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(MaximumArea, double);
  ///@}

  ///@{
  /// The largest length that edges may have, in the plane of the triangulation. 0: any. Default 0,
  /// at least 0.
  virtual void SetMaximumLength(double value);
  virtual double GetMaximumLengthMinValue() { return 0.0; }
  virtual double GetMaximumLengthMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(MaximumLength, double);
  ///@}

  ///@{
  /// The point array with the longest edge wished at each point, linear between the points; all its
  /// numbers must be finite and greater than 0. Empty or "None": edges may have any length. Default
  /// "".
  /// One number for each point. With a source whose points are added, the source has an array of
  /// this name, too; without one, the execution ends with an error.
  virtual void SetSizeArrayName(const std::string& name);
  virtual std::string GetSizeArrayName() { return this->SizeArrayName; }
  ///@}

  ///@{
  /// Stop after so many added points. Triangles that are not as wished by then are marked in
  /// BadReason. -1: as many as it takes. Default -1, at least -1.
  vtkSetClampMacro(MaximumNumberOfAddedPoints, vtkIdType, -1, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfAddedPoints, vtkIdType);
  ///@}

  ///@{
  /// Triangles of the mesh, in the last run.
  /// Counts are 0 if the run was aborted or failed; they are field data of the mesh, too.
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /// Points added by the refinement, in the last run: the last ones of the mesh.
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);
  ///@}

  ///@{
  /// Those of the added points that divide segments, in the last run.
  vtkGetMacro(NumberOfPointsAddedToSegments, vtkIdType);
  ///@}

  ///@{
  /// Triangles that are not as wished, in the last run; BadReason says why.
  vtkGetMacro(NumberOfBadTriangles, vtkIdType);
  ///@}

  ///@{
  /// Pieces of segments that could not be split though a point lies close to them, in the last run.
  vtkGetMacro(NumberOfEncroachedPieces, vtkIdType);
  ///@}

  ///@{
  /// The least angle of all triangles in degrees, in the plane of the triangulation, in the last
  /// run.
  vtkGetMacro(LeastAngle, double);
  ///@}

  ///@{
  /// The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its
  /// input, or was refused: the number that is compared with Memory Limit.
  vtkGetMacro(MemoryEstimate, vtkTypeInt64);
  ///@}

  /// What the last run found, as a text with a line for each number. Numbers that are 0 are left
  /// out, but for the first. Empty before a run.
  virtual std::string GetMeasures();

  /// What the last run took, as a text with a line for each number. Numbers that are 0 are left
  /// out, but for the first. Empty before a run.
  virtual std::string GetResources();

protected:
  vtkAdaptiveHilbertQualityMeshAlgorithm();
  ~vtkAdaptiveHilbertQualityMeshAlgorithm() override;

  /// Sets all measures to their values after a failed execution.
  void ClearMeasures();

  /// Adds the counts to field data, as arrays of one value with the names of the measures.
  void AddCounts(vtkFieldData* data) const;

  // Settings.
  double MinimumAngle = 20.0;
  double MaximumArea = 0.0;
  double MaximumLength = 0.0;
  std::string SizeArrayName = "";
  vtkIdType MaximumNumberOfAddedPoints = -1;

  // Measures of the last execution.
  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberOfAddedPoints = 0;
  vtkIdType NumberOfPointsAddedToSegments = 0;
  vtkIdType NumberOfBadTriangles = 0;
  vtkIdType NumberOfEncroachedPieces = 0;
  double LeastAngle = 0.0;
  vtkTypeInt64 MemoryEstimate = 0;

  // Measures of all executions.

private:
  vtkAdaptiveHilbertQualityMeshAlgorithm(const vtkAdaptiveHilbertQualityMeshAlgorithm&) = delete;
  void operator=(const vtkAdaptiveHilbertQualityMeshAlgorithm&) = delete;
};

#endif
