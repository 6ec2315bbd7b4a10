// A scene that is written and read again is the same scene.

#include "io/converting/scene_writer.h"

#include "core/scene/user_error.h"
#include "io/gltf/read_gltf.h"
#include "io/pbrt/read_pbrt.h"
#include "io/scene_language/read_scene.h"
#include "spectral/band_grid.h"
#include "spectral/rgb_spectrum.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace abbe;
using Catch::Matchers::ContainsSubstring;

namespace {

double largest_difference(const Curve& a, const Curve& b) {
  double most = 0.0;
  for (int k = 0; k < kSampleCount; ++k)
    most = std::max(most, std::abs(a.at(sample_nm(k)) - b.at(sample_nm(k))));
  return most;
}

/// Writes the scene into the folder and reads it again.
Scene written_and_read(const Scene& scene, const test::Folder& folder) {
  SceneWriter(scene, folder.path / "out.sdl", [](const std::string&) {}).write();
  return read_scene(folder.path / "out.sdl", [](const std::string& warning) { FAIL(warning); });
}

void check_same_finish(const Scene& a, MaterialId in_a, const Scene& b, MaterialId in_b) {
  const Material &x = a.materials[in_a.index()], &y = b.materials[in_b.index()];
  INFO(x.name);
  REQUIRE(x.mixture.has_value() == y.mixture.has_value());
  if (x.mixture) {
    CHECK(x.mixture->share == y.mixture->share);
    check_same_finish(a, x.mixture->first, b, y.mixture->first);
    check_same_finish(a, x.mixture->second, b, y.mixture->second);
    return;
  }
  for (const auto part : {&Material::ambient, &Material::diffuse, &Material::specular,
                          &Material::emission, &Material::reflectivity, &Material::transparency})
    CHECK(largest_difference(x.*part, y.*part) < 1e-6);
  CHECK(x.roughness == y.roughness);
  CHECK(x.fresnel == y.fresnel);
  CHECK((x.emission.zero() || x.emits_behind == y.emits_behind));
  REQUIRE(x.metal.has_value() == y.metal.has_value());
  if (x.metal) CHECK(largest_difference(x.metal->k, y.metal->k) < 1e-6);
  REQUIRE(x.coat.has_value() == y.coat.has_value());
  if (x.coat) CHECK(refractive_index(*x.coat, 550.0) == refractive_index(*y.coat, 550.0));
  CHECK(x.film.has_value() == y.film.has_value());
  CHECK(x.pane.has_value() == y.pane.has_value());
  CHECK((x.texture.has_value() == y.texture.has_value()));
}

void check_same(const Scene& a, const Scene& b) {
  CHECK(a.mm_per_unit == b.mm_per_unit);
  CHECK(a.camera.eye == b.camera.eye);
  CHECK(a.camera.look_at == b.camera.look_at);
  CHECK(a.camera.up == b.camera.up);
  CHECK(a.camera.field_of_view_deg == b.camera.field_of_view_deg);
  CHECK(a.settings.width == b.settings.width);
  CHECK(a.settings.integrator == b.settings.integrator);
  CHECK(a.settings.max_depth == b.settings.max_depth);
  CHECK(a.object_names == b.object_names);
  REQUIRE(a.shapes.size() == b.shapes.size());
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    INFO("shape " << i);
    CHECK(a.shapes[i].shape.index() == b.shapes[i].shape.index());
    const Bounds x = bounds(a.shapes[i]), y = bounds(b.shapes[i]);
    CHECK(glm::length(x.lower - y.lower) < 1e-12 * (1.0 + x.largest_coordinate()));
    CHECK(glm::length(x.upper - y.upper) < 1e-12 * (1.0 + x.largest_coordinate()));
    CHECK(is_smooth(a.shapes[i].shape) == is_smooth(b.shapes[i].shape));
    check_same_finish(a, a.shapes[i].material, b, b.shapes[i].material);
    REQUIRE(a.shapes[i].medium.valid() == b.shapes[i].medium.valid());
    if (!a.shapes[i].medium.valid()) continue;
    const Medium &m = a.media[a.shapes[i].medium.index()], &n = b.media[b.shapes[i].medium.index()];
    CHECK(largest_difference(m.absorption_per_mm, n.absorption_per_mm) == 0.0);
    for (const double nm : {400.0, 550.0, 700.0})
      CHECK(refractive_index(m.index, nm) == Approx(refractive_index(n.index, nm)).epsilon(1e-12));
  }
  REQUIRE(a.lights.size() == b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    INFO("light " << i);
    const double scale = std::max(1.0, a.lights[i].spectrum.at(550.0));
    CHECK(largest_difference(a.lights[i].spectrum, b.lights[i].spectrum) < 1e-12 * scale);
    CHECK(a.lights[i].kind.index() == b.lights[i].kind.index());
  }
  CHECK(largest_difference(a.background, b.background) < 1e-12);
  REQUIRE(a.environment.has_value() == b.environment.has_value());
  if (a.environment) CHECK(a.environment->rgb == b.environment->rgb);
}

Scene gltf(const std::string& name) {
  return read_gltf(
      ABBE_SOURCE_DIR "/tests/io/gltf/data/" + name, [](const std::string&) {}, nullptr,
      Strictness::lenient);
}

} // namespace

TEST_CASE("scenes of glTF are the same when written in our language and read again") {
  const test::Folder folder;
  for (const char* name : {"glass_cubes.glb", "materials.glb", "quantized.glb"}) {
    INFO(name);
    const Scene scene = gltf(name);
    check_same(scene, written_and_read(scene, folder));
  }
}

TEST_CASE("a mesh that is placed twice is written once") {
  const test::Folder folder;
  (void)written_and_read(gltf("glass_cubes.glb"), folder);
  CHECK(std::filesystem::exists(folder.path / "out-mesh-2.ply"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "out-mesh-3.ply"));
}

// The balls take the two materials in turn, so each is made the current one twice.
TEST_CASE(
    "a picture and a metal's table are written once, however often their material comes back") {
  const test::Folder folder;
  const std::string ball = " push translate 3 0 0 sphere pop ";
  const std::string painted =
      "defaultMaterials imageTexture \"" ABBE_SOURCE_DIR "/tests/fuzz/corpus/exr/rgb.exr\"" + ball;
  Scene scene = read_scene_text(painted + "metal Ag" + ball + painted + "metal Ag" + ball, "s.sdl",
                                [](const std::string&) {});
  for (Material& material : scene.materials) // a metal that no catalogue has
    if (material.metal) material.metal->k = material.metal->k.scaled(0.9);
  check_same(scene, written_and_read(scene, folder));
  for (const std::string one : {"out-metal-1.yml", "out-picture-1.exr"})
    CHECK(std::filesystem::exists(folder.path / one));
  for (const std::string two : {"out-metal-2.yml", "out-picture-2.exr"})
    CHECK_FALSE(std::filesystem::exists(folder.path / two));
}

TEST_CASE("scenes of pbrt are the same when written in our language and read again") {
  const test::Folder folder;
  const Scene scene = read_pbrt_text(
      "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100\n"
      "Scale -1 1 1\nLookAt 0 0 5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
      "WorldBegin\nLightSource \"infinite\" \"rgb L\" [ 0.2 0.3 0.4 ]\n"
      "LightSource \"spot\" \"point3 from\" [ 1 2 3 ] \"float scale\" 7\n"
      "AttributeBegin\nMaterial \"dielectric\" \"spectrum eta\" \"glass-BK7\"\n"
      "Translate 0 0 -0.5\nShape \"sphere\" \"float zmin\" 0.5\nTranslate 0 0 1\n"
      "Shape \"sphere\" \"float zmax\" -0.5\nAttributeEnd\n"
      "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\" "
      "\"float roughness\" 0.1\nScale 1 2 3\nRotate 30 1 1 0\nShape \"sphere\"\n"
      "Material \"coateddiffuse\" \"rgb reflectance\" [ 0.1 0.5 0.2 ]\nShape \"disk\"\n"
      "AreaLightSource \"diffuse\" \"blackbody L\" 3000 \"float scale\" 4\n"
      "Texture \"c\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [ 0.7 0.1 0.1 ]\n"
      "Material \"diffuse\" \"texture reflectance\" \"c\"\nShape \"disk\" \"float radius\" 2\n",
      "s.pbrt", [](const std::string&) {}, Strictness::strict);
  check_same(scene, written_and_read(scene, folder));
}

TEST_CASE("what our language cannot say is told when it is to be written") {
  const test::Folder folder;
  Scene scene;
  scene.lights.push_back({"laser", Curve::lines({{632.8, 1.0}}), PointLight{}});
  const auto write = [&] {
    SceneWriter(scene, folder.path / "out.sdl", [](const std::string&) {}).write();
  };
  CHECK_THROWS_WITH(write(), ContainsSubstring("single lines"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "out.sdl"));
}
