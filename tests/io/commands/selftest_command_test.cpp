#include "io/commands/selftest_command.h"

#include "tests/catch.h"

#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include <cstdio>
#include <string>

using namespace abbe;

namespace {

struct Outcome {
  int exit_code = -1;
  std::string out;
};

Outcome selftest(const std::string& options) {
  Outcome outcome;
  std::FILE* const pipe =
      ::popen((std::string("\"") + ABBE_EXECUTABLE + "\" selftest " + options).c_str(), "r");
  REQUIRE(pipe != nullptr);
  char buffer[4096];
  for (std::size_t got; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    outcome.out.append(buffer, got);
  outcome.exit_code = WEXITSTATUS(::pclose(pipe));
  return outcome;
}

} // namespace

TEST_CASE("abbe selftest prints a table for people and JSON for programs, and ends with 0") {
  const Outcome table = selftest("");
  CHECK(table.exit_code == 0);
  CHECK(table.out.find("ok     prism ") != table.out.npos);
  CHECK(table.out.find("values are as expected\n") != table.out.npos);
  const Outcome json = selftest("--json");
  CHECK(json.exit_code == 0);
  const auto report = nlohmann::json::parse(json.out);
  CHECK(report["failed"] == 0);
  CHECK(report["passed"] == report["rows"].size());
  CHECK(report["rows"].size() > 200);
  for (const auto& row : report["rows"])
    CHECK(row["passed"] == true);
}

TEST_CASE("a selftest with a value that is not as expected ends with 1") {
  const SelftestRow good{"subject", "a good one", "a book", 1.0, 1.0, 0.1};
  const SelftestRow bad{"subject", "a bad one", "a book", 1.0, 2.0, 0.1};
  CHECK(tell({good}, true) == 0);
  CHECK(tell({good, bad}, true) == 1);
  CHECK(tell({bad}, false) == 1);
}
