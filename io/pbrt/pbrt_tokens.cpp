#include "io/pbrt/pbrt_tokens.h"

namespace abbe {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool ends_word(char c) {
  return is_blank(c) || c == '[' || c == ']' || c == '"' || c == '#';
}

} // namespace

const PbrtToken& PbrtTokens::peek() {
  if (!peeked_) token_ = cut();
  peeked_ = true;
  return token_;
}

PbrtToken PbrtTokens::next() {
  const PbrtToken token = peek();
  peeked_ = false;
  return token;
}

void PbrtTokens::advance() {
  const char c = text_[at_++];
  if (c == '\n') {
    ++line_;
    column_ = 1;
  } else if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) { // one per character of UTF-8
    ++column_;
  }
}

void PbrtTokens::skip_blanks() {
  while (at_ < text_.size()) {
    if (is_blank(text_[at_])) {
      advance();
    } else if (text_[at_] == '#') {
      while (at_ < text_.size() && text_[at_] != '\n')
        advance();
    } else {
      return;
    }
  }
}

PbrtToken PbrtTokens::cut() {
  skip_blanks();
  PbrtToken token;
  token.line = line_;
  token.column = column_;
  if (at_ == text_.size()) return token;
  const char first = text_[at_];
  const std::size_t begin = at_;
  advance();
  if (first == '[' || first == ']') {
    token.kind = first == '[' ? PbrtTokenKind::open_bracket : PbrtTokenKind::close_bracket;
    token.text = text_.substr(begin, 1);
  } else if (first == '"') {
    while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n')
      advance();
    if (at_ == text_.size() || text_[at_] == '\n')
      throw ReadError(where(token), "a quote has no partner", "a string ends on its line",
                      "Add the second quote");
    token.kind = PbrtTokenKind::quoted;
    token.text = text_.substr(begin + 1, at_ - begin - 1);
    advance();
  } else {
    while (at_ < text_.size() && !ends_word(text_[at_]))
      advance();
    token.kind = PbrtTokenKind::word;
    token.text = text_.substr(begin, at_ - begin);
  }
  return token;
}

} // namespace abbe
