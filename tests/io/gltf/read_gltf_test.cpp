// Files that an independent exporter wrote, see data/README.md, and small ones by hand.

#include "io/gltf/read_gltf.h"

#include "core/scene/scene.h"
#include "io/files/regular_file.h"
#include "spectral/fraunhofer.h"
#include "spectral/observer.h"
#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace abbe;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string kData = ABBE_SOURCE_DIR "/tests/io/gltf/data/";

Scene scene_of(const std::string& name, std::vector<std::string>* warnings = nullptr) {
  return read_gltf(
      kData + name,
      [&](const std::string& message) {
        if (warnings) warnings->push_back(message);
      },
      nullptr, warnings ? Strictness::lenient : Strictness::strict);
}

Scene scene_of_text(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  return read_gltf_bytes(
      text, "s.gltf",
      [&](const std::string& message) {
        if (warnings) warnings->push_back(message);
      },
      warnings ? Strictness::lenient : Strictness::strict);
}

std::string error_of(const std::string& text) {
  try {
    (void)scene_of_text(text);
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

/// A triangle (0 0 0, 1 0 0, 0 1 0) as floats, in base64.
const std::string kTriangle =
    R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
    R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],)";

/// A scene of that triangle, with a material.
std::string triangle_with(const std::string& material) {
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" +
         kTriangle + R"("materials":[)" + material + "]}";
}

const Material& finish_of(const Scene& scene, std::size_t shape) {
  return scene.materials[scene.shapes[shape].material.index()];
}

} // namespace

TEST_CASE("nodes of a glTF place meshes, lamps and the camera") {
  const Scene scene = scene_of("glass_cubes.glb");
  REQUIRE(scene.shapes.size() == 3);
  CHECK(scene.mm_per_unit == 1000.0);
  CHECK(scene.object_names == std::vector<std::string>{"floor", "left", "right"});
  // A cube of side 1, turned by 90 degrees and then stretched to 2 along x by its parent.
  const Bounds left = bounds(scene.shapes[1]);
  CHECK(glm::length(left.lower - dvec3(-2.0, 0.0, -0.5)) < 1e-6);
  CHECK(glm::length(left.upper - dvec3(0.0, 1.0, 0.5)) < 1e-6);

  CHECK(glm::length(scene.camera.eye - dvec3(0.0, 2.0, 8.0)) < 1e-12);
  CHECK(glm::length(scene.camera.look_at - dvec3(0.0, 2.0, 7.0)) < 1e-12);
  CHECK(scene.camera.field_of_view_deg == Approx(0.6 * 180.0 / std::numbers::pi));
  CHECK(scene.settings.width * 2 == scene.settings.height * 3);

  REQUIRE(scene.lights.size() == 3);
  CHECK(scene.lights[0].name == "bulb");
  CHECK(to_xyz(scene.lights[0].spectrum).y == Approx(100.0).epsilon(1e-4));
  CHECK(std::get<PointLight>(scene.lights[0].kind).falloff == Falloff::square);
  // 3 lux are pi times the value; turned by -90 degrees about x, -z is -y.
  CHECK(to_xyz(scene.lights[1].spectrum).y == Approx(3.0 / std::numbers::pi).epsilon(1e-4));
  const auto& sun = std::get<DirectionalLight>(scene.lights[1].kind);
  CHECK(glm::length(sun.direction - dvec3(0.0, -1.0, 0.0)) < 1e-12);
  const auto& spot = std::get<SpotLight>(scene.lights[2].kind);
  CHECK(glm::length(spot.axis - dvec3(-1.0, 0.0, 0.0)) < 1e-12);
  CHECK(spot.half_angle == Approx(0.4));
  CHECK(spot.full_angle == Approx(0.2));
  CHECK_FALSE(scene.environment);
}

TEST_CASE("a glTF's volume of glass absorbs and disperses as its extensions say") {
  const Scene scene = scene_of("glass_cubes.glb");
  REQUIRE(scene.shapes[1].medium.valid());
  const Medium& glass = scene.media[scene.shapes[1].medium.index()];
  CHECK(refractive_index(glass.index, kLineD_nm) == Approx(1.6).epsilon(1e-9));
  CHECK(abbe_number(glass.index) == Approx(20.0 / 0.5).epsilon(1e-9));
  // KHR_materials_dispersion: n = n_d + (n_d - 1) / V (523655 / L^2 - 1.5168).
  const double khronos = 1.6 + 0.6 / 40.0 * (523655.0 / (450.0 * 450.0) - 1.5168);
  CHECK(refractive_index(glass.index, 450.0) == Approx(khronos).epsilon(1e-5));
  // Behind 2 m light has the colour 0.25 0.5 0.75, whose parts are those of a reflectance.
  std::vector<double> transmittance;
  for (int k = 0; k < 81; ++k)
    transmittance.push_back(std::exp(-2000.0 * glass.absorption_per_mm.at(380.0 + 5.0 * k)));
  CHECK(transmittance[14] < transmittance[74] * 10.0);
  CHECK(transmittance[14] == Approx(0.75).epsilon(0.15)); // 450 nm
  CHECK(transmittance[64] == Approx(0.25).epsilon(0.3));  // 700 nm
}

TEST_CASE("materials of a glTF become parts of ours") {
  const Scene scene = scene_of("materials.glb");
  REQUIRE(scene.shapes.size() == 8); // the masked cube is not seen
  const Material& gold = finish_of(scene, 0);
  REQUIRE(gold.metal);
  CHECK(gold.roughness == Approx(0.3));
  // ((1 - n)^2 + k^2) / ((1 + n)^2 + k^2) at 700 nm is close to the red of the base colour, 1.
  const double k = gold.metal->k.at(700.0);
  CHECK(k * k / (4.0 + k * k) > 0.95);

  const Material& plastic = finish_of(scene, 1);
  REQUIRE(plastic.coat);
  CHECK(refractive_index(*plastic.coat, 550.0) == 1.5);
  CHECK(plastic.roughness == Approx(0.4));
  CHECK(plastic.diffuse.at(700.0) > 5.0 * plastic.diffuse.at(500.0));

  const Material& pane = finish_of(scene, 2);
  REQUIRE(pane.pane);
  CHECK(pane.pane->thickness_mm == 0.0);
  CHECK(refractive_index(pane.pane->index, 550.0) == 1.5);

  REQUIRE(finish_of(scene, 3).film);
  CHECK(finish_of(scene, 3).film->thickness_nm == 350.0);
  CHECK(refractive_index(finish_of(scene, 3).film->index, 550.0) == 1.4);

  REQUIRE(finish_of(scene, 4).coat);
  CHECK(finish_of(scene, 4).roughness == Approx(0.1)); // of the lacquer, not of what is below

  REQUIRE(finish_of(scene, 5).mixture);
  CHECK(finish_of(scene, 5).mixture->share == 0.25); // has a highlight
  REQUIRE(finish_of(scene, 6).mixture);
  CHECK(finish_of(scene, 6).mixture->share == 0.5); // is there at all
  const Material& seen_through = scene.materials[finish_of(scene, 6).mixture->second.index()];
  CHECK(seen_through.transparency.at(550.0) == 1.0);
  REQUIRE(finish_of(scene, 7).mixture);
  CHECK(scene.materials[finish_of(scene, 7).mixture->first.index()].metal);
}

TEST_CASE("a glTF without camera and lamp is seen from the front, in a studio") {
  const Scene scene = scene_of("materials.glb");
  REQUIRE(scene.environment);
  CHECK(scene.camera.eye.z > 4.0);
  const double half = std::tan(scene.camera.field_of_view_deg * std::numbers::pi / 360.0);
  const dvec3 forward = glm::normalize(scene.camera.look_at - scene.camera.eye);
  const dvec3 right = glm::normalize(glm::cross(forward, scene.camera.up));
  for (const PlacedShape& shape : scene.shapes) { // all corners are in the picture
    const Bounds box = bounds(shape);
    for (int i = 0; i < 8; ++i) {
      const dvec3 corner(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                         i & 4 ? box.upper.z : box.lower.z);
      const dvec3 to = corner - scene.camera.eye;
      const double depth = glm::dot(to, forward);
      CHECK(depth > 0.0);
      CHECK(std::abs(glm::dot(to, right)) < half * depth * 4.0 / 3.0);
      CHECK(std::abs(glm::dot(to, glm::cross(right, forward))) < half * depth);
    }
  }
}

TEST_CASE("quantized meshes have the places of the originals") {
  const Scene exact = scene_of("materials.glb"), packed = scene_of("quantized.glb");
  REQUIRE(packed.shapes.size() == exact.shapes.size());
  for (std::size_t i = 0; i < exact.shapes.size(); ++i) { // 14 bits of a metre
    CHECK(glm::length(bounds(packed.shapes[i]).lower - bounds(exact.shapes[i]).lower) < 3e-4);
    CHECK(glm::length(bounds(packed.shapes[i]).upper - bounds(exact.shapes[i]).upper) < 3e-4);
  }
}

TEST_CASE("an emissive material of a glTF is a lamp of so many candela per square metre") {
  std::vector<std::string> warnings;
  const Scene scene = scene_of("lamp.gltf", &warnings);
  REQUIRE(scene.shapes.size() == 1);
  CHECK(to_xyz(finish_of(scene, 0).emission).y == Approx(20.0).epsilon(1e-4));
  CHECK_FALSE(finish_of(scene, 0).emits_behind);
  CHECK_FALSE(scene.environment);
}

TEST_CASE("packed meshes of a glTF tell the command that unpacks them") {
  CHECK_THROWS_WITH(scene_of("draco.glb"),
                    ContainsSubstring("#/meshes/1/primitives/0: the mesh is packed by KHR_draco") &&
                        ContainsSubstring("npx @gltf-transform/cli copy"));
  CHECK_THROWS_WITH(scene_of("meshopt.glb"),
                    ContainsSubstring("packed by EXT_meshopt_compression") &&
                        ContainsSubstring("npx @gltf-transform/cli copy"));
}

TEST_CASE("what a glTF has that is not understood is told by name") {
  const std::string sheen =
      triangle_with(R"({"extensions":{"KHR_materials_sheen":{}},"name":"cloth"})");
  CHECK_THAT(error_of(sheen),
             ContainsSubstring("s.gltf#/materials/0/extensions/KHR_materials_sheen: the extension "
                               "KHR_materials_sheen is not understood"));
  std::vector<std::string> warnings;
  CHECK(scene_of_text(sheen, &warnings).shapes.size() == 1);
  CHECK(warnings.size() == 1);
  CHECK_THAT(error_of(R"({"asset":{"version":"2.0"},"scenes":[{}],"extensionsRequired":["X"]})"),
             ContainsSubstring("#/extensionsRequired/0: the extension X is not understood"));
}

TEST_CASE("volume on an open mesh of a glTF is a pane, with a warning") {
  std::vector<std::string> warnings;
  const Scene scene = scene_of_text(
      triangle_with(
          R"({"name":"g","pbrMetallicRoughness":{"roughnessFactor":0,"metallicFactor":0},)"
          R"("extensions":{"KHR_materials_transmission":{"transmissionFactor":1},)"
          R"("KHR_materials_volume":{"thicknessFactor":1}}})"),
      &warnings);
  CHECK(finish_of(scene, 0).pane);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], ContainsSubstring("not closed"));
}

TEST_CASE("faults of a glTF have their JSON pointer") {
  const std::string head = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)";
  CHECK_THAT(error_of(head + R"({"mesh":2}]})"),
             ContainsSubstring("s.gltf#/nodes/0/mesh: 2 names nothing"));
  CHECK_THAT(error_of(head + R"({"children":[0]}]})"),
             ContainsSubstring("s.gltf#/nodes/0/children/0: node 0 has two parents"));
  CHECK_THAT(
      error_of(triangle_with(R"({"emissiveFactor":[1,2]})")),
      ContainsSubstring("s.gltf#/materials/0/emissiveFactor: this is not an array of 3 numbers"));
  CHECK_THAT(
      error_of(triangle_with(R"({"pbrMetallicRoughness":{"metallicFactor":2}})")),
      ContainsSubstring("#/materials/0/pbrMetallicRoughness/metallicFactor: metallicFactor is 2"));
  std::string beyond = triangle_with("{}");
  beyond.replace(beyond.find("\"count\":3"), 9, "\"count\":4");
  CHECK_THAT(error_of(beyond),
             ContainsSubstring("#/accessors/0: the accessor reaches beyond its bufferView"));
  CHECK_THAT(error_of("{\n\"asset\": ]"), ContainsSubstring("s.gltf:2:10: this is no JSON"));
  CHECK_THAT(error_of(R"({"asset":{"version":"1.0"}})"),
             ContainsSubstring("s.gltf#/asset: glTF of"));
  const std::string glb = read_regular_file(kData + "glass_cubes.glb");
  CHECK_THAT(error_of(glb.substr(0, 1000)), ContainsSubstring("at byte 12, a chunk is longer"));
}
