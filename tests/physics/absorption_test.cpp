#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <string>

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

// Beer-Lambert along both ways, 2 from the lamp to the card and 5 from there to the eye. A lamp
// that does not fall off shows a diffuse card at normal incidence as bright as reflectance times
// lamp.
TEST_CASE(
    "light between a lamp, a card and an eye in one absorbing medium falls off on both ways") {
  for (const std::string integrator : {"whitted", "path"})
    for (const ShadowRule rule : {ShadowRule::opaque, ShadowRule::attenuated}) {
      Scene scene = test::scene_from("integrator " + integrator +
                                     " maxRecursionDepth 1 background 0 0 0 light E 0 0 2 1\n"
                                     "eye 3 0 4 lookAt 0 0 0 fieldOfView 0.001 imageSize 1 1\n"
                                     "defaultMaterials ambient 0 0 0 specular 0 0 0\n"
                                     "diffuse 0.5 0.5 0.5 square\n"
                                     "defaultMaterials reflectivity 1 transparency 1\n"
                                     "speedOfLight 0.7 absorption 0.1 scale 9 9 9 cube\n");
      scene.settings.shadows = rule;
      CAPTURE(integrator, static_cast<int>(rule));
      CHECK(test::render_scene(scene, true).film.radiance(0, 0, 40) ==
            Approx(0.5 * std::exp(-0.1 * 7.0)).epsilon(1e-4));
    }
}
