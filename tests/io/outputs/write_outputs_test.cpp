// What render writes beside the pictures that it is told to write.

#include "io/images/read_exr.h"
#include "tests/catch.h"
#include "tests/io/run_program.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace abbe;
using test::Desk;
namespace fs = std::filesystem;

namespace {

/// A desk with a small scene of a ball of glass under two lights.
struct Scene : Desk {
  Scene() {
    std::ofstream(*this / "s.sdl")
        << "imageSize 8 6 samples 2 bands 9 eye 0 0 9 integrator path intensity 30 falloff square\n"
           "lightGroup key light E 4 3 5 1 lightGroup fill light E -4 1 5 1\n"
           "defaultMaterials ambient 0 0 0 diffuse 0.5 0.6 0.7\n"
           "push translate 0 0 -2 scale 6 6 1 square pop glass N-SF11 sphere\n";
  }
};

} // namespace

TEST_CASE("the images of all bands add up to the picture") {
  const Scene desk;
  desk.run("render s.sdl -q -o a.exr --exr-pixel float --band-images");
  const ExrImage whole = read_exr_image(desk / "a.exr");
  std::vector<double> sum(whole.rgb.size());
  for (int b = 1; b <= 9; ++b) {
    const ExrImage band = read_exr_image(desk / ("a.band00" + std::to_string(b) + ".exr"));
    REQUIRE(band.rgb.size() == sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += static_cast<double>(band.rgb[i]);
  }
  CHECK_FALSE(fs::exists(desk / "a.band010.exr"));
  double worst = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    worst = std::max(worst, std::abs(sum[i] - static_cast<double>(whole.rgb[i])));
    mean += static_cast<double>(whole.rgb[i]) / static_cast<double>(sum.size());
  }
  CHECK(mean > 0.0);
  CHECK(worst < 2e-6 * mean);
  // Parts keep them, too.
  desk.run("render s.sdl -q --part 1/2 --adaptive off -o 1.state --band-images");
  desk.run("render s.sdl -q --part 2/2 --adaptive off -o 2.state --band-images");
  desk.run("merge 1.state 2.state -q -o m.exr --exr-pixel float");
  CHECK(read_exr_image(desk / "m.band004.exr").rgb == read_exr_image(desk / "a.band004.exr").rgb);
}

TEST_CASE("layers have files of their own, whose names are checked before the work") {
  const Scene desk;
  desk.run("render s.sdl -q -o a.exr --layers depth,object,light:* --layer-files --relightable");
  for (const char* name :
       {"a.exr", "a.depth.exr", "a.CryptoObject.exr", "a.light_key.exr", "a.light.fill.exr"}) {
    CAPTURE(name);
    CHECK(fs::exists(desk / name));
  }
  fs::create_directory(desk / "b.depth.exr");
  desk.refuses("render s.sdl -q -o b.exr --layers depth --layer-files", "b.depth.exr");
  CHECK_FALSE(fs::exists(desk / "b.exr"));
  fs::create_directory(desk / "c.light.key.exr");
  desk.refuses("render s.sdl -q -o c.exr --relightable", "c.light.key.exr");
  fs::create_directory(desk / "d.band003.exr");
  desk.refuses("render s.sdl -q -o d.exr --band-images", "d.band003.exr");
  desk.refuses("render s.sdl -q -o e.exr -o e.depth.exr --layers depth --layer-files",
               "two outputs would have this name");
}

TEST_CASE("a crop in its full frame is black around its pixels, in each format") {
  const Scene desk;
  desk.run("render s.sdl -q -o a.exr -o a.png -o a.tif --spectral s.exr --full-frame "
           "--crop 2,1,6,5 --exr-pixel float");
  desk.run("render s.sdl -q -o b.exr --crop 2,1,6,5 --exr-pixel float");
  const ExrImage all = read_exr_image(desk / "a.exr"), part = read_exr_image(desk / "b.exr");
  REQUIRE(all.width == 8);
  REQUIRE(part.width == 4);
  bool inside = true, black = true;
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x)
      for (int c = 0; c < 3; ++c) {
        const float value = all.rgb[static_cast<std::size_t>(3 * (8 * y + x) + c)];
        const bool in_part = x >= 2 && x < 6 && y >= 1 && y < 5;
        if (in_part)
          inside =
              inside && value == part.rgb[static_cast<std::size_t>(3 * (4 * (y - 1) + x - 2) + c)];
        else
          black = black && value == 0.0f;
      }
  CHECK(inside);
  CHECK(black);
  for (const char* name : {"a.png", "a.tif", "s.exr"}) {
    CAPTURE(name);
    CHECK(desk.run("info " + std::string(name)).find("8 x 6") != std::string::npos);
  }
}
