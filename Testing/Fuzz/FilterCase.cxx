// SPDX-License-Identifier: BSD-3-Clause
#include "FilterCase.h"

#include "FilterArrays.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkCylindricalTransform.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPerspectiveTransform.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStructuredGrid.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

namespace ahd
{
namespace fuzz
{
namespace
{

enum InputKind
{
  kPolyData,
  kWithCells, // polydata that has cells of every kind, good or not
  kUnstructured,
  kStructured,
  kBlocks,
  kPartitions,
  kNoPoints, // not even a vtkPoints
  kImage,
  kInputKinds
};

/// Odd where the caller has a choice. VTK makes no others.
vtkSmartPointer<vtkPoints> makePoints(std::uint8_t type)
{
  const int types[] = { VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_SHORT, VTK_UNSIGNED_CHAR, VTK_LONG_LONG,
    VTK_BIT, VTK_ID_TYPE };
  auto points = vtkSmartPointer<vtkPoints>::New();
  if (type % 9 == 8)
  {
    vtkNew<vtkSOADataArrayTemplate<double>> apart;
    apart->SetNumberOfComponents(3);
    points->SetData(apart);
  }
  else
  {
    points->SetDataType(types[type % 9]);
  }
  return points;
}

vtkSmartPointer<vtkPoints> readPoints(
  ByteReader& bytes, std::uint8_t type, std::size_t count, std::uint8_t multiply)
{
  const std::size_t copies = multiply < 224 ? 1 : multiply < 240 ? 4 : multiply < 252 ? 16 : 64;
  auto points = makePoints(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(copies * count));
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = bytes.coordinate();
    const double y = bytes.coordinate();
    const double z = bytes.coordinate();
    for (std::size_t k = 0; k < copies; ++k)
    {
      points->SetPoint(static_cast<vtkIdType>(k * count + i), x + 16.0 * double(k % 8),
        y + 16.0 * double(k / 8), z);
    }
  }
  return points;
}

vtkSmartPointer<vtkCellArray> readCells(ByteReader& bytes, std::size_t count)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> ids;
  for (std::size_t k = 0; k < count; ++k)
  {
    ids.resize(bytes.byte() % 9u);
    for (vtkIdType& id : ids)
    {
      id = bytes.id();
    }
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return cells;
}

vtkSmartPointer<vtkPointSet> readSet(ByteReader& bytes, int kind, vtkPoints* points)
{
  vtkSmartPointer<vtkPointSet> set;
  if (kind == kUnstructured)
  {
    set = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  else if (kind == kStructured)
  {
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(static_cast<int>(points->GetNumberOfPoints()), 1, 1);
    set = grid;
  }
  else
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    if (kind == kWithCells)
    {
      data->SetVerts(readCells(bytes, bytes.byte() % 4u));
      data->SetLines(readCells(bytes, bytes.byte() % 4u));
      data->SetPolys(readCells(bytes, bytes.byte() % 4u));
      data->SetStrips(readCells(bytes, bytes.byte() % 4u));
    }
    set = data;
  }
  if (kind != kNoPoints)
  {
    set->SetPoints(points);
  }
  return set;
}

vtkSmartPointer<vtkDataObject> gather(int kind, const std::vector<vtkDataObject*>& sets)
{
  if (kind == kPartitions)
  {
    vtkNew<vtkPartitionedDataSet> parts;
    for (unsigned int k = 0; k < sets.size(); ++k)
    {
      parts->SetPartition(k, sets[k]);
    }
    auto all = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
    all->SetPartitionedDataSet(1, parts);
    return all;
  }
  auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> inner;
  for (unsigned int k = 0; k < sets.size(); ++k)
  {
    (k % 2 == 0 ? all.Get() : inner.Get())->SetBlock(k, sets[k]);
  }
  all->SetBlock(static_cast<unsigned int>(sets.size()) + 1, inner);
  return all;
}

vtkSmartPointer<vtkAbstractTransform> transform(std::uint8_t byte)
{
  if (byte == 0)
  {
    return nullptr;
  }
  if (byte % 4 == 0)
  {
    return vtkSmartPointer<vtkCylindricalTransform>::New(); // not linear
  }
  vtkNew<vtkMatrix4x4> matrix;
  const int row = byte >> 2 & 3;
  matrix->SetElement(row, byte >> 4 & 3, number(static_cast<std::uint8_t>(byte * 13u)));
  matrix->SetElement(3 - row, row, byte >= 192 ? 0.5 : 0.0);
  if (byte % 4 == 1)
  {
    auto linear = vtkSmartPointer<vtkTransform>::New();
    linear->SetMatrix(matrix);
    return linear;
  }
  auto perspective = vtkSmartPointer<vtkPerspectiveTransform>::New();
  perspective->SetMatrix(matrix);
  return perspective;
}
}

double ByteReader::coordinate()
{
  const double odd[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), DBL_MAX,
    -DBL_MAX, 1e300, -1e300, 0x1p1000, DBL_MIN, -DBL_MIN, 5e-324, -0.0, 1e-300, 1e16, 7.0 / 3.0,
    std::nextafter(1.0, 2.0), std::nextafter(8.0, 0.0), 3e38, 1e-45, 849393.95, 637177.98 };
  const std::uint8_t first = this->byte();
  if (first < 128)
  {
    return first % 16;
  }
  if (first < 224)
  {
    return (int(first) - 176) * 0.1;
  }
  if (first < 224 + std::size(odd))
  {
    return odd[first - 224];
  }
  unsigned char raw[sizeof(double)];
  for (unsigned char& b : raw)
  {
    b = this->byte();
  }
  double value = 0.0;
  std::memcpy(&value, raw, sizeof value);
  return value;
}

vtkIdType ByteReader::id()
{
  const vtkIdType odd[] = { -1, VTK_ID_MAX, VTK_ID_MIN, vtkIdType(1) << 31, vtkIdType(1) << 32,
    -7 };
  const std::uint8_t first = this->byte();
  return first >= 250 ? odd[first - 250] : first;
}

FilterCase::FilterCase(const std::uint8_t* data, std::size_t size)
{
  ByteReader bytes(data, size);
  for (std::uint8_t& byte : head_)
  {
    byte = bytes.byte();
  }
  const int kind = head_[kInputKind] % kInputKinds;
  const bool isComposite = kind == kBlocks || kind == kPartitions;
  std::vector<vtkSmartPointer<vtkPointSet>> sets;
  const std::size_t count = head_[kPointCount] % 240u;
  for (std::size_t k = 0; k < (isComposite ? 3u : 1u); ++k)
  {
    const auto type = static_cast<std::uint8_t>(head_[kPointType] + (k == 2 ? 1 : 0));
    auto points = readPoints(bytes, type, count / (k + 1), head_[kMultiply]);
    sets.push_back(readSet(bytes, isComposite ? int(k) * 2 % 3 : kind, points));
  }
  transform_ = transform(head_[kPlaneOf]);
  this->readSource(bytes);
  std::vector<vtkDataObject*> all;
  for (const auto& set : sets)
  {
    addArrays(bytes, head_[kArrayCount] & 15u, set);
    all.push_back(set);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  all[0] = kind == kImage ? image.Get() : all[0];
  if (isComposite)
  {
    all.push_back(bit(kInputKind, 7) ? image.Get() : nullptr);
  }
  input_ = isComposite ? gather(kind, all) : vtkSmartPointer<vtkDataObject>(all[0]);
}

void FilterCase::readSource(ByteReader& bytes)
{
  if (bit(kSourceKind, 0))
  {
    const std::size_t own = bit(kSourceKind, 1) ? head_[kSourceKind] >> 2 : 0;
    auto points = readPoints(bytes, static_cast<std::uint8_t>(head_[kPointType] / 9), own, 0);
    auto set = readSet(bytes, own > 0 ? kPolyData : kNoPoints, points);
    source_ = vtkPolyData::SafeDownCast(set);
    source_->SetVerts(readCells(bytes, head_[kCellCount] >> 6));
    source_->SetLines(readCells(bytes, head_[kCellCount] & 7u));
    source_->SetPolys(readCells(bytes, head_[kCellCount] >> 3 & 7u));
    addArrays(bytes, head_[kArrayCount] >> 4, source_);
  }
}

void FilterCase::change(unsigned step)
{
  const unsigned what = head_[kChange] + 7 * step;
  if (what % 8 == 0)
  {
    const unsigned which = what / 8;
    ++head_[which < 27 ? kModes + which % 9 : kMaximumError + which % 3];
    transform_ = transform(head_[kPlaneOf]);
    return;
  }
  for (vtkDataObject* leaf : leavesOf(input_))
  {
    auto* set = vtkPointSet::SafeDownCast(leaf);
    if (set && what % 8 < 4)
    {
      changeArrays(what / 8, set);
    }
    else if (set && what % 8 < 7 && set->GetPoints() && set->GetNumberOfPoints() > 0)
    {
      const vtkIdType id = what * 5 % set->GetNumberOfPoints();
      set->GetPoints()->SetPoint(id, double(what % 5), double(step), 1.0);
      set->GetPoints()->Modified();
    }
    leaf->Modified();
  }
  input_->Modified();
}

std::vector<vtkDataObject*> leavesOf(vtkDataObject* data)
{
  std::vector<vtkDataObject*> leaves;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      leaves.push_back(iterator->GetCurrentDataObject());
    }
  }
  else if (data)
  {
    leaves.push_back(data);
  }
  return leaves;
}

} // namespace fuzz
} // namespace ahd
