// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockBytes_h
#define ahd_BlockBytes_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace ahd
{

/// What one block tells others. Numbers are as they lie in memory: all blocks run one program.
using BlockBytes = std::vector<unsigned char>;

/// Does T list what is sent of it, once for writing and reading?
///     auto fields() { return std::tie(one, other); }
template <typename T, typename = void>
struct HasFields : std::false_type
{
};
template <typename T>
struct HasFields<T, std::void_t<decltype(std::declval<T&>().fields())>> : std::true_type
{
};

/// Appends to bytes: what lists its fields, field by field; what is trivially copyable, as it lies
/// in memory; of vectors and strings how many items, and then these. Throws std::bad_alloc.
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
    if constexpr (HasFields<T>::value)
    {
      std::apply(*this, const_cast<T&>(item).fields()); // which changes none
    }
    else if constexpr (std::is_trivially_copyable<T>::value)
    {
      append(&item, 1);
    }
    else
    {
      write(std::uint64_t(item.size()));
      if constexpr (std::is_trivially_copyable<typename T::value_type>::value)
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

/// Reads what a BytesWriter wrote, in the same order. What vectors and strings have stays, before
/// what is read. What is not there is left as it is, or out. Throws std::bad_alloc.
class BytesReader
{
public:
  explicit BytesReader(const BlockBytes& bytes)
    : at_(bytes.data())
    , left_(bytes.size())
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
    if constexpr (HasFields<T>::value)
    {
      std::apply(*this, item.fields());
    }
    else if constexpr (std::is_trivially_copyable<T>::value)
    {
      take(&item, 1);
    }
    else
    {
      using Item = typename T::value_type;
      constexpr bool isPlain = std::is_trivially_copyable<Item>::value;
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
