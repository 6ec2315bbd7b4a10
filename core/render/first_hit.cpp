#include "core/render/first_hit.h"

#include "core/bands/band_math.h"
#include "core/planning/plan_extent.h"
#include "core/render/least_deviation.h"
#include "core/render/seen_through.h"
#include "core/scattering/hit_material.h"
#include "geometry/world/surface_coordinates.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace abbe {
namespace {

enum class Unit : std::uint8_t { length, share, ids, color, wavelength };

/// A layer with the channels that its values have in a picture; each is a layer of the film.
struct FirstHitLayer {
  ExtraLayer layer;
  std::array<const char*, 3> channels; ///< null: fewer than three
  Unit unit;
  LayerKind kind;
};

constexpr auto kLayers = std::to_array<FirstHitLayer>({
    {ExtraLayer::depth, {"depth.Z"}, Unit::length, LayerKind::value},
    {ExtraLayer::depth_nearest, {"depth_nearest.Z"}, Unit::length, LayerKind::nearest},
    {ExtraLayer::distance, {"distance.Z"}, Unit::length, LayerKind::value},
    {ExtraLayer::position,
     {"position.X", "position.Y", "position.Z"},
     Unit::length,
     LayerKind::value},
    {ExtraLayer::normal, {"normal.X", "normal.Y", "normal.Z"}, Unit::share, LayerKind::value},
    {ExtraLayer::normal_geometric,
     {"normal_geometric.X", "normal_geometric.Y", "normal_geometric.Z"},
     Unit::share,
     LayerKind::value},
    {ExtraLayer::normal_through,
     {"normal_through.X", "normal_through.Y", "normal_through.Z"},
     Unit::share,
     LayerKind::value},
    {ExtraLayer::albedo, {"albedo"}, Unit::color, LayerKind::xyz},
    {ExtraLayer::uv, {"uv.U", "uv.V"}, Unit::share, LayerKind::value},
    {ExtraLayer::object, {"object"}, Unit::ids, LayerKind::ids},
    {ExtraLayer::material, {"material"}, Unit::ids, LayerKind::ids},
    {ExtraLayer::deviation, {"deviation.V"}, Unit::share, LayerKind::value},
    {ExtraLayer::surfaces, {"surfaces.V"}, Unit::share, LayerKind::value},
    {ExtraLayer::glass_path, {"glassPath.V"}, Unit::length, LayerKind::value},
    {ExtraLayer::total_reflections, {"totalReflections.V"}, Unit::share, LayerKind::value},
    {ExtraLayer::least_deviation, {"leastDeviation.V"}, Unit::wavelength, LayerKind::nearest},
    {ExtraLayer::albedo_through, {"albedo_through"}, Unit::color, LayerKind::xyz},
    {ExtraLayer::distance_through, {"distance_through.Z"}, Unit::length, LayerKind::value},
});

/// Quanta of directions, shares and numbers of surfaces. Sums have room for 2^24 samples of 2^8.
constexpr double kShareQuantum = 0x1p-30;
constexpr double kWavelengthQuantum = 0x1p-20; ///< in nm
/// So many quanta of a length are the scene's size. Sums have room for 2^24 samples of 2^8 times
/// this; what lies farther counts as if it lay there.
constexpr double kStepsOfScene = 0x1p30, kFarthestSteps = 0x1p38;

double length_quantum(const Scene& scene) {
  const double size = std::max(farthest_coordinate(scene), 1e-30);
  return std::exp2(std::ceil(std::log2(size))) / kStepsOfScene;
}

double quantum_of(Unit unit, const Scene& scene) {
  switch (unit) {
  case Unit::length:
    return length_quantum(scene);
  case Unit::ids:
    return 1.0;
  case Unit::wavelength:
    return kWavelengthQuantum;
  case Unit::share:
  case Unit::color:
    break;
  }
  return kShareQuantum;
}

const FirstHitLayer& row_of(ExtraLayer layer) {
  return *std::ranges::find(kLayers, layer, &FirstHitLayer::layer);
}

/// Of a surface that scatters so much of each band; white is Y = 1.
Xyz color_under_d65(const Plan& plan, const BandTable& reflectance) {
  const SkyPlan& d65 = plan.sky;
  Xyz sum{0.0, 0.0, 0.0}, white{0.0, 0.0, 0.0};
  for (int b = 0; b < plan.grid.count(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    const Xyz band{static_cast<double>(d65.x[i]), static_cast<double>(d65.y[i]),
                   static_cast<double>(d65.z[i])};
    white += band;
    sum += band * static_cast<double>(reflectance[b]);
  }
  return sum * (1.0 / white.y);
}

} // namespace

std::vector<LayerForm> first_hit_layers(const Scene& scene, const Plan& plan) {
  std::vector<LayerForm> forms;
  for (const FirstHitLayer& row : kLayers) {
    if (!plan.settings.layers.has(row.layer)) continue;
    const double quantum = quantum_of(row.unit, scene);
    for (const char* channel : row.channels)
      if (channel)
        forms.push_back({channel, row.kind, quantum, 0,
                         row.unit == Unit::ids ? LayerMean::samples : LayerMean::covered_samples});
  }
  return forms;
}

FirstHit::FirstHit(const Scene& scene, const Plan& plan, const World& world, Film& film)
    : plan_(plan), world_(world), film_(film), eye_(scene.camera.eye),
      forward_(glm::normalize(scene.camera.look_at - scene.camera.eye)),
      depth_(find(ExtraLayer::depth)), depth_nearest_(find(ExtraLayer::depth_nearest)),
      distance_(find(ExtraLayer::distance)), position_(find(ExtraLayer::position)),
      normal_(find(ExtraLayer::normal)), geometric_(find(ExtraLayer::normal_geometric)),
      through_(find(ExtraLayer::normal_through)), uv_(find(ExtraLayer::uv)),
      deviation_(find(ExtraLayer::deviation)), surfaces_(find(ExtraLayer::surfaces)),
      glass_path_(find(ExtraLayer::glass_path)), total_(find(ExtraLayer::total_reflections)),
      least_(find(ExtraLayer::least_deviation)),
      distance_through_(find(ExtraLayer::distance_through)), albedo_(find(ExtraLayer::albedo)[0]),
      albedo_through_(find(ExtraLayer::albedo_through)[0]), object_(find(ExtraLayer::object)[0]),
      material_(find(ExtraLayer::material)[0]),
      looks_through_(through_[0] || deviation_[0] || surfaces_[0] || glass_path_[0] || total_[0] ||
                     least_[0] || distance_through_[0] || albedo_through_),
      empty_(std::ranges::none_of(
          kLayers, [&](const FirstHitLayer& r) { return plan.settings.layers.has(r.layer); })),
      albedos_(plan.materials.size()), textured_(0.0f, plan.grid.count()) {}

FirstHit::Values FirstHit::find(ExtraLayer layer) const {
  Values ids;
  if (!plan_.settings.layers.has(layer)) return ids;
  const FirstHitLayer& row = row_of(layer);
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (row.channels[i]) ids[i] = film_.find(row.channels[i]);
  return ids;
}

void FirstHit::put(const Film::Place& place, const Values& layers, const dvec3& values) {
  for (int i = 0; i < 3; ++i) {
    const auto& layer = layers[static_cast<std::size_t>(i)];
    if (!layer) continue;
    const double most = kFarthestSteps * film_.layer(*layer).form().quantum;
    film_.add(*layer, place, std::clamp(values[i], -most, most));
  }
}

/// The colour of what the surface scatters other than specularly, under D65. Of a mixture it is the
/// mean of its parts.
Xyz FirstHit::albedo(const Hit& hit, std::size_t number) {
  const MaterialPlan& material = plan_.materials[number];
  if (material.mixture) {
    const MixturePlan& mix = *material.mixture;
    const Xyz a = albedo(hit, static_cast<std::size_t>(mix.first));
    const Xyz b = albedo(hit, static_cast<std::size_t>(mix.second));
    return a * mix.share + b * (1.0 - mix.share);
  }
  if (material.texture >= 0)
    return color_under_d65(plan_, diffuse_at(plan_, world_, material, hit, textured_));
  std::optional<Xyz>& known = albedos_[number];
  if (!known) known = color_under_d65(plan_, material.diffuse);
  return *known;
}

void FirstHit::add(const Film::Place& place, const CameraPaths& start) {
  std::size_t ray = 0;
  while (!start.hits[ray].met())
    ++ray;
  const Hit& hit = start.hits[ray];
  const RayState& state = start.states[ray];
  const dvec3 depth(std::max(0.0, glm::dot(hit.point - eye_, forward_)));
  put(place, depth_, depth);
  put(place, depth_nearest_, depth);
  put(place, distance_, dvec3(hit.t));
  put(place, position_, hit.point);
  put(place, normal_, hit.facing_shading_normal());
  put(place, geometric_, hit.facing_normal());
  if (uv_[0]) {
    const dvec2 uv = surface_coordinates(world_.shapes()[hit.shape.index()], hit.face, hit.point);
    put(place, uv_, {uv.x, uv.y, 0.0});
  }
  if (albedo_) film_.add(*albedo_, place, albedo(hit, hit.material.index()));
  if (object_) film_.add_id(*object_, place, static_cast<std::uint32_t>(hit.shape.index()));
  if (material_) film_.add_id(*material_, place, static_cast<std::uint32_t>(hit.material.index()));
  if (!looks_through_) return;
  const SeenThrough seen = see_through(plan_, world_, state, hit);
  if (seen.end) {
    put(place, through_, seen.end->facing_shading_normal());
    put(place, distance_through_, dvec3(seen.distance));
    if (albedo_through_)
      film_.add(*albedo_through_, place, albedo(*seen.end, seen.end->material.index()));
  }
  put(place, deviation_, dvec3(seen.deviation * 180.0 / std::numbers::pi));
  put(place, surfaces_, dvec3(seen.surfaces));
  put(place, glass_path_, dvec3(seen.glass_length));
  put(place, total_, dvec3(seen.total_reflections));
  if (!least_[0] || seen.surfaces < 2) return;
  if (const auto nm = least_deviation_nm(plan_, world_, state)) put(place, least_, dvec3(*nm));
}

} // namespace abbe
