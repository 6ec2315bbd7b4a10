#include "io/text/read_error.h"

namespace abbe {

std::string to_string(const SourcePosition& where) {
  if (where.line == 0) return where.file;
  return where.file + ':' + std::to_string(where.line) + ':' + std::to_string(where.column);
}

} // namespace abbe
