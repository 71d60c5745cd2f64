// SPDX-License-Identifier: BSD-3-Clause
//
// vtkPlanarGeoTIFFWriter and images that no raster of ours is. Its files: Plugin/TestGeoTIFF.py.
#include "FilterTestSupport.h"
#include "vtkPlanarGeoTIFFWriter.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace
{

using ahdtest::Messages;

/// Writes an image of 2 x 2 points whose scalars are 1, 2, …, and removes the file.
struct Written
{
  explicit Written(int values)
  {
    this->Image->SetExtent(5, 6, 7, 8, 0, 0);
    this->Scalars->SetName("Depth");
    for (int k = 1; k <= values; ++k)
    {
      this->Scalars->InsertNextValue(k);
    }
    this->Image->GetPointData()->SetScalars(this->Scalars);
  }

  /// The last numbers of the file, empty if there is none.
  std::vector<double> Write()
  {
    const std::string number = std::to_string(std::random_device{}()); // tests run side by side
    const auto path = std::filesystem::path(testing::TempDir()) /
      std::filesystem::u8path("größe" + number + ".tif");
    vtkNew<vtkPlanarGeoTIFFWriter> writer;
    this->Said->Watch(writer);
    writer->SetFileName(path.u8string());
    writer->SetInputData(this->Image);
    const bool isWritten = writer->Write() == 1;
    EXPECT_EQ(std::filesystem::exists(path), isWritten);
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{ std::istreambuf_iterator<char>(file), {} };
    std::filesystem::remove(path);
    std::vector<double> numbers(isWritten ? 4 : 0);
    if (isWritten)
    {
      std::memcpy(numbers.data(), bytes.data() + bytes.size() - 32, 32);
    }
    return numbers;
  }

  vtkNew<vtkImageData> Image;
  vtkNew<vtkDoubleArray> Scalars;
  vtkNew<Messages> Said;
};

const std::vector<double> kNorthFirst = { 3, 4, 1, 2 };

TEST(GeoTIFF, MarksThatAreNotOneForEachPointHideNothing)
{
  for (const vtkIdType count : { 1, 2, 4, 100 })
  {
    Written made(4);
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfValues(count);
    marks->FillValue(vtkDataSetAttributes::HIDDENPOINT);
    made.Image->GetPointData()->AddArray(marks);
    EXPECT_EQ(made.Write(), count == 4 ? std::vector<double>(4, -9999.0) : kNorthFirst) << count;
  }
}

TEST(GeoTIFF, WordsNamedElevationAreNoHeights)
{
  Written made(4);
  vtkNew<vtkStringArray> words;
  words->SetName("Elevation");
  words->SetNumberOfValues(4);
  made.Image->GetPointData()->AddArray(words);
  EXPECT_EQ(made.Write(), kNorthFirst);
}

TEST(GeoTIFF, AnArrayThatIsNotOneForEachPointIsRefused)
{
  for (const int count : { 3, 5 })
  {
    Written made(count);
    EXPECT_TRUE(made.Write().empty()) << count;
    EXPECT_EQ(made.Said->Errors.size(), 1u);
  }
}

} // namespace
