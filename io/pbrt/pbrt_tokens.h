#pragma once

#include "io/text/read_error.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace abbe {

enum class PbrtTokenKind : std::uint8_t { word, quoted, open_bracket, close_bracket, end };

struct PbrtToken {
  PbrtTokenKind kind = PbrtTokenKind::end;
  std::string_view text; ///< without the quotes
  int line = 1, column = 1;
};

/// Cuts a scene of pbrt into tokens, one by one. White space separates them, and # begins a
/// comment. Text and name must outlive it.
class PbrtTokens {
public:
  PbrtTokens(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// The next token, which stays the next one. Throws ReadError for a quote without its partner.
  [[nodiscard]] const PbrtToken& peek();
  PbrtToken next();

  [[nodiscard]] SourcePosition where(const PbrtToken& token) const {
    return {file_, token.line, token.column};
  }
  [[nodiscard]] const std::string& file() const { return file_; }

private:
  void skip_blanks();
  void advance();
  [[nodiscard]] PbrtToken cut();

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  bool peeked_ = false;
  PbrtToken token_;
};

} // namespace abbe
