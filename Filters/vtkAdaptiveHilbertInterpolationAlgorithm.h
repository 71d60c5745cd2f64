// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
/**
 * @class   vtkAdaptiveHilbertInterpolationAlgorithm
 * @brief   settings and measures of vtkAdaptiveHilbertInterpolation2D
 *
 * The superclass of vtkAdaptiveHilbertInterpolation2D: its settings that are numbers and names, and
 * what was measured. In what is said here, values of settings have the names of ParaView's panel.
 * How the points are triangulated is said by the filter's Triangulation.
 *
 * @sa
 * vtkAdaptiveHilbertInterpolation2D
 */

#ifndef vtkAdaptiveHilbertInterpolationAlgorithm_h
#define vtkAdaptiveHilbertInterpolationAlgorithm_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

#include <limits> // for defaults that are NaN
#include <string> // for settings that are names

struct vtkAHDSettingsOfRanks;

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertInterpolationAlgorithm
  : public vtkDataSetAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkAdaptiveHilbertInterpolationAlgorithm, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The values of Method.
  enum MethodValues
  {
    /// linear in each triangle
    LINEAR = 0,
    /// Sibson's natural neighbours: smooth but at the points
    NATURAL_NEIGHBOR = 1,
    /// the same neighbours with Laplace's weights
    LAPLACE = 2,
    /// the value of the nearest vertex
    NEAREST = 3
  };

  /// The values of RasterSize.
  enum RasterSizeValues
  {
    /// so many cells
    BY_DIMENSIONS = 0,
    /// cells of this size
    BY_CELL_SIZE = 1
  };

  /// The values of OutputType.
  enum OutputTypeValues
  {
    /// vtkImageData
    IMAGE = 0,
    /// vtkStructuredGrid, its points at their heights
    SURFACE = 1
  };

  /// The values of Outside.
  enum OutsideValues
  {
    /// none
    NO_VALUE = 0,
    /// that of the nearest vertex
    NEAREST_VERTEX = 1
  };

  ///@{
  /// How values come about between the points. Linear: linear in each triangle; the fastest.
  /// Natural Neighbor: of the points around, by the area that the place would take from their
  /// Voronoi cells (Sibson); smooth everywhere but at the points, and for scattered points the best
  /// to look at. Laplace: of the same points, by the lengths of the borders; alike, a little
  /// faster. Nearest: the value of the nearest point, its type kept. Default: LINEAR.
  /// Natural Neighbor and Laplace end at constraints, as at the rim. Nearest is there on the whole
  /// plane; of several vertices that are as near, the one of smallest x, then y, counts. Collinear
  /// points: linear between neighbours on their line.
  vtkSetClampMacro(Method, int, LINEAR, NEAREST);
  vtkGetMacro(Method, int);
  void SetMethodToLinear() { this->SetMethod(LINEAR); }
  void SetMethodToNaturalNeighbor() { this->SetMethod(NATURAL_NEIGHBOR); }
  void SetMethodToLaplace() { this->SetMethod(LAPLACE); }
  void SetMethodToNearest() { this->SetMethod(NEAREST); }
  ///@}

  ///@{
  /// How the number of cells of the raster is given. Dimensions: by their number along x and y.
  /// Cell Size: by the width and height of one cell. Default: BY_DIMENSIONS.
  vtkSetClampMacro(RasterSize, int, BY_DIMENSIONS, BY_CELL_SIZE);
  vtkGetMacro(RasterSize, int);
  void SetRasterSizeToByDimensions() { this->SetRasterSize(BY_DIMENSIONS); }
  void SetRasterSizeToByCellSize() { this->SetRasterSize(BY_CELL_SIZE); }
  ///@}

  ///@{
  /// The number of cells along x and y; they fill the area of the raster. Default 256, 256, at
  /// least 1.
  virtual void SetDimensions(int value0, int value1);
  void SetDimensions(const int values[2]) VTK_SIZEHINT(2);
  vtkGetVector2Macro(Dimensions, int);
  ///@}

  ///@{
  /// The width and height of a cell, in the units of the points: more than 0. Metres for projected
  /// points, degrees where x and y are longitude and latitude. The raster begins at the lower bound
  /// and covers all of the points; what asks for more memory than there is is refused with figures.
  /// Default 1, 1.
  /// Any but a positive finite size is an error of the execution. As many cells as cover the area,
  /// at least one. Whether the last one is needed is judged by the numbers as they are written in
  /// decimal (15 digits): 100 cells of 0.1 cover 0 to 10.
  vtkSetVector2Macro(CellSize, double);
  vtkGetVector2Macro(CellSize, double);
  ///@}

  ///@{
  /// Put the borders between cells at multiples of the cell size, so that rasters of neighbouring
  /// tiles and of different surveys lie cell on cell (as -tap of GDAL). Off by default.
  /// Used with BY_CELL_SIZE. The area's lower bounds are rounded down, the upper ones up.
  vtkSetMacro(AlignToCellSize, bool);
  vtkGetMacro(AlignToCellSize, bool);
  vtkBooleanMacro(AlignToCellSize, bool);
  ///@}

  ///@{
  /// Give the raster an area of its own (Bounds) instead of the bounding box of the points: two
  /// surveys whose difference is wanted need the same. Off by default.
  /// Off: the bounding box of all points that are triangulated, in the plane of the triangulation;
  /// a side of length 0 makes one cell, as long as the other side's (or 1).
  vtkSetMacro(UseBounds, bool);
  vtkGetMacro(UseBounds, bool);
  vtkBooleanMacro(UseBounds, bool);
  ///@}

  ///@{
  /// The area of the raster: least x, largest x, least y, largest y, to the outer borders of its
  /// cells. Default 0, 1, 0, 1.
  /// Bounds that are not finite, or of which the lower is not below the upper, are an error of the
  /// execution.
  vtkSetVector4Macro(Bounds, double);
  vtkGetVector4Macro(Bounds, double);
  ///@}

  ///@{
  /// What the raster becomes. Image: an image in the plane z = 0 with the heights as an array,
  /// small and fast, for GIS and for calculating. Surface: a grid of points at their heights, to be
  /// seen as terrain; points without a value are hidden. Default: IMAGE.
  vtkSetClampMacro(OutputType, int, IMAGE, SURFACE);
  vtkGetMacro(OutputType, int);
  void SetOutputTypeToImage() { this->SetOutputType(IMAGE); }
  void SetOutputTypeToSurface() { this->SetOutputType(SURFACE); }
  ///@}

  ///@{
  /// What places outside the surface get. No Value: NaN in floating point arrays, 0 in others.
  /// Nearest Vertex: the values of the nearest point of the triangulation. Either way
  /// vtkValidPointMask is 0 there. Default: NO_VALUE.
  /// In place of NaN, what NoValue says. Counts of places outside are the same either way.
  vtkSetClampMacro(Outside, int, NO_VALUE, NEAREST_VERTEX);
  vtkGetMacro(Outside, int);
  void SetOutsideToNoValue() { this->SetOutside(NO_VALUE); }
  void SetOutsideToNearestVertex() { this->SetOutside(NEAREST_VERTEX); }
  ///@}

  ///@{
  /// What arrays of floating-point numbers have where there is no value. Arrays of whole numbers
  /// (Nearest) have 0 there. Default NaN.
  virtual void SetNoValue(double value);
  vtkGetMacro(NoValue, double);
  ///@}

  ///@{
  /// For each array of one component add its gradient, an array of two components: the change per
  /// unit of x and of y (NameGradient). Slope and aspect of a terrain come from that of Elevation.
  /// With Linear only, constant in each triangle. Off by default.
  /// With other methods there is a warning. On an edge and at a vertex they are those of one of its
  /// triangles.
  vtkSetMacro(GenerateGradients, bool);
  vtkGetMacro(GenerateGradients, bool);
  vtkBooleanMacro(GenerateGradients, bool);
  ///@}

  ///@{
  /// The name of the array of heights: z of the points or, in another plane, the height above it.
  /// Default "Elevation".
  /// The array is a vtkDoubleArray; an array of the input of that name is passed over, with a
  /// warning. Empty: no such array. The name of the mask, or "vtkGhostType", is an error of the
  /// execution.
  virtual void SetHeightArrayName(const std::string& name);
  virtual std::string GetHeightArrayName() { return this->HeightArrayName; }
  ///@}

  ///@{
  /// The name of the array that says where there is a value: 1 on the surface, 0 elsewhere; by
  /// default as that of ParaView's own resampling filters. Default "vtkValidPointMask".
  /// The array is a vtkCharArray; with Nearest, 1 for all places with finite x and y. Empty: no
  /// mask. The name of the heights or of their gradients, or "vtkGhostType", is an error of the
  /// execution.
  virtual void SetValidPointMaskArrayName(const std::string& name);
  virtual std::string GetValidPointMaskArrayName() { return this->ValidPointMaskArrayName; }
  ///@}

  ///@{
  /// How often this filter has triangulated since it was made. Another method or cell size needs no
  /// new triangulation.
  /// A triangulation is kept where KeepTriangulation is on and ReuseLimit is large enough, for the
  /// next execution with the same points, constraints and Triangulation. It stays 0 on a surface
  /// whose own triangulation is there.
  vtkGetMacro(NumberOfTriangulations, int);
  ///@}

  ///@{
  /// The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its
  /// input, or was refused: what Memory Limit is compared with.
  /// That is the MemoryLimit of Triangulation.
  vtkGetMacro(MemoryEstimate, vtkTypeInt64);
  ///@}

  ///@{
  /// Places, or cells of the raster, in the last run.
  /// They are those on the surface, those outside and those that are not finite. Counts are 0 if
  /// the run was aborted or ended in an error; they are field data of the output, too.
  vtkGetMacro(NumberOfPlaces, vtkIdType);
  ///@}

  ///@{
  /// Places that lie on the surface, in the last run: those where vtkValidPointMask is 1.
  vtkGetMacro(NumberOfValidPlaces, vtkIdType);
  ///@}

  ///@{
  /// Places outside the surface, in the last run: beyond its hull, in a hole or in a triangle that
  /// was left out.
  vtkGetMacro(NumberOfPlacesOutside, vtkIdType);
  ///@}

  ///@{
  /// Places whose x or y is NaN or infinite, in the last run. They have no value.
  vtkGetMacro(NumberOfNotFinitePlaces, vtkIdType);
  ///@}

  ///@{
  /// Values that are NaN, though their place is on the surface, as points around them have NaN, in
  /// the last run.
  /// A value is one for each component of an array at a valid place.
  vtkGetMacro(NumberOfPlacesWithoutValue, vtkIdType);
  ///@}

  ///@{
  /// With Natural Neighbor and Laplace: values that were made without some neighbours, as these
  /// have NaN, in the last run.
  vtkGetMacro(NumberOfPlacesWithNeighborsLeftOut, vtkIdType);
  ///@}

  ///@{
  /// Wall-clock seconds of finding the places and interpolating, in the last run; triangulating is
  /// not among them.
  vtkGetMacro(SampleSeconds, double);
  ///@}

protected:
  vtkAdaptiveHilbertInterpolationAlgorithm();
  ~vtkAdaptiveHilbertInterpolationAlgorithm() override;

  /// Sets all measures to what they are after an execution that came to nothing.
  void ClearMeasures();

  /// Throws std::bad_alloc.
  void GetSettingsOfRanks(vtkAHDSettingsOfRanks& settings) const;

  // Settings.
  int Method = LINEAR;
  int RasterSize = BY_DIMENSIONS;
  int Dimensions[2] = { 256, 256 };
  double CellSize[2] = { 1.0, 1.0 };
  bool AlignToCellSize = false;
  bool UseBounds = false;
  double Bounds[4] = { 0.0, 1.0, 0.0, 1.0 };
  int OutputType = IMAGE;
  int Outside = NO_VALUE;
  double NoValue = std::numeric_limits<double>::quiet_NaN();
  bool GenerateGradients = false;
  std::string HeightArrayName = "Elevation";
  std::string ValidPointMaskArrayName = "vtkValidPointMask";

  // Measures of the last execution.
  vtkTypeInt64 MemoryEstimate = 0;
  vtkIdType NumberOfPlaces = 0;
  vtkIdType NumberOfValidPlaces = 0;
  vtkIdType NumberOfPlacesOutside = 0;
  vtkIdType NumberOfNotFinitePlaces = 0;
  vtkIdType NumberOfPlacesWithoutValue = 0;
  vtkIdType NumberOfPlacesWithNeighborsLeftOut = 0;
  double SampleSeconds = 0.0;

  // Measures of all executions.
  int NumberOfTriangulations = 0;

private:
  vtkAdaptiveHilbertInterpolationAlgorithm(
    const vtkAdaptiveHilbertInterpolationAlgorithm&) = delete;
  void operator=(const vtkAdaptiveHilbertInterpolationAlgorithm&) = delete;
};

#endif
