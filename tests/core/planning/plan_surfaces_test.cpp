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
  CHECK(std::holds_alternative<Diffuse>(plain.bsdf));
  CHECK(std::get<Dielectric>(film.bsdf).film.index == 0);
  CHECK(std::get<Dielectric>(film.bsdf).film.thickness_nm == 100.0);
  CHECK(plan.layers[0].at(500.0) == 1.38);
  CHECK(std::get<CoatedDiffuse>(coat.bsdf).coat == 1);
  CHECK_FALSE(plan.layers[1].achromatic());
}

TEST_CASE("each finish becomes its BSDF") {
  const auto bsdf = [](const std::string& text) {
    return plan_of("background E 1 " + text + " cube").materials.at(0).bsdf;
  };
  CHECK(std::holds_alternative<Diffuse>(bsdf("")));
  CHECK(std::holds_alternative<Diffuse>(bsdf("roughness 0.5")));
  CHECK(std::holds_alternative<Mirror>(bsdf("reflectivity 0.4")));
  CHECK(std::holds_alternative<Mirror>(bsdf("metal Al fresnel off")));
  CHECK(std::holds_alternative<Conductor>(bsdf("metal Al thinFilm 100 1.4")));
  CHECK(std::holds_alternative<Dielectric>(bsdf("glass N-BK7")));
  CHECK(std::holds_alternative<RoughConductor>(bsdf("metal Al roughness 0.2")));
  CHECK(std::holds_alternative<RoughConductor>(bsdf("reflectivity 0.4 roughness 0.2")));
  CHECK(std::holds_alternative<RoughDielectric>(bsdf("glass N-BK7 roughness 0.2")));
  CHECK(std::holds_alternative<CoatedDiffuse>(bsdf("coat 1.5 roughness 0.2")));
}

TEST_CASE("the glass of a pane is a layer, and a passage absorbs by its thickness") {
  const Plan plan = plan_of("background E 1 unit cm thinGlass 4 N-BK7 absorption 0.05 square");
  const auto& pane = std::get<ThinGlass>(plan.materials.at(0).bsdf);
  CHECK(pane.glass == 0);
  CHECK_FALSE(plan.layers.at(0).achromatic());
  CHECK(pane.absorption[40] == Approx(0.2)); // thickness and absorption are in mm
  CHECK(plan.has_panes);
  CHECK(plan.media.empty());
  CHECK_FALSE(plan_of("background E 1 glass N-BK7 cube").has_panes);
}

TEST_CASE("a part that is fainter than the least followed is absent") {
  const auto facts = [](const std::string& text) {
    return plan_of("background E 1 " + text + " cube").materials.at(0).facts();
  };
  CHECK(facts("minReflectivity 0.1 reflectivity 0.2").reflects);
  CHECK_FALSE(facts("minReflectivity 0.3 reflectivity 0.2").reflects);
  const BsdfFacts dim = facts("minReflectivity 0.3 glass N-BK7 reflectivity 0.2");
  CHECK((!dim.reflects && dim.transmits));
  const BsdfFacts dark = facts("minTransparency 0.3 glass N-BK7 transparency 0.2");
  CHECK((dark.reflects && !dark.transmits));
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
