// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Buffer_h
#define ahd_Buffer_h

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace ahd
{

/// An array that is allocated once, aligned to 64 bytes (a cache line), and not initialised: the
/// engine's large arrays are written before they are read, and touching each page twice costs time.
template <typename T>
class Buffer
{
  static_assert(std::is_trivially_copyable<T>::value, "a Buffer's elements are not constructed");

public:
  Buffer() = default;
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept
  {
    Buffer old(std::move(*this));
    swap(other);
    return *this;
  }
  ~Buffer() { ::operator delete(data_, std::align_val_t(kAlignment)); }

  /// Drops what it held and makes room for `size` elements. Throws std::bad_alloc; the engine
  /// catches it at its border and reports Status::OutOfMemory.
  void allocate(std::size_t size)
  {
    reset();
    if (size > std::size_t(-1) / sizeof(T))
    {
      throw std::bad_alloc();
    }
    data_ = static_cast<T*>(::operator new(size * sizeof(T), std::align_val_t(kAlignment)));
    size_ = size;
  }

  void reset() { Buffer old(std::move(*this)); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

private:
  static constexpr std::size_t kAlignment = 64;

  void swap(Buffer& other) noexcept
  {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
};

} // namespace ahd

#endif
