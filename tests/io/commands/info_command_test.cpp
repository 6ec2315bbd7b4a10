#include "tests/catch.h"
#include "tests/io/foreign_exr.h"
#include "tests/io/run_program.h"

using namespace abbe;
using test::Desk;

TEST_CASE("info tells what a picture holds") {
  const Desk desk;
  test::put(desk / "s.sdl", "imageSize 16 12 samples 2 bands 9 light E 2 3 4 1 sphere\n");
  (void)desk.run("render s.sdl -q -o a.exr -o a.png -o a.tif --spectral a.cube.exr "
                 "--crop 2,3,10,9");
  const std::string cube = desk.run("info a.cube.exr");
  CHECK(cube.starts_with("a.cube.exr: a picture, OpenEXR\n"
                         "pixels: 8 x 6 pixels, x 2 to 9, y 3 to 8\n"
                         "whole frame: 16 x 12 pixels, x 0 to 15, y 0 to 11\n"
                         "channels: A B G R (float)\n"
                         "bands: 9, from 400 to 760 nm\n"));
  CHECK(cube.find("\nabbe/samples: 2\n") != std::string::npos);
  CHECK(desk.run("info a.exr").find("channels: A B G R (half)\n") != std::string::npos);
  CHECK(desk.run("info a.png").find("channels: R G B (8 bits)\n") != std::string::npos);
  CHECK(desk.run("info a.png")
            .find("pixels: 8 x 6 pixels, x 2 to 9, y 3 to 8\n"
                  "whole frame: 16 x 12 pixels, x 0 to 15, y 0 to 11\n") != std::string::npos);
  CHECK(desk.run("info a.tif").starts_with("a.tif: a picture, TIFF\n"));
}

TEST_CASE("info refuses what it cannot read") {
  const Desk desk;
  desk.refuses("info none.exr", "there is no file none.exr");
  test::put(desk / "text.png", "text");
  desk.refuses("info text.png", "text.png cannot be read: ");
  test::put(desk / "text.state", "text");
  CHECK(desk.abbe("info text.state").exit_code != 0);
}
