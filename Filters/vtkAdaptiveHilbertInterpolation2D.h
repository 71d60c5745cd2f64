// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertInterpolation2D
 * @brief   values between scattered points: rasters, and places of any data set
 *
 * Triangulates the points of input port 0 as vtkAdaptiveHilbertDelaunay2D does, and interpolates
 * their heights and point arrays on the surface: at the cell centres of a raster, or at the points
 * of any data set in port 1. Details: Plugin/Documentation/Reference.md.
 *
 * <b>Features.</b>
 * - Linear, by natural neighbours (Sibson, Laplace) or nearest; the triangle of each place is
 *   located exactly; the same bytes for any number of threads.
 * - Output: without places a vtkImageData, whose points are the centres of the raster's cells
 *   (GeoTIFF's "pixel is area"), in the plane z = 0 of the triangulation; with OutputType SURFACE a
 *   vtkStructuredGrid with these centres at their heights, hidden where there is no value
 *   (vtkGhostType, HIDDENPOINT). With places: their data set, with arrays.
 * - Arrays: the heights (HeightArrayName), every numeric point array of the input, and a mask
 *   (ValidPointMaskArrayName). Arrays of float stay float, others become double; with NEAREST each
 *   keeps its type. vtkGhostType is not interpolated; arrays of strings, without a name or of
 *   another length than the points are not interpolated, with a warning. Arrays of the places with
 *   the same name are replaced. Active scalars stay active; without any, the heights are. Field
 *   data are those of the places, or without places those of the points, and the counts below.
 *
 * <b>Inputs.</b> Port 0: a vtkPointSet, or a composite data set, whose blocks are merged into one
 * surface; or a surface made by a vtkAdaptiveHilbertDelaunay2D, recognised by its field data: then,
 * without a source, its triangles are used, holes and constraints included, and of the settings of
 * Triangulation only plane, threads and memory. That filter's own triangulation is used while it
 * exists (see ReuseLimit) and is not lent to others, in the plane x, y: the values are those of
 * interpolating its points with its settings. Otherwise the corners are triangulated, with the
 * constraints that the cell array ConstraintEdges names; without it natural neighbours end at the
 * edges of triangles that are not Delaunay. Over several ranks (DistributePoints and Controller of
 * Triangulation) its points are triangulated again, with a warning; there port 0 may be empty or of
 * any type. Port 1, optional: the places, a vtkDataSet or a composite data set of these. Port 2,
 * optional: constraints, as the source of vtkAdaptiveHilbertDelaunay2D.
 *
 * <b>Caveats.</b> Outside of the surface (beyond the hull, in holes, in triangles removed by the
 * settings of Triangulation) there is no value: nothing is extrapolated unless Outside says so. A
 * place outside by no more than rounding has that of the nearest place of the surface.
 * If a point's value is NaN, its triangles have none (LINEAR), or only the other neighbours count
 * (NATURAL_NEIGHBOR, LAPLACE). An invalid setting or too little memory is one error, with an empty
 * output, and nothing thrown; memory is estimated first. Aborted: the output empty, no error. Each
 * warning comes once per execution, for all blocks together.
 *
 * <b>Example.</b> A raster of square cells of 2 units:
 *
 * @code
 * vtkNew<vtkAdaptiveHilbertInterpolation2D> raster;
 * raster->SetInputData(points);
 * raster->SetRasterSizeToByCellSize();
 * raster->SetCellSize(2, 2);
 * raster->SetMethodToNaturalNeighbor();
 * raster->Update();
 * vtkDataObject* heights = raster->GetOutputDataObject(0);
 * @endcode
 *
 * @sa
 * vtkAdaptiveHilbertDelaunay2D vtkProbeFilter vtkResampleToImage
 */

#ifndef vtkAdaptiveHilbertInterpolation2D_h
#define vtkAdaptiveHilbertInterpolation2D_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkAdaptiveHilbertInterpolationAlgorithm.h"

#include <memory> // for std::unique_ptr

class vtkAdaptiveHilbertDelaunay2D;
class vtkPolyData;
class vtkAHDRankUpdates;
class vtkAHDRanks;
struct vtkAHDRaster;
struct vtkAHDSampleMemoryKept;
struct vtkAHDSampleResult;
struct vtkAHDSampleSettings;
struct vtkAHDSettings;

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertInterpolation2D
  : public vtkAdaptiveHilbertInterpolationAlgorithm
{
public:
  static vtkAdaptiveHilbertInterpolation2D* New();
  vtkTypeMacro(vtkAdaptiveHilbertInterpolation2D, vtkAdaptiveHilbertInterpolationAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The settings of the triangulation, threads, memory and KeepTriangulation included: a filter
  /// that is not executed. By default one with default settings. Not used: GenerateX, VoronoiClip,
  /// VoronoiPolygon, MergeBlocks. Null is an error.
  virtual void SetTriangulation(vtkAdaptiveHilbertDelaunay2D* triangulation);
  vtkGetObjectMacro(Triangulation, vtkAdaptiveHilbertDelaunay2D);
  ///@}

  ///@{
  /// The places, input port 1, any vtkDataSet: its points, by x and y. If the points are
  /// triangulated in another plane, the places are moved into it like the points. All blocks of a
  /// composite data set (SetPlacesConnection, SetInputData(1, ...)) are used; GetPlaces() is null
  /// then. Without places the output is a raster.
  void SetPlacesData(vtkDataSet* places);
  void SetPlacesConnection(vtkAlgorithmOutput* output);
  vtkDataSet* GetPlaces();
  ///@}

  ///@{
  /// The constraints, input port 2, like those of vtkAdaptiveHilbertDelaunay2D.
  void SetSourceData(vtkPolyData* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  vtkPolyData* GetSource();
  ///@}

  /// The later of the modification times of the filter and Triangulation.
  vtkMTimeType GetMTime() override;

  /// With several ranks, the pipeline is modified on all ranks if it is on one: so all execute, or
  /// none. Collective there.
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int requestFromOutputPort, vtkMTimeType* mtime) override;

  /// The superclass', without exceptions where memory runs out.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkAdaptiveHilbertInterpolation2D();
  ~vtkAdaptiveHilbertInterpolation2D() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkAdaptiveHilbertDelaunay2D* Triangulation = nullptr;

private:
  vtkAdaptiveHilbertInterpolation2D(const vtkAdaptiveHilbertInterpolation2D&) = delete;
  void operator=(const vtkAdaptiveHilbertInterpolation2D&) = delete;

  void ReadSettings(vtkAHDSettings& settings, vtkAHDSampleSettings& wishes) const;
  void UpdateInputs();
  void Describe(vtkInformation* info, bool isRaster);
  bool Execute(vtkInformationVector** inputs, vtkInformation* info, vtkDataObject* output);
  void SayOutOfMemory();
  void WarnOfOtherRaster();
  int EndWithOtherRaster(bool isDone, vtkDataObject* output);
  void ClearCounts();
  bool IsDistributed() const;
  void AnnouncePieces(vtkInformation* info) const;
  void DescribeOnRanks(vtkInformation* info, bool isRaster);
  void UpdatePieces();
  vtkAHDRaster FindRasterOnRanks(vtkAHDRanks& ranks, vtkInformation* info);
  void ShareTimes(vtkInformationVector* outputs);
  void AskForPieces(vtkInformationVector** inputs);
  int ExecuteOnRanks(vtkInformationVector** inputs, vtkInformation* info, vtkDataObject* output);
  int EndOnRanks(vtkDataObject* output);
  void WarnAboutRanks();

  const std::unique_ptr<vtkAHDSampleMemoryKept> Kept; // for the next execution
  const std::unique_ptr<vtkAHDRankUpdates> Updates;   // agreed on by ranks
  bool WarnedAboutRanks = false;
  bool WarnedOfOtherRaster = false;
  bool HasPortsOfRanks = false;  // the last answer of FillInputPortInformation()
  bool MustDescribeAnew = false; // the raster differs from that of RequestInformation()
};

#endif
