#include "core/planning/plan_groups.h"

#include "core/scene/user_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace abbe {
namespace {

/// A name as it may stand in the name of a channel: a dot would part layers, and a comma lists.
std::string plain(std::string name) {
  for (char& c : name) {
    const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '_' || c == '-';
    if (!fits) c = '_';
  }
  return name;
}

std::string name_of(const Light& light, std::size_t number) {
  if (!light.group.empty()) return light.group;
  return light.name.empty() ? fmt::format("light{}", number) : light.name;
}

std::string name_of(const Material& material, std::size_t number) {
  return material.name.empty() ? fmt::format("material{}", number) : material.name;
}

const char* kind_of(const Shape& shape) {
  constexpr std::array kKinds{"sphere", "cube",   "polyhedron", "cylinder", "boolean",
                              "mesh",   "square", "disc",       "plane"};
  static_assert(kKinds.size() == std::variant_size_v<Shape>);
  return kKinds[shape.index()];
}

void set_group(Plan& plan, int source, const Curve& spectrum, std::string name) {
  if (spectrum.zero()) return;
  name = plain(std::move(name));
  const auto known = std::ranges::find(plan.light_groups, name);
  plan.sources[static_cast<std::size_t>(source)].group =
      static_cast<int>(known - plan.light_groups.begin());
  if (known == plan.light_groups.end()) plan.light_groups.push_back(std::move(name));
}

void check_asked(const Plan& plan) {
  for (const std::string& light : plan.settings.layers.lights)
    if (light != "*" && std::ranges::find(plan.light_groups, light) == plan.light_groups.end())
      throw UserError(fmt::format("the scene has no light or group of lights {} for the layer "
                                  "light:{}; it has: {}",
                                  light, light, fmt::join(plan.light_groups, ", ")));
}

std::vector<std::string> names_of_objects(const Scene& scene) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const bool named = i < scene.object_names.size() && !scene.object_names[i].empty();
    names.push_back(named ? scene.object_names[i]
                          : fmt::format("{}{}", kind_of(scene.shapes[i].shape), i + 1));
  }
  return names;
}

} // namespace

void plan_groups(const Scene& scene, Plan& plan) {
  set_group(plan, Plan::kBackground, scene.background, "background");
  set_group(plan, Plan::kAmbient, scene.global_ambient, "ambient");
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    set_group(plan, plan.light_source(i), scene.lights[i].spectrum,
              name_of(scene.lights[i], i + 1));
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (plan.materials[i].emission_source >= 0)
      set_group(plan, plan.materials[i].emission_source, scene.materials[i].emission,
                name_of(scene.materials[i], i + 1));
  if (plan.environment_source >= 0)
    set_group(plan, plan.environment_source, scene.environment->light, "environment");
  check_asked(plan);
  constexpr std::size_t kMostGroups = 4096; // at most four layers each, of those of a film
  if (plan.light_groups.size() > kMostGroups &&
      (!plan.settings.layers.lights.empty() || plan.settings.relightable))
    throw UserError(fmt::format("{} lights and groups are more than the {} that there can be "
                                "layers for. Put lights together with lightGroup",
                                plan.light_groups.size(), kMostGroups));
  if (plan.settings.layers.has(ExtraLayer::object)) plan.object_names = names_of_objects(scene);
  if (plan.settings.layers.has(ExtraLayer::material))
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
      plan.material_names.push_back(name_of(scene.materials[i], i + 1));
}

} // namespace abbe
