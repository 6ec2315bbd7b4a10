#include "io/building/opaque_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <variant>

namespace abbe {
namespace {

/// Places are compared with solids at most so often, as a scene of many of both would take too
/// long.
constexpr std::size_t kMostComparisons = 20'000'000;

/// Solids that are warned of. Where there are more, they are of one kind.
constexpr int kMostWarnings = 8;

std::optional<dvec3> place_of(const LightKind& kind) {
  if (const auto* point = std::get_if<PointLight>(&kind)) return point->position;
  if (const auto* spot = std::get_if<SpotLight>(&kind)) return spot->position;
  return std::nullopt; // it comes from the sky
}

bool within(const Bounds& box, const dvec3& p) {
  return p.x >= box.lower.x && p.x <= box.upper.x && p.y >= box.lower.y && p.y <= box.upper.y &&
         p.z >= box.lower.z && p.z <= box.upper.z;
}

/// True where something clear that fills the place before the opaque solid does is around it, which
/// may lead out.
bool in_something_clear(const Scene& scene, const PlacedShape& opaque, const dvec3& place) {
  return std::ranges::any_of(scene.shapes, [&](const PlacedShape& shape) {
    return shape.medium.valid() && shape.priority >= opaque.priority && contains(shape, place);
  });
}

/// Whether the scene has light of other kinds than lights and the sky.
bool has_other_light(const Scene& scene) {
  return !scene.global_ambient.zero() ||
         std::ranges::any_of(scene.materials,
                             [](const Material& material) { return !material.emission.zero(); });
}

bool has_sky(const Scene& scene) {
  return !scene.background.zero() || scene.environment.has_value();
}

} // namespace

void OpaqueSolids::add(std::size_t shape, const SourcePosition& where) {
  if (files_.empty() || files_.back() != where.file) files_.push_back(where.file);
  solids_.push_back(
      {shape, static_cast<std::uint32_t>(files_.size() - 1), where.line, where.column});
}

std::string OpaqueSolids::place_of(const Noted& solid) const {
  return to_string({files_[solid.file], solid.line, solid.column});
}

void OpaqueSolids::warn_of_parted(const Scene& scene, const Warn& warn) const {
  std::vector<dvec3> lights;
  for (const Light& light : scene.lights)
    if (const auto place = abbe::place_of(light.kind)) lights.push_back(*place);
  std::ranges::sort(lights, {}, &dvec3::x);
  const dvec3& eye = scene.camera.eye;
  const bool sky_alone = scene.lights.size() == lights.size() && lights.empty() && has_sky(scene) &&
                         !has_other_light(scene);
  std::size_t comparisons = 0;
  int warnings = 0;
  for (const Noted& solid : solids_) {
    const PlacedShape& shape = scene.shapes[solid.shape];
    const Bounds box = bounds(shape);
    const bool has_eye = within(box, eye) && contains(shape, eye);
    std::size_t inside = 0;
    std::optional<dvec3> one;
    for (auto light = std::ranges::lower_bound(lights, box.lower.x, {}, &dvec3::x);
         light != lights.end() && light->x <= box.upper.x; ++light) {
      if (++comparisons > kMostComparisons) return;
      if (!within(box, *light) || !contains(shape, *light)) continue;
      ++inside;
      one = *light;
    }
    const std::size_t parted = has_eye ? lights.size() - inside : inside;
    if (parted == 0 && !(has_eye && sky_alone)) continue;
    if (in_something_clear(scene, shape, has_eye ? eye : *one)) continue;
    const std::string where = place_of(solid);
    const char* lights_are = parted == 1 ? "light is" : "lights are";
    if (parted == 0)
      warn(where + ": the camera is inside of this opaque solid, and only the sky gives light");
    else if (has_eye)
      warn(fmt::format("{}: the camera is inside of this opaque solid, and {} {} outside: nothing "
                       "of that light is seen",
                       where, parted, lights_are));
    else
      warn(fmt::format("{}: {} {} inside of this opaque solid, and the camera is not: nothing of "
                       "that light is seen",
                       where, parted, lights_are));
    if (++warnings == kMostWarnings) return;
  }
}

} // namespace abbe
