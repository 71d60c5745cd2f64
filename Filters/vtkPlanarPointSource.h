// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlanarPointSource
 * @brief   make the point sets that triangulations are compared on
 *
 * Makes points of the plane z = 0: one of the six distributions on which T. Su, W. Wang, Z. Lv,
 * W. Wu, X. Li compare methods of triangulation (<em>Rapid Delaunay triangulation for randomly
 * distributed point cloud data using adaptive Hilbert curve</em>, Computers & Graphics 54 (2016)
 * 65-74, doi:10.1016/j.cag.2015.07.019, figure 10), or a lattice, on which every four neighbours
 * lie on one circle.
 *
 * <b>The distributions.</b> The paper shows pictures and gives no formulas; these are ours. Each
 * use of u stands for a new random number, uniform in [0, 1), a multiple of 2^-53; each g for a new
 * one near the normal distribution: the sum of twelve u, less 6, so its mean is 0, its standard
 * deviation 1, and |g| <= 6. Lengths are in the units of the coordinates.
 * - UNIFORM: (u, u). The unit square.
 * - LINE: (t, t + 0.01 g) with t = u. A band about the diagonal from (0, 0) to (1, 1), its standard
 *   deviation 0.01 in y; 0 <= x < 1, -0.06 <= y < 1.06.
 * - CROSS: a point (x, y) of LINE, or its mirror image (x, 1 - y), each with probability 1/2. Two
 *   bands that cross in (0.5, 0.5).
 * - CIRCLE: radius 0.4 + 0.01 g about (0.5, 0.5), direction 2 pi u. A ring with radii from 0.34 to
 *   0.46.
 * - SPIRAL: radius 0.15 t + 0.01 g about (0.5, 0.5), direction 2 pi t, with t = 3 sqrt(u). Three
 *   turns of an Archimedean spiral, 0.15 from turn to turn, that ends at radius 0.45. The root
 *   spreads the points evenly along its length. All points lie within 0.51 of (0.5, 0.5).
 * - MIXED: with probability 1/2 a point of UNIFORM; else a point (0.01 g, 0.01 g) away from the
 *   centre of one of 20 clusters, all equally likely. The centres are (u, u); they depend on Seed
 *   only. A coordinate lies from -0.06 to 1.06.
 * - LATTICE: point i is (i modulo s, i / s rounded down), where s is the square root of
 *   NumberOfPoints rounded up: whole coordinates, row by row from (0, 0). No point is there twice.
 *   A square number of points fills the square, any other leaves places of the last rows empty.
 *
 * <b>What comes out.</b> A vtkPolyData of NumberOfPoints points, z = 0, and one vertex cell of the
 * type VTK_POLY_VERTEX with all of them, as vtkPointSource makes it, so that they are seen when
 * drawn; no cell where there is no point. The points come in random order, those of LATTICE row by
 * row. vtkAdaptiveHilbertDelaunay2D and vtkDelaunay2D take the output as it is.
 *
 * <b>The same everywhere.</b> The points are a function of Distribution, NumberOfPoints and Seed,
 * to the last bit, wherever doubles are those of IEEE 754: the random numbers are this class's own
 * (splitmix64), neither vtkMath's nor the C library's, and sines and cosines are summed up from
 * their series. A larger NumberOfPoints appends to the points that a smaller one makes, except on
 * the LATTICE, which becomes wider.
 *
 * <b>Time, memory, errors.</b> One thread works. The output takes 28 bytes per point (16 in single
 * precision). Where there is not as much memory, an error says so, once, before anything is
 * allocated, and the output is empty; the request counts as done, as with
 * vtkAdaptiveHilbertDelaunay2D. An aborted execution (SetAbortExecute from a progress observer)
 * leaves an empty output and no error; to run again, call SetAbortExecute(0) and Modified(). On
 * several ranks, and where pieces are asked for, the first has all points.
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
    LATTICE = 6  ///< whole coordinates, row by row
  };

  ///@{
  /**
   * How the points are distributed: one of Distributions, by the formulas above. Default UNIFORM.
   */
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
  /**
   * How many points to make, from 0 to 2^29 = 536870912, twice what vtkAdaptiveHilbertDelaunay2D
   * takes; default 10000. Numbers outside are taken as the nearest inside.
   */
  vtkSetClampMacro(NumberOfPoints, vtkIdType, 0, 1 << 29);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Where the sequence of random numbers starts: any int, each gives other points; default 1. Not
   * used by LATTICE.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * The type of the coordinates: vtkAlgorithm::DOUBLE_PRECISION (the default; DEFAULT_PRECISION
   * stands for the same) or vtkAlgorithm::SINGLE_PRECISION. Single precision rounds the double
   * coordinates to the nearest float, and some points of a large random set then coincide (of 10^7,
   * a few), which are distinct in double precision.
   */
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
  int OutputPointsPrecision = DOUBLE_PRECISION;

private:
  vtkPlanarPointSource(const vtkPlanarPointSource&) = delete;
  void operator=(const vtkPlanarPointSource&) = delete;

  bool FitsInMemory();
  template <typename Array>
  bool MakePoints(vtkPolyData* output);
};

#endif
