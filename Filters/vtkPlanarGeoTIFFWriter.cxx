// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlanarGeoTIFFWriter.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <locale>
#include <new>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

vtkStandardNewMacro(vtkPlanarGeoTIFFWriter);

namespace
{
// Types of TIFF.
constexpr std::uint16_t kText = 2, kShort = 3, kLong = 4, kDouble = 12;
constexpr double kMostBytes = 4294967295.0;

template <typename Number>
std::string bytesOf(const std::vector<Number>& numbers)
{
  return std::string(
    reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
}

/// The directory of a TIFF file, with the values that do not fit into it behind.
class Directory
{
public:
  /// Tags must ascend. `size`: of one value.
  void Add(std::uint16_t tag, std::uint16_t type, const std::string& bytes, std::size_t size)
  {
    this->Entries.push_back({ tag, type, static_cast<std::uint32_t>(bytes.size() / size), bytes });
  }
  void Add(std::uint16_t tag, std::vector<std::uint16_t> numbers)
  {
    this->Add(tag, kShort, bytesOf(numbers), 2);
  }
  void Add(std::uint16_t tag, std::vector<std::uint32_t> numbers)
  {
    this->Add(tag, kLong, bytesOf(numbers), 4);
  }
  void Add(std::uint16_t tag, std::vector<double> numbers)
  {
    this->Add(tag, kDouble, bytesOf(numbers), 8);
  }

  /// Header, directory and values: what comes before the pixels.
  std::string Write() const
  {
    const std::uint16_t little = 0x4949, big = 0x4d4d, number = 42, one = 1;
    const bool isLittle = *reinterpret_cast<const unsigned char*>(&one) == 1;
    std::string made = bytesOf<std::uint16_t>({ isLittle ? little : big, number }) +
      bytesOf<std::uint32_t>({ 8 }) +
      bytesOf<std::uint16_t>({ static_cast<std::uint16_t>(this->Entries.size()) });
    const std::size_t begin = made.size() + 12 * this->Entries.size() + 4;
    std::string values;
    for (const Entry& entry : this->Entries)
    {
      std::string value = entry.Bytes;
      if (value.size() > 4)
      {
        value = bytesOf<std::uint32_t>({ static_cast<std::uint32_t>(begin + values.size()) });
        values += entry.Bytes + std::string(entry.Bytes.size() % 2, '\0');
      }
      value.resize(4, '\0');
      made += bytesOf<std::uint16_t>({ entry.Tag, entry.Type }) +
        bytesOf<std::uint32_t>({ entry.Count }) + value;
    }
    return made + bytesOf<std::uint32_t>({ 0 }) + values;
  }

private:
  struct Entry
  {
    std::uint16_t Tag, Type;
    std::uint32_t Count;
    std::string Bytes;
  };
  std::vector<Entry> Entries;
};

std::string textOf(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << number;
  return std::isnan(number) ? "nan" : text.str();
}

/// GeoTIFF's keys: pixel is area, and the system of coordinates.
std::vector<std::uint16_t> keysOf(int code, bool isGeographic)
{
  const auto number = static_cast<std::uint16_t>(code);
  if (isGeographic)
  {
    return { 1, 1, 0, 3, 1024, 0, 1, 2, 1025, 0, 1, 1, 2048, 0, 1, number };
  }
  return { 1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, number };
}

/// Where an image lies, to the outer borders of its pixels.
struct Frame
{
  explicit Frame(vtkImageData* image)
  {
    int extent[6];
    image->GetExtent(extent);
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Size[axis] = image->GetSpacing()[axis];
      this->Count[axis] = static_cast<std::uint32_t>(extent[2 * axis + 1] - extent[2 * axis] + 1);
      const double first = image->GetOrigin()[axis] + extent[2 * axis] * this->Size[axis];
      this->Low[axis] = first - 0.5 * this->Size[axis];
      this->High[axis] = first + (this->Count[axis] - 0.5) * this->Size[axis];
    }
  }

  /// The pixels at the borders may stick out, as those of a raster that covers its points do.
  bool IsInDegrees() const
  {
    const auto isWithin = [this](int axis, double most)
    {
      return this->Low[axis] + this->Size[axis] >= -most &&
        this->High[axis] - this->Size[axis] <= most;
    };
    return isWithin(0, 360.0) && isWithin(1, 90.0);
  }

  double Size[2], Low[2], High[2];
  std::uint32_t Count[2];
};

std::uint16_t bytesPerPixel(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT ? sizeof(float) : sizeof(double);
}

/// What comes before the pixels; a strip is a row.
std::string headerOf(const Frame& frame, std::uint16_t bytes, int code, double noData)
{
  const std::uint32_t rows = frame.Count[1], row = frame.Count[0] * bytes;
  const auto make = [&](std::uint32_t begin)
  {
    std::vector<std::uint32_t> offsets(rows);
    for (std::uint32_t k = 0; k < rows; ++k)
    {
      offsets[k] = begin + k * row;
    }
    Directory all;
    all.Add(256, std::vector<std::uint32_t>{ frame.Count[0] }); // ImageWidth
    all.Add(257, std::vector<std::uint32_t>{ rows });           // ImageLength
    all.Add(258, std::vector<std::uint16_t>{ static_cast<std::uint16_t>(8 * bytes) });
    all.Add(259, std::vector<std::uint16_t>{ 1 }); // not compressed
    all.Add(262, std::vector<std::uint16_t>{ 1 }); // 0 is black
    all.Add(273, offsets);
    all.Add(277, std::vector<std::uint16_t>{ 1 }); // one number a pixel
    all.Add(278, std::vector<std::uint32_t>{ 1 }); // RowsPerStrip
    all.Add(279, std::vector<std::uint32_t>(rows, row));
    all.Add(339, std::vector<std::uint16_t>{ 3 }); // floating-point numbers
    all.Add(33550, std::vector<double>{ frame.Size[0], frame.Size[1], 0.0 });
    all.Add(33922, std::vector<double>{ 0.0, 0.0, 0.0, frame.Low[0], frame.High[1], 0.0 });
    if (code != 0) // keys without a system are read as one that is unknown
    {
      all.Add(34735, keysOf(code, frame.IsInDegrees()));
    }
    all.Add(42113, kText, textOf(noData) + '\0', 1);
    return all.Write();
  };
  return make(static_cast<std::uint32_t>(make(0).size()));
}

/// Writes the rows of the image, the last one first.
template <typename Number>
void writeRows(std::ostream& file, vtkImageData* image, vtkDataArray* array, double noData)
{
  auto* marks = vtkArrayDownCast<vtkUnsignedCharArray>(
    image->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  marks = marks && marks->GetNumberOfValues() == image->GetNumberOfPoints() ? marks : nullptr;
  const Frame frame(image);
  const vtkIdType columns = frame.Count[0];
  std::vector<Number> row(frame.Count[0]);
  for (vtkIdType y = frame.Count[1] - 1; y >= 0 && file; --y)
  {
    for (vtkIdType x = 0; x < columns; ++x)
    {
      const vtkIdType point = y * columns + x;
      const double value = array->GetComponent(point, 0);
      const bool isHidden = marks &&
        (marks->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
      row[std::size_t(x)] = static_cast<Number>(isHidden || std::isnan(value) ? noData : value);
    }
    file.write(reinterpret_cast<const char*>(row.data()),
      static_cast<std::streamsize>(row.size() * sizeof(Number)));
  }
}
}

vtkPlanarGeoTIFFWriter::vtkPlanarGeoTIFFWriter()
{
  this->SetNumberOfOutputPorts(0);
}

int vtkPlanarGeoTIFFWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Modified();
  this->UpdateWholeExtent();
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

vtkDataArray* vtkPlanarGeoTIFFWriter::FindArray(vtkImageData* image)
{
  vtkPointData* const data = image->GetPointData();
  if (!this->ArrayName.empty())
  {
    return data->GetArray(this->ArrayName.c_str());
  }
  vtkDataArray* const heights = data->GetArray("Elevation");
  return heights ? heights : data->GetScalars();
}

int vtkPlanarGeoTIFFWriter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkImageData* const image = vtkImageData::GetData(inputs[0]);
  vtkDataArray* const array = image ? this->FindArray(image) : nullptr;
  const char* wrong = nullptr;
  if (!image || image->GetNumberOfPoints() == 0 || image->GetDimensions()[2] != 1 ||
    !image->GetDirectionMatrix()->IsIdentity() || !(image->GetSpacing()[0] > 0.0) ||
    !(image->GetSpacing()[1] > 0.0))
  {
    wrong = "The input is not an image of one layer in x and y.";
  }
  else if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    wrong = "There is no point array of one component that ArrayName names.";
  }
  else if (double(bytesPerPixel(array)) * double(image->GetNumberOfPoints()) +
      8.0 * image->GetDimensions()[1] + 65536.0 >
    kMostBytes)
  {
    wrong = "A GeoTIFF of so many pixels has more than 4 GiB. Take larger cells.";
  }
  if (wrong)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< wrong << " No file was written.");
  }
  else if (!this->WriteFile(image, array))
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro("The file could not be written: " << this->FileName);
  }
  return 1;
}

/// Returns false, and leaves the folder as it was, if the file cannot be written.
bool vtkPlanarGeoTIFFWriter::WriteFile(vtkImageData* image, vtkDataArray* array)
{
  const auto wanted = std::filesystem::u8path(this->FileName);
  const auto made = std::filesystem::u8path(this->FileName + ".part"); // until it is whole
  std::error_code fault;
  try
  {
    std::ofstream file(made, std::ios::binary | std::ios::trunc);
    const bool isFloat = bytesPerPixel(array) == sizeof(float);
    const double noData = isFloat ? double(float(this->NoDataValue)) : this->NoDataValue;
    file << headerOf(Frame(image), bytesPerPixel(array), this->EPSG, noData);
    isFloat ? writeRows<float>(file, image, array, noData)
            : writeRows<double>(file, image, array, noData);
    file.close();
    if (file)
    {
      std::filesystem::rename(made, wanted, fault);
      if (!fault)
      {
        return true;
      }
    }
  }
  catch (const std::bad_alloc&)
  {
  }
  std::filesystem::remove(made, fault);
  return false;
}

void vtkPlanarGeoTIFFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "EPSG: " << this->EPSG << "\n";
  os << indent << "NoDataValue: " << this->NoDataValue << "\n";
}
