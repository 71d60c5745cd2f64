// SPDX-License-Identifier: BSD-3-Clause
//
// Outputs belong to their holder: their arrays may be emptied, filled and enlarged like any others.
#include "FilterTestSupport.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"

#include <gtest/gtest.h>

#include <cstddef>

using namespace ahdtest;

namespace
{
constexpr std::size_t kPoints = 400000; // arrays of several MiB
const vtkIdType kCorners[3] = { 0, 1, 2 };

/// An output that only the test still holds.
class ChangedOutput : public ::testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->SetInputData(makeCloud(scatteredPoints(kPoints)));
    filter->GenerateNeighborsOn();
    filter->Update();
    this->Output = filter->GetOutput();
    this->Triangles = this->Output->GetNumberOfPolys();
    ASSERT_GT(this->Triangles, vtkIdType(kPoints));
    this->Polys = this->Output->GetPolys();
    this->Neighbors = vtkIdTypeArray::SafeDownCast(
      this->Output->GetCellData()->GetArray("Neighbors"));
    ASSERT_TRUE(this->Neighbors);
  }

  void InsertOne()
  {
    this->Polys->InsertNextCell(3, kCorners);
    EXPECT_EQ(this->Polys->GetNumberOfCells(), 1);
    EXPECT_EQ(this->Polys->GetConnectivityArray()->GetComponent(2, 0), 2.0);
  }

  void SetFive()
  {
    this->Neighbors->SetNumberOfTuples(5);
    this->Neighbors->FillComponent(0, 7.0);
    EXPECT_EQ(this->Neighbors->GetComponent(4, 0), 7.0);
  }

  vtkSmartPointer<vtkPolyData> Output;
  vtkSmartPointer<vtkCellArray> Polys;
  vtkSmartPointer<vtkIdTypeArray> Neighbors;
  vtkIdType Triangles = 0;
};
}

TEST_F(ChangedOutput, CellsAreInitializedAndInserted)
{
  this->Polys->Initialize();
  this->InsertOne();
}

TEST_F(ChangedOutput, CellsAreResetSqueezedAndInserted)
{
  this->Polys->Reset();
  this->Polys->Squeeze();
  this->InsertOne();
}

TEST_F(ChangedOutput, CellsAreAllocatedAnew)
{
  ASSERT_TRUE(this->Polys->AllocateExact(2 * this->Triangles, 6 * this->Triangles));
  this->InsertOne();
}

TEST_F(ChangedOutput, ArraysAreResizedToNothing)
{
  this->Neighbors->Resize(0);
  this->SetFive();
}

TEST_F(ChangedOutput, ArraysAreInitialized)
{
  this->Neighbors->Initialize();
  this->SetFive();
}

TEST_F(ChangedOutput, ArraysAreAllocatedAnew)
{
  ASSERT_TRUE(this->Neighbors->Allocate(3 * this->Triangles + 10));
  this->SetFive();
}
