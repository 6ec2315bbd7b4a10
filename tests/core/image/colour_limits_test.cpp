// Colours at the limits on their way to a screen: single wavelengths, which no screen shows, no
// light, nearly none and very much, through every observer, colour space, white point, gamut
// mapping, transfer function and exposure.

#include "core/image/display.h"
#include "spectral/illuminant.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace abbe;

namespace {

/// Colours of luminance about 1: wavelengths, whites, and colours that no light has.
std::vector<Xyz> colours(Observer observer) {
  std::vector<Xyz> all;
  for (const double nm : {380.0, 420.0, 460.0, 480.0, 505.0, 530.0, 555.0, 590.0, 650.0, 780.0})
    all.push_back(to_xyz(Curve::lines({{nm, 1.0}}), observer));
  for (const char* light : {"D65", "A", "FL2", "E"})
    all.push_back(to_xyz(*find_illuminant(light), observer));
  all.push_back(to_xyz(LinearRgb{-0.5, 1.0, -0.5}));
  all.push_back(to_xyz(LinearRgb{-1.0, -1.0, -1.0}));
  all.push_back(to_xyz(LinearRgb{1.0, -0.3, -0.3}));
  return all;
}

std::vector<TransferFunction> transfers() {
  std::vector<TransferFunction> all;
  for (const std::string& name : transfer_names())
    all.push_back(find_transfer(name).value());
  for (const double gamma : {0.1, 1.0, 2.2, 10.0})
    all.push_back(power_transfer(gamma));
  return all;
}

std::vector<std::optional<WhitePoint>> white_points() {
  std::vector<std::optional<WhitePoint>> all{std::nullopt, WhitePoint::at({0.3127, 0.3290})};
  for (const std::string& name : illuminant_names())
    all.emplace_back(WhitePoint::of_light(*find_illuminant(name)));
  return all;
}

constexpr double kStrengths[] = {0.0, 1e-30, 1e-8, 0.5, 1.0, 1e8, 1e30};
constexpr GamutMapping kMappings[] = {GamutMapping::clip, GamutMapping::scale,
                                      GamutMapping::desaturate};

/// Values that a screen takes: from 0 to 1, hence numbers.
bool is_code(const DisplayRgb& c) {
  return std::min({c.r, c.g, c.b}) >= 0.0 && std::max({c.r, c.g, c.b}) <= 1.0;
}

} // namespace

TEST_CASE("every colour at every strength comes to a screen as numbers from 0 to 1") {
  int count = 0;
  for (const Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    for (const ColorSpace& space : color_spaces())
      for (const auto& white : white_points())
        for (const GamutMapping gamut : kMappings)
          for (const double exposure : {-64.0, 0.0, 64.0}) {
            DisplaySettings settings;
            settings.space = space;
            settings.white_point = white;
            settings.gamut = gamut;
            settings.exposure_ev = exposure;
            const DisplayTransform transform(settings, observer);
            for (const Xyz& colour : colours(observer))
              for (const double strength : kStrengths) {
                const LinearRgb raw = transform.unclipped(colour * strength);
                const LinearRgb linear = transform.linear(colour * strength);
                const DisplayRgb code = transform.encoded(linear);
                ++count;
                if (std::isfinite(raw.r + raw.g + raw.b) && is_code(code)) continue;
                CAPTURE(space.name, gamut, exposure, strength, colour.x, colour.y, colour.z);
                CAPTURE(linear.r, linear.g, linear.b, code.r, code.g, code.b);
                FAIL("a value that no screen takes");
              }
          }
  CHECK(count > 1000000);
}

TEST_CASE("no light is black, and endless light white or the screen's purest colour") {
  for (const ColorSpace& space : color_spaces())
    for (const GamutMapping gamut : kMappings) {
      CAPTURE(space.name, gamut);
      DisplaySettings settings;
      settings.space = space;
      settings.gamut = gamut;
      const DisplayTransform transform(settings, Observer::cie1931_2deg);
      const LinearRgb black = transform.linear({0.0, 0.0, 0.0});
      CHECK(std::max({black.r, black.g, black.b}) == 0.0);
      const LinearRgb bright = transform.linear(to_xyz(space.white, 1e30));
      CHECK(std::max({bright.r, bright.g, bright.b}) == 1.0);
      const LinearRgb faint = transform.linear(to_xyz(space.white, 1e-30));
      CHECK(faint.g == Approx(1e-30).epsilon(1e-9));
      if (gamut == GamutMapping::desaturate)
        CHECK(transform.linear({1e30, 1e30, 0.0}) == LinearRgb{1.0, 1.0, 1.0});
    }
}

TEST_CASE("transfer functions rise from 0 to 1, without a step, and are undone at any strength") {
  for (const TransferFunction& transfer : transfers()) {
    CAPTURE(transfer.name);
    CHECK(encode(transfer, 0.0) == 0.0);
    CHECK(encode(transfer, 1.0) == Approx(1.0).epsilon(1e-14));
    double last = 0.0;
    for (double light = 1e-30; light < 2e30; light *= 1.5) {
      const double code = encode(transfer, light);
      REQUIRE(std::isfinite(code));
      REQUIRE(code > last);
      REQUIRE(encode(transfer, -light) == -code);
      REQUIRE(decode(transfer, code) == Approx(light).epsilon(1e-9));
      last = code;
    }
  }
}
