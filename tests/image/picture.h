#pragma once

#include "core/image/develop.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <vector>

namespace abbe::test {

/// An image as its pixels, in colour and in all bands, to be compared as bits.
struct Picture {
  std::vector<float> rgba, bands;
  friend bool operator==(const Picture&, const Picture&) = default;
};

/// Renders; the film may refuse nothing.
inline Picture picture(const Scene& scene, const BandPlace& bands = {}) {
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  const Rendering r = render(scene, plan, world, bands);
  CHECK(r.film.refused().not_finite == 0);
  CHECK(r.film.refused().negative == 0);
  CHECK(r.film.refused().overflow == 0);
  return {develop_scene_linear(r.film, plan).rgba, develop_spectral(r.film, plan).values};
}

} // namespace abbe::test
