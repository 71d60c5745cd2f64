// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlanarSurfaceOutline
 * @brief   the outline of a surface, as polygons with holes
 *
 * Closed polylines around the polygons of a vtkPolyData: a surface of vtkAdaptiveHilbertDelaunay2D,
 * an alpha shape, or bands of vtkBandedPolyDataContourFilter (GroupArrayName "Scalars").
 *
 * <b>Features.</b> Two cells are joined where they share an edge, and a polygon is a largest set of
 * joined cells, of one number in the array GroupArrayName. Rings are simple, and touch at vertices
 * only. Each line is a ring, and ends with its first point; the outer ring of a polygon comes first
 * and runs counterclockwise, its holes run clockwise. Which is which is decided exactly. The order
 * does not depend on that of the cells: by numbers, then by the smallest vertices.
 *
 * Cell data: "PolygonId" (vtkIdType), from 0; "IsHole" (vtkUnsignedCharArray), 1 or 0; the array
 * GroupArrayName. Points are those of the input that rings pass, with their point data.
 *
 * <b>Caveats.</b> Points at one place count as one. Lines, vertices and triangle strips of the
 * input are left out, as are cells that vtkGhostType marks as duplicate or hidden. Rings are outer
 * or holes, and turn, as seen in x, y; if the surface folds over itself there, as seen in y, z or
 * z, x. All blocks of a composite data set are one surface, without point data. On several ranks
 * all must update, and the first one outlines the polygons of all, without
 * point data.
 *
 * <b>Example.</b>
 *
 * @code
 * vtkNew<vtkPlanarSurfaceOutline> outline;
 * outline->SetInputConnection(delaunay->GetOutputPort());
 * @endcode
 *
 * @sa
 * vtkAdaptiveHilbertDelaunay2D vtkBandedPolyDataContourFilter vtkFeatureEdges
 */

#ifndef vtkPlanarSurfaceOutline_h
#define vtkPlanarSurfaceOutline_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include "vtkSmartPointer.h" // for the parts of a surface

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for the parts of a surface

namespace ahd
{
struct Outline;
}
class vtkAHDContext;
class vtkAHDRankUpdates;
class vtkMultiProcessController;

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkPlanarSurfaceOutline : public vtkPolyDataAlgorithm
{
public:
  static vtkPlanarSurfaceOutline* New();
  vtkTypeMacro(vtkPlanarSurfaceOutline, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The array of the cells by which polygons are told apart, with one number each; a cell with NaN
  /// is left out. Empty, the default, or "None": all cells are alike.
  virtual void SetGroupArrayName(const std::string& name);
  virtual std::string GetGroupArrayName() const { return this->GroupArrayName; }
  ///@}

  ///@{
  /// The most memory the filter may use beyond its input, in KiB; 0, the default: what the process
  /// can get. More is refused with an error.
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  ///@{
  /// The ranks whose polygons are outlined together; by default those of the global controller when
  /// the filter is created. Null: this process alone. Always null if VTK was built without
  /// ParallelCore.
  virtual void SetController(vtkMultiProcessController* controller);
  virtual vtkMultiProcessController* GetController() { return this->Controller; }
  ///@}

  /// With several ranks, the pipeline is modified on all ranks if it is on one. Collective there.
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int requestFromOutputPort, vtkMTimeType* mtime) override;

protected:
  vtkPlanarSurfaceOutline();
  ~vtkPlanarSurfaceOutline() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string GroupArrayName;
  vtkTypeInt64 MemoryLimit = 0;
  vtkMultiProcessController* Controller = nullptr;

private:
  vtkPlanarSurfaceOutline(const vtkPlanarSurfaceOutline&) = delete;
  void operator=(const vtkPlanarSurfaceOutline&) = delete;

  struct Lacks;
  struct Surface;

  bool IsDistributed() const;
  Surface Hold(vtkPolyData* input, Lacks& lacks);
  Surface Take(vtkDataObject* input, const vtkAHDContext& context);
  static Surface Join(const std::vector<vtkSmartPointer<vtkDataObject>>& parts);
  bool Gather(Surface& surface);
  void MakeOutline(const Surface& surface, vtkPolyData* output, const vtkAHDContext& context);
  void Write(const Surface& surface, const ahd::Outline& made, vtkPolyData* output);

  const std::unique_ptr<vtkAHDRankUpdates> Updates; // agreed on by ranks
};

#endif
