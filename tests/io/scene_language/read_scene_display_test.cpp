#include "spectral/color_space.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"

using namespace abbe;

TEST_CASE("a scene is shown on sRGB, without adaptation, by the observer of 1931") {
  const Scene scene = scene_of("");
  CHECK(scene.display.space == srgb_space());
  CHECK(scene.display.gamut == GamutMapping::desaturate);
  CHECK_FALSE(scene.display.transfer.has_value());
  CHECK_FALSE(scene.display.white_point.has_value());
  CHECK(scene.settings.observer == Observer::cie1931_2deg);
}

TEST_CASE("display keywords") {
  CHECK(scene_of("display Display-P3").display.space.name == "Display P3");
  CHECK(scene_of("display p22").display.space.name == "SMPTE-C");
  CHECK(scene_of("display \"NTSC 1953\"").display.space.name == "NTSC 1953");
  CHECK(scene_of("transfer 2.2").display.transfer == power_transfer(2.2));
  CHECK(scene_of("transfer Rec2020").display.transfer == find_transfer("rec709"));
  CHECK(scene_of("transfer linear").display.transfer == linear_transfer());
  CHECK(scene_of("gamut clip").display.gamut == GamutMapping::clip);
  CHECK(scene_of("gamut scale").display.gamut == GamutMapping::scale);
  CHECK(scene_of("gamut clip gamut desaturate").display.gamut == GamutMapping::desaturate);
  CHECK(scene_of("whitePoint 0.3457 0.3585").display.white_point ==
        WhitePoint::at({0.3457, 0.3585}));
  CHECK_FALSE(scene_of("whitePoint A whitePoint none").display.white_point.has_value());
  const auto a = scene_of("whitePoint a").display.white_point;
  REQUIRE(a.has_value());
  CHECK(a->cie1931_2deg.x == Approx(0.44758).margin(5.1e-5));
  CHECK(a->cie1964_10deg.y == Approx(0.40594).margin(2e-4));
  CHECK(scene_of("observer 10deg").settings.observer == Observer::cie1964_10deg);
  CHECK(scene_of("observer 2deg").settings.observer == Observer::cie1931_2deg);
}

TEST_CASE("errors of display keywords") {
  CHECK(scene_error("display srbg") ==
        "s.sdl:1:9: unknown display \"srbg\" (no such colour space). Did you mean srgb?");
  CHECK(scene_error("display television") ==
        "s.sdl:1:9: unknown display \"television\" (no such colour space). Give one of srgb, "
        "rec709, display-p3, p3, dci-p3, rec2020, adobe-rgb, aces2065-1, acescg, prophoto, ntsc, "
        "smpte-c, p22, ebu, pal, cie-rgb, wide-gamut, smpte-240m, apple-rgb, colormatch");
  CHECK(scene_error("transfer logarithm") ==
        "s.sdl:1:10: unknown transfer function \"logarithm\" (it is a name or a gamma from 0.1 to "
        "10). Give one of rec2020, linear, srgb, rec709, smpte240m, romm, or a gamma");
  CHECK(scene_error("transfer 0") == "s.sdl:1:10: 0 is out of range for transfer (it is the "
                                     "display's gamma). Give a number from 0.1 to 10");
  CHECK(scene_error("whitePoint D66") == "s.sdl:1:12: unknown white point \"D66\" (no such "
                                         "illuminant). Did you mean D65?");
  CHECK(scene_error("whitePoint moonshine") ==
        "s.sdl:1:12: unknown white point \"moonshine\" (no such illuminant). Give an illuminant "
        "such as D50, x y, or none");
  CHECK(scene_error("whitePoint 0.1 0.01") ==
        "s.sdl:1:12: 0.1 0.01 is no white (no eye can adapt to this chromaticity). Give x y such "
        "as 0.3457 0.3585");
  CHECK(scene_error("whitePoint 0.3") ==
        "s.sdl:1:15: the file ends where a number should stand (whitePoint takes NAME | x y | "
        "none). Complete the statement");
  CHECK(scene_error("gamut compress") == "s.sdl:1:7: \"compress\" is no choice of gamut (gamut "
                                         "takes clip|scale|desaturate|none). Give "
                                         "clip, scale, desaturate or none");
  CHECK(scene_error("observer 5deg") == "s.sdl:1:10: \"5deg\" is no choice of observer (observer "
                                        "takes 2deg|10deg). Give 2deg or 10deg");
  CHECK(scene_error("display {") ==
        "s.sdl:1:9: \"{\" stands where the name of a display should (display takes NAME). Give a "
        "name; one with spaces goes in double quotes");
}
