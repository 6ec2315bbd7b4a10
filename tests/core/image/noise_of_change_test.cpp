#include "core/image/relight.h"
#include "spectral/illuminant.h"
#include "tests/catch.h"

#include <cmath>

using namespace abbe;

TEST_CASE("a lamp of equal energy adds no noise, and one band alone has noise where it had none") {
  const BandGrid grid(81);
  const auto noise = [&](const Curve& lamp) {
    return noise_of_change(grid, lamp, Observer::cie1931_2deg);
  };
  CHECK(noise(Curve::constant(1.0)) == 1.0);
  CHECK(noise(Curve::constant(0.25)) == Approx(1.0).epsilon(1e-12));
  CHECK(noise(Curve::constant(0.0)) == 1.0);
  CHECK(std::isinf(noise(Curve::lines({{550.0, 1.0}}))));
  // Lamps with much light in few bands add more than smooth ones.
  CHECK(noise(find_illuminant("D65").value()) < 1.1);
  CHECK(noise(find_illuminant("FL11").value()) > 1.3);
}
