// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SizeInWords_h
#define ahd_SizeInWords_h

#include <cstdint>
#include <string>

namespace ahd
{

/// A need is rounded up, available memory down, so that the need never reads as the smaller one.
enum class Rounded
{
  Down,
  Up
};

/// Bytes in readable form, with three digits at most: "850 bytes", "7.63 MB", "20.8 GB". A
/// KB has 1000 bytes.
std::string sizeInWords(std::uint64_t bytes, Rounded rounded);

} // namespace ahd

#endif
