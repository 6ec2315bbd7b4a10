#include "core/bundles/path_wavelengths.h"
#include "core/planning/make_plan.h"
#include "spectral/glass.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

const Dispersion& flint() {
  return find_glass("SF11")->dispersion;
}

Plan two_media(int bands) {
  Scene scene;
  scene.media = {{"flint", flint(), {}}, {"water", ConstantIndex{1.33}, {}}};
  RenderSettings settings;
  settings.bands = bands;
  return make_plan(scene, settings);
}

} // namespace

TEST_CASE("a path looks all indices up at the same place inside the bands") {
  const Plan plan = two_media(27);
  PathWavelengths wavelengths(plan);
  for (const double offset : {0.5, 0.0, 0.999}) { // the second path must not see the first's
    wavelengths.begin_path(offset);
    for (int b = 0; b < 27; ++b) {
      const double nm = 377.5 + 15.0 * (b + offset);
      CHECK(wavelengths.indices(MediumId{0})[b] ==
            Approx(refractive_index(flint(), nm)).margin(1e-7));
      CHECK(wavelengths.indices(MediumId{1})[b] == 1.33);
      CHECK(wavelengths.indices(MediumId{})[b] == 1.0);
    }
  }
}

TEST_CASE("bands taken as one have the index at the path's place in their range") {
  const Plan plan = two_media(81);
  PathWavelengths wavelengths(plan);
  for (const double offset : {0.0, 0.25, 0.999}) {
    wavelengths.begin_path(offset);
    const double nm = 377.5 + 5.0 * (10 + offset * 8);
    CHECK(wavelengths.shared_index(MediumId{0}, {10, 18}) ==
          Approx(refractive_index(flint(), nm)).margin(1e-7));
    CHECK(wavelengths.shared_index(MediumId{0}, {40, 41}) == wavelengths.indices(MediumId{0})[40]);
    CHECK(wavelengths.shared_index(MediumId{}, {10, 18}) == 1.0);
    // It lies between those of the outermost bands, so where both of them pass, it passes too.
    CHECK(wavelengths.shared_index(MediumId{0}, {10, 18}) <= wavelengths.indices(MediumId{0})[10]);
    CHECK(wavelengths.shared_index(MediumId{0}, {10, 18}) >= wavelengths.indices(MediumId{0})[17]);
  }
}

TEST_CASE("films and coats are looked up at the same wavelengths") {
  Scene scene;
  Material coated;
  coated.coat = flint();
  scene.media = {{"water", ConstantIndex{1.33}, {}}};
  scene.materials = {coated};
  const Plan plan = make_plan(scene, {});
  PathWavelengths wavelengths(plan);
  for (const double offset : {0.5, 0.0, 0.999}) {
    wavelengths.begin_path(offset);
    for (int b = 0; b < 81; ++b) {
      const double nm = 377.5 + 5.0 * (b + offset);
      CHECK(wavelengths.wavelengths_nm()[b] == Approx(nm).epsilon(1e-12));
      CHECK(wavelengths.layer_indices(0)[b] == Approx(refractive_index(flint(), nm)).margin(1e-7));
      CHECK(wavelengths.indices(MediumId{0})[b] == 1.33);
    }
  }
}
