// SPDX-License-Identifier: BSD-3-Clause
//
// The fingerprint of an array: by it an execution detects that the points are those of the one
// before.
#include "ContextSupport.h"
#include "Execution/vtkAHDFingerprint.h"

#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace
{
ahd::Fingerprint fingerprintOf(vtkDataArray* array, unsigned threads = 1)
{
  const ahdtest::Work work(threads);
  ahd::Fingerprint fingerprint;
  EXPECT_TRUE(vtkAHDTakeFingerprint(array, work.Context, fingerprint));
  return fingerprint;
}
}

TEST(Fingerprint, TellsApartWhatDiffersInABit)
{
  std::set<ahd::Fingerprint> seen;
  std::size_t count = 0;
  for (int size : { 1, 2, 7, 8, 9, 31, 32, 33, 63, 64, 65, 100 })
  {
    vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetNumberOfValues(size);
    bytes->FillValue(0);
    seen.insert(fingerprintOf(bytes));
    ++count;
    for (int i = 0; i < size; ++i)
    {
      for (int bit = 0; bit < 8; ++bit)
      {
        bytes->SetValue(i, static_cast<unsigned char>(1 << bit));
        seen.insert(fingerprintOf(bytes));
        ++count;
      }
      bytes->SetValue(i, 0);
    }
  }
  EXPECT_EQ(seen.size(), count);
}

TEST(Fingerprint, TellsApartPlacesTypesAndShapes)
{
  // two different words change places, in steps of the lanes too
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetNumberOfValues(64);
  std::set<ahd::Fingerprint> seen;
  std::size_t count = 0;
  for (int i = 0; i < 64; ++i)
  {
    for (int j = 0; j < 64; ++j)
    {
      if (i != j)
      {
        numbers->FillValue(0.0);
        numbers->SetValue(i, 1.0);
        numbers->SetValue(j, 2.0);
        seen.insert(fingerprintOf(numbers));
        ++count;
      }
    }
  }
  EXPECT_EQ(seen.size(), count);

  vtkNew<vtkIntArray> wholes;
  vtkNew<vtkFloatArray> floats;
  wholes->SetNumberOfValues(12);
  floats->SetNumberOfValues(12);
  wholes->FillValue(0);
  floats->FillValue(0);
  EXPECT_NE(fingerprintOf(wholes), fingerprintOf(floats));
  const ahd::Fingerprint flat = fingerprintOf(floats);
  floats->SetNumberOfComponents(3);
  floats->SetNumberOfTuples(4);
  EXPECT_NE(fingerprintOf(floats), flat);
  EXPECT_NE(fingerprintOf(nullptr), flat);
  EXPECT_NE(fingerprintOf(nullptr), fingerprintOf(vtkNew<vtkDoubleArray>()));
}

/// The same bytes are another array if its type or its components are others.
TEST(Fingerprint, TellsApartTheSameBytesOfOtherShapes)
{
  std::set<ahd::Fingerprint> seen;
  std::size_t count = 0;
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_INT,
         VTK_FLOAT, VTK_DOUBLE, VTK_LONG_LONG, VTK_ID_TYPE })
  {
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    for (int components = 1; components <= 20; ++components)
    {
      array->SetNumberOfComponents(components);
      array->SetNumberOfValues(0);
      seen.insert(fingerprintOf(array));
      ++count;
    }
  }
  EXPECT_EQ(seen.size(), count);
}

TEST(Fingerprint, TellsApartPairsOfBits)
{
  // one changed word must not undo another
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfValues(20);
  std::set<ahd::Fingerprint> seen;
  std::size_t count = 0;
  for (int a = 0; a < 160; ++a)
  {
    for (int b = a + 1; b < 160; ++b)
    {
      bytes->FillValue(0);
      bytes->SetValue(a / 8, static_cast<unsigned char>(1 << a % 8));
      bytes->SetValue(b / 8, static_cast<unsigned char>(bytes->GetValue(b / 8) | 1 << b % 8));
      seen.insert(fingerprintOf(bytes));
      ++count;
    }
  }
  EXPECT_EQ(seen.size(), count);
  std::set<std::uint64_t> halves[2];
  for (const ahd::Fingerprint& fingerprint : seen)
  {
    halves[0].insert(fingerprint[0]);
    halves[1].insert(fingerprint[1]);
  }
  EXPECT_EQ(halves[0].size(), count) << "each half would do";
  EXPECT_EQ(halves[1].size(), count) << "each half would do";
}

TEST(Fingerprint, ThreadsDoNotMatter)
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetNumberOfValues((1 << 19) + 5);
  for (vtkIdType i = 0; i < numbers->GetNumberOfValues(); ++i)
  {
    numbers->SetValue(i, 1.0 / double(i + 1));
  }
  EXPECT_EQ(fingerprintOf(numbers, 3), fingerprintOf(numbers));
}
