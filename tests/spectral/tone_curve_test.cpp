#include "spectral/tone_curve.h"

#include "tests/catch.h"

#include <limits>

using namespace abbe;

TEST_CASE("the linear curve changes nothing") {
  CHECK(tone(ToneCurve::linear, -2.5) == -2.5);
  CHECK(tone(ToneCurve::linear, 17.0) == 17.0);
  CHECK(with_tone({0.2, -0.5, 40.0}, ToneCurve::linear, srgb_luminance_weights()) ==
        LinearRgb{0.2, -0.5, 40.0});
}

TEST_CASE("the filmic curve is Hable's") {
  // By hand: h(0.36) = 0.04144 / 0.25944 - 1/15 = 0.0930622 and h(11.2) = 19.38 / 24.476 - 1/15 =
  // 0.7251353; h(2) = 0.704 / 1.66 - 1/15 = 0.3574297.
  CHECK(tone(ToneCurve::filmic, 0.0) == 0.0);
  CHECK(tone(ToneCurve::filmic, 0.18) == Approx(0.0930622 / 0.7251353).epsilon(1e-5));
  CHECK(tone(ToneCurve::filmic, 1.0) == Approx(0.3574297 / 0.7251353).epsilon(1e-5));
  CHECK(tone(ToneCurve::filmic, 5.6) == 1.0);
  CHECK(tone(ToneCurve::filmic, 1e300) == 1.0);
  CHECK(tone(ToneCurve::filmic, std::numeric_limits<double>::infinity()) == 1.0);
}

TEST_CASE("the filmic curve ascends without a step, below 0 too") {
  double before = tone(ToneCurve::filmic, -1.0);
  for (double luminance = -1.0 + 0.001; luminance < 6.0; luminance += 0.001) {
    const double value = tone(ToneCurve::filmic, luminance);
    CHECK(value >= before);
    CHECK(value - before < 0.001);
    before = value;
  }
  // The tangent at 0: the same slope on both sides.
  CHECK(-tone(ToneCurve::filmic, -1e-7) == Approx(tone(ToneCurve::filmic, 1e-7)).epsilon(1e-5));
}

TEST_CASE("a tone curve keeps the chromaticity") {
  const LinearRgb toned = with_tone({4.0, 1.0, 0.5}, ToneCurve::filmic, srgb_luminance_weights());
  CHECK(toned.r / toned.g == Approx(4.0));
  CHECK(toned.g / toned.b == Approx(2.0));
  CHECK(luminance(toned) == Approx(tone(ToneCurve::filmic, luminance(LinearRgb{4.0, 1.0, 0.5}))));
  // A colour outside of all displays, with no luminance, is neither infinite nor lost.
  const Vector3& w = srgb_luminance_weights();
  const LinearRgb none = with_tone({1.0, -w[0] / w[1], 0.0}, ToneCurve::filmic, w);
  CHECK(none.r > 0.3);
  CHECK(none.r < 1.0);
}
