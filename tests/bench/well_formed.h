#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace abbe::test {

/// What is wrong with a text of XML, by a reader of the little that the bench writes: a
/// declaration, elements, quoted values, the five entities' first four. Empty: nothing.
inline std::string xml_mistake(std::string_view text) {
  std::vector<std::string> open;
  std::size_t roots = 0;
  const auto entities_are_known = [](std::string_view content) {
    for (std::size_t at = content.find('&'); at != content.npos; at = content.find('&', at + 1)) {
      const std::string_view rest = content.substr(at);
      if (!rest.starts_with("&amp;") && !rest.starts_with("&lt;") && !rest.starts_with("&gt;") &&
          !rest.starts_with("&quot;"))
        return false;
    }
    return true;
  };
  std::size_t at = 0;
  if (text.starts_with("<!DOCTYPE html>")) at = text.find('>') + 1;
  while (at < text.size()) {
    const std::size_t tag = text.find('<', at);
    const std::string_view content = text.substr(at, tag - at);
    if (!entities_are_known(content)) return "unknown entity in: " + std::string(content);
    if (content.find('>') != content.npos) return "stray > in: " + std::string(content);
    const bool blank = content.find_first_not_of(" \n") == content.npos;
    if (!blank && open.empty()) return "text outside: " + std::string(content);
    if (tag == text.npos) break;
    const std::size_t end = text.find('>', tag);
    if (end == text.npos) return "a tag without end";
    std::string_view inner = text.substr(tag + 1, end - tag - 1);
    at = end + 1;
    if (inner.starts_with('/')) {
      if (open.empty() || open.back() != inner.substr(1)) return "closes " + std::string(inner);
      open.pop_back();
      continue;
    }
    const bool empty = inner.ends_with('/');
    if (empty) inner.remove_suffix(1);
    const std::size_t name_end = inner.find(' ');
    if (open.empty()) ++roots;
    if (!empty) open.emplace_back(inner.substr(0, name_end));
    while (name_end != inner.npos && !(inner = inner.substr(inner.find(' '))).empty()) {
      inner.remove_prefix(1);
      const std::size_t equals = inner.find("=\"");
      if (equals == inner.npos) return "no value: " + std::string(inner);
      const std::size_t close = inner.find('"', equals + 2);
      if (close == inner.npos) return "no end: " + std::string(inner);
      const std::string_view value = inner.substr(equals + 2, close - equals - 2);
      if (!entities_are_known(value) || value.find('<') != value.npos)
        return "value: " + std::string(value);
      inner = inner.substr(close + 1);
      if (inner.empty()) break;
      if (inner.front() != ' ') return "after a value: " + std::string(inner);
    }
  }
  if (!open.empty()) return "not closed: " + open.back();
  return roots == 1 ? "" : "not one element";
}

/// The values of one attribute in the order of the text, those of all elements.
inline std::vector<std::string> values_of(std::string_view text, std::string_view attribute) {
  const std::string begin = std::string(1, ' ').append(attribute).append("=\"");
  std::vector<std::string> values;
  for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at + 1)) {
    const std::size_t first = at + begin.size();
    values.emplace_back(text.substr(first, text.find('"', first) - first));
  }
  return values;
}

} // namespace abbe::test
