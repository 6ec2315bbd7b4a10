#include "io/text/json.h"

#include <fmt/format.h>

#include <cmath>

namespace abbe {

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\' || c == '\n') result += '\\';
    if (c == '\n')
      result += 'n';
    else
      result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + '"';
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.12g}", value) : "null";
}

std::string json_list(std::span<const double> values) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ", ") + json_number(value);
  return "[" + text + "]";
}

} // namespace abbe
