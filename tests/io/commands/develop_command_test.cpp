#include "io/images/read_picture.h"
#include "spectral/illuminant.h"
#include "tests/catch.h"
#include "tests/io/foreign_exr.h"
#include "tests/io/run_program.h"

#include <fmt/format.h>

using namespace abbe;
using test::Desk;

namespace {

const char* const kScene = "imageSize 24 16 samples 4 background E 0.5 light E 2 3 4 1\n"
                           "glass N-SF11 sphere\n";

std::vector<float> colors(const std::filesystem::path& path) {
  return read_picture(path, {}).rgb;
}

void check_near(const std::vector<float>& a, const std::vector<float>& b, double margin) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    CHECK(a[i] == Approx(b[i]).margin(margin));
}

} // namespace

TEST_CASE("develop makes of an EXR the pictures that render makes") {
  const Desk desk;
  test::put(desk / "s.sdl", kScene);
  for (const char* look :
       {"", " --exposure 1 --gamut scale --display display-p3",
        " --white-point A --adaptation cat16 --tone filmic", " --transfer 2.2 --gamut none"}) {
    INFO(look);
    const std::string options = std::string(look) + " --exr-pixel float --tiff-depth 16";
    (void)desk.run("render s.sdl -q -o r.exr -o r.png -o r.tif --spectral r.cube.exr" + options);
    (void)desk.run("develop r.exr -o d.exr -o d.png -o d.tif" + options);
    CHECK(test::content(desk / "d.exr") == test::content(desk / "r.exr"));
    check_near(colors(desk / "d.tif"), colors(desk / "r.tif"), 1e-4);
    // The spectral EXR has the same colours.
    (void)desk.run("develop r.cube.exr -o c.tif" + options);
    check_near(colors(desk / "c.tif"), colors(desk / "r.tif"), 1e-4);
    // And so have its bands, by the observer of the rendering.
    (void)desk.run("develop r.cube.exr --observer 2deg -o o.tif" + options);
    check_near(colors(desk / "o.tif"), colors(desk / "r.tif"), 2e-3);
  }
}

TEST_CASE("develop shows bands to the other observer") {
  const Desk desk;
  const Curve d65 = *find_illuminant("D65");
  std::vector<test::ForeignChannel> channels;
  for (int nm = 380; nm <= 780; nm += 5)
    channels.push_back({fmt::format("S0.{}nm", nm), {static_cast<float>(d65.at(nm))}});
  test::write_foreign_exr(desk / "d65.exr", 1, 1, channels);
  (void)desk.run("develop d65.exr --observer 10deg --exr-pixel float -o o.exr");
  const std::vector<float> rgb = colors(desk / "o.exr");
  const Chromaticity seen = chromaticity(to_xyz(LinearRgb{rgb[0], rgb[1], rgb[2]}));
  CHECK(seen.x == Approx(0.3138).margin(1e-4)); // [CIE15]
  CHECK(seen.y == Approx(0.3310).margin(1e-4));
}

TEST_CASE("develop exposes, and lets a floating-point TIFF out of the gamut") {
  const Desk desk;
  test::write_foreign_exr(desk / "a.exr", 2, 1,
                          {{"R", {0.25F, 2.0F}}, {"G", {0.25F, -0.25F}}, {"B", {0.25F, 0.0F}}});
  (void)desk.run("develop a.exr --exposure 1 --tiff-depth 32 --gamut none -o a.tif -o a.png");
  check_near(colors(desk / "a.tif"), {0.5F, 0.5F, 0.5F, 4.0F, -0.5F, 0.0F}, 1e-4);
  check_near(colors(desk / "a.png"), {0.5F, 0.5F, 0.5F, 1.0F, 0.0F, 0.0F}, 3e-3);
  // Hable's curve: h(0.5) / h(11.2) of the luminance 0.25. By hand: h(0.5) = 0.0665 / 0.3475 -
  // 1/15 = 0.1247002 and h(11.2) = 0.7251353.
  (void)desk.run("develop a.exr --tone filmic --png-depth 16 -o f.png");
  CHECK(colors(desk / "f.png")[0] == Approx(0.1247002 / 0.7251353).margin(1e-3));
}

TEST_CASE("develop keeps alpha, the window, and what the rendering says of itself") {
  const Desk desk;
  test::put(desk / "s.sdl", kScene);
  (void)desk.run("render s.sdl -q -o r.exr --sky transparent --crop 3,2,20,14");
  (void)desk.run("develop r.exr -q -o d.exr --exr-space acescg -o d.png");
  const Picture before = read_picture(desk / "r.exr", {.alpha = true});
  const Picture after = read_picture(desk / "d.exr", {.alpha = true});
  CHECK(after.header.data == PixelWindow{3, 2, 20, 14});
  CHECK(after.header.display == before.header.display);
  REQUIRE_FALSE(before.alpha.empty());
  CHECK(after.alpha == before.alpha);
  check_near(after.rgb, before.rgb, 2e-3); // two roundings to half floats
  const Metadata& png = read_picture_header(desk / "d.png").metadata;
  const auto has = [&](const char* name, const char* value) {
    return std::find(png.begin(), png.end(), std::pair<std::string, std::string>(name, value)) !=
           png.end();
  };
  CHECK(has("abbe/samples", "4"));
  CHECK(has("abbe/exposure", "0"));
}

TEST_CASE("develop refuses what is wrong, and warns of what has no effect") {
  const Desk desk;
  test::write_foreign_exr(desk / "a.exr", 1, 1, {{"Y", {0.5F}}});
  test::write_foreign_exr(desk / "z.exr", 1, 1, {{"Z", {0.5F}}});
  desk.refuses("develop a.exr", "--output is required");
  desk.refuses("develop none.exr -o b.png", "there is no file none.exr");
  desk.refuses("develop a.exr -o a.exr", "would replace the one that it is made of");
  desk.refuses("develop a.exr -o b.jpg", "no picture can be written under this name");
  desk.refuses("develop a.exr -o b.png -o b.png", "two outputs would have this name");
  desk.refuses("develop z.exr -o b.png", "it has neither channels R, G and B");
  desk.refuses("develop a.exr --observer 2deg -o b.png", "it has no bands");
  desk.refuses("develop a.exr --tone log -o b.png", "--tone");
  desk.refuses("develop a.exr --adaptation sharp -o b.png", "--adaptation");
  CHECK(desk.abbe("develop a.exr --tone filmic -o b.exr").error ==
        "warning: --tone has no effect (no TIFF and no PNG is written)\n");
  CHECK(desk.abbe("develop a.exr --adaptation cat16 -o b.png").error ==
        "warning: --adaptation has no effect without --white-point\n");
}
