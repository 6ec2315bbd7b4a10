#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>

using namespace abbe;

namespace {

/// Radiance behind a slab 2 units thick whose index is that of the air, so that only its
/// absorption is seen, before a background of radiance 1.
double through_slab(const std::string& unit) {
  const Scene scene = test::scene_from("background E 1 " + unit +
                                       "\neye 0 0 500 lookAt 0 0 0 fieldOfView 0.001\n"
                                       "imageSize 1 1 samples 4\n"
                                       "defaultMaterials reflectivity 1 transparency 1\n"
                                       "speedOfLight 1 absorption 0.3 cube\n");
  return test::render_scene(scene, true).film.radiance(0, 0, 40);
}

} // namespace

// Beer-Lambert: exp(-0.3 / mm * length).
TEST_CASE("light falls off exponentially in an absorbing medium, per millimetre") {
  CHECK(through_slab("unit mm") == Approx(std::exp(-0.3 * 2.0)).epsilon(1e-5));
  CHECK(through_slab("unit cm") == Approx(std::exp(-0.3 * 20.0)).epsilon(1e-5));
}
