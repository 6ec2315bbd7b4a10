#include "io/text/token.h"

#include "tests/catch.h"

#include <filesystem>

using namespace abbe;

namespace {

std::string error_of(std::string_view text) {
  try {
    (void)tokenize(text, "f");
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("white space separates tokens") {
  const auto tokens = tokenize(" a\tb\r\n\n c", "f");
  REQUIRE(tokens.size() == 4);
  CHECK(tokens[0].text == "a");
  CHECK(to_string(tokens[0].where) == "f:1:2");
  CHECK(to_string(tokens[1].where) == "f:1:4");
  CHECK(to_string(tokens[2].where) == "f:3:2");
  CHECK(tokens[3].kind == TokenKind::end);
  CHECK(to_string(tokens[3].where) == "f:3:3");
}

TEST_CASE("an exclamation mark starts a comment to the end of the line") {
  const auto tokens = tokenize("a!b c\nd ! e\n!", "f");
  REQUIRE(tokens.size() == 3);
  CHECK(tokens[0].text == "a");
  CHECK(tokens[1].text == "d");
}

TEST_CASE("braces are tokens without space around them") {
  const auto tokens = tokenize("def a{b}{", "f");
  REQUIRE(tokens.size() == 7);
  CHECK(tokens[2].kind == TokenKind::open_brace);
  CHECK(tokens[3].text == "b");
  CHECK(tokens[4].kind == TokenKind::close_brace);
  CHECK(to_string(tokens[5].where) == "f:1:9");
}

TEST_CASE("a quoted name holds spaces, braces and comment marks") {
  const auto tokens = tokenize("use \"two {words}!\"x", "f");
  REQUIRE(tokens.size() == 4);
  CHECK(tokens[1].kind == TokenKind::quoted);
  CHECK(tokens[1].text == "two {words}!");
  CHECK(tokens[2].text == "x");
}

TEST_CASE("a column is one character of UTF-8, and a byte order mark is none") {
  const auto tokens = tokenize("\xEF\xBB\xBFgr\xC3\xBCn x", "f");
  REQUIRE(tokens.size() == 3);
  CHECK(tokens[0].text == "gr\xC3\xBCn");
  CHECK(tokens[1].where.column == 6);
}

TEST_CASE("a word in quotes is no keyword") {
  CHECK(is_word(tokenize("Sphere", "f")[0], "sphere"));
  CHECK_FALSE(is_word(tokenize("spheres", "f")[0], "sphere"));
  CHECK_FALSE(is_word(tokenize("\"sphere\"", "f")[0], "sphere"));
}

TEST_CASE("a reader goes on giving the end") {
  TokenReader reader("a", "f");
  CHECK(reader.next().text == "a");
  CHECK(reader.at_end());
  CHECK(reader.next().kind == TokenKind::end);
  CHECK(reader.next().kind == TokenKind::end);
}

TEST_CASE("tokens are shown as they were written") {
  CHECK(shown(tokenize("a", "f")[0]) == "\"a\"");
  CHECK(shown(tokenize("", "f")[0]) == "the end of the file");
}

TEST_CASE("the tokenizer's errors") {
  CHECK(error_of("a \"b\nc\"") == "f:1:3: a quoted name has no closing quote (it must end on the "
                                  "line where it begins). Add \" after the name");
  CHECK(error_of("a \"b") == "f:1:3: a quoted name has no closing quote (it must end on the line "
                             "where it begins). Add \" after the name");
  CHECK(error_of(std::string_view("ab\0c", 4)) ==
        "f:1:3: this is not a text file (it holds a zero byte). Give a text file in ASCII or "
        "UTF-8");
}

TEST_CASE("a file that cannot be read is named") {
  REQUIRE_THROWS_WITH(read_text_file("no/such.sdl"),
                      "no/such.sdl: the file cannot be read (No such file or directory). Check its "
                      "name and folder");
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  REQUIRE_THROWS_WITH(read_text_file(folder),
                      folder.string() + ": the file cannot be read (it is a folder). Check its "
                                        "name and folder");
}
