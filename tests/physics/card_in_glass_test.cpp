#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/render_text.h"

using namespace abbe;

// A card that glows with radiance 1 in all bands, embedded in a block of glass and seen straight
// on through its face. A pencil of rays that leaves glass widens: its radiance falls by n^2, and
// Fresnel takes R0 = ((n-1)/(n+1))^2. What the face throws back meets the card, which reflects
// nothing. So the camera sees (1 - R0) / n^2.
TEST_CASE("a card inside a block of glass shows with the radiance that n^2 says") {
  const Scene scene = test::scene_from("eye 0 0 5000  lookAt 0 0 0  fieldOfView 0.001\n"
                                       "imageSize 1 1  samples 4  jitter off\n"
                                       "glass SF11 cube\n"
                                       "defaultMaterials emissive 1 1 1 scale 0.9 0.9 1 square\n");
  const Rendering r = test::render_scene(scene, true);
  const Curve card = scene.materials.back().emission;
  for (int b = 0; b < 81; ++b) {
    const double nm = 380.0 + 5.0 * b;
    const double n = refractive_index(find_glass("SF11")->dispersion, nm);
    const double r0 = (n - 1.0) * (n - 1.0) / ((n + 1.0) * (n + 1.0));
    CHECK(r.film.radiance(0, 0, b) == Approx(card.at(nm) * (1.0 - r0) / (n * n)).epsilon(1e-5));
  }
}
