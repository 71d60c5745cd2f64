// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of a raster: their number, their origin, and invalid rasters.
#include "Sampling/vtkAHDRaster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace
{

using Fault = vtkAHDRasterFault;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ahd::Bounds box(double xmin, double xmax, double ymin, double ymax)
{
  ahd::Bounds area;
  area.xmin = xmin;
  area.xmax = xmax;
  area.ymin = ymin;
  area.ymax = ymax;
  return area;
}

vtkAHDRasterWish bySize(double size, bool align = false)
{
  vtkAHDRasterWish wish;
  wish.ByCellSize = true;
  wish.CellSize = { { size, size } };
  wish.Align = align;
  return wish;
}

vtkAHDRasterWish byCount(int columns, int rows)
{
  vtkAHDRasterWish wish;
  wish.Dimensions = { { columns, rows } };
  return wish;
}

vtkAHDRaster makeRaster(
  const vtkAHDRasterWish& wish, const ahd::Bounds& area, std::size_t points = 0)
{
  return vtkAHDMakeRaster(wish, area, points);
}

/// Columns of a raster from `low` to `high`.
std::size_t columnsOf(double low, double high, double size, bool align = false)
{
  return makeRaster(bySize(size, align), box(low, high, low, high)).Cells.columns;
}

TEST(Raster, ByDimensionsFillsTheArea)
{
  const vtkAHDRaster raster = makeRaster(byCount(4, 5), box(2, 4, -10, 0));
  ASSERT_EQ(raster.Fault, Fault::None);
  EXPECT_EQ(raster.Cells.columns, 4u);
  EXPECT_EQ(raster.Cells.rows, 5u);
  EXPECT_EQ(raster.Cells.spacing, (ahd::Point{ 0.5, 2.0 }));
  EXPECT_EQ(raster.Cells.origin, (ahd::Point{ 2.25, -9.0 })); // a centre: pixel is area
  EXPECT_EQ(raster.Cells.at(3, 4), (ahd::Point{ 3.75, -1.0 }));
}

TEST(Raster, BySizeBeginsAtTheLowerBoundAndCoversTheUpper)
{
  const vtkAHDRaster raster = makeRaster(bySize(2.0), box(1, 6, 0, 4));
  ASSERT_EQ(raster.Fault, Fault::None);
  EXPECT_EQ(raster.Cells.columns, 3u); // 1 to 7
  EXPECT_EQ(raster.Cells.rows, 2u);    // 0 to 4 exactly
  EXPECT_EQ(raster.Cells.origin, (ahd::Point{ 2.0, 1.0 }));
  EXPECT_EQ(raster.Cells.spacing, (ahd::Point{ 2.0, 2.0 }));
}

TEST(Raster, BoundsThatAreMultiplesInDecimalTakeNoCellMore)
{
  for (int k = 1; k <= 5000; ++k)
  {
    const double tenths = k / 10.0; // as it is read from a file
    EXPECT_EQ(columnsOf(0.0, tenths, 0.1), std::size_t(k));
    EXPECT_EQ(columnsOf(0.0, tenths, 0.1, true), std::size_t(k));
    EXPECT_EQ(columnsOf(-tenths, tenths, 0.1, true), 2u * std::size_t(k));
  }
  EXPECT_EQ(columnsOf(500000.1, 500010.1, 0.1), 100u);
  EXPECT_EQ(columnsOf(500000.1, 500010.1, 0.1, true), 100u);
  EXPECT_EQ(columnsOf(5000000.3, 5000010.3, 0.01), 1000u);
  EXPECT_EQ(columnsOf(-0.7, 1.1, 0.1), 18u);
}

TEST(Raster, WhatSticksOutTakesACellMore)
{
  EXPECT_EQ(columnsOf(0.0, 1.1 + 1e-12, 0.1), 12u);
  EXPECT_EQ(columnsOf(0.0, 1.0 + 1e-14, 0.1), 11u);
  EXPECT_EQ(columnsOf(500000.1, 500010.1 + 1e-7, 0.1), 101u);
  EXPECT_EQ(columnsOf(-1e-12, 1.0, 0.1, true), 11u);
  EXPECT_EQ(columnsOf(0.0, 1.0 - 1e-12, 0.1), 10u);
}

TEST(Raster, AlignedBordersAreMultiples)
{
  const vtkAHDRaster raster = makeRaster(bySize(10.0, true), box(-27, 13, 5, 31));
  ASSERT_EQ(raster.Fault, Fault::None);
  EXPECT_EQ(raster.Cells.origin, (ahd::Point{ -25.0, 5.0 })); // -30 and 0
  EXPECT_EQ(raster.Cells.columns, 5u);                        // -30 to 20
  EXPECT_EQ(raster.Cells.rows, 4u);                           // 0 to 40
  // Two rasters of one size have the same centres where they overlap.
  const vtkAHDRaster other = makeRaster(bySize(10.0, true), box(-3, 99, -3, 99));
  EXPECT_EQ(other.Cells.origin, (ahd::Point{ -5.0, -5.0 }));
}

TEST(Raster, AtLeastOneCell)
{
  EXPECT_EQ(columnsOf(3.0, 3.0, 10.0), 1u);
  EXPECT_EQ(columnsOf(3.0, 3.0, 10.0, true), 1u);
  EXPECT_EQ(columnsOf(10.0, 10.0, 10.0, true), 1u);
  EXPECT_EQ(columnsOf(3.0, 4.0, 1e300), 1u);
}

TEST(Raster, ASideOfLengthZeroIsARowThroughIt)
{
  const vtkAHDRaster row = makeRaster(byCount(4, 5), box(0, 2, 7, 7));
  ASSERT_EQ(row.Fault, Fault::None);
  EXPECT_EQ(row.Cells.rows, 1u);
  EXPECT_EQ(row.Cells.columns, 4u);
  EXPECT_EQ(row.Cells.origin, (ahd::Point{ 0.25, 7.0 }));
  EXPECT_EQ(row.Cells.spacing, (ahd::Point{ 0.5, 0.5 }));
  const vtkAHDRaster one = makeRaster(byCount(4, 5), box(3, 3, 7, 7));
  ASSERT_EQ(one.Fault, Fault::None);
  EXPECT_EQ(one.Cells.columns * one.Cells.rows, 1u);
  EXPECT_EQ(one.Cells.origin, (ahd::Point{ 3.0, 7.0 }));
  EXPECT_EQ(one.Cells.spacing, (ahd::Point{ 1.0, 1.0 }));
}

TEST(Raster, ByCellSizeARowRunsThroughItToo)
{
  const vtkAHDRaster row = makeRaster(bySize(0.5), box(0, 2, 7, 7));
  ASSERT_EQ(row.Fault, Fault::None);
  EXPECT_EQ(row.Cells.rows, 1u);
  EXPECT_EQ(row.Cells.columns, 4u);
  EXPECT_EQ(row.Cells.origin, (ahd::Point{ 0.25, 7.0 }));
  EXPECT_EQ(row.Cells.spacing, (ahd::Point{ 0.5, 0.5 }));
  const vtkAHDRaster aligned = makeRaster(bySize(2.0, true), box(0, 2, 7, 7));
  EXPECT_EQ(aligned.Cells.origin, (ahd::Point{ 1.0, 7.0 })); // 6 to 8
}

/// A raster of chosen cells, in either way to ask for them, which must be squares.
vtkAHDRaster chosen(const ahd::Bounds& area, std::size_t points)
{
  const vtkAHDRaster raster = makeRaster(bySize(0.0), area, points);
  EXPECT_EQ(raster.Fault, Fault::None);
  EXPECT_EQ(raster.Cells.spacing.x, raster.Cells.spacing.y);
  for (const auto& [columns, rows] : { std::pair(0, 0), std::pair(0, 9), std::pair(9, 0) })
  {
    const ahd::SampleRaster other = makeRaster(byCount(columns, rows), area, points).Cells;
    EXPECT_EQ(other.spacing, raster.Cells.spacing);
    EXPECT_EQ(other.origin, raster.Cells.origin);
    EXPECT_EQ(other.columns, raster.Cells.columns);
    EXPECT_EQ(other.rows, raster.Cells.rows);
  }
  return raster;
}

TEST(Raster, CellsAreChosenFromThePoints)
{
  struct Case
  {
    ahd::Bounds Area;
    std::size_t Points;
    double Size;
    std::size_t Columns, Rows;
  };
  const Case cases[] = {
    { box(0, 1000, 0, 500), 500, 2.0, 500, 250 },              // 2.76 for 65536 cells
    { box(0, 1000, 0, 500), 65536, 2.0, 500, 250 },            // as few
    { box(0, 1000, 0, 500), 2000000, 0.5, 2000, 1000 },        // as many as points
    { box(0, 4096, 0, 4096), 1000000000, 1.0, 4096, 4096 },    // no more along a side
    { box(0, 40960, 0, 1), 100, 10.0, 4096, 1 },               // nor of a long one
    { box(5, 4101, 7, 7), 100, 1.0, 4096, 1 },                 // a line
    { box(-20, -19.064, 40, 40.485), 25601, 0.002, 468, 243 }, // degrees
    { box(3, 3, 7, 7), 1, 1.0, 1, 1 },                         // a point
  };
  for (const Case& one : cases)
  {
    const ahd::SampleRaster cells = chosen(one.Area, one.Points).Cells;
    EXPECT_EQ(cells.spacing.x, one.Size);
    EXPECT_EQ(cells.columns, one.Columns) << one.Size;
    EXPECT_EQ(cells.rows, one.Rows) << one.Size;
  }
}

TEST(Raster, CellsAreChosenInAreasOfAnySize)
{
  for (int power = -1070; power <= 1020; ++power)
  {
    const double side = std::ldexp(1.0, power);
    const ahd::SampleRaster cells = chosen(box(0, side, 0, side), 1).Cells;
    EXPECT_GE(cells.columns, 1u) << power;
    EXPECT_LE(cells.columns, 600u) << power;
    EXPECT_EQ(cells.columns, cells.rows) << power;
    EXPECT_TRUE(cells.columns > 150u || power < -1060) << power;
  }
  const double most = std::numeric_limits<double>::max();
  EXPECT_GT(chosen(box(-most / 2, most / 2, -most / 3, most / 3), 1).Cells.columns, 150u);
}

TEST(Raster, ChosenCellsAreAlignedBySizeAlone)
{
  const ahd::Bounds area = box(1, 1001, 3, 503);
  EXPECT_EQ(makeRaster(bySize(0.0, true), area).Cells.origin, (ahd::Point{ 1.0, 3.0 })); // 0 and 2
  vtkAHDRasterWish wish = byCount(0, 0);
  wish.Align = true;
  EXPECT_EQ(makeRaster(wish, area).Cells.origin, (ahd::Point{ 2.0, 4.0 }));
}

TEST(Raster, HugeCoordinates)
{
  const double most = std::numeric_limits<double>::max();
  const double half = most / 2;
  const vtkAHDRaster all = makeRaster(byCount(8, 8), box(-half, half, -half, half));
  ASSERT_EQ(all.Fault, Fault::None);
  EXPECT_EQ(all.Cells.spacing.x, most / 8);
  EXPECT_TRUE(std::isfinite(all.Cells.at(7, 7).x));
  // Here 7 times the spacing overflows.
  EXPECT_EQ(makeRaster(byCount(8, 8), box(-most, most, 0, 1)).Fault, Fault::TooWide);
  EXPECT_EQ(makeRaster(byCount(8, 1), box(0, 1, -most, most)).Fault, Fault::TooWide);
  EXPECT_EQ(makeRaster(byCount(1, 1), box(-most, most, 0, 1)).Fault, Fault::TooWide);
  EXPECT_EQ(makeRaster(bySize(most / 100), box(-most, most, 0, 1)).Fault, Fault::TooWide);
  EXPECT_EQ(makeRaster(bySize(most / 1e10), box(-most, most, 0, 1)).Fault, Fault::TooMany);
  const vtkAHDRaster far = makeRaster(bySize(0.25), box(4.5e6, 4.5e6 + 100, 5e5, 5e5 + 1));
  ASSERT_EQ(far.Fault, Fault::None);
  EXPECT_EQ(far.Cells.columns, 400u);
  EXPECT_EQ(far.Cells.at(399, 3), (ahd::Point{ 4.5e6 + 99.875, 5e5 + 0.875 }));
}

TEST(Raster, CellsThatNumbersCannotTellApartAreNone)
{
  EXPECT_EQ(makeRaster(bySize(1e-3), box(1e16, 1e16 + 8, 0, 1)).Fault, Fault::OutOfNumbers);
  EXPECT_EQ(makeRaster(byCount(100, 1), box(1e16, 1e16 + 8, 0, 1)).Fault, Fault::OutOfNumbers);
}

TEST(Raster, TooManyCellsAreNoneAndCounted)
{
  const vtkAHDRaster raster = makeRaster(bySize(1e-9), box(0, 4, 0, 1));
  EXPECT_EQ(raster.Fault, Fault::TooMany);
  EXPECT_NEAR(raster.Wished[0], 4e9, 1.0);
  EXPECT_NEAR(raster.Wished[1], 1e9, 1.0);
  EXPECT_EQ(makeRaster(bySize(1e-300), box(-1e300, 1e300, 0, 1)).Fault, Fault::TooMany);
  EXPECT_EQ(makeRaster(byCount(2147483647, 2147483647), box(0, 1, 0, 1)).Fault, Fault::None);
}

TEST(Raster, SizesThatAreNone)
{
  for (const double size : { -1.0, std::nan(""), kInfinity })
  {
    EXPECT_EQ(makeRaster(bySize(size), box(0, 1, 0, 1)).Fault, Fault::CellSize) << size;
  }
  vtkAHDRasterWish half = bySize(0.0);
  half.CellSize[1] = 1.0;
  EXPECT_EQ(makeRaster(half, box(0, 1, 0, 1)).Fault, Fault::CellSize);
  EXPECT_EQ(makeRaster(bySize(1.0), ahd::Bounds()).Fault, Fault::NoArea);
}

TEST(Raster, BoundsThatAreNone)
{
  const auto faultOf = [](const std::array<double, 4>& bounds)
  { return vtkAHDMakeRasterWithin(byCount(2, 2), bounds, 0).Fault; };
  EXPECT_EQ(faultOf({ { 0, 1, 0, 1 } }), Fault::None);
  EXPECT_EQ(faultOf({ { 1, 0, 0, 1 } }), Fault::Bounds);
  EXPECT_EQ(faultOf({ { 0, 0, 0, 1 } }), Fault::Bounds);
  EXPECT_EQ(faultOf({ { 0, 1, 0, std::nan("") } }), Fault::Bounds);
  EXPECT_EQ(faultOf({ { std::nan(""), 1, 0, 1 } }), Fault::Bounds);
  EXPECT_EQ(faultOf({ { 0, 1, -kInfinity, 1 } }), Fault::Bounds);
}

} // namespace
