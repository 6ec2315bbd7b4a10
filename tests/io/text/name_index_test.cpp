#include "io/text/name_index.h"

#include "tests/catch.h"

using namespace abbe;

TEST_CASE("names are found in upper and lower case, and the first of a name stays") {
  NameIndex index;
  CHECK(index.add("Rust", 3));
  CHECK(index.add("bare", 4));
  CHECK_FALSE(index.add("RUST", 5));
  CHECK(index.find("rUST") == std::size_t{3});
  CHECK(index.find("Bare") == std::size_t{4});
  CHECK_FALSE(index.find("rus").has_value());
  CHECK(lower_case("\xC3\x84 Z") == "\xC3\x84 z"); // ASCII letters alone
}
