// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
/**
 * @class   vtkAdaptiveHilbertInterpolationAlgorithm
 * @brief   settings and measures of vtkAdaptiveHilbertInterpolation2D
 *
 * The superclass of vtkAdaptiveHilbertInterpolation2D: its numeric settings, names of arrays and
 * measures. The descriptions name values of settings as ParaView's panel does. The filter's
 * Triangulation has the settings of the triangulation.
 *
 * @sa
 * vtkAdaptiveHilbertInterpolation2D
 */

#ifndef vtkAdaptiveHilbertInterpolationAlgorithm_h
#define vtkAdaptiveHilbertInterpolationAlgorithm_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

#include <limits> // for defaults that are NaN
#include <string> // for names and texts

namespace ahd
{
struct SampleReport;
}
class vtkFieldData;
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
    /// by the number of cells
    BY_DIMENSIONS = 0,
    /// by the size of a cell
    BY_CELL_SIZE = 1
  };

  /// The values of OutputType.
  enum OutputTypeValues
  {
    /// vtkImageData
    IMAGE = 0,
    /// vtkStructuredGrid with its points at their heights
    SURFACE = 1
  };

  /// The values of Outside.
  enum OutsideValues
  {
    /// no value
    NO_VALUE = 0,
    /// that of the nearest vertex
    NEAREST_VERTEX = 1,
    /// that at the nearest place of the surface
    BOUNDARY = 2
  };

  ///@{
  /// The method of interpolation. Linear: linear in each triangle; the fastest. Natural Neighbor:
  /// the surrounding points, weighted by the areas that the place would take from their Voronoi
  /// cells (Sibson); smooth everywhere except at the points, and the best-looking for scattered
  /// points. Laplace: the same points, weighted by the lengths of the common borders over the
  /// distances; similar, a little faster. Nearest: the value of the nearest point, in the array's
  /// own type. Default: LINEAR.
  /// Constraint edges and the rim end the reach of Natural Neighbor and Laplace. Nearest has values
  /// on the whole plane; of several vertices at the same distance it takes the one with the
  /// smallest x, then y. It does not look across holes and outlines: the straight line to the
  /// vertex does not leave the surface through a constraint edge that bounds it. Collinear points:
  /// linear between neighbours on their line.
  vtkSetClampMacro(Method, int, LINEAR, NEAREST);
  vtkGetMacro(Method, int);
  void SetMethodToLinear() { this->SetMethod(LINEAR); }
  void SetMethodToNaturalNeighbor() { this->SetMethod(NATURAL_NEIGHBOR); }
  void SetMethodToLaplace() { this->SetMethod(LAPLACE); }
  void SetMethodToNearest() { this->SetMethod(NEAREST); }
  ///@}

  ///@{
  /// How the number of cells of the raster is set. Dimensions: by their number along x and y. Cell
  /// Size: by the width and height of a cell. Default: BY_CELL_SIZE in ParaView, BY_DIMENSIONS in
  /// VTK.
  /// Where the numbers of that are 0, the cells are squares, chosen from the points: about as many
  /// as there are points in the input, or 65536 if these are fewer, and no more than about 4096
  /// along a side. Their size is 1, 2 or 5 times a power of ten.
  vtkSetClampMacro(RasterSize, int, BY_DIMENSIONS, BY_CELL_SIZE);
  vtkGetMacro(RasterSize, int);
  void SetRasterSizeToByDimensions() { this->SetRasterSize(BY_DIMENSIONS); }
  void SetRasterSizeToByCellSize() { this->SetRasterSize(BY_CELL_SIZE); }
  ///@}

  ///@{
  /// The number of cells along x and y; they fill the area of the raster. 0: square cells, chosen
  /// from the points. Default 0, 0 in ParaView, 256, 256 in VTK, at least 0.
  virtual void SetDimensions(int value0, int value1);
  void SetDimensions(const int values[2]) VTK_SIZEHINT(2);
  vtkGetVector2Macro(Dimensions, int);
  ///@}

  ///@{
  /// The width and height of a cell in the units of the points: metres for projected points,
  /// degrees if x and y are longitude and latitude. Both 0: square cells, chosen from the points:
  /// about as many, or 65536 if these are fewer, of 1, 2 or 5 times a power of ten. The raster
  /// begins at the lower bounds and covers all points; one that needs more memory than available is
  /// refused with an error that says how much. Default 0, 0 in ParaView, 1, 1 in VTK.
  /// Other sizes that are not positive and finite are an error of the execution. The raster has as
  /// many cells as cover the area, at least one. Whether the last one is needed is decided on the
  /// numbers as written in decimal (15 digits): 100 cells of 0.1 cover 0 to 10.
  vtkSetVector2Macro(CellSize, double);
  vtkGetVector2Macro(CellSize, double);
  ///@}

  ///@{
  /// Align the borders between cells with multiples of the cell size, so that the cells of
  /// neighbouring tiles and of different surveys coincide (like -tap of GDAL). Off by default.
  /// Used with BY_CELL_SIZE. The area's lower bounds are rounded down, the upper ones up.
  vtkSetMacro(AlignToCellSize, bool);
  vtkGetMacro(AlignToCellSize, bool);
  vtkBooleanMacro(AlignToCellSize, bool);
  ///@}

  ///@{
  /// Use Bounds as the area of the raster instead of the bounding box of the points: two surveys to
  /// be subtracted from each other need the same area. Off by default.
  /// If off, the area is the bounding box of all triangulated points, in the plane of the
  /// triangulation; a side of length 0 makes one cell, as long as the other side's (or 1).
  vtkSetMacro(UseBounds, bool);
  vtkGetMacro(UseBounds, bool);
  vtkBooleanMacro(UseBounds, bool);
  ///@}

  ///@{
  /// The area of the raster, to the outer borders of its cells: least x, greatest x, least y,
  /// greatest y. Default 0, 1, 0, 1.
  /// Bounds that are not finite, or with a lower bound that is not below the upper, are an error of
  /// the execution.
  vtkSetVector4Macro(Bounds, double);
  vtkGetVector4Macro(Bounds, double);
  ///@}

  ///@{
  /// The type of the raster. Image: an image in the plane z = 0 with the heights as an array, small
  /// and fast, for GIS and for calculations. Surface: a grid of points at their heights, to show
  /// terrain. Points without a value are hidden. Default: IMAGE.
  /// Points are hidden by vtkGhostType (HIDDENPOINT). An image has this array only where there is
  /// such a point: one without a value in any array. In a surface those outside and those without a
  /// finite height are hidden.
  vtkSetClampMacro(OutputType, int, IMAGE, SURFACE);
  vtkGetMacro(OutputType, int);
  void SetOutputTypeToImage() { this->SetOutputType(IMAGE); }
  void SetOutputTypeToSurface() { this->SetOutputType(SURFACE); }
  ///@}

  ///@{
  /// The values at places outside the surface. No Value: NaN in floating-point arrays, 0 in others.
  /// Nearest Vertex: the values of the nearest point of the triangulation, as with Nearest.
  /// Boundary: the values at the nearest place of the surface, without a jump along its border.
  /// Always vtkValidPointMask is 0 there. Places outside by no more than rounding have values like
  /// those inside. Default: NO_VALUE.
  /// NoValue replaces NaN. Counts of places outside do not depend on this. Rounding: 16 units in
  /// the last place of the largest coordinate of place and edge.
  vtkSetClampMacro(Outside, int, NO_VALUE, BOUNDARY);
  vtkGetMacro(Outside, int);
  void SetOutsideToNoValue() { this->SetOutside(NO_VALUE); }
  void SetOutsideToNearestVertex() { this->SetOutside(NEAREST_VERTEX); }
  void SetOutsideToBoundary() { this->SetOutside(BOUNDARY); }
  ///@}

  ///@{
  /// The number in floating-point arrays where there is no value. Integer arrays (Nearest) have 0
  /// there. Default NaN.
  virtual void SetNoValue(double value);
  vtkGetMacro(NoValue, double);
  ///@}

  ///@{
  /// For each array of one component add its gradient, an array of two components: the change per
  /// unit of x and of y (NameGradient). The gradient of Elevation gives the slope and aspect of a
  /// terrain. Only with Linear; constant in each triangle. Off by default.
  /// With other methods there is a warning. On an edge or at a vertex it is that of one of its
  /// triangles.
  vtkSetMacro(GenerateGradients, bool);
  vtkGetMacro(GenerateGradients, bool);
  vtkBooleanMacro(GenerateGradients, bool);
  ///@}

  ///@{
  /// The name of the array of heights: z of the points or, in another plane, the height above it.
  /// Default "Elevation".
  /// The array is a vtkDoubleArray; an array of the input with that name is not interpolated, and
  /// there is a warning. Empty: no such array. The name of the mask, or "vtkGhostType", is an error
  /// of the execution.
  virtual void SetHeightArrayName(const std::string& name);
  virtual std::string GetHeightArrayName() { return this->HeightArrayName; }
  ///@}

  ///@{
  /// The name of the array that marks where there is a value: 1 on the surface, 0 elsewhere. The
  /// default is the name that ParaView's own resampling filters use. Default "vtkValidPointMask".
  /// The array is a vtkCharArray; with Nearest, 1 for all places with finite x and y. Empty: no
  /// mask. The name of the heights or of their gradients, or "vtkGhostType", is an error of the
  /// execution.
  virtual void SetValidPointMaskArrayName(const std::string& name);
  virtual std::string GetValidPointMaskArrayName() { return this->ValidPointMaskArrayName; }
  ///@}

  ///@{
  /// Places, or cells of the raster, in the last run.
  /// The sum of those on the surface, those outside it and those that are not finite. Counts are 0
  /// if the run was aborted or failed; they are field data of the output, too.
  vtkGetMacro(NumberOfPlaces, vtkIdType);
  ///@}

  ///@{
  /// Places on the surface, in the last run: those where vtkValidPointMask is 1.
  vtkGetMacro(NumberOfValidPlaces, vtkIdType);
  ///@}

  ///@{
  /// Places outside the surface, in the last run: beyond its hull, in a hole or in a removed
  /// triangle.
  vtkGetMacro(NumberOfPlacesOutside, vtkIdType);
  ///@}

  ///@{
  /// Places whose x or y is NaN or infinite, in the last run. They have no value.
  vtkGetMacro(NumberOfNotFinitePlaces, vtkIdType);
  ///@}

  ///@{
  /// Values that are NaN at places on the surface, because points around them have NaN, in the last
  /// run.
  /// There is one value for each component of an array at a valid place.
  vtkGetMacro(NumberOfPlacesWithoutValue, vtkIdType);
  ///@}

  ///@{
  /// With Natural Neighbor and Laplace: values interpolated without some natural neighbours,
  /// because these have NaN, in the last run.
  vtkGetMacro(NumberOfPlacesWithNeighborsLeftOut, vtkIdType);
  ///@}

  ///@{
  /// Wall-clock seconds to locate the places and interpolate, in the last run, without the
  /// triangulation.
  vtkGetMacro(SampleSeconds, double);
  ///@}

  ///@{
  /// How often this filter has triangulated since it was created. Another method or cell size needs
  /// no new triangulation.
  /// A triangulation is kept if KeepTriangulation is on and ReuseLimit is large enough, for the
  /// next execution with the same points, constraints and Triangulation. It stays 0 on a surface
  /// whose own triangulation is available.
  vtkGetMacro(NumberOfTriangulations, int);
  ///@}

  ///@{
  /// The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its
  /// input, or was refused: the number that is compared with Memory Limit.
  /// That is the MemoryLimit of Triangulation.
  vtkGetMacro(MemoryEstimate, vtkTypeInt64);
  ///@}

  /// What the last run found, as a text with a line for each number. Numbers that are 0 are left
  /// out, but for the first. Empty before a run.
  virtual std::string GetMeasures();

  /// What the last run took, as a text with a line for each number: seconds of wall-clock time,
  /// threads, memory. Numbers that are 0 are left out, but for the first. Empty before a run.
  virtual std::string GetResources();

protected:
  vtkAdaptiveHilbertInterpolationAlgorithm();
  ~vtkAdaptiveHilbertInterpolationAlgorithm() override;

  /// Sets all measures to their values after a failed execution.
  void ClearMeasures();

  /// Adds those of an engine's report.
  void AddMeasures(const ahd::SampleReport& report);

  /// Adds its counts to field data, as arrays of one value with the names of the measures.
  static void AddCounts(const ahd::SampleReport& report, vtkFieldData* data);

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
  vtkIdType NumberOfPlaces = 0;
  vtkIdType NumberOfValidPlaces = 0;
  vtkIdType NumberOfPlacesOutside = 0;
  vtkIdType NumberOfNotFinitePlaces = 0;
  vtkIdType NumberOfPlacesWithoutValue = 0;
  vtkIdType NumberOfPlacesWithNeighborsLeftOut = 0;
  double SampleSeconds = 0.0;
  vtkTypeInt64 MemoryEstimate = 0;

  // Measures of all executions.
  int NumberOfTriangulations = 0;

private:
  vtkAdaptiveHilbertInterpolationAlgorithm(
    const vtkAdaptiveHilbertInterpolationAlgorithm&) = delete;
  void operator=(const vtkAdaptiveHilbertInterpolationAlgorithm&) = delete;
};

#endif
