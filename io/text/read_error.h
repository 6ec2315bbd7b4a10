#pragma once

#include "core/scene/user_error.h"

#include <filesystem>
#include <functional>
#include <string>

namespace abbe {

/// Where something stands in a file; lines and columns count from 1, a column is one character. A
/// reader of files without lines sets the line to 0, and says in `file` what it can.
struct SourcePosition {
  std::string file;
  int line = 1;
  int column = 1;
};

/// `file:line:column`, or `file` alone without a line.
[[nodiscard]] std::string to_string(const SourcePosition& where);

/// A file that cannot be understood. what() is "file:line:column: what is wrong (why). What would
/// be right"; for a file that cannot be read at all there is no line and no column.
class ReadError : public UserError {
public:
  ReadError(const SourcePosition& where, const std::string& what, const std::string& why,
            const std::string& right)
      : UserError(to_string(where) + ": " + what + " (" + why + "). " + right) {}
  ReadError(const std::filesystem::path& file, const std::string& what, const std::string& why,
            const std::string& right)
      : UserError(file.string() + ": " + what + " (" + why + "). " + right) {}
  /// The same, with `note` at its end.
  [[nodiscard]] ReadError with(const std::string& note) const { return ReadError(what() + note); }

private:
  explicit ReadError(const std::string& message) : UserError(message) {}
};

/// Receives what a reader finds odd but can live with, as "file:line:column: message".
using Warn = std::function<void(const std::string&)>;

} // namespace abbe
