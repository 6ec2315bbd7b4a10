#include "bench/measurements/generated_scenes.h"

#include "io/scene_language/read_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace abbe::bench {
namespace {

/// Circles of latitude and corners on each, such that a ball with two poles has 2 * circles *
/// corners triangles; nothing unless that is a power of ten.
struct Division {
  std::size_t circles, corners;
};

Division division_of(std::size_t count) {
  Division division{1, 5};
  for (bool finer_along = false;; finer_along = !finer_along) {
    const std::size_t triangles = 2 * division.circles * division.corners;
    if (triangles == count) return division;
    if (triangles > count)
      throw std::invalid_argument(fmt::format("{} triangles: not a power of ten from 10", count));
    division = finer_along ? Division{division.circles * 2, division.corners * 5}
                           : Division{division.circles * 5, division.corners * 2};
  }
}

/// What two balls of radius 2 have in common: diameter 2 at its rim, 0.54 thick.
CsgTree lens() {
  const double from_middle = std::sqrt(3.0);
  const auto ball = [](double z) {
    return CsgTree(
        Sphere{}, Transform::translation({0.0, 0.0, z}).after(Transform::scaling({2.0, 2.0, 2.0})));
  };
  return {CsgOperation::intersect, ball(-from_middle), ball(from_middle)};
}

} // namespace

Triangles ball_of_triangles(std::size_t count) {
  const auto [circles, corners] = division_of(count);
  Triangles ball;
  ball.vertices.emplace_back(0.0, 0.0, 1.0);
  for (std::size_t i = 1; i <= circles; ++i)
    for (std::size_t k = 0; k < corners; ++k) {
      const double theta =
          std::numbers::pi * static_cast<double>(i) / static_cast<double>(circles + 1);
      const double phi =
          2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
      ball.vertices.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                 std::cos(theta));
    }
  ball.vertices.emplace_back(0.0, 0.0, -1.0);
  const auto last = static_cast<int>(ball.vertices.size()) - 1;
  const auto at = [n = corners](std::size_t circle, std::size_t corner) {
    return static_cast<int>(1 + (circle - 1) * n + corner % n);
  };
  for (std::size_t k = 0; k < corners; ++k) {
    ball.triangles.push_back({0, at(1, k), at(1, k + 1)});
    for (std::size_t i = 1; i < circles; ++i) {
      ball.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      ball.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
    ball.triangles.push_back({at(circles, k), last, at(circles, k + 1)});
  }
  return ball;
}

void Stage::add(Shape shape, const Transform& to_world) {
  PlacedShape& placed = scene.shapes.emplace_back();
  placed.shape = std::move(shape);
  placed.to_world = to_world;
  placed.material = glass_surface;
  placed.medium = glass;
}

Stage empty_stage() {
  Scene scene = read_scene_text("eye 0 0 5 lookAt 0 0 0 fieldOfView 30 imageSize 128 128\n"
                                "background 0.2 0.3 0.5 light D65 -3 4 5 1\n"
                                "glass N-BK7 sphere\n"
                                "defaultMaterials diffuse 0.8 0.8 0.8 ambient 0 0 0\n"
                                "push translate 0 0 -1.5 scale 3 3 1 square pop\n",
                                "stage.sdl", [](const std::string&) {});
  const PlacedShape model = scene.shapes.front(); // shows how glass is said
  scene.shapes.erase(scene.shapes.begin());
  return {std::move(scene), model.material, model.medium};
}

Scene mesh_scene(Mesh mesh) {
  Stage stage = empty_stage();
  stage.add(std::move(mesh), Transform());
  return std::move(stage.scene);
}

Scene lens_scene(std::size_t count) {
  Stage stage = empty_stage();
  const CsgTree model = lens();
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const double cell = 2.0 / static_cast<double>(columns);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t column = i % columns, row = i / columns;
    const dvec3 place(cell * (static_cast<double>(column) + 0.5) - 1.0,
                      1.0 - cell * (static_cast<double>(row) + 0.5), 0.0);
    const double size = 0.45 * cell; // lenses do not touch
    stage.add(model, Transform::translation(place).after(Transform::scaling({size, size, size})));
  }
  return std::move(stage.scene);
}

} // namespace abbe::bench
