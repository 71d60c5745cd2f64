// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDCellsView_h
#define vtkAHDCellsView_h

#include "Engine/Prepare/Prepare.h"
#include "Pipeline/vtkAHDContext.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Cells as the engine reads them: in place if ids and offsets are all of 32 or all of 64
/// bits in memory. Others must be converted: since VTK 9.6 offsets need not be in memory (cells
/// of one size), and ids may be of any type.
class vtkAHDCellsView
{
public:
  /// Holds the current arrays of the cells; null: none. `what`: a literal, their name in messages.
  explicit vtkAHDCellsView(vtkCellArray* cells, const char* what)
    : What(what)
    , Ids(cells ? cells->GetConnectivityArray() : nullptr)
    , Offsets(cells ? cells->GetOffsetsArray() : nullptr)
  {
    // An array without a single offset gives -1 cells.
    if (cells && cells->GetNumberOfCells() > 0 && cells->GetNumberOfConnectivityIds() > 0)
    {
      this->View.ids = static_cast<std::size_t>(cells->GetNumberOfConnectivityIds());
      this->View.cells = static_cast<std::size_t>(cells->GetNumberOfCells());
    }
  }

  /// The numbers of cells and ids; Open() fills in the arrays.
  const ahd::CellsView& GetCounts() const { return this->View; }

  /// Bytes of the converted cells.
  std::size_t EstimateBytes() const
  {
    if (this->View.ids == 0 || this->HasOnly<vtkTypeInt32>())
    {
      return 0;
    }
    const std::size_t ids = this->Wide(this->Ids) ? 0 : this->View.ids;
    const std::size_t offsets = this->Wide(this->Offsets) ? 0 : this->View.cells + 1;
    return sizeof(std::int64_t) * (ids + offsets);
  }

  /// The cells, converted if they must be. Valid as long as this object exists and the arrays keep
  /// their memory. Throws vtkAHDStop if the filter aborts or offsets are invalid, and
  /// std::bad_alloc.
  ahd::CellsView Open(const vtkAHDContext& context)
  {
    if (this->View.ids == 0)
    {
      return this->View;
    }
    if (this->HasOnly<vtkTypeInt32>())
    {
      this->View.ids32 = Lying<vtkTypeInt32>(this->Ids)->GetPointer(0);
      this->View.offsets32 = Lying<vtkTypeInt32>(this->Offsets)->GetPointer(0);
    }
    else
    {
      this->View.ids64 = Open(this->Ids, this->View.ids, this->ConvertedIds, context);
      this->View.offsets64 = Open(
        this->Offsets, this->View.cells + 1, this->ConvertedOffsets, context);
    }
    vtkAHDStop stop{ ahd::Status::Ok, {}, this->What };
    stop.Reason = ahd::findBadCell(this->View, context, stop.Cell);
    if (stop.Reason == ahd::Status::BadCells)
    {
      throw stop;
    }
    context.Check(stop.Reason);
    return this->View;
  }

private:
  static_assert(sizeof(vtkTypeInt64) == sizeof(std::int64_t), "the same numbers here and there");

  template <typename Number>
  static vtkAOSDataArrayTemplate<Number>* Lying(vtkDataArray* array)
  {
    return vtkArrayDownCast<vtkAOSDataArrayTemplate<Number>>(array);
  }

  template <typename Number>
  bool HasOnly() const
  {
    return Lying<Number>(this->Ids) && Lying<Number>(this->Offsets);
  }

  /// The array's numbers of 64 bits; null if it has others.
  static const std::int64_t* Wide(vtkDataArray* array)
  {
    auto* lying = Lying<vtkTypeInt64>(array);
    // long and long long are one type with two names
    return lying ? reinterpret_cast<const std::int64_t*>(lying->GetPointer(0)) : nullptr;
  }

  static const std::int64_t* Open(vtkDataArray* array, std::size_t count,
    std::vector<std::int64_t>& converted, const vtkAHDContext& context)
  {
    if (const std::int64_t* wide = Wide(array))
    {
      return wide;
    }
    converted.resize(count);
    context.ForRange(count,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          // whole numbers up to 2^53 are the same as double
          converted[i] = static_cast<std::int64_t>(array->GetComponent(vtkIdType(i), 0));
        }
      });
    return converted.data();
  }

  const char* What;
  vtkSmartPointer<vtkDataArray> Ids;
  vtkSmartPointer<vtkDataArray> Offsets;
  ahd::CellsView View;
  std::vector<std::int64_t> ConvertedIds;
  std::vector<std::int64_t> ConvertedOffsets;
};

#endif
