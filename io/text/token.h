#pragma once

#include "io/text/read_error.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abbe {

enum class TokenKind : std::uint8_t { word, quoted, open_brace, close_brace, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string text; ///< without the quotes; of an end what ends, empty for a file
  SourcePosition where;
};

/// The token as a message shows it: `"text"`, or "the end of the file".
[[nodiscard]] std::string shown(const Token& token);

/// What an `end` token ends: "the file", or "macro NAME".
[[nodiscard]] std::string ending(const Token& end);

/// True for this word without quotes, in upper or lower case.
[[nodiscard]] bool is_word(const Token& token, std::string_view word);

/// Cuts a text into tokens, the last of which is an `end`. `file` is only for messages.
/// Throws ReadError for a quote without its partner, for a word that is longer than any that has a
/// meaning, and for text that is not text.
[[nodiscard]] std::vector<Token> tokenize(std::string_view text, const std::string& file);

/// Hands out tokens one by one. Past the end it goes on giving the `end` token.
class TokenReader {
public:
  TokenReader(std::string_view text, const std::string& file) : tokens_(tokenize(text, file)) {}
  /// The last of the tokens is an `end`.
  explicit TokenReader(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  [[nodiscard]] const Token& peek() const { return tokens_[next_]; }
  [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
  const Token& next();
  /// The number of all tokens, with the `end`.
  [[nodiscard]] std::size_t count() const { return tokens_.size(); }

private:
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
};

/// The whole content of a file. Throws ReadError, which names the file.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file);

} // namespace abbe
