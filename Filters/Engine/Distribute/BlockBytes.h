// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockBytes_h
#define ahd_BlockBytes_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace ahd
{

/// What one block tells others. Numbers are as they lie in memory: all blocks run one program.
using BlockBytes = std::vector<unsigned char>;

/// Appends to bytes. Throws std::bad_alloc.
class BytesWriter
{
public:
  explicit BytesWriter(BlockBytes& bytes)
    : bytes_(bytes)
  {
  }

  template <typename T>
  void write(const T* items, std::size_t count)
  {
    static_assert(std::is_trivially_copyable<T>::value, "written as it lies in memory");
    const auto* const from = reinterpret_cast<const unsigned char*>(items);
    bytes_.insert(bytes_.end(), from, from + count * sizeof(T));
  }
  template <typename T>
  void write(const T& item)
  {
    write(&item, 1);
  }
  /// How many, and then these.
  template <typename T>
  void writeAll(const std::vector<T>& items)
  {
    write(std::uint64_t(items.size()));
    write(items.data(), items.size());
  }

private:
  BlockBytes& bytes_;
};

/// Reads what a BytesWriter wrote, in the same order. What is not there is 0, and then isWhole() is
/// false.
class BytesReader
{
public:
  explicit BytesReader(const BlockBytes& bytes)
    : bytes_(bytes)
  {
  }

  template <typename T>
  T read()
  {
    T item{};
    if (has(sizeof(T)))
    {
      std::memcpy(&item, bytes_.data() + at_, sizeof(T));
      at_ += sizeof(T);
    }
    return item;
  }
  /// Adds to the items. Throws std::bad_alloc.
  template <typename T>
  void readAll(std::vector<T>& items)
  {
    const auto count = read<std::uint64_t>();
    if (count <= bytes_.size() / sizeof(T) && has(std::size_t(count) * sizeof(T)))
    {
      const std::size_t before = items.size();
      items.resize(before + std::size_t(count));
      if (count != 0)
      {
        std::memcpy(items.data() + before, bytes_.data() + at_, std::size_t(count) * sizeof(T));
      }
      at_ += std::size_t(count) * sizeof(T);
    }
    else
    {
      isWhole_ = false;
    }
  }
  /// Was all there that was read?
  bool isWhole() const { return isWhole_; }

private:
  bool has(std::size_t count)
  {
    isWhole_ = isWhole_ && count <= bytes_.size() - at_;
    return isWhole_;
  }

  const BlockBytes& bytes_;
  std::size_t at_ = 0;
  bool isWhole_ = true;
};

} // namespace ahd

#endif
