#pragma once

#include "io/text/read_json.h"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// What helps where a file is not as glTF 2.0 asks for.
inline constexpr std::string_view kGltfAdvice = "Check the file with the glTF validator";

/// A value in the JSON of a glTF file, and the JSON pointer that leads to it. All members throw
/// ReadError with that pointer where a value is not of the kind that is asked for.
class GltfValue {
public:
  /// `file` names the file in messages, and outlives this, as `value` does.
  GltfValue(const JsonValue& value, const std::string& file, std::string pointer)
      : value_(&value), file_(&file), pointer_(std::move(pointer)) {}

  /// file#/materials/0
  [[nodiscard]] SourcePosition where() const { return {*file_ + "#" + pointer_, 0, 0}; }
  [[nodiscard]] const std::string& pointer() const { return pointer_; }

  /// The member of an object.
  [[nodiscard]] std::optional<GltfValue> find(std::string_view name) const;
  /// The extension of this name.
  [[nodiscard]] std::optional<GltfValue> extension(std::string_view name) const;
  /// The elements of the array that is the member of this name; none where there is no such member.
  [[nodiscard]] std::vector<GltfValue> list(std::string_view name) const;
  /// The names of the members of the object.
  [[nodiscard]] std::vector<std::string_view> names() const;

  /// The number that is the member of this name, which lies from `lowest` to `highest`.
  [[nodiscard]] std::optional<double>
  number(std::string_view name, double lowest = -std::numeric_limits<double>::infinity(),
         double highest = std::numeric_limits<double>::infinity()) const;
  /// The same for a whole number that is not below 0.
  [[nodiscard]] std::optional<std::size_t> whole(std::string_view name) const;
  /// The same for a number that must be below `count`; `things` completes "there are 3 ...".
  [[nodiscard]] std::optional<std::size_t> index(std::string_view name, std::size_t count,
                                                 std::string_view things) const;
  [[nodiscard]] std::size_t as_index(std::size_t count, std::string_view things) const;
  [[nodiscard]] bool flag(std::string_view name, bool otherwise) const;
  [[nodiscard]] std::string string(std::string_view name, std::string_view otherwise) const;
  [[nodiscard]] std::string as_string() const;
  /// As many finite numbers as `otherwise` has.
  template <std::size_t n>
  [[nodiscard]] std::array<double, n> numbers(std::string_view name,
                                              std::array<double, n> otherwise) const {
    read_numbers(name, otherwise.data(), n);
    return otherwise;
  }

private:
  [[nodiscard]] double as_number() const;
  void read_numbers(std::string_view name, double* values, std::size_t count) const;
  [[noreturn]] void fail(std::string_view expected) const;

  const JsonValue* value_;
  const std::string* file_;
  std::string pointer_;
};

} // namespace abbe
