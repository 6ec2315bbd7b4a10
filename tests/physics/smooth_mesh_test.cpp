// Balls of triangles that are shaded by the normals of the ball.

#include "core/optics/shading_side.h"
#include "tests/catch.h"
#include "tests/geometry/mesh_reference.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

Mesh smooth_ball(int levels) {
  const Mesh flat = reference::icosphere(levels);
  CornerNormals normals;
  for (const dvec3& v : flat.vertices())
    normals.normals.emplace_back(glm::normalize(v));
  normals.of_triangles = flat.triangles();
  return flat.shaded_by(std::move(normals));
}

/// The scene, whose balls are made of triangles.
Scene with_smooth_balls(const std::string& text, int levels) {
  Scene scene = test::scene_from(text);
  for (PlacedShape& shape : scene.shapes)
    if (std::holds_alternative<Sphere>(shape.shape)) shape.shape = smooth_ball(levels);
  return scene;
}

struct Statistics {
  double mean, standard_error;
};

/// The luminance of a rendering, over its pixels.
Statistics luminance(const Scene& scene) {
  const Film film = test::render_scene(scene, false).film;
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (int y = 0; y < film.window().height(); ++y)
    for (int x = 0; x < film.window().width(); ++x, ++count) {
      const double value = film.color(x, y).y;
      sum += value;
      squares += value * value;
    }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / count)};
}

} // namespace

TEST_CASE("normals of corners are interpolated, and lie on the outer side") {
  const Mesh ball = smooth_ball(1);
  for (int face = 0; face < 80; ++face) {
    const auto [a, b, c] = ball.corners(face);
    CHECK(glm::distance(*shading_normal(ball, a, face), glm::normalize(a)) < 1e-6);
    const dvec3 inside = 0.2 * a + 0.3 * b + 0.5 * c;
    CHECK(glm::distance(*shading_normal(ball, inside, face), glm::normalize(inside)) < 1e-6);
  }
  CornerNormals inwards;
  for (const dvec3& v : ball.vertices())
    inwards.normals.emplace_back(-glm::normalize(v));
  inwards.of_triangles = ball.triangles();
  inwards.of_triangles[3] = {-1, -1, -1};
  const Mesh turned = ball.shaded_by(inwards);
  CHECK(glm::dot(*shading_normal(turned, turned.corner(0, 0), 0), turned.corner(0, 0)) > 0.0);
  CHECK_FALSE(shading_normal(turned, turned.corner(3, 0), 3));
}

TEST_CASE("a ray is never on two sides of a smooth surface") {
  const Scene scene = with_smooth_balls("sphere", 1);
  const World world(scene.shapes, 10.0);
  int bent = 0, flat = 0;
  for (int i = 0; i < 2000; ++i) { // all over the silhouette, which is coarse
    const dvec3 from(-1.05 + 0.00105 * i, 0.3 + 0.0003 * i, 5.0);
    const auto hit = world.closest(world.start_at({from, {0.0, 0.0, -1.0}}));
    if (!hit) continue;
    (hit->bent ? bent : flat) += 1;
    CHECK(glm::dot(hit->normal, dvec3(0.0, 0.0, -1.0)) < 0.0);
    CHECK(glm::dot(hit->shading_normal, dvec3(0.0, 0.0, -1.0)) < 0.0);
  }
  CHECK(bent > 1000);
}

TEST_CASE("directions on the wrong side are mirrored, and the others kept") {
  const dvec3 n(0.0, 0.0, 1.0), below = glm::normalize(dvec3(1.0, 2.0, -0.5));
  CHECK(kept_on_side(below, n, false) == below);
  const dvec3 kept = kept_on_side(below, n, true);
  CHECK(kept.z == -below.z);
  CHECK(kept.x == below.x);
}

TEST_CASE("the adjoint factor is that of the two cosines") {
  const dvec3 n(0.0, 0.0, 1.0), s = glm::normalize(dvec3(0.3, 0.0, 1.0));
  const dvec3 from = glm::normalize(dvec3(0.5, 0.1, 1.0)),
              to = glm::normalize(dvec3(-0.2, 0.4, 1.0));
  const double expected =
      glm::dot(from, s) * glm::dot(to, n) / (glm::dot(from, n) * glm::dot(to, s));
  CHECK(adjoint_factor(-from, to, s, n) == Approx(expected));
  CHECK(adjoint_factor(from, to, n, n) == Approx(1.0));
}

TEST_CASE("no light is lost at a smooth surface: under an even sky it is not seen") {
  const std::string sky = "background 1 1 1 eye 0 0 5 fieldOfView 20 imageSize 24 24 samples 64 "
                          "integrator path bands 9 ";
  const std::string material =
      GENERATE(as<std::string>(), "glass SF11 ", "glass SF11 roughness 0.4 ",
               "diffuse 1 1 1 ambient 0 0 0 ", "reflectivity 1 fresnel off diffuse 0 0 0 ");
  // A ball of twenty triangles catches 2 % of what gets in for good, by total reflection: with two
  // normals the way in is no longer the way out.
  const int levels = material == "glass SF11 " ? 2 : GENERATE(0, 2);
  const Statistics seen = luminance(with_smooth_balls(sky + material + "sphere", levels));
  // What facets lose beyond what `compensation` gives back is less than 1 %.
  const double margin = material.find("roughness") == std::string::npos ? 1e-4 : 0.012;
  CHECK(seen.mean == Approx(1.0).margin(margin + 4.0 * seen.standard_error));
}

TEST_CASE("a smooth ball throws the caustic of the ball, by light paths and by camera paths") {
  const std::string scene = "integrator path bands 9 eye 0 6 6 lookAt 0 -1.6 0 fieldOfView 24 "
                            "imageSize 16 16 samples 400 "
                            "diffuse 0 0 0 emissive E 20 emissiveSides front "
                            "push translate 0 5 0 rotate 90 1 0 0 scale 1 1 1 square pop "
                            "defaultMaterials ambient 0 0 0 diffuse 0.8 0.8 0.8 "
                            "push translate 0 -1.6 0 rotate -90 1 0 0 scale 4 4 1 square pop "
                            "glass N-BK7 sphere ";
  const Statistics ball = luminance(test::scene_from(scene));
  const Statistics fine = luminance(with_smooth_balls(scene, 5)); // 20480 triangles
  CHECK(std::abs(fine.mean / ball.mean - 1.0) < 0.005);
  // A coarse one, of 80 triangles: both directions of light must still agree.
  const Statistics light = luminance(with_smooth_balls(scene, 1));
  const Statistics camera = luminance(with_smooth_balls(scene + "caustics off ", 1));
  CHECK(std::abs(light.mean / camera.mean - 1.0) < 0.02);
}
