#include "spectral/data_table.h"
#include "tests/catch.h"

#include <stdexcept>

using namespace abbe;

TEST_CASE("A table is read by column name and row") {
  const DataTable table("# a comment\r\nnm,what\r\n400,a b\n\n405,\n");
  CHECK(table.row_count() == 2);
  CHECK(table.field(0, "what") == "a b");
  CHECK(table.field(1, "what").empty());
  CHECK(table.numbers("nm") == std::vector<double>{400.0, 405.0});
}

TEST_CASE("A table refuses ragged rows, a missing header and unknown columns") {
  CHECK_THROWS_AS(DataTable("a,b\n1\n"), std::invalid_argument);
  CHECK_THROWS_AS(DataTable("a\n1,2\n"), std::invalid_argument);
  CHECK_THROWS_AS(DataTable("# only a comment\n"), std::invalid_argument);
  CHECK_THROWS_AS(DataTable("a\n1\n").numbers("b"), std::out_of_range);
  CHECK_THROWS_AS(DataTable("a\nx\n").numbers("a"), std::invalid_argument);
}

TEST_CASE("A number is the whole text or none") {
  CHECK(parse_number("-1.5e-3") == -1.5e-3);
  for (const char* text : {"", " 1", "1 ", "1x", "x"})
    CHECK_THROWS_AS(parse_number(text), std::invalid_argument);
}

TEST_CASE("Words are what lies between spaces") {
  CHECK(split_words("0 1.5  -2") == std::vector<std::string_view>{"0", "1.5", "-2"});
  CHECK(split_words("").empty());
}

TEST_CASE("Names are compared without regard to case") {
  CHECK(same_name("N-bk7", "n-BK7"));
  CHECK_FALSE(same_name("BK7", "BK"));
  CHECK_FALSE(same_name("BK7", "BK8"));
}

TEST_CASE("The tables are compiled in, comment line first") {
  CHECK(embedded_tables().size() == 54);
  for (const EmbeddedTable& table : embedded_tables()) {
    INFO(table.file_name);
    CHECK(table.text.starts_with("# "));
    CHECK(table.text.find("source:") != std::string_view::npos);
    CHECK(table.text.find("licence:") != std::string_view::npos);
    CHECK(DataTable(table.text).row_count() > 0);
  }
  CHECK(DataTable(embedded_table("cie1931_2deg_1nm.csv")).row_count() == 471);
  CHECK_THROWS_AS(embedded_table("missing.csv"), std::out_of_range);
}
