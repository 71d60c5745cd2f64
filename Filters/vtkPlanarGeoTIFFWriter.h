// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlanarGeoTIFFWriter
 * @brief   write an array of an image in x and y as a GeoTIFF
 *
 * For rasters of vtkAdaptiveHilbertInterpolation2D, and other images of one layer: their points are
 * the centres of pixels ("pixel is area"), the first row of the file is the one of the largest y.
 *
 * <b>Features.</b> The place (ModelPixelScale, ModelTiepoint), a coordinate reference system by its
 * EPSG number, and a number for pixels without a value (GDAL_NODATA): points that are NaN or hidden
 * (vtkGhostType). Arrays of float are written as float, others as double. Not compressed, and
 * without other libraries.
 *
 * <b>Caveats.</b> Files end at 4 GiB. A number stands for a geographic system if all pixels reach
 * into x within 360 and y within 90, as degrees are, else for a projected one; whether there is
 * such a system is not checked. A failure is one error, with GetErrorCode(), and changes no file.
 *
 * <b>Example.</b>
 *
 * @code
 * vtkNew<vtkPlanarGeoTIFFWriter> writer;
 * writer->SetInputConnection(raster->GetOutputPort());
 * writer->SetFileName("dem.tif");
 * writer->SetEPSG(32633);
 * writer->Write();
 * @endcode
 *
 * @sa
 * vtkAdaptiveHilbertInterpolation2D vtkTIFFWriter
 */

#ifndef vtkPlanarGeoTIFFWriter_h
#define vtkPlanarGeoTIFFWriter_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

#include <string>

class vtkDataArray;

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkPlanarGeoTIFFWriter : public vtkImageAlgorithm
{
public:
  static vtkPlanarGeoTIFFWriter* New();
  vtkTypeMacro(vtkPlanarGeoTIFFWriter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file, in UTF-8. One of this name is replaced when the new one is whole.
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

  ///@{
  /// The array of the points, of one component. Empty, the default: Elevation if there is one, else
  /// the active scalars.
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /// The EPSG number of the coordinate reference system, such as 32633. 0, the default: none.
  vtkSetClampMacro(EPSG, int, 0, 65535);
  vtkGetMacro(EPSG, int);
  ///@}

  ///@{
  /// The number of pixels without a value. Default -9999; it may be NaN.
  vtkSetMacro(NoDataValue, double);
  vtkGetMacro(NoDataValue, double);
  ///@}

  /// Updates the input and writes the file. Returns 1, or 0 after an error.
  int Write();

protected:
  vtkPlanarGeoTIFFWriter();
  ~vtkPlanarGeoTIFFWriter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string FileName;
  std::string ArrayName;
  int EPSG = 0;
  double NoDataValue = -9999.0;

private:
  vtkPlanarGeoTIFFWriter(const vtkPlanarGeoTIFFWriter&) = delete;
  void operator=(const vtkPlanarGeoTIFFWriter&) = delete;

  vtkDataArray* FindArray(vtkImageData* image);
  bool WriteFile(vtkImageData* image, vtkDataArray* array);
};

#endif
