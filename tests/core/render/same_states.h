#pragma once

#include "core/render/render_state.h"
#include "tests/catch.h"

namespace abbe::test {

/// That all sums and counts are the same.
inline void check_same(const Film& a, const Film& b) {
  REQUIRE(a.layer_count() == b.layer_count());
  CHECK(a.light_passes() == b.light_passes());
  for_each_pixel(a.window(), [&](int x, int y) {
    const std::size_t pixel = a.window().index(x, y);
    REQUIRE(a.samples(x, y) == b.samples(x, y));
    REQUIRE(a.covered_samples(x, y) == b.covered_samples(x, y));
    if (a.keeps_errors()) REQUIRE(a.strata(x, y) == b.strata(x, y));
    for (std::size_t i = 0; i < a.layer_count(); ++i) {
      const Layer& first = a.layer(static_cast<LayerId>(i));
      const Layer& second = b.layer(static_cast<LayerId>(i));
      REQUIRE(first.form() == second.form());
      for (std::size_t v = 0; v < first.form().values(); ++v) {
        REQUIRE(first.sum(pixel, v) == second.sum(pixel, v));
        if (first.form().strata) REQUIRE(first.first_sum(pixel, v) == second.first_sum(pixel, v));
      }
    }
  });
}

inline void check_same(const RenderState& a, const RenderState& b) {
  check_same(a.film, b.film);
  CHECK(a.done == b.done);
  CHECK(a.rays.total() == b.rays.total());
  CHECK(a.rays.light == b.rays.light);
  CHECK(a.rays.splats == b.rays.splats);
  CHECK(a.rays.photons == b.rays.photons);
}

} // namespace abbe::test
