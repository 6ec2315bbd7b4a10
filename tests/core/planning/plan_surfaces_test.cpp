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

TEST_CASE("a material with a part fainter than the least is met with it and without it") {
  const auto plan = [](const std::string& text) {
    return plan_of("background E 1 " + text + " cube");
  };
  CHECK_FALSE(plan("minReflectivity 0.2 reflectivity 0.2").materials.at(0).mixture);
  CHECK_FALSE(plan("minReflectivity 0.3 reflectivity 0").materials.at(0).mixture);

  const Plan mirror = plan("minReflectivity 0.4 reflectivity 0.1");
  REQUIRE(mirror.materials.size() == 3);
  const MixturePlan& mixed = mirror.materials[0].mixture.value();
  CHECK((mixed.first == 1 && mixed.second == 2));
  CHECK(mixed.share == Approx(0.25));
  CHECK(std::get<Mirror>(mirror.materials[1].bsdf).reflectivity[0] == Approx(0.4));
  CHECK(std::holds_alternative<Diffuse>(mirror.materials[2].bsdf));

  const Plan dim = plan("minReflectivity 0.4 glass N-BK7 reflectivity 0.2");
  CHECK((dim.materials.at(1).facts().reflects && dim.materials.at(1).facts().transmits));
  CHECK((!dim.materials.at(2).facts().reflects && dim.materials.at(2).facts().transmits));
  const Plan dark = plan("minTransparency 0.4 glass N-BK7 transparency 0.2");
  CHECK((dark.materials.at(1).facts().reflects && dark.materials.at(1).facts().transmits));
  CHECK((dark.materials.at(2).facts().reflects && !dark.materials.at(2).facts().transmits));
}

TEST_CASE("a lamp with a faint part stays a lamp") {
  const Plan plan = plan_of("minReflectivity 0.4 reflectivity 0.1 emissive 1 1 1 cube");
  CHECK(plan.materials.at(0).emission_source >= 0);
  CHECK(plan.materials.at(1).emission_source == plan.materials[0].emission_source);
  CHECK(plan.materials.at(2).emission_source == plan.materials[0].emission_source);
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
