#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace abbe {

/// A short list that lives inside its owner: at most `Capacity` values, no allocation.
template <class T, std::size_t Capacity>
class FixedVector {
public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] bool full() const { return size_ == Capacity; }
  [[nodiscard]] const T* begin() const { return values_.data(); }
  [[nodiscard]] const T* end() const { return values_.data() + size_; }
  [[nodiscard]] T* begin() { return values_.data(); }
  [[nodiscard]] T* end() { return values_.data() + size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return values_[i]; }

  void clear() { size_ = 0; }
  void push_back(const T& value) {
    assert(!full());
    values_[size_++] = value;
  }
  /// Puts the value before the one at `i`. A full list drops its last; false when that is `value`.
  bool insert(std::size_t i, const T& value) {
    if (i == Capacity) return false;
    if (!full()) ++size_;
    for (std::size_t k = size_ - 1; k > i; --k)
      values_[k] = values_[k - 1];
    values_[i] = value;
    return true;
  }
  /// Removes the value at `i`; the order of the others is kept.
  void erase(std::size_t i) {
    for (std::size_t k = i + 1; k < size_; ++k)
      values_[k - 1] = values_[k];
    --size_;
  }

private:
  std::array<T, Capacity> values_{};
  std::size_t size_ = 0;
};

} // namespace abbe
