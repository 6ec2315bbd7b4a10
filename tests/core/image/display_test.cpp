#include "core/image/display.h"

#include "spectral/illuminant.h"
#include "tests/catch.h"

#include <cmath>
#include <stdexcept>

using namespace abbe;

namespace {

void check_equal(const LinearRgb& a, const LinearRgb& b, double margin) {
  CHECK(a.r == Approx(b.r).margin(margin));
  CHECK(a.g == Approx(b.g).margin(margin));
  CHECK(a.b == Approx(b.b).margin(margin));
}

} // namespace

TEST_CASE("without a white point, what is, is shown") {
  const DisplayTransform srgb({}, Observer::cie1931_2deg);
  const Xyz orange = to_xyz(LinearRgb{0.8, 0.4, 0.1});
  check_equal(srgb.linear(orange), {0.8, 0.4, 0.1}, 1e-13);
  CHECK(srgb.encoded({0.5, 0.0, 1.0}).r == Approx(0.7353569830524495).epsilon(1e-13));
  // The same light on another display has other numbers and is the same colour.
  DisplaySettings settings;
  settings.space = find_color_space("display-p3").value();
  const LinearRgb p3 = DisplayTransform(settings, Observer::cie1931_2deg).linear(orange);
  const Vector3 xyz = multiply(rgb_to_xyz_matrix(settings.space.primaries, settings.space.white),
                               Vector3{p3.r, p3.g, p3.b});
  CHECK(xyz[0] == Approx(orange.x).epsilon(1e-12));
  CHECK(xyz[1] == Approx(orange.y).epsilon(1e-12));
  CHECK(xyz[2] == Approx(orange.z).epsilon(1e-12));
  CHECK(p3.r < 0.8);
}

TEST_CASE("a white point becomes the white of every display") {
  for (const Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    for (const char* light : {"A", "D50", "FL2"})
      for (const ColorSpace& space : color_spaces()) {
        INFO(light << " on " << space.name);
        DisplaySettings settings;
        settings.space = space;
        settings.white_point = WhitePoint::of_light(*find_illuminant(light));
        const Xyz white = to_xyz(*find_illuminant(light), observer);
        const LinearRgb seen = DisplayTransform(settings, observer).linear(white * (0.5 / white.y));
        check_equal(seen, {0.5, 0.5, 0.5}, 1e-12);
      }
}

TEST_CASE("exposure acts before the gamut, the transfer function after it") {
  DisplaySettings settings;
  settings.exposure_ev = 2.0;
  settings.transfer = power_transfer(2.2);
  const DisplayTransform transform(settings, Observer::cie1931_2deg);
  check_equal(transform.linear(to_xyz(LinearRgb{0.1, 0.2, 0.05})), {0.4, 0.8, 0.2}, 1e-13);
  settings.gamut = GamutMapping::scale;
  settings.exposure_ev = 1.0;
  // The thesis's example at half its light: shifted and scaled, then raised to 1 / 2.2.
  const DisplayTransform thesis(settings, Observer::cie1931_2deg);
  const LinearRgb scaled = thesis.linear(to_xyz(LinearRgb{0.2, -0.3, 0.6}));
  check_equal(scaled, {5.0 / 9.0, 0.0, 1.0}, 1e-12);
  const DisplayRgb code = thesis.encoded(scaled);
  CHECK(code.r == Approx(0.765538511).margin(1e-9)); // printed as 0.766
  CHECK(code.g == Approx(0.0).margin(1e-6));
  CHECK(code.b == Approx(1.0).margin(1e-12));
}

TEST_CASE("the tone curve acts after the exposure, and the gamut mapping none changes nothing") {
  DisplaySettings settings;
  settings.exposure_ev = 1.0;
  settings.tone = ToneCurve::filmic;
  const DisplayTransform transform(settings, Observer::cie1931_2deg);
  const double shown = tone(ToneCurve::filmic, 3.0);
  check_equal(transform.linear(to_xyz(LinearRgb{1.5, 1.5, 1.5})), {shown, shown, shown}, 1e-12);
  settings.tone = ToneCurve::linear;
  settings.gamut = GamutMapping::none;
  const DisplayTransform plain(settings, Observer::cie1931_2deg);
  check_equal(plain.linear(to_xyz(LinearRgb{1.5, -0.25, 0.1})), {3.0, -0.5, 0.2}, 1e-12);
}

TEST_CASE("CAT16 takes a white point to white, and other colours another way than Bradford") {
  DisplaySettings settings;
  settings.white_point = WhitePoint::of_light(*find_illuminant("A"));
  const Xyz white = to_xyz(*find_illuminant("A")), red{0.4, 0.25, 0.05};
  const LinearRgb before = DisplayTransform(settings, Observer::cie1931_2deg).unclipped(red);
  settings.adaptation = AdaptationMethod::cat16;
  const DisplayTransform transform(settings, Observer::cie1931_2deg);
  check_equal(transform.linear(white * (0.5 / white.y)), {0.5, 0.5, 0.5}, 1e-12);
  CHECK(std::abs(transform.unclipped(red).r - before.r) > 1e-3);
}

TEST_CASE("the encoding of a display is that of its space unless another is chosen") {
  DisplaySettings settings;
  CHECK(encoding_of(settings) == DisplayEncoding{});
  settings.space = find_color_space("ntsc").value();
  CHECK(encoding_of(settings).transfer == power_transfer(2.2));
  settings.transfer = linear_transfer();
  CHECK(encoding_of(settings) == DisplayEncoding{settings.space, linear_transfer()});
}

TEST_CASE("a white point that cannot be white is refused") {
  DisplaySettings settings;
  settings.white_point = WhitePoint::at({0.1, 0.01});
  CHECK_THROWS_AS(DisplayTransform(settings, Observer::cie1931_2deg), std::invalid_argument);
}
