// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_test_ListOf_h
#define ahd_test_ListOf_h

#include "Core/Buffer.h"

#include <vector>

namespace ahd
{
namespace test
{

/// What an array has, to be compared and kept.
template <typename Value>
std::vector<Value> listOf(const Buffer<Value>& values)
{
  return std::vector<Value>(values.begin(), values.end());
}

} // namespace test
} // namespace ahd

#endif
