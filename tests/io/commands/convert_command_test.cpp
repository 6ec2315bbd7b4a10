#include "tests/catch.h"
#include "tests/io/run_program.h"

using namespace abbe;
using test::Desk;

TEST_CASE("convert never replaces a file that it reads") {
  const Desk desk;
  const std::string text = "include card.sdl sphere";
  test::put(desk / "scene.sdl", text);
  test::put(desk / "card.sdl", "square");
  desk.refuses("convert scene.sdl scene.sdl", "this file would replace scene.sdl");
  desk.refuses("convert scene.sdl card.sdl", "this file would replace card.sdl");
  CHECK(test::content(desk / "scene.sdl") == text);
  CHECK(test::content(desk / "card.sdl") == "square");
  desk.refuses("convert scene.sdl scene.exr", "should end in .sdl");
  desk.run("convert scene.sdl other.sdl");
}
