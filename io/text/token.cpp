// The common ground of scenes and libraries, for example
//
//   filter "street lamp"{ intensity 0.85 }   ! a comment to the end of the line
//
// White space separates tokens. Braces are tokens of their own, with or without space around them.
// A name in double quotes may hold spaces, braces and !; it ends on the line where it begins.

#include "io/text/token.h"

#include "io/files/regular_file.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <stdexcept>

namespace abbe {
namespace {

constexpr std::size_t kShownOfLong = 16;
constexpr std::size_t kLongestWord = 4096; ///< in bytes; no name of a file is longer

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

// In UTF-8 every byte of a character but the first is 10xxxxxx.
bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

class Cutter {
public:
  Cutter(std::string_view text, const std::string& file) : text_(text), where_{file, 1, 1} {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  }

  Token next() {
    skip_space_and_comments();
    Token token{TokenKind::end, "", where_};
    if (done()) return token;
    if (front() == '"') {
      token.kind = TokenKind::quoted;
      token.text = take_quoted();
    } else if (front() == '{' || front() == '}') {
      token.kind = front() == '{' ? TokenKind::open_brace : TokenKind::close_brace;
      token.text = take();
    } else {
      token.kind = TokenKind::word;
      while (!done() && !is_space(front()) &&
             std::string_view("{}!\"").find(front()) == std::string_view::npos)
        add_to(token.text, token.where);
    }
    return token;
  }

private:
  [[nodiscard]] bool done() const { return text_.empty(); }
  [[nodiscard]] char front() const { return text_.front(); }

  char take() {
    const char c = front();
    if (c == '\0')
      throw ReadError(where_, "this is not a text file", "it holds a zero byte",
                      "Give a text file in ASCII or UTF-8");
    text_.remove_prefix(1);
    if (c == '\n') {
      ++where_.line;
      where_.column = 1;
    } else if (done() || !continues_character(front())) {
      ++where_.column;
    }
    return c;
  }

  /// Takes one more byte of the word that begins at `begin`.
  void add_to(std::string& word, const SourcePosition& begin) {
    if (word.size() == kLongestWord)
      throw ReadError(begin, fmt::format("a word is longer than {} bytes", kLongestWord),
                      fmt::format("it begins with \"{}\"", word.substr(0, kShownOfLong)),
                      "Break it up, or check that this is the file you meant");
    word += take();
  }

  void skip_space_and_comments() {
    while (!done() && (is_space(front()) || front() == '!')) {
      if (take() != '!') continue;
      while (!done() && front() != '\n')
        take();
    }
  }

  std::string take_quoted() {
    const SourcePosition begin = where_;
    std::string name;
    take();
    while (!done() && front() != '"' && front() != '\n')
      add_to(name, begin);
    if (done() || front() == '\n')
      throw ReadError(begin, "a quoted name has no closing quote",
                      "it must end on the line where it begins", "Add \" after the name");
    take();
    return name;
  }

  std::string_view text_;
  SourcePosition where_;
};

} // namespace

std::string shown(const Token& token) {
  if (token.kind == TokenKind::end) return "the end of " + ending(token);
  return '"' + token.text + '"';
}

std::string ending(const Token& end) {
  return end.text.empty() ? "the file" : end.text;
}

bool is_word(const Token& token, std::string_view word) {
  return token.kind == TokenKind::word && same_name(token.text, word);
}

std::vector<Token> tokenize(std::string_view text, const std::string& file) {
  Cutter cutter(text, file);
  std::vector<Token> tokens;
  do
    tokens.push_back(cutter.next());
  while (tokens.back().kind != TokenKind::end);
  return tokens;
}

const Token& TokenReader::next() {
  const Token& token = tokens_[next_];
  if (token.kind != TokenKind::end) ++next_;
  return token;
}

std::string read_text_file(const std::filesystem::path& file) {
  try {
    return read_regular_file(file);
  } catch (const std::runtime_error& fault) {
    throw ReadError(file, "the file cannot be read", fault.what(), "Check its name and folder");
  }
}

} // namespace abbe
