#include "core/planning/make_plan.h"
#include "core/planning/plan_drops.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <algorithm>

using namespace abbe;

namespace {

Plan plan_of(const std::string& text) {
  const Scene scene = test::scene_from(text);
  return make_plan(scene, scene.settings);
}

} // namespace

TEST_CASE("an extinction is per mm, and per scene unit in the plan") {
  const Plan plan = plan_of("unit m light E 0 1 0 0 drops 2e-4 absorption 1e-4 cube");
  REQUIRE(plan.media.size() == 1);
  REQUIRE(plan.media[0].drops);
  CHECK(plan.has_drops);
  CHECK(plan.media[0].drops->extinction_per_unit == Approx(0.2));
  CHECK(plan.media[0].absorption_per_unit[40] == Approx(0.3));
  CHECK_FALSE(plan_of("light E 0 1 0 0 glass N-BK7 cube").has_drops);
}

TEST_CASE("phase functions are there for the lamps there are") {
  const auto drops = [](const std::string& lamps) {
    return plan_of("bands 3 " + lamps + " drops 1 cube").media.at(0).drops.value();
  };
  CHECK_FALSE(drops("").under_sun);
  CHECK_FALSE(drops("").near_light);
  CHECK(drops("light E 0 1 0 0").under_sun);
  CHECK_FALSE(drops("light E 0 1 0 0").near_light);
  CHECK(drops("light E 0 1 0 1").near_light);
  CHECK_FALSE(drops("light E 0 1 0 1").under_sun);
}

// 381 and 780 nm in one band, as drawn or at its centre.
TEST_CASE("a band has the mean of its wavelengths, without jitter its centre's alone") {
  const auto flux = [](const std::string& setting) {
    const Plan plan = plan_of("bands 1 light E 0 1 0 0 drops 1 dropSun 0 cube " + setting);
    const DropPhaseFunction& phase = *plan.media.at(0).drops->under_sun;
    double outside = 0.0; // of the bow of 580 nm, at 42.1 degrees, and within that of 780 nm
    for (std::size_t cell = 2750; cell < 2757; ++cell)
      outside += phase.flux(cell, 0);
    return outside;
  };
  CHECK(flux("jitter on") > 10.0 * flux("jitter off"));
}

TEST_CASE("a band of lines has the indices of its lines") {
  const Plan plan = plan_of("bands 1 light line(450) 0 1 0 0 drops 1 dropSun 0 cube");
  const DropPhaseFunction one(water_in_air(), {{450.0}}, 0.0);
  for (const double cosine : {-0.99, -0.76, -0.74, -0.62, 0.5})
    CHECK(plan.media.at(0).drops->under_sun->at(cosine)[0] ==
          Approx(one.at(cosine)[0]).epsilon(1e-5));
}

TEST_CASE("the plan tells the bows of its drops and what is left out") {
  const Plan plan = plan_of("light E 0 1 0 0 drops 1 cube");
  CHECK(std::any_of(plan.notes.begin(), plan.notes.end(), [](const std::string& note) {
    return note.find("drops: n_d 1.3330, primary bow 42.1, secondary bow 50.9, degrees") == 0;
  }));
}

TEST_CASE("only boundaries of drops with nothing of their own are unseen") {
  const auto clear = [](const std::string& text) {
    return plan_of("light E 0 1 0 0 " + text).materials.at(0).clear;
  };
  CHECK(clear("drops 1 cube"));
  CHECK(clear("bands 3 drops 1 fresnel on cube"));
  CHECK_FALSE(clear("drops 1 reflectivity 0.1 cube"));
  CHECK_FALSE(clear("drops 1 emissive 1 0 0 cube"));
  CHECK_FALSE(clear("drops 1 transparency 0.5 cube"));
  const Plan plan = plan_of("light E 0 1 0 0 drops 1 cube glass N-BK7 cube");
  const auto unseen = [&](int material, MediumId before, MediumId after) {
    Hit hit;
    hit.material = {material};
    hit.medium_before = before;
    hit.medium_after = after;
    return plan.unseen(hit);
  };
  const MediumId air, drops{0}, glass{1};
  CHECK(unseen(0, air, drops));
  CHECK(unseen(0, drops, air));
  CHECK_FALSE(unseen(1, air, glass));
  CHECK_FALSE(unseen(1, drops, glass));
  CHECK_FALSE(unseen(0, glass, drops));
}
