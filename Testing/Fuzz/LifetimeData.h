// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_LifetimeData_h
#define ahd_LifetimeData_h

#include "Dice.h"

#include "vtkImageAlgorithm.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDoubleArray;
class vtkPoints;

namespace ahd
{
namespace fuzz
{

/// Points whose number, place and size depend on the time; a piece of them where pieces are
/// requested.
class TimedPoints : public vtkPolyDataAlgorithm
{
public:
  static TimedPoints* New();
  vtkTypeMacro(TimedPoints, vtkPolyDataAlgorithm);
  static void make(double time, int piece, int pieces, vtkPolyData* made);

protected:
  TimedPoints() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
};

/// A downstream filter of the raster, for images.
class ImageConsumer : public vtkImageAlgorithm
{
public:
  static ImageConsumer* New();
  vtkTypeMacro(ImageConsumer, vtkImageAlgorithm);

protected:
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
};

/// The program's memory, used by VTK's arrays.
class Lenders
{
public:
  vtkSmartPointer<vtkDoubleArray> lend(std::vector<double> numbers);
  /// The same numbers at another address; the memory lent before is overwritten and freed. False if
  /// the array has memory of its own.
  bool lendOther(vtkDataArray* array);

private:
  struct Lent
  {
    vtkSmartPointer<vtkDoubleArray> array;
    std::unique_ptr<std::vector<double>> numbers;
  };
  std::vector<Lent> all_;
};

/// Reuses memory that was freed just before, so that its old content is gone.
class Rubbish
{
public:
  void fill(Dice& dice);

private:
  std::vector<std::vector<double>> all_;
};

std::vector<double> numbersOf(vtkDataArray* array);
vtkSmartPointer<vtkPoints> pointsOf(const std::vector<double>& xyz);
vtkSmartPointer<vtkPolyData> makeInput(Dice& dice);
vtkSmartPointer<vtkPolyData> makeSource(Dice& dice);
/// Cells of a source with invalid offsets.
void makeLie(vtkPolyData* source, Dice& dice);
vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data);

/// Of a raster: all of it, and the point arrays of a part that lies in `extent`.
std::string rasterText(vtkDataObject* raster);
std::string partText(vtkDataObject* raster, const int extent[6]);

/// Are the point arrays of two rasters the same, but for the rounding of weights?
bool areClose(vtkDataObject* found, vtkDataObject* wanted);

} // namespace fuzz
} // namespace ahd

#endif
