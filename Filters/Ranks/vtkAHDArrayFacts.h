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

/// Coordinates of points, three numbers each, as floats or doubles: so many, not set, or those of
/// `points`, which may be null. Both throw std::bad_alloc.
vtkSmartPointer<vtkDataArray> vtkAHDMakePlaces(std::size_t count, bool areFloats);
vtkSmartPointer<vtkDataArray> vtkAHDPlacesOf(vtkPoints* points, bool areFloats);
/// The first ones of these.
ahd::PointView vtkAHDViewOf(vtkDataArray* places, std::size_t count);

/// The description of a point data array, for ranks to compare.
struct vtkAHDArrayFacts
{
  std::string Name;
  int Type = 0;
  int Components = 1;
  int Attribute = -1;                      ///< its number among VTK's attributes; -1: none
  std::vector<std::string> ComponentNames; ///< of each component; empty if none is named

  vtkAHDArrayFacts() = default;
  /// The description of array `index`.
  vtkAHDArrayFacts(vtkDataSetAttributes* data, int index);

  /// An array of this description with so many tuples, values not set. Throws std::bad_alloc.
  vtkSmartPointer<vtkAbstractArray> Make(std::size_t count) const;
  /// Adds such an array, as the same attribute.
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
