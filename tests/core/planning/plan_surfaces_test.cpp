#include "core/planning/make_plan.h"
#include "tests/catch.h"
#include "tests/render_text.h"

using namespace abbe;

namespace {

Plan plan_of(const std::string& text) {
  const Scene scene = test::scene_from(text);
  return make_plan(scene, scene.settings);
}

int notes_with(const Plan& plan, const std::string& words) {
  int count = 0;
  for (const std::string& note : plan.notes)
    count += note.find(words) != std::string::npos;
  return count;
}

} // namespace

TEST_CASE("films and coats become layers of the plan") {
  const Plan plan = plan_of("background E 1 cube glass N-BK7 thinFilm 100 1.38 cube "
                            "defaultMaterials coat N-BK7 cube");
  REQUIRE(plan.layers.size() == 2);
  const MaterialPlan &plain = plan.materials[0], &film = plan.materials[1],
                     &coat = plan.materials[2];
  CHECK((plain.film < 0 && plain.coat < 0 && plain.roughness == 0.0));
  CHECK((film.film == 0 && film.coat < 0 && film.film_nm == 100.0));
  CHECK(plan.layers[0].at(500.0) == 1.38);
  CHECK((coat.film < 0 && coat.coat == 1));
  CHECK_FALSE(plan.layers[1].achromatic());
  CHECK(coat.reflects); // whatever its reflectivity
  CHECK(coat.reflectivity.constant() == 1.0f);
}

TEST_CASE("the plan tells which rough surfaces whitted shows smooth") {
  CHECK(notes_with(plan_of("background E 1 metal Al cube"), "rough") == 0);
  CHECK(notes_with(plan_of("background E 1 roughness 0.5 cube"), "rough") == 0); // only diffuse
  CHECK(notes_with(plan_of("background E 1 metal Al roughness 0.001 cube"), "rough") == 0);
  CHECK(notes_with(plan_of("background E 1 metal Al roughness 0.2 cube"),
                   "1 rough material: whitted shows it smooth") == 1);
  CHECK(notes_with(plan_of("background E 1 metal Al roughness 0.2 cube roughness 1 cube"),
                   "2 rough materials: whitted shows them smooth") == 1);
}
