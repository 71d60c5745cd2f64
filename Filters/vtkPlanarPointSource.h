// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlanarPointSource
 * @brief   make the point sets used to compare triangulations
 *
 * Points of the plane z = 0, or on hills, and one VTK_POLY_VERTEX cell with all: those of Su
 * et al., Computers & Graphics 54 (2016) 65-74, figure 10, and a lattice. Formulas:
 * Plugin/Documentation/Reference.md.
 *
 * <b>Features.</b> The points depend on the settings alone, to the last bit, on every machine with
 * doubles of IEEE 754; x and y not on HillHeight.
 *
 * <b>Caveats.</b> 28 bytes per point (16 in single precision); too little memory is one error and
 * an empty output. On several ranks, the first rank has all points.
 *
 * <b>Example.</b>
 *
 * @code
 * vtkNew<vtkPlanarPointSource> points;
 * points->SetDistributionToSpiral();
 * points->SetNumberOfPoints(100000);
 * delaunay->SetInputConnection(points->GetOutputPort());
 * @endcode
 *
 * @sa
 * vtkAdaptiveHilbertDelaunay2D vtkPointSource
 */

#ifndef vtkPlanarPointSource_h
#define vtkPlanarPointSource_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkPlanarPointSource : public vtkPolyDataAlgorithm
{
public:
  static vtkPlanarPointSource* New();
  vtkTypeMacro(vtkPlanarPointSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The values of Distribution.
  enum Distributions
  {
    UNIFORM = 0, ///< the unit square
    LINE = 1,    ///< a band about its diagonal
    CROSS = 2,   ///< bands about both diagonals
    CIRCLE = 3,  ///< a ring
    SPIRAL = 4,  ///< three turns of a spiral
    MIXED = 5,   ///< half of the points in the unit square, half in 20 clusters
    LATTICE = 6  ///< integer coordinates, row by row
  };

  ///@{
  /// The distribution of the points, one of Distributions. Default UNIFORM.
  vtkSetClampMacro(Distribution, int, UNIFORM, LATTICE);
  vtkGetMacro(Distribution, int);
  void SetDistributionToUniform() { this->SetDistribution(UNIFORM); }
  void SetDistributionToLine() { this->SetDistribution(LINE); }
  void SetDistributionToCross() { this->SetDistribution(CROSS); }
  void SetDistributionToCircle() { this->SetDistribution(CIRCLE); }
  void SetDistributionToSpiral() { this->SetDistribution(SPIRAL); }
  void SetDistributionToMixed() { this->SetDistribution(MIXED); }
  void SetDistributionToLattice() { this->SetDistribution(LATTICE); }
  ///@}

  ///@{
  /// The number of points, from 0 to 2^29, twice the most that the filter takes; default 10000.
  /// Seed: of the random numbers, any int, default 1; LATTICE has none.
  vtkSetClampMacro(NumberOfPoints, vtkIdType, 0, 1 << 29);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// The height of hills, z, as a part of the width of the set, from 0 (the default: none) to 1000;
  /// and the factor of all coordinates, from 1e-9 to 1e9, default 1. NaN changes nothing.
  void SetHillHeight(double height);
  double GetHillHeightMinValue() { return 0.0; }
  double GetHillHeightMaxValue() { return 1000.0; }
  vtkGetMacro(HillHeight, double);
  void SetScale(double scale);
  double GetScaleMinValue() { return 1e-9; }
  double GetScaleMaxValue() { return 1e9; }
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /// vtkAlgorithm::DOUBLE_PRECISION, the default (DEFAULT_PRECISION is the same), or
  /// SINGLE_PRECISION: rounded to float, so that a few of 10^7 random points coincide.
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkPlanarPointSource();
  ~vtkPlanarPointSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Distribution = UNIFORM;
  vtkIdType NumberOfPoints = 10000;
  int Seed = 1;
  double HillHeight = 0.0;
  double Scale = 1.0;
  int OutputPointsPrecision = DOUBLE_PRECISION;

private:
  vtkPlanarPointSource(const vtkPlanarPointSource&) = delete;
  void operator=(const vtkPlanarPointSource&) = delete;

  bool FitsInMemory();
  template <typename Array>
  bool MakePoints(vtkPolyData* output);
};

#endif
