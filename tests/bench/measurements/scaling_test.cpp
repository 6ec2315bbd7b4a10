#include "bench/measurements/arithmetic_loop.h"
#include "bench/measurements/generated_scenes.h"
#include "bench/measurements/memory.h"
#include "bench/reports/result_tables.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace abbe;
using namespace abbe::bench;

namespace {

/// The kernel may give memory in pages of 2 MiB, some of each used.
constexpr std::size_t kPages = std::size_t{1} << 23;

} // namespace

TEST_CASE("balls have the triangles that are asked for, and are closed") {
  for (const std::size_t count : {10u, 100u, 1000u, 10000u}) {
    const Triangles ball = ball_of_triangles(count);
    CHECK(ball.triangles.size() == count);
    CHECK(ball.vertices.size() == count / 2 + 2); // Euler
    const Mesh mesh(ball.vertices, ball.triangles);
    CHECK(mesh.triangles().size() == count); // none without area
    CHECK(mesh.is_closed());
    double volume = 0.0;
    for (const Triangle& t : ball.triangles) {
      const auto corner = [&](std::size_t i) {
        return ball.vertices[static_cast<std::size_t>(t[i])];
      };
      volume += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
    }
    CHECK(volume > 0.0); // normals outwards
    CHECK(volume < 4.0 * std::numbers::pi / 3.0);
    if (count == 10000) CHECK(mesh.area() == Approx(4.0 * std::numbers::pi).epsilon(0.01));
  }
  CHECK_THROWS_AS(ball_of_triangles(1), std::invalid_argument);
  CHECK_THROWS_AS(ball_of_triangles(200), std::invalid_argument);
}

TEST_CASE("lenses stand side by side before the card") {
  for (const std::size_t count : {1u, 10u, 100u}) {
    const Scene scene = lens_scene(count);
    REQUIRE(scene.shapes.size() == count + 1);
    // The rim has radius 1 in the lens's own frame.
    const auto middle = [&](std::size_t i) { return scene.shapes[i].to_world.point(dvec3(0.0)); };
    const double radius = glm::length(scene.shapes[1].to_world.vector({1.0, 0.0, 0.0}));
    for (std::size_t i = 1; i <= count; ++i) {
      CHECK(std::max(std::abs(middle(i).x), std::abs(middle(i).y)) + radius <= 1.0);
      CHECK(scene.shapes[i].medium.valid());
      for (std::size_t k = 1; k < i; ++k)
        CHECK(glm::distance(middle(i), middle(k)) > 2.0 * radius);
    }
  }
}

TEST_CASE("a generated lens is as thick as two balls make it") {
  // Balls of radius 2 about z = -sqrt(3) and sqrt(3) meet in a rim of radius 1; 2 - sqrt(3) of each
  // reaches over the middle.
  const Scene scene = lens_scene(1);
  const double size = glm::length(scene.shapes[1].to_world.vector({1.0, 0.0, 0.0}));
  const double half = size * (2.0 - std::sqrt(3.0));
  CHECK(contains(scene.shapes[1], {0.0, 0.0, 0.999 * half}));
  CHECK_FALSE(contains(scene.shapes[1], {0.0, 0.0, 1.001 * half}));
  CHECK(contains(scene.shapes[1], {0.999 * size, 0.0, 0.0}));
  CHECK_FALSE(contains(scene.shapes[1], {0.0, 1.001 * size, 0.0}));
}

TEST_CASE("the arithmetic loop does all of its work on any number of threads") {
  // Each of 32 numbers goes to 1 by x -> 0.999 x + 0.001, whose distance falls as 0.999^n.
  CHECK(arithmetic_loop(100'000, 1) == Approx(32.0).epsilon(1e-9));
  CHECK(arithmetic_loop(100'000, 3) == Approx(3 * 32.0).epsilon(1e-9));
  const double start = 8 * (1.0 + 1.1 + 1.2 + 1.3) + 4 * 0.1 * (1 + 2 + 3 + 4 + 5 + 6 + 7);
  CHECK(arithmetic_loop(0, 1) == Approx(start));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // they keep freed memory
TEST_CASE("memory that is used is seen") {
  constexpr std::size_t kBytes = std::size_t{1} << 25;
  const std::size_t before = resident_bytes();
  const std::vector<char> used(kBytes, 'x');
  const auto added = added_bytes(before);
  REQUIRE(added);
  CHECK(*added >= kBytes);
  CHECK(*added < kBytes + kPages);
  CHECK(used[kBytes / 2] == 'x');
  CHECK_FALSE(added_bytes(resident_bytes()));
}

TEST_CASE("the memory of triangles is that of their mesh") {
  constexpr std::size_t kTriangles = 100'000;
  RenderOptions options;
  options.width = options.height = 8;
  options.samples_per_pixel = options.repeats = 1;
  const PrimitivePoint point = measure_triangles(kTriangles, options);
  REQUIRE(point.bytes);
  const Triangles ball = ball_of_triangles(kTriangles);
  const Mesh mesh(ball.vertices, ball.triangles);
  const auto& nodes = mesh.hierarchy().nodes;
  const std::size_t used = mesh.vertices().size() * sizeof(dvec3) + kTriangles * sizeof(Triangle) +
                           nodes.size() * sizeof(nodes[0]);
  CHECK(*point.bytes > used / 10 * 9);
  CHECK(*point.bytes < used + kPages);
}

#endif

TEST_CASE("every axis gives its points") {
  ScalingOptions options;
  options.render.width = options.render.height = 16;
  options.render.samples_per_pixel = 1;
  options.render.repeats = 1;
  options.render.threads = 2;
  options.most_triangles = 100;
  options.most_lenses = 10;
  const Scaling s = measure_scaling("sphere", options, [](const std::string&) {});
  REQUIRE(s.threads.size() == 2);
  CHECK(s.threads[0].speedup.median == 1.0);
  CHECK(s.threads[0].loop_speedup.median == 1.0);
  CHECK(s.threads[1].threads == 2);
  REQUIRE(s.sizes.size() == 4);
  CHECK(s.sizes[0].settings.width == 4);
  CHECK(s.sizes[3].settings.width == 32);
  CHECK(s.samples.size() == 5);
  REQUIRE(s.triangles.size() == 2);
  CHECK(s.triangles[1].primitives == 100);
  CHECK(s.triangles[1].rays > 256); // some are reflected
  REQUIRE(s.lenses.size() == 2);
  CHECK(s.lenses[1].rays > 256);
  CHECK(tables_of(s).size() == 5);
  CHECK(tables_of(s)[0].rows.size() == 2);
}
