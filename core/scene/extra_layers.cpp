#include "core/scene/extra_layers.h"

#include <algorithm>
#include <array>

namespace abbe {
namespace {

constexpr auto kNames = std::to_array<ExtraLayerName>({
    {"transmittance", ExtraLayer::transmittance},
    {"depth", ExtraLayer::depth},
    {"depth.nearest", ExtraLayer::depth_nearest},
    {"distance", ExtraLayer::distance},
    {"position", ExtraLayer::position},
    {"normal", ExtraLayer::normal},
    {"normal.geometric", ExtraLayer::normal_geometric},
    {"normal.through", ExtraLayer::normal_through},
    {"albedo", ExtraLayer::albedo},
    {"uv", ExtraLayer::uv},
    {"object", ExtraLayer::object},
    {"material", ExtraLayer::material},
    {"samples", ExtraLayer::samples},
    {"variance", ExtraLayer::variance},
    {"direct", ExtraLayer::direct},
    {"indirect", ExtraLayer::indirect},
    {"caustic", ExtraLayer::caustic},
    {"class:direct", ExtraLayer::class_direct},
    {"class:reflection", ExtraLayer::class_reflection},
    {"class:refraction", ExtraLayer::class_refraction},
    {"deviation", ExtraLayer::deviation},
    {"surfaces", ExtraLayer::surfaces},
    {"glassPath", ExtraLayer::glass_path},
    {"totalReflections", ExtraLayer::total_reflections},
    {"leastDeviation", ExtraLayer::least_deviation},
    {"noise", ExtraLayer::noise},
    {"albedo.through", ExtraLayer::albedo_through},
    {"distance.through", ExtraLayer::distance_through},
});
static_assert(kNames.size() == kExtraLayerCount);

constexpr std::string_view kLight = "light:", kClass = "class:", kAll = "*";

/// What a filter needs to know of a picture to take its noise away.
constexpr std::string_view kDenoise = "denoise";
constexpr auto kForDenoise = std::to_array<ExtraLayer>({
    ExtraLayer::normal,
    ExtraLayer::normal_through,
    ExtraLayer::albedo_through,
    ExtraLayer::distance,
    ExtraLayer::distance_through,
    ExtraLayer::noise,
});

bool add_layer(std::string_view name, ExtraLayers& layers) {
  if (name.starts_with(kLight)) {
    const std::string light(name.substr(kLight.size()));
    if (light.empty()) return false;
    if (std::ranges::find(layers.lights, light) == layers.lights.end())
      layers.lights.push_back(light);
    return true;
  }
  if (name == kDenoise) {
    for (const ExtraLayer layer : kForDenoise)
      layers.add(layer);
    return true;
  }
  bool known = false;
  for (const ExtraLayerName& row : kNames) {
    const bool by_star = name == "class:*" && row.name.starts_with(kClass);
    if (row.name != name && !by_star) continue;
    layers.add(row.layer);
    known = true;
  }
  return known;
}

} // namespace

std::span<const ExtraLayerName> extra_layer_names() {
  return kNames;
}

bool ExtraLayers::has_light(std::string_view name) const {
  return std::ranges::any_of(
      lights, [&](const std::string& asked) { return asked == kAll || asked == name; });
}

bool ExtraLayers::divides_light() const {
  using enum ExtraLayer;
  return !lights.empty() || has(direct) || has(indirect) || has(caustic) || has(class_direct) ||
         has(class_reflection) || has(class_refraction);
}

bool add_layers(std::string_view list, ExtraLayers& layers) {
  if (list == "none") return true;
  while (true) {
    const std::size_t comma = list.find(',');
    if (!add_layer(list.substr(0, comma), layers)) return false;
    if (comma == list.npos) return true;
    list.remove_prefix(comma + 1);
  }
}

std::string layer_list(const ExtraLayers& layers) {
  std::string list;
  const auto add = [&](std::string_view name) {
    if (!list.empty()) list += ',';
    list += name;
  };
  for (const ExtraLayerName& row : kNames)
    if (layers.has(row.layer)) add(row.name);
  std::vector<std::string> lights = layers.lights;
  std::ranges::sort(lights);
  for (const std::string& light : lights)
    add(std::string(kLight) + light);
  return list.empty() ? "none" : list;
}

} // namespace abbe
