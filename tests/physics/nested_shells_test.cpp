#include "io/selftest/single_ray.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <vector>

using namespace abbe;

namespace {

/// A shell of a ball: all inside `radius` has the index `n`, but for what later shells hold.
struct Shell {
  double radius, n;
};

World ball_of(const std::vector<Shell>& shells) {
  std::vector<PlacedShape> shapes;
  for (std::size_t i = 0; i < shells.size(); ++i)
    shapes.push_back({Sphere{}, Transform::scaling(dvec3(shells[i].radius)), MaterialId{0},
                      MediumId{static_cast<std::int32_t>(i)}, 0});
  return World(shapes, 10.0);
}

/// The angle by which concentric shells turn a ray that passes the centre at the distance `b`. In
/// each, n times the distance at which the ray's line passes the centre stays b (Snell's law at
/// both ends of a radius). Entering and leaving turn it by the same.
double turned(const std::vector<Shell>& shells, double b) {
  double angle = 0.0, outside = 1.0;
  for (const Shell& s : shells) {
    if (b / outside >= s.radius) break; // passes by
    REQUIRE(b / s.n < s.radius);        // no total reflection
    angle += std::asin(b / (outside * s.radius)) - std::asin(b / (s.n * s.radius));
    outside = s.n;
  }
  return 2.0 * angle;
}

} // namespace

TEST_CASE("shells of one index leave a ray straight, however many") {
  for (const int count : {1, 8, 9, 12, 20, 200, 2000}) {
    CAPTURE(count);
    std::vector<PlacedShape> shapes;
    for (int i = 0; i < count; ++i)
      shapes.push_back({Sphere{}, Transform::scaling(dvec3(1.0 - 0.9 * i / count)), MaterialId{0},
                        MediumId{0}, 0});
    const World world(shapes, 10.0);
    RayState state{{{0.03, 0.02, -5.0}, {0.0, 0.0, 1.0}}, {}, {}};
    const double half_chord = std::sqrt(1.0 - 0.03 * 0.03 - 0.02 * 0.02);
    const auto in = world.closest(state);
    REQUIRE(in);
    CHECK(in->t == Approx(5.0 - half_chord).epsilon(1e-14));
    state = in->going_on(state.ray.direction, true);
    const auto out = world.closest(state);
    REQUIRE(out);
    CHECK(out->shape.value == 0);
    CHECK(out->t == Approx(2.0 * half_chord).epsilon(1e-13));
    CHECK(out->medium_before.value == 0);
    CHECK_FALSE(out->medium_after.valid());
    CHECK(out->nesting_after().empty());
  }
}

TEST_CASE("shells of rising index turn a ray as Snell's law says, however many") {
  for (const int count : {1, 8, 9, 12, 20, 100}) {
    std::vector<Shell> shells;
    for (int i = 0; i < count; ++i)
      shells.push_back({1.0 - 0.9 * i / count, 1.0 + 0.6 * (i + 1) / count});
    const World world = ball_of(shells);
    for (const double b : {0.01, 0.05, 0.2, 0.5, 0.8}) {
      CAPTURE(count, b);
      const Ray out = refracted_through(world, {{b, 0.0, -5.0}, {0.0, 0.0, 1.0}}, [&](MediumId id) {
                        return id.valid() ? shells[id.index()].n : 1.0;
                      }).ray;
      const double angle = std::atan2(-out.direction.x, out.direction.z);
      CHECK(angle == Approx(turned(shells, b)).margin(1e-12));
    }
  }
}

// Eight shells of one glass around a bubble of air are a ball of that glass with a bubble.
TEST_CASE("a bubble in eight shells of glass shows as in one") {
  const std::string around =
      "background 0.2 0.2 0.2  eye 0 0 6  imageSize 24 24  samples 4  bands 9\n"
      "push translate 0 0 -3 scale 4 0.4 1 defaultMaterials ambient 0 0 0\n"
      "diffuse 0 0 0 emissive 1 0.1 0.1 square pop\n"
      "cauchy 1.5 0 0 sphere\n";
  const std::string bubble = "cauchy 1 0 0 push scale 0.3 0.3 0.3 sphere pop\n";
  std::string shells;
  for (const char* radius : {"0.9", "0.8", "0.7", "0.6", "0.5", "0.45", "0.4"})
    shells += std::string("push scale ") + radius + " " + radius + " " + radius + " sphere pop\n";
  const Rendering nested = test::render_scene(test::scene_from(around + shells + bubble), true);
  const Rendering plain = test::render_scene(test::scene_from(around + bubble), true);
  const Rendering solid = test::render_scene(test::scene_from(around), true);
  double largest = 0.0, against_solid = 0.0;
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x)
      for (int b = 0; b < 9; ++b) {
        const double seen = plain.film.radiance(x, y, b);
        largest = std::max(largest, std::abs(nested.film.radiance(x, y, b) - seen));
        against_solid = std::max(against_solid, std::abs(solid.film.radiance(x, y, b) - seen));
      }
  CHECK(largest < 1e-5);
  CHECK(against_solid > 0.1);
}

TEST_CASE("of many coplanar cards the one defined last shows") {
  for (const int count : {2, 8, 9, 40}) {
    CAPTURE(count);
    std::string text = "imageSize 1 1  samples 1  bands 9  fieldOfView 1\n"
                       "defaultMaterials ambient 0 0 0 diffuse 0 0 0\n";
    for (int i = 1; i <= count; ++i)
      text += "emissive " + std::to_string(0.01 * i) + " 0 0 square\n";
    const Scene scene = test::scene_from(text);
    const Rendering r = test::render_scene(scene, true);
    CHECK(r.film.radiance(0, 0, 8) ==
          Approx(band_means(BandGrid(9), scene.materials.back().emission)[8]).epsilon(1e-5));
  }
}
