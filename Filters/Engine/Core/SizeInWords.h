// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SizeInWords_h
#define ahd_SizeInWords_h

#include <cstdint>
#include <string>

namespace ahd
{

/// What is needed is rounded up and what is there down, so that the first is never the smaller one.
enum class Rounded
{
  Down,
  Up
};

/// Bytes as a person writes them, with three digits at most: "850 bytes", "7.63 MB", "20.8 GB". A
/// KB has 1000 bytes.
std::string sizeInWords(std::uint64_t bytes, Rounded rounded);

} // namespace ahd

#endif
