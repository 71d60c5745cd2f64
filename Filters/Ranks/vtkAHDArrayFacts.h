// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDArrayFacts_h
#define vtkAHDArrayFacts_h

#include "Engine/Points/Points.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkPoints;

/// Places of points, three numbers each, as floats or as doubles: as many, not set, or those of
/// `points`, which may be null. Both throw std::bad_alloc.
vtkSmartPointer<vtkDataArray> vtkAHDMakePlaces(std::size_t count, bool areFloats);
vtkSmartPointer<vtkDataArray> vtkAHDPlacesOf(vtkPoints* points, bool areFloats);
/// The first ones of these.
ahd::PointView vtkAHDViewOf(vtkDataArray* places, std::size_t count);

/// A point data array, as ranks compare theirs.
struct vtkAHDArrayFacts
{
  std::string Name;
  int Type = 0;
  int Components = 1;
  int Attribute = -1;                      ///< which one of VTK's attributes it is; -1: none
  std::vector<std::string> ComponentNames; ///< of each component; none if none is named

  vtkAHDArrayFacts() = default;
  /// Those of array `index`.
  vtkAHDArrayFacts(vtkDataSetAttributes* data, int index);

  /// An array of so many tuples that is like this one, values not set. Throws std::bad_alloc.
  vtkSmartPointer<vtkAbstractArray> Make(std::size_t count) const;
  /// Adds one, and makes it the attribute that it is.
  void AddTo(vtkDataSetAttributes* data, vtkAbstractArray* array) const;

  /// See ahd::HasFields.
  auto fields()
  {
    return std::tie(
      this->Name, this->Type, this->Components, this->Attribute, this->ComponentNames);
  }

  bool operator==(const vtkAHDArrayFacts& other) const
  {
    return this->Name == other.Name && this->Type == other.Type &&
      this->Components == other.Components;
  }
};

#endif
