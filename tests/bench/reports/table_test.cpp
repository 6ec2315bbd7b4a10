#include "bench/reports/table.h"
#include "tests/catch.h"

using namespace abbe::bench;

TEST_CASE("a table's columns are as wide as their widest cell") {
  const Table table{"title", {"kind", "s"}, {{"a", "1.25"}, {"camera", "10"}}, {"a note"}};
  CHECK(to_text(table) == "\ntitle\n"
                          "  kind       s\n"
                          "  a       1.25\n"
                          "  camera    10\n"
                          "  a note\n");
}

TEST_CASE("without columns there are notes alone") {
  CHECK(to_text({"title", {}, {}, {"one", "two"}}) == "\ntitle\n  one\n  two\n");
}
