// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDCommonPlaces.h"

#include "Pipeline/vtkAHDContext.h"

#include <algorithm>

namespace
{
bool Has(const ahd::SampleRaster& piece, std::size_t column, std::size_t row)
{
  return column >= piece.firstColumn && column < piece.firstColumn + piece.columns &&
    row >= piece.firstRow && row < piece.firstRow + piece.rows;
}
}

std::size_t vtkAHDFindCommonPlaces(const ahd::SampleRaster& piece,
  const std::vector<ahd::SampleRaster>& others, const vtkAHDContext& context,
  std::vector<ahd::Point>* places)
{
  std::size_t count = 0;
  for (auto other = others.begin(); other != others.end(); ++other)
  {
    const std::size_t x0 = std::max(piece.firstColumn, other->firstColumn);
    const std::size_t x1 = std::min(
      piece.firstColumn + piece.columns, other->firstColumn + other->columns);
    const std::size_t y0 = std::max(piece.firstRow, other->firstRow);
    const std::size_t y1 = std::min(piece.firstRow + piece.rows, other->firstRow + other->rows);
    for (std::size_t y = y0; y < y1; ++y)
    {
      context.StopIfAborted();
      for (std::size_t x = x0; x < x1; ++x)
      {
        if (std::any_of(others.begin(), other,
              [&](const ahd::SampleRaster& before) { return Has(before, x, y); }))
        {
          continue;
        }
        ++count;
        if (places)
        {
          places->push_back(piece.at(x - piece.firstColumn, y - piece.firstRow));
        }
      }
    }
  }
  return count;
}
