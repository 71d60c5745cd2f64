// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockBytes_h
#define ahd_BlockBytes_h

#include "../Points/Points.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace ahd
{

/// A message between blocks. Numbers are sent as they lie in memory: all blocks run one program.
using BlockBytes = std::vector<unsigned char>;

/// Does T list the fields to send, once for writing and reading?
///     auto fields() { return std::tie(one, other); }
template <typename T, typename = void>
struct HasFields : std::false_type
{
};
template <typename T>
struct HasFields<T, std::void_t<decltype(std::declval<T&>().fields())>> : std::true_type
{
};

/// Does each byte of T belong to a number? Then it is sent as it lies in memory, and so are many in
/// a row. A struct with doubles lists its fields() to show it; with padding, or where it lists only
/// some, it is sent field by field, so that no uninitialised byte is sent.
template <typename T, typename = void>
struct IsSolid
  : std::integral_constant<bool,
      std::is_same<T, double>::value || std::has_unique_object_representations<T>::value>
{
};
template <>
struct IsSolid<Point> : std::integral_constant<bool, sizeof(Point) == 2 * sizeof(double)>
{
};
template <>
struct IsSolid<Bounds> : std::integral_constant<bool, sizeof(Bounds) == 4 * sizeof(double)>
{
};
template <typename T, std::size_t N>
struct IsSolid<std::array<T, N>> : IsSolid<T>
{
};
template <typename T, typename Fields = decltype(std::declval<T&>().fields())>
struct AreSolid;
template <typename T, typename... Fields>
struct AreSolid<T, std::tuple<Fields&...>>
  : std::integral_constant<bool,
      std::is_trivially_copyable<T>::value && (IsSolid<Fields>::value && ...) &&
        (sizeof(Fields) + ...) == sizeof(T)>
{
};
template <typename T>
struct IsSolid<T, std::enable_if_t<HasFields<T>::value>> : AreSolid<T>
{
};

/// Appends to bytes: solid types as they lie in memory; types that list their fields, field by
/// field; of vectors and strings the number of items, then these. Throws std::bad_alloc.
class BytesWriter
{
public:
  explicit BytesWriter(BlockBytes& bytes)
    : bytes_(bytes)
  {
  }

  template <typename... T>
  void operator()(const T&... items)
  {
    (write(items), ...);
  }

private:
  template <typename T>
  void write(const T& item)
  {
    if constexpr (IsSolid<T>::value)
    {
      append(&item, 1);
    }
    else if constexpr (HasFields<T>::value)
    {
      std::apply(*this, const_cast<T&>(item).fields()); // which changes none
    }
    else
    {
      static_assert(!std::is_trivially_copyable<T>::value, "its fields() say what is sent");
      write(std::uint64_t(item.size()));
      if constexpr (IsSolid<typename T::value_type>::value)
      {
        append(item.data(), item.size());
      }
      else
      {
        for (const auto& one : item)
        {
          write(one);
        }
      }
    }
  }
  template <typename T>
  void append(const T* items, std::size_t count)
  {
    const auto* const from = reinterpret_cast<const unsigned char*>(items);
    bytes_.insert(bytes_.end(), from, from + count * sizeof(T));
  }

  BlockBytes& bytes_;
};

/// Reads what a BytesWriter wrote, in the same order. Items are appended to vectors and strings. Of
/// a message that is too short, numbers are left unchanged and items are left out. Throws
/// std::bad_alloc.
class BytesReader
{
public:
  explicit BytesReader(const BlockBytes& bytes)
    : BytesReader(bytes.data(), bytes.size())
  {
  }
  BytesReader(const unsigned char* bytes, std::size_t size)
    : at_(bytes)
    , left_(size)
  {
  }

  template <typename... T>
  void operator()(T&... items)
  {
    (read(items), ...);
  }

private:
  template <typename T>
  void read(T& item)
  {
    if constexpr (IsSolid<T>::value)
    {
      take(&item, 1);
    }
    else if constexpr (HasFields<T>::value)
    {
      std::apply(*this, item.fields());
    }
    else
    {
      using Item = typename T::value_type;
      constexpr bool isPlain = IsSolid<Item>::value;
      std::uint64_t count = 0;
      read(count);
      const std::size_t before = item.size();
      item.resize(before +
        static_cast<std::size_t>(
          std::min<std::uint64_t>(count, left_ / (isPlain ? sizeof(Item) : 1))));
      if constexpr (isPlain)
      {
        take(item.data() + before, item.size() - before);
      }
      else
      {
        for (std::size_t i = before; i != item.size(); ++i)
        {
          read(item[i]);
        }
      }
    }
  }
  template <typename T>
  void take(T* items, std::size_t count)
  {
    const std::size_t size = count * sizeof(T);
    if (size != 0 && size <= left_)
    {
      std::memcpy(static_cast<void*>(items), at_, size);
      at_ += size;
      left_ -= size;
    }
  }

  const unsigned char* at_;
  std::size_t left_;
};

} // namespace ahd

#endif
