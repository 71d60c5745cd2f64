// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Hash_h
#define ahd_Hash_h

#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace ahd
{
namespace test
{

/// FNV-1a with 64 bits of a row of numbers. Each counts with eight bytes, the least significant
/// first: integers of any width as those of 64 bits, doubles with their bits, so that -0 and 0
/// differ. A vector counts with its length before its values. The same on every machine.
class Hash
{
public:
  template <typename Integer>
  void add(Integer value)
  {
    static_assert(std::is_integral<Integer>::value || std::is_enum<Integer>::value, "a number");
    addBits(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)));
  }
  void add(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    addBits(bits);
  }
  void add(const Point& point)
  {
    add(point.x);
    add(point.y);
  }
  template <typename Value>
  void add(const std::vector<Value>& values)
  {
    add(values.size());
    for (const Value& value : values)
    {
      add(value);
    }
  }

  /// 16 hexadecimal digits.
  std::string text() const
  {
    std::string result;
    for (int shift = 60; shift >= 0; shift -= 4)
    {
      result += "0123456789abcdef"[(value_ >> shift) & 0xF];
    }
    return result;
  }

private:
  void addBits(std::uint64_t bits)
  {
    for (int shift = 0; shift < 64; shift += 8)
    {
      value_ = (value_ ^ ((bits >> shift) & 0xFF)) * 0x100000001B3u;
    }
  }

  std::uint64_t value_ = 0xCBF29CE484222325u;
};

} // namespace test
} // namespace ahd

#endif
