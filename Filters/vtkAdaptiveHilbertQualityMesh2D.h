// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertQualityMesh2D
 * @brief   triangles to compute on: of wide angles and wished sizes
 *
 * Triangulates the points of input port 0 with the constraints of port 1, as
 * vtkAdaptiveHilbertDelaunay2D does, and adds points until no angle is smaller and no triangle is
 * larger than wished. Details: Plugin/Documentation/Reference.md.
 *
 * <b>Features.</b> The triangles that polygons of the source (or a trimmed rim) leave are refined;
 * lines stay in their places. The result is the exact constrained Delaunay triangulation of the
 * points and the added ones, the same bytes for any number of threads.
 *
 * <b>Outputs.</b> Port 0, the mesh: triangles; all points in double precision, those of the
 * triangulation with their ids, then the added ones with data in between, "OriginalPointIds" (-1:
 * not of the input); cell data "RegionId" and "BadReason" (-1, or why a triangle is not as wished);
 * counts as field data. Port 1: the edges of triangles along lines and outlines, with the same
 * points; cell data "SourceCell" (-1: none) and "IsBoundary" (1: it bounds the mesh, on its left).
 *
 * <b>Caveats.</b> Points that are no corner of a triangle stay among the points. Alpha,
 * MaximumEdgeLength and InsertionLimit of Triangulation, and points on several ranks (unless
 * DistributePoints is off), are one error. Blocks of a composite input are merged.
 *
 * <b>Example.</b>
 *
 * @code
 * vtkNew<vtkAdaptiveHilbertQualityMesh2D> mesh;
 * mesh->SetInputData(points);
 * mesh->SetSourceData(outline); // a vtkPolyData with a polygon of points of its own
 * mesh->GetTriangulation()->SetSourceModeToCoordinates();
 * mesh->SetMinimumAngle(30);
 * mesh->SetMaximumArea(0.5);
 * mesh->Update();
 * @endcode
 *
 * @sa
 * vtkAdaptiveHilbertDelaunay2D
 */

#ifndef vtkAdaptiveHilbertQualityMesh2D_h
#define vtkAdaptiveHilbertQualityMesh2D_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkAdaptiveHilbertQualityMeshAlgorithm.h"
#include "vtkSmartPointer.h" // for outputs

#include <array> // for the same

class vtkAdaptiveHilbertDelaunay2D;
class vtkAHDContext;

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertQualityMesh2D
  : public vtkAdaptiveHilbertQualityMeshAlgorithm
{
public:
  static vtkAdaptiveHilbertQualityMesh2D* New();
  vtkTypeMacro(vtkAdaptiveHilbertQualityMesh2D, vtkAdaptiveHilbertQualityMeshAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The settings of the triangulation, threads and memory included: a filter that is not executed.
  /// By default one with default settings. Not used: GenerateX, VoronoiClip, VoronoiPolygon,
  /// MergeBlocks, KeepTriangulation, ReuseLimit. Null is an error.
  virtual void SetTriangulation(vtkAdaptiveHilbertDelaunay2D* triangulation);
  vtkGetObjectMacro(Triangulation, vtkAdaptiveHilbertDelaunay2D);
  ///@}

  ///@{
  /// The constraints, input port 1, like those of vtkAdaptiveHilbertDelaunay2D.
  void SetSourceData(vtkPolyData* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  vtkPolyData* GetSource();
  ///@}

  /// The later of the modification times of the filter and Triangulation.
  vtkMTimeType GetMTime() override;

protected:
  vtkAdaptiveHilbertQualityMesh2D();
  ~vtkAdaptiveHilbertQualityMesh2D() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkAdaptiveHilbertDelaunay2D* Triangulation = nullptr;

private:
  vtkAdaptiveHilbertQualityMesh2D(const vtkAdaptiveHilbertQualityMesh2D&) = delete;
  void operator=(const vtkAdaptiveHilbertQualityMesh2D&) = delete;

  using Outputs = std::array<vtkSmartPointer<vtkPolyData>, 2>;
  bool Execute(vtkInformationVector** inputs, const Outputs& outputs);
  bool MayRefine(vtkAdaptiveHilbertDelaunay2D* triangulation);

  bool WarnedAboutRanks = false;
};

#endif
