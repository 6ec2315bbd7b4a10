#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace abbe {

/// A list that is short as a rule: up to `Inline` values live inside their owner; a longer list
/// takes room on the heap, so that none is ever lost. Lists are nearly empty most of the time, so
/// only values that are there are made and copied.
template <class T, std::size_t Inline>
class ShortVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
  ShortVector() {}
  ShortVector(const ShortVector& other) { copy(other); }
  ShortVector& operator=(const ShortVector& other) {
    if (is_long() || other.is_long()) [[unlikely]]
      assign_long(other);
    else
      copy(other);
    return *this;
  }
  ~ShortVector() {
    if (is_long()) [[unlikely]]
      release();
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const T* begin() const { return is_long() ? many_ : values_; }
  [[nodiscard]] const T* end() const { return begin() + size_; }
  [[nodiscard]] T* begin() { return is_long() ? many_ : values_; }
  [[nodiscard]] T* end() { return begin() + size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return begin()[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return begin()[i]; }

  void clear() {
    if (is_long()) [[unlikely]]
      release();
    size_ = 0;
  }
  /// Makes the value the only one.
  void assign(const T& value) {
    if (is_long()) [[unlikely]]
      release();
    std::construct_at(values_, value);
    size_ = 1;
  }
  void push_back(const T& value) {
    if (size_ >= Inline) [[unlikely]]
      return push_long(value);
    std::construct_at(values_ + size_++, value);
  }
  /// Puts the value before the one at `i`.
  void insert(std::size_t i, const T& value) {
    const T inserted = value; // it may be one of the list's own
    push_back(inserted);
    T* const values = begin();
    for (std::size_t k = size_ - 1; k > i; --k)
      values[k] = values[k - 1];
    values[i] = inserted;
  }
  /// Removes the value at `i`; the order of the others is kept.
  void erase(std::size_t i) {
    T* const values = begin();
    for (std::size_t k = i + 1; k < size_; ++k)
      values[k - 1] = values[k];
    if (size_ == Inline + 1) [[unlikely]]
      return move_inside();
    --size_;
  }

private:
  /// The length tells where the values are, so that a list that is not long costs nothing for what
  /// a long one needs.
  [[nodiscard]] bool is_long() const { return size_ > Inline; }

  /// Memory on the heap for a list of so many values: up to the next power of two.
  [[nodiscard]] static T* room_for(std::size_t count) {
    return std::make_unique_for_overwrite<T[]>(std::bit_ceil(count)).release();
  }
  void release() { std::unique_ptr<T[]>(many_).reset(); }

  // Long lists are rare, so their code is kept out of the callers.
  [[gnu::noinline]] void push_long(T value) {
    if (size_ == Inline || std::has_single_bit(size_)) { // the room is full
      T* const more = room_for(size_ + std::size_t{1});
      std::copy(begin(), end(), more);
      if (is_long()) release();
      std::construct_at(&many_, more);
    }
    many_[size_++] = value;
  }
  [[gnu::noinline]] void move_inside() {
    const std::unique_ptr<T[]> values(many_);
    size_ = Inline;
    for (std::size_t i = 0; i < Inline; ++i)
      std::construct_at(values_ + i, values[i]);
  }
  [[gnu::noinline]] void assign_long(const ShortVector& other) {
    if (this == &other) return;
    if (is_long()) release();
    copy(other);
  }
  [[gnu::noinline]] void copy_long(const ShortVector& other) {
    std::construct_at(&many_, room_for(other.size_));
    std::copy(other.begin(), other.end(), many_);
    size_ = other.size_;
  }

  /// Copies into a list that is not long.
  void copy(const ShortVector& other) {
    if (other.is_long()) [[unlikely]]
      return copy_long(other);
    size_ = other.size_;
    if (size_ == 0) return;
    std::construct_at(values_, other.values_[0]); // a loop alone becomes a call of memmove
    for (std::size_t i = 1; i < size_; ++i)
      std::construct_at(values_ + i, other.values_[i]);
  }

  std::uint32_t size_ = 0;
  union {
    T values_[Inline]; ///< of a short list; those from size_ on do not exist
    T* many_;          ///< of a list longer than that
  };
};

} // namespace abbe
