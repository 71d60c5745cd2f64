// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertDelaunay2D
 * @brief   exact 2D Delaunay triangulation of large point sets
 *
 * Triangulates points in x and y (or another plane: ProjectionPlaneMode); z is carried along. All
 * settings of vtkDelaunay2D have the same names. Details: Plugin/Documentation/Reference.md.
 *
 * <b>Features.</b> By default the triangles
 * - are the Delaunay triangulation of the distinct points, exactly, for all finite coordinates;
 * - are counterclockwise and cover the convex hull (in other planes than x, y: see Rim); points on
 *   its edges are corners of triangles;
 * - number 2v - 2 - h, for v distinct points of which h lie on the boundary of the hull;
 * - depend, like their order, on the coordinates and constraints alone. Shuffling the input
 *   changes only the ids; of the insertion settings only InsertionLimit changes the triangles.
 *
 * <b>Output port 0</b> has the points of the input (the same vtkPoints, ids and point data; added
 * points follow, and all are then a copy in double precision) and one triangle per cell. Cells of
 * the input are not passed on. Ports 1 (insertion order) and 2 (Voronoi diagram) are empty unless
 * requested.
 *
 * <b>Point status.</b> Each point is a vertex; a duplicate (x and y of a point of smaller id);
 * merged (within Tolerance of another); rejected (x or y NaN or infinite); skipped (a ghost or
 * hidden point by vtkGhostType); or beyond InsertionLimit. All stay among the output's points and
 * are counted, by Get methods and as field data of their names.
 *
 * <b>Caveats.</b> At most 2^28 - 2 points. Too many points or too little memory: one error, all
 * outputs empty, nothing thrown. Aborted (SetAbortExecute): outputs empty, no error. Each warning
 * comes once per execution, with counts. Several MPI ranks: DistributePoints.
 *
 * <b>Example.</b> A survey whose surface ends at a coastline:
 *
 * @code
 * vtkNew<vtkAdaptiveHilbertDelaunay2D> delaunay;
 * delaunay->SetInputData(soundings);  // any vtkPointSet
 * delaunay->SetSourceData(coastline); // polygons bound the surface
 * delaunay->SetSourceModeToCoordinates();
 * delaunay->Update();
 * vtkPolyData* surface = delaunay->GetOutput();
 * @endcode
 *
 * @sa
 * vtkDelaunay2D vtkAdaptiveHilbertAlgorithm
 */

#ifndef vtkAdaptiveHilbertDelaunay2D_h
#define vtkAdaptiveHilbertDelaunay2D_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkAdaptiveHilbertAlgorithm.h"
#include "vtkSmartPointer.h" // for return values

#include <array>
#include <memory> // for std::unique_ptr

namespace ahd
{
class Workspace;
enum class Status;
}
class vtkAHDContext;
class vtkAHDLentTriangulation;
class vtkAHDOutputCache;
class vtkAHDOutputMemory;
class vtkAHDRankBlocks;
class vtkAHDRankUpdates;
class vtkAHDRanks;
struct vtkAHDDataSets;
struct vtkAHDRankResult;
struct vtkAHDReport;
struct vtkAHDSettings;
class vtkAbstractTransform;
class vtkMultiProcessController;
class vtkPointSet;

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertDelaunay2D
  : public vtkAdaptiveHilbertAlgorithm
{
public:
  static vtkAdaptiveHilbertDelaunay2D* New();
  vtkTypeMacro(vtkAdaptiveHilbertDelaunay2D, vtkAdaptiveHilbertAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The constraints, input port 1, a vtkPolyData; none by default. Lines and polylines become
  /// edges of the triangulation, polygons edges and loops that bound the surface. Points on a
  /// segment divide it; segments may overlap. A segment that crosses an earlier one (see
  /// CrossingMode) or has an end that is not a vertex is left out, and its loop bounds nothing:
  /// both are counted. The field data array "Crossings" lists the first 1000 pairs of cells that
  /// cross, the later cell first. All vtkPolyData of a composite data set (SetSourceConnection,
  /// SetInputData(1, ...)) are appended to one source, cells by type; GetSource() is null then.
  void SetSourceData(vtkPolyData* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  vtkPolyData* GetSource();
  ///@}

  ///@{
  /// The transform applied to the points before they are triangulated, linear or not; null by
  /// default: none. If it is modified, the filter executes again; the filter never modifies it.
  virtual void SetTransform(vtkAbstractTransform* transform);
  vtkGetObjectMacro(Transform, vtkAbstractTransform);
  ///@}

  /// The plane with the least sum of squared distances from the finite points, as a vtkTransform
  /// that rotates and translates it to z = 0; up is where the normal's largest component is
  /// positive. Points that all have the same z, x or y keep the two other coordinates, to the bit.
  /// The caller owns the result; null without input or memory.
  static VTK_NEWINSTANCE vtkAbstractTransform* ComputeBestFittingPlane(vtkPointSet* input);

  /// Also changes the data types that the input port accepts.
  void SetMergeBlocks(bool merge) override;

  /// Also makes the input optional, as a rank may have none.
  void SetDistributePoints(bool distribute) override;

  ///@{
  /// The ranks of DistributePoints; by default those of the global controller when the filter is
  /// created. Null: this process alone. Always null if VTK was built without ParallelCore.
  virtual void SetController(vtkMultiProcessController* controller);
  virtual vtkMultiProcessController* GetController();
  ///@}

  /// The later of the modification times of the filter and its Transform.
  vtkMTimeType GetMTime() override;

  /// With several ranks, the pipeline is modified on all ranks if it is on one: so all execute, or
  /// none. Collective there.
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int requestFromOutputPort, vtkMTimeType* mtime) override;

  /// With several ranks, the outputs have blocks if each block is triangulated by itself.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkAdaptiveHilbertDelaunay2D();
  ~vtkAdaptiveHilbertDelaunay2D() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkAbstractTransform* Transform = nullptr;
  vtkMultiProcessController* Controller = nullptr;

private:
  friend class vtkAdaptiveHilbertInterpolation2D; // reads the settings
  friend class vtkAdaptiveHilbertQualityMesh2D;   // the same
  vtkAdaptiveHilbertDelaunay2D(const vtkAdaptiveHilbertDelaunay2D&) = delete;
  void operator=(const vtkAdaptiveHilbertDelaunay2D&) = delete;

  using RankSurfaces = std::array<vtkSmartPointer<vtkPolyData>, 3>; // the outputs, held

  void Execute(vtkDataObject* input, vtkDataObject* source, vtkAHDDataSets& data,
    const vtkAHDContext& context);
  bool IsDistributed() const;
  bool IsEmptyPiece(vtkInformationVector* outputs) const;
  void KeepFirstPieces(vtkInformationVector* outputs) const;
  void DescribePortsAnew();
  void MakeOutputs(vtkDataObject* input, vtkInformationVector* outputs) const;
  void ExecuteOnRanks(vtkDataObject* input, vtkDataObject* source, vtkInformationVector* outputs);
  void ExecuteBlocksOnRanks(vtkAHDRanks& ranks, const vtkAHDRankBlocks& blocks,
    vtkDataObject* source, int levels, vtkInformationVector* outputs);
  void SayAbort(ahd::Status status);
  bool WarnOfInput(vtkDataObject* input);
  void ExecuteOneOnRanks(vtkAHDRanks& ranks, vtkDataObject* input, vtkDataObject* source,
    int levels, const RankSurfaces& surfaces);
  void WarnOnRanks(const vtkAHDSettings& settings, const vtkAHDRankResult& result);
  void EndOnRanks(ahd::Status status, vtkAHDRankResult& result, const RankSurfaces& surfaces);
  void Triangulate(const vtkAHDDataSets& data, const vtkAHDContext& context);
  void TakeBackLent();
  bool PassOnCached(const vtkAHDDataSets& data, const vtkAHDContext& context);
  void EndWithoutMemory(const vtkAHDDataSets& data);
  void ReadSettings(
    vtkAHDSettings& settings, bool forSamples = false, bool onSurface = false) const;
  void ReadNumbers(vtkAHDSettings& settings) const;
  void WarnAboutRanks();
  void Warn(const vtkAHDSettings& settings, const vtkAHDReport& report);

  const std::unique_ptr<ahd::Workspace> Workspace;        // kept for the next execution
  vtkSmartPointer<vtkAHDLentTriangulation> Lent;          // the last execution's
  const std::unique_ptr<vtkAHDOutputCache> Cache;         // the last execution's outputs
  const std::unique_ptr<vtkAHDOutputMemory> OutputMemory; // kept for the next execution
  const std::unique_ptr<vtkAHDRankUpdates> Updates;       // agreed on by ranks
  bool WarnedAboutRanks = false;
  bool WarnedAboutOneRank = false;
  bool WarnedAboutLimit = false;
};

#endif
