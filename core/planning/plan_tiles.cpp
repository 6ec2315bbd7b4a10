#include "core/planning/plan_tiles.h"

#include "core/cameras/placed_camera.h"
#include "core/sampling/sampler.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

constexpr int kTileSize = 16;

/// The part of the image that a shape's bounding box covers; everything when the box reaches
/// behind the camera.
PixelWindow screen_window(const Projection& project, const Bounds& box, double margin) {
  constexpr double kEverywhere = 1e9;
  dvec2 lower(kEverywhere), upper(-kEverywhere);
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 p{corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                  corner & 4 ? box.upper.z : box.lower.z};
    const auto seen = project(p);
    if (!seen) return {-1000000000, -1000000000, 1000000000, 1000000000};
    lower = {std::min(lower.x, seen->x), std::min(lower.y, seen->y)};
    upper = {std::max(upper.x, seen->x), std::max(upper.y, seen->y)};
  }
  const auto pixel = [&](double v) {
    return static_cast<int>(std::clamp(v, -kEverywhere, kEverywhere));
  };
  return {pixel(std::floor(lower.x - margin)), pixel(std::floor(lower.y - margin)),
          pixel(std::ceil(upper.x + margin)), pixel(std::ceil(upper.y + margin))};
}

bool overlap(const PixelWindow& a, const PixelWindow& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

} // namespace

std::vector<Tile> make_tiles(const Scene& scene, const PixelWindow& window,
                             const RenderSettings& settings) {
  // Where a shape shows through a lens, which blurs and distorts it, is not asked.
  const Projection project = projection(scene, settings.width, settings.height);
  const bool skip = settings.skip.empty_tiles && project;
  std::vector<PixelWindow> shown;
  if (skip) {
    // A sample lies within the filter's reach of its pixel's centre; a pixel more for rounding.
    const double margin = filter_radius(settings.filter) + 1.0;
    for (const PlacedShape& shape : scene.shapes)
      shown.push_back(screen_window(project, bounds(shape), margin));
  }
  std::vector<Tile> tiles;
  for (int y = window.y0; y < window.y1; y += kTileSize)
    for (int x = window.x0; x < window.x1; x += kTileSize) {
      Tile tile{{x, y, std::min(x + kTileSize, window.x1), std::min(y + kTileSize, window.y1)}};
      tile.empty = skip && std::none_of(shown.begin(), shown.end(),
                                        [&](const auto& w) { return overlap(w, tile.window); });
      tiles.push_back(tile);
    }
  return tiles;
}

} // namespace abbe
