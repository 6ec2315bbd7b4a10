#include "io/building/scene_builder.h"

#include "io/building/fingerprint.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

const SourcePosition kHere{"ball.gltf, node 3", 0, 0};

ShapeMaterial grey(double value) {
  ShapeMaterial material;
  material.finish.diffuse = Curve::constant(value);
  return material;
}

void add_sphere(SceneBuilder& builder, const ShapeMaterial& material) {
  builder.add_shape(kHere, {Sphere{}, Transform(), {}, {}, 0}, material);
}

/// The message of the error that `act` ends with.
template <class Act>
std::string error_of(const Act& act) {
  try {
    act();
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("a scene is built without a token: equal materials and media are kept once") {
  SceneBuilder builder("balls");
  const ShapeMaterial glass = clear_glass(*find_glass("N-BK7"));
  for (int i = 0; i < 1000; ++i) {
    add_sphere(builder, grey(i / 1000.0));
    add_sphere(builder, glass);
    add_sphere(builder, grey(i / 1000.0));
  }
  const Scene scene = builder.take();
  CHECK(scene.title == "balls");
  REQUIRE(scene.shapes.size() == 3000);
  CHECK(scene.materials.size() == 1001);
  CHECK(scene.media.size() == 1);
  for (std::size_t i = 0; i < 1000; ++i) {
    const auto id = scene.shapes[3 * i].material;
    CHECK(scene.materials[id.index()].diffuse.constant_value() == static_cast<double>(i) / 1000.0);
    CHECK(scene.shapes[3 * i + 2].material == id);
    CHECK_FALSE(scene.shapes[3 * i].medium.valid());
    CHECK(scene.shapes[3 * i + 1].medium.valid());
  }
}

TEST_CASE("materials that differ where no fingerprint looks are still two") {
  // Between the wavelengths of the fingerprint.
  ShapeMaterial a, b;
  a.finish.diffuse = Curve::table({400, 420, 440, 450, 750}, {0.5, 0.5, 0.5, 0.5, 0.5});
  b.finish.diffuse = Curve::table({400, 420, 440, 450, 750}, {0.5, 0.9, 0.5, 0.5, 0.5});
  REQUIRE(fingerprint(a.finish) == fingerprint(b.finish));
  SceneBuilder builder;
  const MaterialId first = builder.add_material({}, a);
  const MaterialId second = builder.add_material({}, b);
  CHECK(first != second);
  CHECK(builder.add_material({}, a) == first);
  CHECK(builder.add_material({}, b) == second);
}

TEST_CASE("zeros of both signs are equal, and so have the same fingerprint") {
  ShapeMaterial a, b;
  a.finish.diffuse = Curve::constant(0.0);
  b.finish.diffuse = Curve::constant(-0.0);
  REQUIRE(a.finish == b.finish);
  CHECK(fingerprint(a.finish) == fingerprint(b.finish));
}

TEST_CASE("what does not go together is refused with the place that the caller gives") {
  SceneBuilder builder;
  ShapeMaterial coated = clear_glass(*find_glass("N-BK7"));
  coated.finish.coat = ConstantIndex{1.5};
  CHECK(error_of([&] {
          add_sphere(builder, coated);
        }).starts_with("ball.gltf, node 3: coat does not go with glass or metal ("));
  ShapeMaterial hollow = clear_material({"nothing", ConstantIndex{0.0}, Curve::constant(0.0)});
  CHECK(error_of([&] {
          add_sphere(builder, hollow);
        }).starts_with("ball.gltf, node 3: the solid's refractive index is 0 at"));
  CHECK(builder.scene().shapes.empty());
  CHECK(error_of([&] {
          (void)builder.mix(kHere, clear_glass(*find_glass("N-BK7")),
                            clear_glass(*find_glass("SF10")), 0.5);
        }).starts_with("ball.gltf, node 3: the two materials would fill a solid differently"));
  Camera camera;
  camera.look_at = camera.eye;
  CHECK(error_of([&] {
          check_view(kHere, camera);
        }).starts_with("ball.gltf, node 3: eye and lookAt are the same point"));
  RenderSettings settings;
  settings.crop = PixelWindow{0, 0, 513, 1};
  CHECK(error_of([&] {
          check_crop(kHere, settings);
        }).starts_with("ball.gltf, node 3: the crop reaches beyond the picture"));
}

TEST_CASE("an image is read once") {
  SceneBuilder builder;
  int reads = 0;
  const auto read = [&] {
    ++reads;
    return ReflectanceImage{1, 1, {0.5f, 0.5f, 0.5f}};
  };
  CHECK(builder.add_image("a.png", read) == 0);
  CHECK(builder.add_image("b.png", read) == 1);
  CHECK(builder.add_image("a.png", read) == 0);
  CHECK(reads == 2);
}

TEST_CASE("a glass that is extrapolated is warned of once") {
  Glass glass;
  glass.name = "short";
  glass.lower_nm = 400.0;
  glass.upper_nm = 700.0;
  std::vector<std::string> warnings;
  const Warn warn = [&](const std::string& message) { warnings.push_back(message); };
  SceneBuilder builder;
  builder.warn_of_extrapolation(kHere, glass, warn);
  builder.warn_of_extrapolation(kHere, glass, warn);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].starts_with("ball.gltf, node 3: glass short is extrapolated"));
}
