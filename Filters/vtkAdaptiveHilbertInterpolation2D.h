// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertInterpolation2D
 * @brief   values between scattered points: rasters, and places of any data set
 *
 * Triangulates the points of input port 0 as vtkAdaptiveHilbertDelaunay2D does, and interpolates
 * their heights and point arrays on the surface: at the cell centres of a raster, or at the points
 * of any data set in port 1. Details: Plugin/Documentation/Reference.md.
 *
 * <b>Inputs.</b> Port 0: a vtkPointSet, or a composite data set, whose blocks are merged into one
 * surface; or a surface that a vtkAdaptiveHilbertDelaunay2D made, known by its field data: then,
 * without a source, its triangles count, holes and constraints included, and of the settings of
 * Triangulation only plane, threads and memory. That filter's own triangulation is used while it is
 * still there (see ReuseLimit) and in nobody else's use, in the plane x, y: the values are those of
 * interpolating its points with its settings. Else the corners are triangulated; natural neighbours
 * then end at constraints that the cell array ConstraintEdges names, and at edges of triangles that
 * are not Delaunay. Over several ranks (DistributePoints and Controller of Triangulation) its
 * points are triangulated anew, with a warning; there port 0 may be empty or of any type. Port 1,
 * optional: the places, a vtkDataSet or a composite data set of such. Port 2, optional:
 * constraints, as the source of vtkAdaptiveHilbertDelaunay2D.
 *
 * <b>Output.</b> Without places a vtkImageData, whose points are the centres of the raster's cells
 * (GeoTIFF's "pixel is area"), in the plane z = 0 of the triangulation; or, with OutputType
 * SURFACE, a vtkStructuredGrid whose points are these centres at their heights, hidden where there
 * is no value (vtkGhostType, HIDDENPOINT). With places: their data set, with arrays.
 *
 * <b>Arrays.</b> The heights (HeightArrayName), every numeric point array of the input, and a mask
 * (ValidPointMaskArrayName). Arrays of float stay float, others become double; with NEAREST each
 * keeps its type. vtkGhostType is not interpolated; arrays of strings, without a name or of another
 * length than the points are passed over, with a warning. What the places have of the same name is
 * replaced. Active scalars stay active; if there are none, the heights are. Field data are those of
 * the places, or without places those of the points, and the counts below.
 *
 * <b>No value.</b> Outside of the surface (beyond the hull, in holes, in triangles that the
 * settings of Triangulation leave out) there is no value: nothing is extrapolated unless Outside
 * says so. Where a point's value is NaN, its triangles have none (LINEAR), or the others alone
 * count (NATURAL_NEIGHBOR, LAPLACE).
 *
 * <b>Limits and errors.</b> As in vtkAdaptiveHilbertDelaunay2D: one error, the output empty, and
 * nothing thrown, if a setting makes no sense or memory is too little; memory is estimated before
 * anything is computed. Aborted: the output empty, no error. Each warning comes once per execution,
 * of all blocks together.
 *
 * @sa
 * vtkAdaptiveHilbertDelaunay2D vtkProbeFilter vtkResampleToImage
 */

#ifndef vtkAdaptiveHilbertInterpolation2D_h
#define vtkAdaptiveHilbertInterpolation2D_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for names of arrays

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
  : public vtkDataSetAlgorithm
{
public:
  static vtkAdaptiveHilbertInterpolation2D* New();
  vtkTypeMacro(vtkAdaptiveHilbertInterpolation2D, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The values of Method.
  enum Methods
  {
    LINEAR = 0,           ///< linear in each triangle
    NATURAL_NEIGHBOR = 1, ///< Sibson's natural neighbours: smooth but at the points
    LAPLACE = 2,          ///< the same neighbours with Laplace's weights
    NEAREST = 3           ///< the value of the nearest vertex
  };

  /// The values of RasterSize.
  enum RasterSizes
  {
    BY_DIMENSIONS = 0, ///< so many cells
    BY_CELL_SIZE = 1   ///< cells of this size
  };

  /// The values of OutputType.
  enum OutputTypes
  {
    IMAGE = 0,  ///< vtkImageData
    SURFACE = 1 ///< vtkStructuredGrid, its points at their heights
  };

  /// The values of Outside.
  enum OutsideValues
  {
    NO_VALUE = 0,      ///< none
    NEAREST_VERTEX = 1 ///< that of the nearest vertex
  };

  ///@{
  /// How the points are triangulated: a filter of which the settings count, threads, memory and
  /// KeepTriangulation included; it is not executed. There is one from the beginning, with the
  /// defaults. Not used: GenerateX, VoronoiClip, MergeBlocks. Null is an error.
  virtual void SetTriangulation(vtkAdaptiveHilbertDelaunay2D* triangulation);
  vtkGetObjectMacro(Triangulation, vtkAdaptiveHilbertDelaunay2D);
  ///@}

  ///@{
  /// The places, input port 1, any vtkDataSet: its points, by x and y. Where the points are
  /// triangulated in another plane, the places are moved into it as the points are. Of a composite
  /// data set (SetPlacesConnection, SetInputData(1, ...)) all blocks; GetPlaces() is null then.
  /// Without places there is a raster.
  void SetPlacesData(vtkDataSet* places);
  void SetPlacesConnection(vtkAlgorithmOutput* output);
  vtkDataSet* GetPlaces();
  ///@}

  ///@{
  /// The constraints, input port 2, as those of vtkAdaptiveHilbertDelaunay2D.
  void SetSourceData(vtkPolyData* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  vtkPolyData* GetSource();
  ///@}

  ///@{
  /// How values are interpolated. LINEAR, the default: in the triangle. NATURAL_NEIGHBOR: Sibson's
  /// natural neighbours, which is smooth but at the points; LAPLACE: the same neighbours, sooner
  /// found and less smooth; both end at constraints, as at the rim. NEAREST: the nearest vertex, on
  /// the whole plane, of several the one of smallest x, then y. Collinear points: linear between
  /// neighbours on their line.
  vtkSetClampMacro(Method, int, LINEAR, NEAREST);
  vtkGetMacro(Method, int);
  void SetMethodToLinear() { this->SetMethod(LINEAR); }
  void SetMethodToNaturalNeighbor() { this->SetMethod(NATURAL_NEIGHBOR); }
  void SetMethodToLaplace() { this->SetMethod(LAPLACE); }
  void SetMethodToNearest() { this->SetMethod(NEAREST); }
  ///@}

  ///@{
  /// What says how many cells the raster has. BY_DIMENSIONS, the default: Dimensions, and the cells
  /// fill its area. BY_CELL_SIZE: CellSize.
  vtkSetClampMacro(RasterSize, int, BY_DIMENSIONS, BY_CELL_SIZE);
  vtkGetMacro(RasterSize, int);
  void SetRasterSizeToByDimensions() { this->SetRasterSize(BY_DIMENSIONS); }
  void SetRasterSizeToByCellSize() { this->SetRasterSize(BY_CELL_SIZE); }
  ///@}

  ///@{
  /// The number of cells along x and y, from 1 to 2^31 - 1 each; default 256, 256. Used by
  /// BY_DIMENSIONS.
  virtual void SetDimensions(int columns, int rows);
  void SetDimensions(const int dimensions[2]) VTK_SIZEHINT(2);
  vtkGetVector2Macro(Dimensions, int);
  ///@}

  ///@{
  /// The size of a cell along x and y, in the unit of the points; default 1, 1. Any but a positive
  /// finite one is an error of the execution. Used by BY_CELL_SIZE: as many cells as cover the
  /// area, at least one. Whether the last one is needed is judged by the numbers as they are
  /// written in decimal (15 digits): 100 cells of 0.1 cover 0 to 10.
  vtkSetVector2Macro(CellSize, double);
  vtkGetVector2Macro(CellSize, double);
  ///@}

  ///@{
  /// Lay the borders between cells on multiples of CellSize, as GDAL's -tap does: the area's lower
  /// bounds are rounded down, the upper ones up. Off by default: the raster begins at the lower
  /// bounds. Used by BY_CELL_SIZE.
  vtkSetMacro(AlignToCellSize, bool);
  vtkGetMacro(AlignToCellSize, bool);
  vtkBooleanMacro(AlignToCellSize, bool);
  ///@}

  ///@{
  /// The raster's area: with UseBounds it is Bounds, as xmin, xmax, ymin, ymax (default 0, 1, 0,
  /// 1); bounds that are not finite or of which the lower is not below the upper are an error of
  /// the execution. Off, the default: the bounding box of all points that are triangulated, in the
  /// plane of the triangulation; a side of length 0 makes one cell, as long as the other side's
  /// (or 1).
  vtkSetMacro(UseBounds, bool);
  vtkGetMacro(UseBounds, bool);
  vtkBooleanMacro(UseBounds, bool);
  vtkSetVector4Macro(Bounds, double);
  vtkGetVector4Macro(Bounds, double);
  ///@}

  ///@{
  /// What is put out without places. IMAGE, the default, or SURFACE.
  vtkSetClampMacro(OutputType, int, IMAGE, SURFACE);
  vtkGetMacro(OutputType, int);
  void SetOutputTypeToImage() { this->SetOutputType(IMAGE); }
  void SetOutputTypeToSurface() { this->SetOutputType(SURFACE); }
  ///@}

  ///@{
  /// What places outside of the surface get. NO_VALUE, the default, or NEAREST_VERTEX: the value of
  /// the nearest vertex; the mask is 0 there all the same, and so are the counts.
  vtkSetClampMacro(Outside, int, NO_VALUE, NEAREST_VERTEX);
  vtkGetMacro(Outside, int);
  void SetOutsideToNoValue() { this->SetOutside(NO_VALUE); }
  void SetOutsideToNearestVertex() { this->SetOutside(NEAREST_VERTEX); }
  ///@}

  ///@{
  /// What arrays of floating-point numbers have where there is no value; default NaN. Arrays of
  /// whole numbers (NEAREST) have 0 there.
  virtual void SetNoValue(double value);
  vtkGetMacro(NoValue, double);
  ///@}

  ///@{
  /// Add the slopes of the heights and of each interpolated array of one component: an array of two
  /// components, d/dx and d/dy, with the name of the array and "Gradient" behind it. LINEAR alone
  /// has them, with other methods there is a warning. On an edge and at a vertex they are those of
  /// one of its triangles. Off by default.
  vtkSetMacro(GenerateGradients, bool);
  vtkGetMacro(GenerateGradients, bool);
  vtkBooleanMacro(GenerateGradients, bool);
  ///@}

  ///@{
  /// The name of the array of heights (vtkDoubleArray): z of the points, or their height above the
  /// plane of the triangulation. Default "Elevation"; an array of the input of that name is passed
  /// over, with a warning. Empty: no such array. The name of the mask, or "vtkGhostType", is an
  /// error of the execution.
  virtual void SetHeightArrayName(const std::string& name);
  virtual std::string GetHeightArrayName() { return this->HeightArrayName; }
  ///@}

  ///@{
  /// The name of the mask (vtkCharArray): 1 for places on the surface (NEAREST: for all with finite
  /// x and y), 0 for others. Default "vtkValidPointMask", as vtkProbeFilter has it. Empty: no mask.
  /// The name of the heights or of their gradients, or "vtkGhostType", is an error of the
  /// execution.
  virtual void SetValidPointMaskArrayName(const std::string& name);
  virtual std::string GetValidPointMaskArrayName() { return this->ValidPointMaskArrayName; }
  ///@}

  ///@{
  /**
   * Of the last execution; 0 if it was aborted or ended in an error. All places, which are those
   * with a value (on the surface), outside of it, and with an x or y that is not finite. Values
   * (one for each component of an array at a valid place) that are NaN, because those of points
   * are; values from which neighbours with NaN were left out. Also field data of these names.
   * Wall-clock seconds of the interpolation, the triangulation excluded.
   */
  vtkGetMacro(NumberOfPlaces, vtkIdType);
  vtkGetMacro(NumberOfValidPlaces, vtkIdType);
  vtkGetMacro(NumberOfPlacesOutside, vtkIdType);
  vtkGetMacro(NumberOfNotFinitePlaces, vtkIdType);
  vtkGetMacro(NumberOfPlacesWithoutValue, vtkIdType);
  vtkGetMacro(NumberOfPlacesWithNeighborsLeftOut, vtkIdType);
  vtkGetMacro(SampleSeconds, double);
  ///@}

  ///@{
  /// Upper estimate, in kibibytes, of the memory that the last execution needed beyond its inputs,
  /// or was refused: what the MemoryLimit of Triangulation is compared with. How often this filter
  /// has triangulated: it keeps the triangulation for the next execution with the same points,
  /// constraints and Triangulation, whatever the raster and method, where KeepTriangulation is on
  /// and ReuseLimit is large enough. It stays 0 on a surface whose own triangulation is there.
  vtkGetMacro(MemoryEstimate, vtkTypeInt64);
  vtkGetMacro(NumberOfTriangulations, int);
  ///@}

  /// When the filter or Triangulation was changed last.
  vtkMTimeType GetMTime() override;

  /// Across ranks, the pipeline of each is modified whenever that of one is: so all execute, or
  /// none. Collective there.
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int requestFromOutputPort, vtkMTimeType* mtime) override;

protected:
  vtkAdaptiveHilbertInterpolation2D();
  ~vtkAdaptiveHilbertInterpolation2D() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  // Settings.
  vtkAdaptiveHilbertDelaunay2D* Triangulation = nullptr;
  int Method = LINEAR;
  int RasterSize = BY_DIMENSIONS;
  int Dimensions[2] = { 256, 256 };
  double CellSize[2] = { 1.0, 1.0 };
  bool AlignToCellSize = false;
  bool UseBounds = false;
  double Bounds[4] = { 0.0, 1.0, 0.0, 1.0 };
  int OutputType = IMAGE;
  int Outside = NO_VALUE;
  double NoValue;
  bool GenerateGradients = false;
  std::string HeightArrayName = "Elevation";
  std::string ValidPointMaskArrayName = "vtkValidPointMask";

  // Measures of the last execution.
  vtkIdType NumberOfPlaces = 0;
  vtkIdType NumberOfValidPlaces = 0;
  vtkIdType NumberOfPlacesOutside = 0;
  vtkIdType NumberOfNotFinitePlaces = 0;
  vtkIdType NumberOfPlacesWithoutValue = 0;
  vtkIdType NumberOfPlacesWithNeighborsLeftOut = 0;
  double SampleSeconds = 0.0;
  vtkTypeInt64 MemoryEstimate = 0;

  int NumberOfTriangulations = 0; // of all executions

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
  void ClearMeasures();
  void ClearCounts();
  void AddMeasures(const vtkAHDSampleResult& result);
  static void AddCounts(const vtkAHDSampleResult& result, vtkDataSet* output);
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
  bool HasPortsOfRanks = false;  // what FillInputPortInformation() said last
  bool MustDescribeAnew = false; // the raster is another than RequestInformation() said
};

#endif
