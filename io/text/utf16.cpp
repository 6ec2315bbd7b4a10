#include "io/text/utf16.h"

namespace abbe {

std::string without_utf16(std::string_view text) {
  if (!text.starts_with("\xFF\xFE")) return std::string(text);
  std::string narrow;
  for (std::size_t i = 2; i + 1 < text.size(); i += 2)
    narrow += text[i + 1] == '\0' ? text[i] : '?';
  return narrow;
}

} // namespace abbe
