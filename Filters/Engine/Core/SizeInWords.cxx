// SPDX-License-Identifier: BSD-3-Clause
#include "SizeInWords.h"

namespace ahd
{
namespace
{

/// `number` / 10^decimals.
std::string decimal(std::uint64_t number, unsigned decimals)
{
  std::string digits = std::to_string(number);
  digits.insert(0, digits.size() <= decimals ? decimals + 1 - digits.size() : 0, '0');
  digits.insert(digits.size() - decimals, decimals > 0 ? "." : "");
  while (decimals > 0 && (digits.back() == '0' || digits.back() == '.'))
  {
    decimals = digits.back() == '.' ? 0 : decimals;
    digits.pop_back();
  }
  return digits;
}

} // namespace

std::string sizeInWords(std::uint64_t bytes, Rounded rounded)
{
  const char* const units[] = { " bytes", " KB", " MB", " GB", " TB", " PB", " EB" };
  std::uint64_t part = 1; // of a unit: a hundredth, a tenth, all of it
  for (unsigned decimals = 0, unit = 0;; part *= 10)
  {
    const bool isMore = rounded == Rounded::Up && bytes % part > 0;
    const std::uint64_t parts = bytes / part + (isMore ? 1 : 0);
    if (parts < 1000)
    {
      return decimal(parts, decimals) + (bytes == 1 ? " byte" : units[unit]);
    }
    unit += decimals == 0 ? 1 : 0;
    decimals = decimals == 0 ? 2 : decimals - 1;
  }
}

} // namespace ahd
