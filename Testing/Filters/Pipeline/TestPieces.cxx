// SPDX-License-Identifier: BSD-3-Clause
//
// Pieces requested in one process: the output is made of all points, whatever the piece.
#include "SampleTestSupport.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkElevationFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkStructuredGridAlgorithm.h"

#include <gtest/gtest.h>

#include <cstring>

namespace
{

using namespace ahdtest;
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Points along x from 0 to 1 of which a piece has those of its part; as many for each.
class Pieces : public vtkPolyDataAlgorithm
{
public:
  static Pieces* New() { VTK_STANDARD_NEW_BODY(Pieces); }
  vtkTypeMacro(Pieces, vtkPolyDataAlgorithm);
  int Executed = 0;
  bool AsLines = false;
  bool Mirrored = false; ///< x runs from 1 to 0

protected:
  Pieces() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    outputs->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    ++this->Executed;
    vtkInformation* const info = outputs->GetInformationObject(0);
    const int piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
    const int pieces = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
    std::vector<Xyz> own;
    for (const Xyz& p : scatteredPoints(600, 5))
    {
      if (int(p[0] * pieces) == piece)
      {
        const double x = this->Mirrored ? 1 - p[0] : p[0];
        own.push_back({ x, p[1], std::sin(7 * x) + p[1] * p[1] });
      }
    }
    auto made = makeCloud(own);
    if (this->AsLines)
    {
      vtkNew<vtkCellArray> lines;
      const vtkIdType ends[] = { 0, 1 };
      lines->InsertNextCell(2, ends);
      made->SetLines(lines);
    }
    vtkPolyData::GetData(outputs)->ShallowCopy(made);
    return 1;
  }
};

/// A structured grid that makes the requested extent.
class GridPieces : public vtkStructuredGridAlgorithm
{
public:
  static GridPieces* New() { VTK_STANDARD_NEW_BODY(GridPieces); }
  vtkTypeMacro(GridPieces, vtkStructuredGridAlgorithm);

protected:
  GridPieces() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const int extent[] = { 0, 15, 0, 15, 0, 0 };
    outputs->GetInformationObject(0)->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
    outputs->GetInformationObject(0)->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    int extent[6];
    outputs->GetInformationObject(0)->Get(Pipeline::UPDATE_EXTENT(), extent);
    std::vector<Xyz> own;
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        own.push_back({ i / 15.0, j / 15.0, std::sin(i) + j });
      }
    }
    auto* output = vtkStructuredGrid::GetData(outputs);
    output->SetExtent(extent);
    output->SetPoints(makePoints(own));
    return 1;
  }
};

bool areSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void expectOneRaster(vtkAlgorithm* points, vtkAlgorithm* source)
{
  WatchedInterpolation filter;
  filter->SetInputConnection(points->GetOutputPort());
  if (source)
  {
    filter->SetSourceConnection(source->GetOutputPort());
    filter->GetTriangulation()->SetSourceModeToCoordinates();
  }
  filter->SetDimensions(12, 8);
  filter->Update();
  const auto whole = numbersOf(filter->GetOutput(), "Elevation");
  const std::size_t outside = static_cast<std::size_t>(filter->GetNumberOfPlacesOutside());
  for (const int pieces : { 2, 3, 1 })
  {
    for (int piece = 0; piece < pieces; ++piece)
    {
      filter->Modified();
      filter->UpdatePiece(piece, pieces, 0);
      EXPECT_TRUE(areSame(numbersOf(filter->GetOutput(), "Elevation"), whole)) << piece;
      EXPECT_EQ(static_cast<std::size_t>(filter->GetNumberOfPlacesOutside()), outside);
    }
  }
  EXPECT_TRUE(filter.Said->Errors.empty());
}

TEST(Pieces, EachPieceOfARasterIsOfAllPoints)
{
  vtkNew<Pieces> points, source;
  source->AsLines = true;
  expectOneRaster(points, nullptr);
  expectOneRaster(points, source);
  expectOneRaster(vtkNew<GridPieces>(), nullptr);
}

/// The raster is announced by all points, whatever another filter has requested of them last.
TEST(Pieces, RasterIsAnnouncedByAllPoints)
{
  vtkNew<Pieces> points;
  WatchedInterpolation filter;
  filter->SetInputConnection(points->GetOutputPort());
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0.05, 0.05);
  points->UpdatePiece(1, 4, 0);
  filter->UpdateInformation();
  int extent[6];
  filter->GetOutputInformation(0)->Get(Pipeline::WHOLE_EXTENT(), extent);
  EXPECT_EQ(extent[1], 19);
  points->UpdatePiece(1, 4, 0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPlaces(), 400);
}

/// Places are taken in pieces, the points to interpolate between are not.
TEST(Pieces, PlacesInPiecesHaveTheValuesOfAllPoints)
{
  vtkNew<Pieces> points, places;
  places->Mirrored = true;
  WatchedInterpolation filter;
  filter->SetInputConnection(points->GetOutputPort());
  filter->SetPlacesConnection(places->GetOutputPort());
  filter->SetOutsideToNearestVertex();
  filter->Update();
  std::vector<double> whole = numbersOf(filter->GetOutput(), "Elevation"), inPieces;
  EXPECT_EQ(whole.size(), 600u);
  for (int piece = 0; piece < 3; ++piece)
  {
    filter->UpdatePiece(piece, 3, 0);
    EXPECT_LT(filter->GetNumberOfPlaces(), 300);
    const auto some = numbersOf(filter->GetOutput(), "Elevation");
    inPieces.insert(inPieces.end(), some.begin(), some.end());
  }
  std::sort(whole.begin(), whole.end());
  std::sort(inPieces.begin(), inPieces.end());
  EXPECT_TRUE(areSame(inPieces, whole));
}

TEST(Pieces, FirstPieceIsTheWholeTriangulation)
{
  vtkNew<Pieces> points;
  WatchedFilter filter;
  filter->SetInputConnection(points->GetOutputPort());
  filter->GenerateVoronoiOn();
  filter->Update();
  const std::vector<Triangle> whole = trianglesOf(filter->GetOutput());
  ASSERT_GT(whole.size(), 1000u);
  for (const int piece : { 1, 0, 2, 0 })
  {
    filter->UpdatePiece(piece, 3, 1);
    EXPECT_EQ(trianglesOf(filter->GetOutput()), piece == 0 ? whole : std::vector<Triangle>());
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), piece == 0 ? 600 : 0);
    // of that port only the first piece was requested
    auto* diagram = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2));
    EXPECT_EQ(diagram->GetNumberOfCells(), 600) << piece;
  }
  EXPECT_EQ(points->Executed, 1);
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

/// Writers of pieces list the arrays of the last piece.
TEST(Pieces, OthersHaveTheArraysOfTheFirst)
{
  vtkNew<Pieces> points;
  vtkNew<vtkElevationFilter> withData;
  withData->SetInputConnection(points->GetOutputPort());
  WatchedFilter filter;
  filter->SetInputConnection(withData->GetOutputPort());
  filter->GeneratePointStatusOn();
  filter->GenerateConstraintEdgesOn();
  for (const int piece : { 1, 0, 1 })
  {
    filter->UpdatePiece(piece, 2, 0);
    vtkPolyData* const surface = filter->GetOutput();
    EXPECT_EQ(surface->GetNumberOfPoints(), piece == 0 ? 600 : 0);
    ASSERT_TRUE(surface->GetPoints());
    EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(surface->GetPointData()->GetNumberOfArrays(), 2);
    ASSERT_TRUE(surface->GetPointData()->GetScalars());
    EXPECT_EQ(surface->GetPointData()->GetScalars()->GetNumberOfTuples(), piece == 0 ? 600 : 0);
    EXPECT_TRUE(surface->GetCellData()->HasArray("ConstraintEdges"));
  }
  filter->GenerateConstraintEdgesOff();
  filter->UpdatePiece(1, 2, 0); // with other settings
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_FALSE(filter->GetOutput()->GetCellData()->HasArray("ConstraintEdges"));
}

/// Global ids too, which VTK does not copy by itself.
TEST(Pieces, OthersHaveTheGlobalIdsOfTheFirst)
{
  const auto points = makeCloud(scatteredPoints(100));
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  for (vtkIdType i = 0; i < 100; ++i)
  {
    ids->InsertNextValue(1000 + i);
  }
  points->GetPointData()->SetGlobalIds(ids);
  WatchedFilter filter;
  filter->SetInputData(points);
  for (const int piece : { 0, 1 })
  {
    filter->UpdatePiece(piece, 2, 0);
    vtkDataArray* const found = filter->GetOutput()->GetPointData()->GetGlobalIds();
    ASSERT_NE(found, nullptr) << piece;
    EXPECT_STREQ(found->GetName(), "ids");
    EXPECT_EQ(found->GetNumberOfTuples(), piece == 0 ? 100 : 0);
  }
}

/// Another piece than the first costs nothing, and leaves the measures alone.
TEST(Pieces, OthersTakeNoTriangulation)
{
  vtkNew<Pieces> points;
  WatchedFilter filter;
  filter->SetInputConnection(points->GetOutputPort());
  filter->UpdatePiece(0, 2, 0);
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 600);
  EXPECT_EQ(points->Executed, 1);
}

} // namespace
