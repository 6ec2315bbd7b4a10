#include "io/images/ocio_look.h"

#include "core/scene/user_error.h"
#include "tests/catch.h"
#include "tests/io/run_program.h"

#include <fstream>
#include <string>

using namespace abbe;
using test::Desk;

namespace {

/// A configuration whose view "film" takes the square root of light, and "double" twice that.
std::string config(const std::string& input) {
  const auto space = [](const std::string& name, const std::string& more) {
    return "  - !<ColorSpace>\n    name: " + name + "\n    isdata: false\n" + more;
  };
  const std::string root = "!<ExponentTransform> {value: [2, 2, 2, 1], direction: inverse}";
  const std::string twice = "!<MatrixTransform> {matrix: [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}";
  return "ocio_profile_version: 1\nsearch_path: \"\"\nroles:\n  default: raw\n"
         "displays:\n  screen:\n    - !<View> {name: film, colorspace: out}\n"
         "    - !<View> {name: double, colorspace: out2}\n"
         "active_displays: []\nactive_views: []\ncolorspaces:\n" +
         space("raw", "") + space(input, "") + space("out", "    from_reference: " + root + "\n") +
         space("out2", "    from_reference: !<GroupTransform>\n      children:\n        - " + root +
                           "\n        - " + twice + "\n");
}

struct Looks {
  Desk desk;
  explicit Looks(const std::string& input = "lin_rec709_scene") {
    std::ofstream(desk / "c.ocio") << config(input);
  }
  [[nodiscard]] OcioLook look(const std::string& display = "", const std::string& view = "") const {
    return {desk / "c.ocio", display, view};
  }
};

std::string mistake(const OcioLook& look) {
  try {
    const OcioTransform transform(look);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a view of a configuration makes the picture for screens") {
  if (!has_ocio()) return;
  const Looks looks;
  const PixelWindow window{0, 0, 1, 1};
  const SceneLinearImage image{window, window, {0.0625f, 0.25f, 1.0f, 1.0f}, {}};
  const OcioTransform film(looks.look());
  CHECK(film.space() == SceneLinearSpace::rec709);
  const DisplayImage first = ocio_picture(film, image, {});
  REQUIRE(first.encoded.size() == 3);
  CHECK(first.encoded[0] == Approx(0.25).epsilon(1e-4));
  CHECK(first.encoded[1] == Approx(0.5).epsilon(1e-4));
  CHECK(first.encoded[2] == Approx(1.0).epsilon(1e-4));
  // Codes of the display that is told: IEC 61966-2-1.
  CHECK(first.linear[1] == Approx(std::pow((0.5 + 0.055) / 1.055, 2.4)).epsilon(1e-3));
  DisplaySettings brighter;
  brighter.exposure_ev = 2.0;
  const DisplayImage second =
      ocio_picture(OcioTransform(looks.look("screen", "double")), image, brighter);
  CHECK(second.encoded[0] == Approx(1.0).epsilon(1e-4));
}

TEST_CASE("a configuration that cannot be used is told") {
  if (!has_ocio()) {
    CHECK(mistake({"c.ocio"}).find("libopencolorio-dev") != std::string::npos);
    return;
  }
  const Looks looks;
  const auto has = [](const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
  };
  CHECK(mistake(looks.look()).empty());
  CHECK(has(mistake(looks.look("cinema")), "no display \"cinema\"; it has: screen"));
  CHECK(has(mistake(looks.look("screen", "log")), "no view \"log\"; it has: film, double"));
  CHECK(has(mistake(Looks("unheard-of").look()), "aces_interchange"));
  CHECK(has(mistake({looks.desk / "none.ocio"}), "none.ocio"));
}

TEST_CASE("render and develop take a configuration, and refuse half of one") {
  const Looks looks;
  const Desk& desk = looks.desk;
  std::ofstream(desk / "s.sdl") << "imageSize 4 4 samples 1 background E 0.25\n";
  desk.refuses("render s.sdl -o a.png --ocio-view film", "need a configuration. Give --ocio FILE");
  if (!has_ocio()) {
    desk.refuses("render s.sdl -o a.png --ocio c.ocio", "this build has no OpenColorIO");
    return;
  }
  desk.run("render s.sdl -o a.png -o a.exr --exr-pixel float --ocio c.ocio");
  desk.run("develop a.exr -o b.png --ocio c.ocio");
  CHECK(test::content(desk / "a.png") != test::content(desk / "a.exr"));
  CHECK(desk.run("diff a.png b.png --tolerance 1e-6").find("RMSE") != std::string::npos);
  const test::Outcome warned =
      desk.abbe("develop a.exr -o b.png --ocio c.ocio --tone filmic --gamut clip");
  CHECK(warned.error.find("--tone has no effect (--ocio makes the picture)") != std::string::npos);
  CHECK(warned.error.find("--gamut has no effect") != std::string::npos);
}
