#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace abbe {

/// A short list that lives inside its owner: at most `Capacity` values, no allocation. Lists are
/// nearly empty as a rule, so only values that are there are made and copied.
template <class T, std::size_t Capacity>
class FixedVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
  FixedVector() {}
  FixedVector(const FixedVector& other) { copy(other); }
  FixedVector& operator=(const FixedVector& other) {
    copy(other);
    return *this;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] bool full() const { return size_ == Capacity; }
  [[nodiscard]] const T* begin() const { return values_; }
  [[nodiscard]] const T* end() const { return values_ + size_; }
  [[nodiscard]] T* begin() { return values_; }
  [[nodiscard]] T* end() { return values_ + size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return values_[i]; }

  void clear() { size_ = 0; }
  void push_back(const T& value) {
    assert(!full());
    std::construct_at(values_ + size_++, value);
  }
  /// Puts the value before the one at `i`. A full list drops its last; false when that is `value`.
  bool insert(std::size_t i, const T& value) {
    if (i == Capacity) return false;
    if (!full()) ++size_;
    for (std::size_t k = size_ - 1; k > i; --k)
      std::construct_at(values_ + k, values_[k - 1]);
    std::construct_at(values_ + i, value);
    return true;
  }
  /// Removes the value at `i`; the order of the others is kept.
  void erase(std::size_t i) {
    for (std::size_t k = i + 1; k < size_; ++k)
      values_[k - 1] = values_[k];
    --size_;
  }

private:
  void copy(const FixedVector& other) {
    size_ = other.size_;
    if (size_ == 0) return;
    std::construct_at(values_, other.values_[0]); // a loop alone becomes a call of memmove
    for (std::size_t i = 1; i < size_; ++i)
      std::construct_at(values_ + i, other.values_[i]);
  }

  std::uint32_t size_ = 0;
  union {
    T values_[Capacity]; ///< those from size_ on do not exist
  };
};

} // namespace abbe
