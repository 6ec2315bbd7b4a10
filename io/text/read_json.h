#pragma once

#include "io/text/read_error.h"

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace abbe {

struct JsonValue;
using JsonArray = std::vector<JsonValue>;
/// The members in the order of the text.
using JsonObject = std::vector<std::pair<std::string, JsonValue>>;

/// A value of JSON. Numbers are doubles.
struct JsonValue {
  std::variant<std::monostate, bool, double, std::string, JsonArray, JsonObject> value;

  /// The member of an object; null where there is none, or where this is no object.
  [[nodiscard]] const JsonValue* member(std::string_view name) const;
};

/// Reads a text of JSON. `file` is for messages. Throws ReadError at the line and column where the
/// text ceases to be JSON, or nests deeper than any file of a known format does.
[[nodiscard]] JsonValue read_json(std::string_view text, const std::string& file);

} // namespace abbe
