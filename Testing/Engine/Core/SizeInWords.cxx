// SPDX-License-Identifier: BSD-3-Clause
//
// Sizes of memory as they are written in messages.
#include "Core/SizeInWords.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace ahd
{
namespace test
{
namespace
{

TEST(SizeInWords, HasThreeDigitsAtMost)
{
  const struct
  {
    std::uint64_t bytes;
    std::string down, up;
  } rows[] = { { 0, "0 bytes", "0 bytes" }, { 1, "1 byte", "1 byte" },
    { 999, "999 bytes", "999 bytes" }, { 1000, "1 KB", "1 KB" }, { 1001, "1 KB", "1.01 KB" },
    { 1230, "1.23 KB", "1.23 KB" }, { 4096, "4.09 KB", "4.1 KB" }, { 9999, "9.99 KB", "10 KB" },
    { 99900, "99.9 KB", "99.9 KB" }, { 99999, "99.9 KB", "100 KB" }, { 999000, "999 KB", "999 KB" },
    { 999001, "999 KB", "1 MB" }, { 7633920, "7.63 MB", "7.64 MB" },
    { 20793991168, "20.7 GB", "20.8 GB" }, { std::uint64_t(5) << 40, "5.49 TB", "5.5 TB" },
    { std::numeric_limits<std::uint64_t>::max(), "18.4 EB", "18.5 EB" } };
  for (const auto& row : rows)
  {
    EXPECT_EQ(sizeInWords(row.bytes, Rounded::Down), row.down) << row.bytes;
    EXPECT_EQ(sizeInWords(row.bytes, Rounded::Up), row.up) << row.bytes;
  }
}

/// No message reads "20.8 GB are needed, but there are 20.8 GB".
TEST(SizeInWords, WhatIsNeededIsNeverWhatThereIs)
{
  for (std::uint64_t bytes = 1; bytes < std::uint64_t(1) << 62; bytes += bytes / 7 + 1)
  {
    EXPECT_NE(sizeInWords(bytes, Rounded::Down), sizeInWords(bytes + 1, Rounded::Up)) << bytes;
  }
}

} // namespace
} // namespace test
} // namespace ahd
