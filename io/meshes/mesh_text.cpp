#include "io/meshes/mesh_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

namespace abbe {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// True when the magnitude of a decimal number, without its sign, is less than 1.
bool is_small(const char* at, const char* end) {
  std::int64_t places = 0; // before the first digit that is not 0 stand 10^places
  bool found = false, after_point = false;
  for (; at < end && (is_digit(*at) || *at == '.'); ++at) {
    if (*at == '.') {
      after_point = true;
      continue;
    }
    found = found || *at != '0';
    if (found && !after_point) ++places;
    if (!found && after_point) --places;
  }
  std::int64_t exponent = 0;
  if (at < end && (*at == 'e' || *at == 'E')) {
    ++at;
    const bool negative = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+')) ++at;
    for (; at < end && is_digit(*at); ++at)
      if (exponent < (std::int64_t{1} << 50)) exponent = 10 * exponent + (*at - '0');
    if (negative) exponent = -exponent;
  }
  return !found || places + exponent <= 0;
}

} // namespace

MeshText::MeshText(std::string_view text, std::filesystem::path file, LineRules rules)
    : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), file_(std::move(file)),
      rules_(rules) {
  if (text.starts_with("\xEF\xBB\xBF")) at_ = begin_ += 3; // the byte order mark
}

int MeshText::line_end(const char* at) const {
  if (at == end_) return 0;
  if (*at == '\n') return 1;
  if (*at != '\r') return 0;
  return at + 1 < end_ && at[1] == '\n' ? 2 : 1;
}

bool MeshText::word_ends(const char* at) const {
  return at == end_ || is_blank(*at) || line_end(at) > 0 ||
         (rules_.continued && *at == '\\' && line_end(at + 1) > 0);
}

void MeshText::skip_blanks() {
  while (at_ < end_) {
    if (is_blank(*at_))
      ++at_;
    else if (const int length = line_end(at_ + 1); rules_.continued && *at_ == '\\' && length > 0)
      at_ += 1 + length;
    else
      break;
  }
  if (rules_.comments && at_ < end_ && *at_ == '#')
    while (at_ < end_ && line_end(at_) == 0)
      ++at_;
}

bool MeshText::line_is_done() {
  skip_blanks();
  return at_ == end_ || line_end(at_) > 0;
}

bool MeshText::next_line() {
  while (!line_is_done())
    word();
  at_ += line_end(at_);
  return at_ < end_;
}

std::string_view MeshText::word() {
  skip_blanks();
  const char* const begin = at_;
  while (!word_ends(at_))
    ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::size_t MeshText::offset() {
  skip_blanks();
  return static_cast<std::size_t>(at_ - begin_);
}

void MeshText::require_word(std::string_view meaning) {
  if (line_is_done())
    throw error(
        static_cast<std::size_t>(at_ - begin_),
        fmt::format("the {} ends where {} should stand", at_ == end_ ? "file" : "line", meaning),
        "something is missing", "Write the mesh again");
}

void MeshText::fail(std::string_view meaning) const {
  const auto place = static_cast<std::size_t>(at_ - begin_);
  throw error(place, fmt::format("{} is not {}", shown_word(place), meaning),
              "no such thing can stand here", "Write the mesh again");
}

template <class Number>
Number MeshText::floating(std::string_view meaning) {
  require_word(meaning);
  const char* from = at_;
  if (*from == '+' && from + 1 < end_ && from[1] != '-') ++from;
  Number value{};
  auto [stop, fault] = std::from_chars(from, end_, value);
  const char* const digits = *from == '-' ? from + 1 : from;
  // Some libraries call numbers that are too near to 0 out of range, and leave the value alone.
  if (fault == std::errc::result_out_of_range && is_small(digits, stop)) {
    value = *from == '-' ? -Number{} : Number{};
    fault = {};
  }
  if (fault == std::errc::invalid_argument || !word_ends(stop)) fail(meaning);
  if (fault != std::errc{} || !std::isfinite(value))
    fail(fmt::format("{} that is finite", meaning));
  at_ = stop;
  return value;
}

double MeshText::number(std::string_view meaning) {
  return floating<double>(meaning);
}

float MeshText::single_number(std::string_view meaning) {
  return floating<float>(meaning);
}

std::int64_t MeshText::leading_whole_number(std::string_view meaning) {
  require_word(meaning);
  const char* from = at_;
  if (*from == '+' && from + 1 < end_ && from[1] != '-') ++from;
  std::int64_t value = 0;
  const auto [stop, fault] = std::from_chars(from, end_, value);
  if (fault != std::errc{}) fail(meaning);
  at_ = stop;
  return value;
}

std::int64_t MeshText::whole_number(std::string_view meaning) {
  require_word(meaning);
  const char* const before = at_;
  const std::int64_t value = leading_whole_number(meaning);
  if (word_ends(at_)) return value;
  at_ = before;
  fail(meaning);
}

bool MeshText::take(char c) {
  if (at_ == end_ || *at_ != c) return false;
  ++at_;
  return true;
}

SourcePosition MeshText::position(std::size_t offset) const {
  SourcePosition where{file_.string(), 1, 1};
  for (const char* at = begin_; at < begin_ + offset; ++at) {
    const bool inside_pair = *at == '\r' && at + 1 < end_ && at[1] == '\n';
    if ((*at == '\n' || *at == '\r') && !inside_pair) {
      ++where.line;
      where.column = 1;
    } else if ((static_cast<unsigned char>(*at) & 0xC0U) != 0x80U) { // UTF-8: begins a character
      ++where.column;
    }
  }
  return where;
}

std::string MeshText::shown_word(std::size_t offset) const {
  constexpr std::ptrdiff_t kMost = 40;
  std::string text = "\"";
  const char* const begin = begin_ + offset;
  const char* at = begin;
  for (; !word_ends(at) && at - begin < kMost; ++at) {
    const auto code = static_cast<unsigned char>(*at);
    if (code < 0x20 || code == 0x7F)
      text += fmt::format("\\x{:02x}", code);
    else
      text += *at;
  }
  return text + (word_ends(at) ? "\"" : "...\"");
}

} // namespace abbe
