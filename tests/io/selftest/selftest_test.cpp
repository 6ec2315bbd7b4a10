#include "io/selftest/selftest.h"

#include "tests/catch.h"

#include <limits>
#include <set>

using namespace abbe;

TEST_CASE("all values of the selftest are as expected, and none is without a source") {
  const SelftestRows rows = run_selftest();
  std::set<std::string> subjects, names;
  for (const SelftestRow& row : rows) {
    INFO(row.subject << ": " << row.what << ", expected " << row.expected << ", got " << row.got);
    CHECK(row.passed());
    CHECK(row.tolerance > 0.0);
    CHECK_FALSE(row.source.empty());
    CHECK(names.insert(row.subject + row.what).second); // no row stands there twice
    subjects.insert(row.subject);
  }
  CHECK(subjects.size() == 13);
  CHECK(rows.size() > 200);
  CHECK(failures(rows) == 0);
}

TEST_CASE("a value that differs, or is none, does not pass") {
  SelftestRow row{"subject", "what", "source", 1.0, 1.05, 0.1};
  CHECK(row.passed());
  row.got = 1.2;
  CHECK_FALSE(row.passed());
  row.got = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(row.passed());
  CHECK(failures({row, row}) == 2);
}

TEST_CASE("the selftest's table and JSON show each row, and how many fail") {
  const SelftestRow good{"prism", "a \"good\" one", "a book", 1.0, 1.0, 0.1, "deg"};
  const SelftestRow bad{"lens", "a bad one", "a book", 1.0, 2.0, 0.1};
  const SelftestRow none{"film", "none", "-", 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0};
  const std::string table = selftest_table({good, bad, none});
  CHECK(table.find("ok     prism") != table.npos);
  CHECK(table.find("FAILED lens") != table.npos);
  CHECK(table.find("2 of 3 values are not as expected") != table.npos);
  CHECK(selftest_table({good}).find("all 1 values are as expected") != table.npos);
  CHECK(
      selftest_json({good, bad, none}) ==
      "{\"rows\": [\n"
      "  {\"subject\": \"prism\", \"what\": \"a \\\"good\\\" one\", \"source\": \"a book\", "
      "\"unit\": \"deg\", \"expected\": 1, \"got\": 1, \"tolerance\": 0.1, \"passed\": true},\n"
      "  {\"subject\": \"lens\", \"what\": \"a bad one\", \"source\": \"a book\", \"unit\": \"\", "
      "\"expected\": 1, \"got\": 2, \"tolerance\": 0.1, \"passed\": false},\n"
      "  {\"subject\": \"film\", \"what\": \"none\", \"source\": \"-\", \"unit\": \"\", "
      "\"expected\": 0, \"got\": null, \"tolerance\": 0, \"passed\": false}\n"
      "], \"passed\": 1, \"failed\": 2}");
}
