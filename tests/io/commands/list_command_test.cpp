#include "tests/catch.h"
#include "tests/io/run_program.h"

using namespace abbe;
using test::Desk;

TEST_CASE("list finds names by a part, in all lists") {
  const Desk desk;
  const std::string found = desk.run("list bk7");
  CHECK(found.find("N-BK7") != std::string::npos);
  CHECK(found.find("N-SF11") == std::string::npos);
  CHECK(found.find("metal") == std::string::npos); // a list without a hit has no header
  const std::string lights = desk.run("list d6");
  CHECK(lights.find("\nD65 ") != std::string::npos);
  CHECK(lights.find("D50") == std::string::npos);
  CHECK(desk.run("list glasses").find("N-SF11") != std::string::npos);
}

TEST_CASE("list searches a library that is named") {
  const Desk desk;
  std::string values;
  for (int i = 0; i < 81; ++i)
    values += " 0.5";
  test::put(desk / "my.filter",
            "filter glowworm\n{\n  intensity 1\n  colour 81" + values + "\n}\n");
  CHECK(desk.run("list GLOW my.filter").find("glowworm") != std::string::npos);
}

TEST_CASE("a name that is nowhere is told, with similar ones") {
  const Desk desk;
  desk.refuses("list N-BK8", "nor in any of their names. Did you mean N-BK7");
  desk.refuses("list", "what");
  desk.refuses("list N-BK7 --plot D65", "with --plot it is glasses, lights, materials or metals");
}
