// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankChains.h"

#include <algorithm>

void vtkAHDRankChains::ReadOwn(const vtkAHDRankPoints& points, Part& own)
{
  const ahd::PreparedInput& prepared = points.GetPrepared();
  const ahd::InputRequest& request = points.GetInput().GetRequest();
  own.Content = points.GetInput().GetSourceContent();
  own.LineCells = static_cast<std::int64_t>(request.lines.cells);
  own.PolygonCells = static_cast<std::int64_t>(request.polygons.cells);
  if (!prepared.hasConstraints())
  {
    return;
  }
  own.Unfit = prepared.unfitIds();
  own.Unfit.firstCell -= own.Unfit.count > 0 ? request.firstCell : 0;
  const ahd::ConstraintView chains = prepared.constraints();
  for (std::size_t chain = 0; chain < chains.chains; ++chain)
  {
    const std::int64_t cell = prepared.cellOf(chain) - request.firstCell;
    const bool isLine = cell < own.LineCells;
    const Kind kind = chain < chains.lines ? Open : isLine ? Closed : Polygon;
    own.Cells[kind].push_back(isLine ? cell : cell - own.LineCells);
    own.Sizes[kind].push_back(chains.offsets[chain + 1] - chains.offsets[chain]);
    for (std::int64_t i = chains.offsets[chain]; i < chains.offsets[chain + 1]; ++i)
    {
      own.Ids[kind].push_back(points.GetId(chains.ids[i]));
    }
  }
}

void vtkAHDRankChains::Write(const Part& own, ahd::BlockBytes& bytes)
{
  ahd::BytesWriter writer(bytes);
  for (std::size_t kind = 0; kind < Kinds; ++kind)
  {
    writer.writeAll(own.Ids[kind]);
    writer.writeAll(own.Sizes[kind]);
    writer.writeAll(own.Cells[kind]);
  }
  writer.write(own.LineCells);
  writer.write(own.PolygonCells);
  writer.write(own.Content);
  writer.write(own.Unfit);
}

void vtkAHDRankChains::Read(const ahd::BlockBytes& bytes, Part& part)
{
  ahd::BytesReader reader(bytes);
  for (std::size_t kind = 0; kind < Kinds; ++kind)
  {
    reader.readAll(part.Ids[kind]);
    reader.readAll(part.Sizes[kind]);
    reader.readAll(part.Cells[kind]);
  }
  part.LineCells = reader.read<std::int64_t>();
  part.PolygonCells = reader.read<std::int64_t>();
  part.Content = reader.read<vtkAHDInput::SourceContent>();
  part.Unfit = reader.read<ahd::UnfitIds>();
}

/// In the appended source, vertices come before lines, and these before polygons.
void vtkAHDRankChains::Append(const std::vector<Part>& parts)
{
  std::vector<std::int64_t> firstLine, firstPolygon;
  std::int64_t cells = 0;
  for (const Part& part : parts)
  {
    this->Content.Points += part.Content.Points;
    this->Content.Vertices += part.Content.Vertices;
    this->Content.Strips += part.Content.Strips;
  }
  cells = this->Content.Vertices;
  for (const Part& part : parts)
  {
    firstLine.push_back(cells);
    cells += part.LineCells;
  }
  for (const Part& part : parts)
  {
    firstPolygon.push_back(cells);
    cells += part.PolygonCells;
  }
  this->Offsets.push_back(0);
  for (std::size_t kind = 0; kind < Kinds; ++kind)
  {
    for (std::size_t rank = 0; rank < parts.size(); ++rank)
    {
      const Part& part = parts[rank];
      this->Ids.insert(this->Ids.end(), part.Ids[kind].begin(), part.Ids[kind].end());
      for (std::size_t k = 0; k < part.Sizes[kind].size(); ++k)
      {
        this->Offsets.push_back(this->Offsets.back() + part.Sizes[kind][k]);
        this->Cells.push_back(
          part.Cells[kind][k] + (kind == Polygon ? firstPolygon[rank] : firstLine[rank]));
      }
    }
    this->Lines = kind == Open ? this->Cells.size() : this->Lines;
  }
  for (std::size_t rank = 0; rank < parts.size(); ++rank)
  {
    const Part& part = parts[rank];
    const std::int64_t own = part.Unfit.firstCell;
    const std::int64_t cell = own < part.LineCells ? firstLine[rank] + own
                                                   : firstPolygon[rank] + own - part.LineCells;
    if (part.Unfit.count > 0 && (this->Unfit.count == 0 || cell < this->Unfit.firstCell))
    {
      this->Unfit.firstId = part.Unfit.firstId;
      this->Unfit.firstCell = cell;
    }
    this->Unfit.count += part.Unfit.count;
  }
}

void vtkAHDRankChains::Gather(
  const vtkAHDRankPoints& points, vtkAHDRanks& ranks, const vtkAHDContext& context)
{
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  ranks.Together(context,
    [&]
    {
      Part part;
      ReadOwn(points, part);
      Write(part, own);
    });
  context.Check(ranks.gather(own, all));
  ranks.Together(context,
    [&]
    {
      std::vector<Part> parts(all.size());
      for (std::size_t rank = 0; rank < all.size(); ++rank)
      {
        Read(all[rank], parts[rank]);
        all[rank] = ahd::BlockBytes();
      }
      this->Append(parts);
    });
}

ahd::ConstraintView vtkAHDRankChains::GetView() const
{
  ahd::ConstraintView view;
  view.ids = this->Ids.data();
  view.offsets = this->Offsets.data();
  view.chains = this->Cells.size();
  view.lines = this->Lines;
  return view;
}
