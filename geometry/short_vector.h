#pragma once

#include <algorithm>
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
    copy(other);
    return *this;
  }
  ~ShortVector() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const T* begin() const { return many_ ? many_.get() : values_; }
  [[nodiscard]] const T* end() const { return begin() + size_; }
  [[nodiscard]] T* begin() { return many_ ? many_.get() : values_; }
  [[nodiscard]] T* end() { return begin() + size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return begin()[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return begin()[i]; }

  /// Keeps the room that the list has taken.
  void clear() { size_ = 0; }
  void push_back(const T& value) {
    if (size_ == capacity()) [[unlikely]]
      return push_grown(value);
    std::construct_at(begin() + size_++, value);
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
    --size_;
  }

private:
  [[nodiscard]] std::size_t capacity() const { return many_ ? capacity_ : Inline; }

  [[gnu::noinline]] void push_grown(T value) { // rare, so out of the way
    auto more = std::make_unique_for_overwrite<T[]>(2 * std::size_t{size_});
    std::copy(begin(), end(), more.get());
    many_ = std::move(more);
    capacity_ = 2 * size_;
    many_[size_++] = value;
  }

  void copy(const ShortVector& other) {
    if (many_ || other.many_) [[unlikely]]
      return copy_long(other);
    size_ = other.size_;
    if (size_ == 0) return;
    std::construct_at(values_, other.values_[0]); // a loop alone becomes a call of memmove
    for (std::size_t i = 1; i < size_; ++i)
      std::construct_at(values_ + i, other.values_[i]);
  }

  [[gnu::noinline]] void copy_long(const ShortVector& other) {
    if (this == &other) return;
    if (other.size_ > capacity()) {
      many_ = std::make_unique_for_overwrite<T[]>(other.size_);
      capacity_ = other.size_;
    }
    size_ = other.size_;
    std::copy(other.begin(), other.end(), begin());
  }

  std::uint32_t size_ = 0;
  std::uint32_t capacity_;    ///< of `many_`, and without meaning where that is null
  std::unique_ptr<T[]> many_; ///< the values where they are, or have been, more than `Inline`
  union {
    T values_[Inline]; ///< those from size_ on do not exist
  };
};

} // namespace abbe
