#include "tests/io/scene_language/read_scene_helpers.h"

#include "io/scene_language/read_scene_state.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

const Material& finish_of(const Scene& scene, std::size_t shape) {
  return scene.materials[scene.shapes[shape].material.index()];
}

} // namespace

TEST_CASE("defMaterial: a name stands for the whole material as it was") {
  const Scene scene =
      scene_of("glass SF11 defMaterial Flint diffuse 0.5 0.5 0.5 "
               "defaultMaterials sphere UseMaterial flint sphere glass SF11 sphere");
  CHECK(scene.shapes[1].material == scene.shapes[2].material);
  CHECK(scene.shapes[1].medium == scene.shapes[2].medium);
  CHECK(scene.shapes[0].material != scene.shapes[1].material);
  CHECK(finish_of(scene, 1).diffuse.constant_value() == 0.0);
}

TEST_CASE("defMaterial: the last of a name counts, and comes before the library's") {
  const Scene scene = scene_of("diffuse 0.25 0.25 0.25 defMaterial StrongOrangeYellow "
                               "UseMaterial strongorangeyellow sphere "
                               "diffuse 0.5 0.5 0.5 defMaterial STRONGORANGEYELLOW "
                               "defaultMaterials UseMaterial StrongOrangeYellow sphere");
  CHECK(finish_of(scene, 0).diffuse.constant_value() == 0.25);
  CHECK(finish_of(scene, 1).diffuse.constant_value() == 0.5);
}

TEST_CASE("mix: two materials of the scene, or of the library, with the first one's share") {
  const Scene scene = scene_of("materials metamers.mtl diffuse 0.25 0.25 0.25 defMaterial dull "
                               "mix dull FrontOrange 0.125 sphere");
  REQUIRE(scene.materials.size() == 3);
  const Mixture mixture = finish_of(scene, 0).mixture.value();
  CHECK(mixture.share == 0.125);
  CHECK(scene.materials[mixture.first.index()].diffuse.constant_value() == 0.25);
  CHECK(scene.materials[mixture.second.index()].name == "FrontOrange");
  CHECK(scene.shapes[0].material > mixture.first);
  CHECK(scene.shapes[0].material > mixture.second);
  CHECK_FALSE(scene.shapes[0].medium.valid());
}

TEST_CASE("mix: the part that lets light in says what fills the solid") {
  const std::string parts = "defMaterial dull glass SF11 defMaterial flint "
                            "reflectivity 0.5 defMaterial dimmed defaultMaterials ";
  for (const char* mix :
       {"mix dull flint 0.5 sphere", "mix flint dull 0.5 sphere", "mix flint dimmed 0.5 sphere"}) {
    const Scene scene = scene_of(parts + mix);
    REQUIRE(scene.shapes[0].medium.valid());
    CHECK(scene.media[scene.shapes[0].medium.index()].name == "SF11");
  }
}

TEST_CASE("errors of mixtures") {
  const std::string glasses = "glass SF11 defMaterial a\nglass N-BK7 defMaterial b\n";
  CHECK(scene_error(glasses + "mix a b 0.5") ==
        "s.sdl:3:1: the two materials would fill a solid differently (both let light in, and a "
        "solid has one filling). Mix materials of the same glass, or one that lets no light in");
  CHECK(scene_error(glasses + "mix a a 1.5") ==
        "s.sdl:3:9: 1.5 is out of range for mix (it is the share of the first material). Give a "
        "number from 0 to 1");
  CHECK(scene_error(glasses + "mix a c 0.5") ==
        "s.sdl:3:7: unknown material \"c\" (there is no all.mtl beside the scene, and no materials "
        "keyword). Add it to the material library, or name another one");
  for (const std::string keyword :
       {"ambient", "diffuse", "specular", "emissive", "emissiveSides", "specularExponent",
        "reflectivity", "transparency", "fresnel", "checker", "grid", "imageTexture"})
    CHECK(scene_error(glasses + "mix a a 0.5\n" + keyword + " 1") ==
          "s.sdl:4:1: " + keyword +
              " does not go with mix (its two materials have finishes of their own). Change them "
              "before they are mixed, or begin again with defaultMaterials");
  CHECK(scene_error(glasses + "mix a a 0.5 defaultMaterials diffuse 0.5 0.5 0.5") == "no error");
}
