#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace abbe {

static_assert(std::endian::native == std::endian::little, "files of states are little-endian");

/// Appends numbers and texts to bytes. Numbers are little-endian; before the values of a list comes
/// their number, as 64 bits, and before a text its length.
class ValueWriter {
public:
  template <class Number>
  void put(Number number) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    append(&number, sizeof number);
  }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    bytes_ += text;
  }
  /// Only the numbers: their count is known otherwise.
  template <class Number>
  void put_each(const std::vector<Number>& numbers) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    append(numbers.data(), numbers.size() * sizeof(Number));
  }
  template <class Number>
  void put(const std::vector<Number>& numbers) {
    put(std::uint64_t{numbers.size()});
    put_each(numbers);
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }

private:
  void append(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

/// Takes what ValueWriter has written. Throws std::runtime_error where the bytes end too early.
class ValueReader {
public:
  /// Keeps a view of the bytes.
  explicit ValueReader(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  [[nodiscard]] Number get() {
    static_assert(std::is_arithmetic_v<Number>);
    Number number;
    std::memcpy(&number, take(sizeof number).data(), sizeof number);
    return number;
  }
  [[nodiscard]] std::string text() { return std::string(take(length(1))); }
  template <class Number>
  void get_each(std::vector<Number>& numbers) {
    const std::string_view bytes = take(numbers.size() * sizeof(Number));
    if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  }
  template <class Number>
  [[nodiscard]] std::vector<Number> list() {
    std::vector<Number> numbers(length(sizeof(Number)));
    get_each(numbers);
    return numbers;
  }
  /// How many values follow, of which each takes at least so many bytes.
  [[nodiscard]] std::size_t length(std::size_t least_size) {
    const auto count = get<std::uint64_t>();
    if (count > rest_.size() / least_size) throw_short();
    return count;
  }
  /// Throws where something is left.
  void end() const {
    if (!rest_.empty()) throw std::runtime_error("it holds more than it should");
  }

private:
  [[noreturn]] static void throw_short() { throw std::runtime_error("it ends too early"); }
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) throw_short();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  std::string_view rest_;
};

} // namespace abbe
