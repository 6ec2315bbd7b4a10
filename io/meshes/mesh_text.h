#pragma once

#include "io/text/token.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace abbe {

/// What belongs to lines beside words.
struct LineRules {
  bool comments = false;  ///< a word that begins with # and all that follows is left out
  bool continued = false; ///< a backslash at the end of a line joins the next one to it
};

/// Reads the lines of a mesh in text, word by word. Lines end with a line feed, a carriage return
/// or both. Errors are ReadErrors at the place of the word.
class MeshText {
public:
  /// The text must outlive the reader.
  MeshText(std::string_view text, std::filesystem::path file, LineRules rules);

  /// Goes to the beginning of the next line. Returns false at the end of the file.
  bool next_line();
  /// True where no word of this line is left.
  [[nodiscard]] bool line_is_done();
  [[nodiscard]] bool file_is_done() const { return at_ == end_; }
  /// The next word of this line, empty when none is left.
  std::string_view word();
  /// The next word of this line as a finite number, correctly rounded. `meaning` completes "...
  /// where
  /// ... should stand".
  double number(std::string_view meaning);
  /// Rounded to single precision instead.
  float single_number(std::string_view meaning);
  std::int64_t whole_number(std::string_view meaning);
  /// A whole number that another character than white space may follow.
  std::int64_t leading_whole_number(std::string_view meaning);
  /// Takes the next character if it is this one.
  bool take(char c);
  [[nodiscard]] bool stands(char c) const { return at_ < end_ && *at_ == c; }
  /// True where no character of a word follows.
  [[nodiscard]] bool word_ends() const { return word_ends(at_); }

  /// Where the next word stands in the text.
  [[nodiscard]] std::size_t offset();
  /// The text that has not been read.
  [[nodiscard]] std::string_view rest() const {
    return {at_, static_cast<std::size_t>(end_ - at_)};
  }
  [[nodiscard]] SourcePosition position(std::size_t offset) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] ReadError error(std::size_t offset, const std::string& what, const std::string& why,
                                const std::string& right) const {
    return {position(offset), what, why, right};
  }
  /// The word at a place as a message shows it, in quotes: control characters are escaped, and a
  /// long one is cut off.
  [[nodiscard]] std::string shown_word(std::size_t offset) const;

private:
  void skip_blanks();
  /// The number of characters of a line end that stands here, 0 for none.
  [[nodiscard]] int line_end(const char* at) const;
  [[nodiscard]] bool word_ends(const char* at) const;
  /// Throws when the line ends here.
  void require_word(std::string_view meaning);
  template <class Number>
  Number floating(std::string_view meaning);
  [[noreturn]] void fail(std::string_view meaning) const;

  const char *begin_, *at_, *end_;
  std::filesystem::path file_;
  LineRules rules_;
};

} // namespace abbe
