#include "io/pbrt/read_pbrt.h"

#include "core/scene/scene.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

const std::string kHead = "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100\n"
                          "Scale -1 1 1\nLookAt 0 0 5  0 0 0  0 1 0\n"
                          "Camera \"perspective\" \"float fov\" 40\nWorldBegin\n";

Scene scene_of(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  return read_pbrt_text(
      text, "s.pbrt",
      [&](const std::string& message) {
        if (warnings) warnings->push_back(message);
      },
      warnings ? Strictness::lenient : Strictness::strict);
}

std::string error_of(const std::string& text) {
  try {
    (void)scene_of(text);
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

const std::string kQuad = "Shape \"trianglemesh\" \"point3 P\" [ 1 2 3  3 2 3  3 2 7  1 2 7 ] "
                          "\"integer indices\" [ 0 1 2 0 2 3 ]";

const std::string kPly = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                         "property float y\nproperty float z\nelement face 1\n"
                         "property list uchar int vertex_indices\nend_header\n"
                         "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// kPly, packed by Python's gzip.
std::string packed_ply() {
  const std::string_view digits =
      "1f8b08000000000002035d8de10ac3200c84ffe729ee0986ae0f5482461ab02aea46ddd3cff54707"
      "e520777c09b91207855c77eee0e654611f8624ca2ea9e32db5cb81854acd65e68110f3bc3cee60dc"
      "c1e7fa11d809ec7f1fb575bcdcc6157a55ac9abc3a6924c9af9bb0974a065364cf69309d16fcfc49"
      "5fb17478f9b4000000";
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(digits.substr(i, 2)), nullptr, 16));
  return bytes;
}

} // namespace

TEST_CASE("a camera of pbrt sees what ours sees") {
  const Scene scene = scene_of(kHead);
  CHECK(glm::length(scene.camera.eye - dvec3(0.0, 0.0, 5.0)) < 1e-12);
  CHECK(glm::length(scene.camera.look_at - dvec3(0.0, 0.0, 4.0)) < 1e-12);
  CHECK(scene.camera.field_of_view_deg == Approx(40.0)); // of the shorter side
  CHECK(scene.settings.width == 200);
  CHECK(scene.settings.integrator == Integrator::path);
}

TEST_CASE("the field of view of a tall picture is that of its width") {
  std::string tall = kHead;
  tall.replace(tall.find("200"), 3, "50");
  const double half = std::atan(2.0 * std::tan(20.0 * std::numbers::pi / 180.0));
  CHECK(scene_of(tall).camera.field_of_view_deg == Approx(2.0 * half * 180.0 / std::numbers::pi));
}

TEST_CASE("a world that its camera sees mirrored is mirrored") {
  // Without Scale -1 1 1 pbrt shows +x on the left of a camera that looks along -z.
  std::string text = kHead;
  text.erase(text.find("Scale"), 13);
  const Scene scene = scene_of(text + "Translate 2 0 0 Shape \"sphere\"");
  REQUIRE(scene.shapes.size() == 1);
  CHECK(scene.shapes[0].to_world.point(dvec3(0.0)).x == -2.0);
  CHECK(scene_of(kHead + "Translate 2 0 0 Shape \"sphere\"").shapes[0].to_world.offset().x == 2.0);
}

TEST_CASE("transforms apply from the last to the first") {
  const Scene scene = scene_of(kHead + "Translate 1 0 0 Rotate 90 0 0 1 Scale 2 2 2\n"
                                       "ConcatTransform [ 1 0 0 0  0 1 0 0  0 0 1 0  1 0 0 1 ]\n"
                                       "Shape \"sphere\" \"float radius\" 3");
  const dvec3 p = scene.shapes[0].to_world.point({1.0, 0.0, 0.0}); // 3, 4, 8, up, and 1 beside
  CHECK(glm::length(p - dvec3(1.0, 8.0, 0.0)) < 1e-12);
}

TEST_CASE("attributes are kept and given back") {
  const Scene scene =
      scene_of(kHead + "AttributeBegin Translate 1 0 0 AttributeEnd Shape \"sphere\"");
  CHECK(scene.shapes[0].to_world.offset().x == 0.0);
}

TEST_CASE("two triangles that make a parallelogram are a square of ours") {
  const Scene scene = scene_of(kHead + "AreaLightSource \"diffuse\" \"float scale\" 3\n" + kQuad);
  REQUIRE(scene.shapes.size() == 1);
  CHECK(std::holds_alternative<Square>(scene.shapes[0].shape));
  const Transform& place = scene.shapes[0].to_world;
  CHECK(glm::length(place.offset() - dvec3(2.0, 2.0, 5.0)) < 1e-12);
  // (3 2 3) - (1 2 3) times (3 2 7) - (1 2 3) points along -y, and so does the light.
  CHECK(place.normal({0.0, 0.0, 1.0}).y == Approx(-1.0));
  const Material& material = scene.materials[scene.shapes[0].material.index()];
  CHECK_FALSE(material.emits_behind);
  CHECK(to_xyz(material.emission).y == Approx(3.0));
  const Scene turned = scene_of(
      kHead + "ReverseOrientation AreaLightSource \"diffuse\" \"rgb L\" [ 1 1 1 ]\n" + kQuad);
  CHECK(turned.shapes[0].to_world.normal({0.0, 0.0, 1.0}).y == Approx(1.0));
}

TEST_CASE("u and v of a parallelogram run as they are given") {
  const Scene scene =
      scene_of(kHead +
               "Texture \"c\" \"spectrum\" \"checkerboard\" \"float uscale\" 4 \"float vscale\" 2\n"
               "Material \"diffuse\" \"texture reflectance\" \"c\"\n" +
               kQuad + " \"point2 uv\" [ 0 0  0 1  1 1  1 0 ]");
  const Transform& place = scene.shapes[0].to_world;
  CHECK(glm::length(place.point({1.0, -1.0, 0.0}) - dvec3(1.0, 2.0, 7.0)) < 1e-12); // u = 1
  CHECK(glm::length(place.point({-1.0, 1.0, 0.0}) - dvec3(3.0, 2.0, 3.0)) < 1e-12); // v = 1
  const Material& material = scene.materials[scene.shapes[0].material.index()];
  REQUIRE(material.texture);
  CHECK(std::get<CheckerTexture>(*material.texture).across == 4.0);
  CHECK(std::get<CheckerTexture>(*material.texture).up == 2.0);
}

TEST_CASE("lights have the luminance that their scale tells") {
  const Scene scene = scene_of(
      kHead + "LightSource \"infinite\" \"spectrum L\" \"stdillum-A\" \"float scale\" 0.5\n"
              "LightSource \"distant\" \"blackbody L\" 3000 \"point3 from\" [ 0 2 0 ] "
              "\"point3 to\" [ 0 0 0 ]\n"
              "LightSource \"spot\" \"spectrum I\" [ 400 7 700 9 ] \"float coneangle\" 20");
  CHECK(to_xyz(scene.background).y == Approx(0.5));
  REQUIRE(scene.lights.size() == 2);
  // The irradiance of parallel light is pi times its value, see core/scene/light.h.
  CHECK(to_xyz(scene.lights[0].spectrum).y == Approx(1.0 / std::numbers::pi));
  CHECK(std::get<DirectionalLight>(scene.lights[0].kind).direction.y == Approx(-1.0));
  const SpotLight& spot = std::get<SpotLight>(scene.lights[1].kind);
  CHECK(to_xyz(scene.lights[1].spectrum).y == Approx(1.0));
  CHECK(spot.half_angle == Approx(std::numbers::pi / 9.0));
  CHECK(spot.full_angle == Approx(std::numbers::pi / 12.0)); // 5 degrees less
  CHECK(spot.falloff == Falloff::square);
}

TEST_CASE("two caps of glass that share a rim are a lens") {
  const auto lens = [](const std::string& second) {
    return scene_of(kHead +
                    "Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"\n"
                    "AttributeBegin Translate 0 0 -1.8 Shape \"sphere\" \"float radius\" 2 "
                    "\"float zmin\" 1.8 AttributeEnd\n" +
                    second);
  };
  const Scene convex =
      lens("Translate 0 0 1.8 Shape \"sphere\" \"float radius\" 2 \"float zmax\" -1.8");
  REQUIRE(convex.shapes.size() == 1);
  CHECK(contains(convex.shapes[0], {0.0, 0.0, 0.19}));
  CHECK(contains(convex.shapes[0], {0.0, 0.0, -0.19}));
  CHECK_FALSE(contains(convex.shapes[0], {0.0, 0.0, 0.21}));
  CHECK_FALSE(contains(convex.shapes[0], {1.0, 0.0, 0.0})); // the rim is at 0.87
  // A cap of a larger ball on the same side: R = 4, the same rim.
  const double rim2 = 4.0 - 1.8 * 1.8, depth = std::sqrt(16.0 - rim2);
  const Scene meniscus =
      lens("Translate 0 0 " + std::to_string(-depth) +
           " Shape \"sphere\" \"float radius\" 4 \"float zmin\" " + std::to_string(depth));
  REQUIRE(meniscus.shapes.size() == 1);
  const double inner = 4.0 - depth; // the apex of the flatter cap
  CHECK(contains(meniscus.shapes[0], {0.0, 0.0, 0.5 * (inner + 0.2)}));
  CHECK_FALSE(contains(meniscus.shapes[0], {0.0, 0.0, 0.9 * inner}));
  CHECK(error_of(kHead + "Material \"dielectric\"\nShape \"sphere\" \"float zmin\" 0.5")
            .starts_with("s.pbrt:7:1: a part of a sphere of glass is not understood"));
}

TEST_CASE("objects are placed as often as they are named") {
  const Scene scene = scene_of(kHead + "ObjectBegin \"a\" Translate 0 0 1 Shape \"sphere\" "
                                       "ObjectEnd\nObjectInstance \"a\"\nScale 2 2 2\n"
                                       "ObjectInstance \"a\"");
  REQUIRE(scene.shapes.size() == 2);
  CHECK(scene.shapes[0].to_world.offset().z == 1.0);
  CHECK(scene.shapes[1].to_world.offset().z == 2.0);
}

TEST_CASE("materials have the parts that pbrt gives them") {
  const Scene scene = scene_of(
      kHead + "MakeNamedMaterial \"m\" \"string type\" \"conductor\" \"spectrum eta\" "
              "\"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\" \"float roughness\" 0.16\n"
              "NamedMaterial \"m\" Shape \"sphere\"\n"
              "Material \"coateddiffuse\" \"rgb reflectance\" [ .2 .4 .6 ] Shape \"sphere\"\n"
              "MakeNamedMedium \"ink\" \"string type\" \"homogeneous\" \"spectrum sigma_a\" "
              "[ 400 2 700 2 ] \"spectrum sigma_s\" [ 400 0 700 0 ] \"float scale\" 3\n"
              "Material \"dielectric\" \"float eta\" 1.4 MediumInterface \"ink\" \"\" "
              "Shape \"sphere\"");
  REQUIRE(scene.shapes.size() == 3);
  const auto material = [&](std::size_t i) {
    return scene.materials[scene.shapes[i].material.index()];
  };
  REQUIRE(material(0).metal);
  // The facets' slopes are sqrt(0.16) wide there, and our roughness squared here.
  CHECK(material(0).roughness == Approx(std::sqrt(0.4)));
  CHECK(material(1).coat);
  const Medium& ink = scene.media[scene.shapes[2].medium.index()];
  CHECK(ink.absorption_per_mm.at(500.0) == Approx(6.0));
  CHECK(refractive_index(ink.index, 500.0) == 1.4);
}

TEST_CASE("what is not understood of pbrt is an error, or left out with a warning") {
  const std::string subdivided = kHead + "Shape \"loopsubdiv\" \"integer levels\" 3\n";
  CHECK(error_of(subdivided) ==
        "s.pbrt:6:1: the shape \"loopsubdiv\" is not understood (sphere, disk, cylinder, "
        "trianglemesh, bilinearmesh and plymesh are read). Change it, or give --lenient to go on "
        "without");
  std::vector<std::string> warnings;
  CHECK(scene_of(subdivided + "Shape \"sphere\"", &warnings).shapes.size() == 1);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].starts_with("s.pbrt:6:1: the shape \"loopsubdiv\" is not understood"));
}

TEST_CASE("mistakes in a scene of pbrt are told at their place") {
  CHECK(error_of("") == "s.pbrt: the scene has no WorldBegin (its shapes and lights stand behind "
                        "it). Add it");
  CHECK(error_of("Shpe \"sphere\"") ==
        "s.pbrt:1:1: unknown directive \"Shpe\" (pbrt-v4 has none such). Did you mean Shape?");
  CHECK(error_of("Shape \"sphere\"").starts_with("s.pbrt:1:1: Shape stands too early"));
  CHECK(error_of(kHead + "Shape \"sphere\" \"float radius\" -1")
            .starts_with("s.pbrt:6:1: a sphere has no radius"));
  CHECK(error_of(kHead + "Shape \"sphere\" \"float radios\" 1")
            .starts_with("s.pbrt:6:16: the parameter \"radios\" is not understood"));
  CHECK(
      error_of(kHead + "Translate 1 2 x").starts_with("s.pbrt:6:15: \"x\" stands where a number"));
  CHECK(error_of(kHead + "AttributeBegin").starts_with("s.pbrt:6:1: this has no end"));
  CHECK(error_of(kHead + "AttributeEnd").starts_with("s.pbrt:6:1: nothing has begun"));
  CHECK(error_of(kHead + "Shape \"sphere").starts_with("s.pbrt:6:7: a quote has no partner"));
  CHECK(error_of(kHead + "Shape \"sphere\" \"float radius\" [ 1")
            .starts_with("s.pbrt:6:16: the values of radius have no end"));
  CHECK(error_of(kHead + "Scale 0 1 1 Shape \"sphere\"")
            .starts_with("s.pbrt:6:13: the current transform cannot be undone"));
  CHECK(error_of(kHead + "Material \"dielectric\" " + kQuad)
            .starts_with("s.pbrt:6:23: the mesh is not closed"));
}

TEST_CASE("a shape of pbrt without a material is diffuse, of reflectance 0.5") {
  const Scene scene = scene_of(kHead + "Shape \"sphere\"");
  REQUIRE(scene.materials.size() == 1);
  CHECK(scene.materials[0].diffuse.constant_value() == 0.5);
  CHECK(scene.materials[0].ambient.zero());
}

TEST_CASE("names in an included file of pbrt are found from the folder of the main file") {
  const test::Folder folder;
  std::filesystem::create_directory(folder.path / "parts");
  test::put(folder.path / "parts/a.pbrt", "Include \"parts/b.pbrt\"\n");
  test::put(folder.path / "parts/b.pbrt",
            "MakeNamedMaterial \"m\" \"string type\" \"diffuse\" "
            "\"spectrum reflectance\" \"parts/grey.spd\"\n"
            "Shape \"plymesh\" \"string filename\" \"parts/t.ply\"\n");
  test::put(folder.path / "parts/grey.spd", "400 0.25\n700 0.25\n");
  test::put(folder.path / "parts/t.ply", kPly);
  test::put(folder.path / "s.pbrt", kHead + "Include \"parts/a.pbrt\"\n");
  InputFiles files;
  const Scene scene = read_pbrt(folder.path / "s.pbrt", {}, &files, Strictness::strict);
  CHECK(scene.shapes.size() == 1);
  CHECK(files.size() == 5);
}

TEST_CASE("a mesh of pbrt may be packed by gzip") {
  const test::Folder folder;
  test::put(folder.path / "t.ply.gz", packed_ply());
  test::put(folder.path / "s.pbrt", kHead + "Shape \"plymesh\" \"string filename\" \"t.ply.gz\"\n");
  const Scene scene = read_pbrt(folder.path / "s.pbrt", {}, nullptr, Strictness::strict);
  REQUIRE(scene.shapes.size() == 1);
  CHECK(std::get<Mesh>(scene.shapes[0].shape).triangles().size() == 1);

  test::put(folder.path / "t.ply.gz", packed_ply().substr(0, 60));
  CHECK_THROWS_WITH(read_pbrt(folder.path / "s.pbrt", {}, nullptr, Strictness::strict),
                    Catch::Matchers::ContainsSubstring("damaged, or ends too early"));
}
