#include "bench/plots/markup.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace abbe::bench {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  }
  return result;
}

std::string coordinate(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("a coordinate that is not finite");
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

void Markup::begin(std::string_view tag, Attributes attributes) {
  text_ += '<';
  text_ += tag;
  for (const Attribute& a : attributes)
    text_ += fmt::format(" {}=\"{}\"", a.name, escaped(a.value));
}

void Markup::open(std::string_view tag, Attributes attributes) {
  begin(tag, attributes);
  text_ += ">\n";
  open_.emplace_back(tag);
}

void Markup::close() {
  text_ += fmt::format("</{}>\n", open_.back());
  open_.pop_back();
}

void Markup::element(std::string_view tag, Attributes attributes) {
  begin(tag, attributes);
  text_ += "/>\n";
}

void Markup::text(std::string_view tag, Attributes attributes, std::string_view content) {
  begin(tag, attributes);
  text_ += fmt::format(">{}</{}>\n", escaped(content), tag);
}

std::string Markup::finish() {
  while (!open_.empty())
    close();
  return std::move(text_);
}

} // namespace abbe::bench
