// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FilterArrays_h
#define ahd_FilterArrays_h

#include "FilterCase.h"

#include <cstddef>
#include <string>

class vtkAbstractArray;
class vtkFieldData;
class vtkPointSet;

namespace ahd
{
namespace fuzz
{

/// Gives the set so many point arrays: of any kind and length, with names that are the filter's or
/// others', twice or none, active as anything they fit; and a field data array.
void addArrays(ByteReader& bytes, std::size_t count, vtkPointSet* set);

/// Changes a value, or the set of arrays.
void changeArrays(unsigned what, vtkPointSet* set);

/// All data of the arrays, as text to be compared.
std::string textOf(vtkFieldData* data);

} // namespace fuzz
} // namespace ahd

#endif
