#pragma once

#include "core/bundles/bundle.h"
#include "core/film/film.h"
#include "core/plan/plan.h"
#include "geometry/world/world.h"

#include <array>
#include <optional>
#include <vector>

namespace abbe {

/// The layers of what camera rays meet first that the settings ask for.
[[nodiscard]] std::vector<LayerForm> first_hit_layers(const Scene& scene, const Plan& plan);

/// Adds to such layers of a film. One object serves one thread.
class FirstHit {
public:
  /// Finds the layers. Keeps references to all.
  FirstHit(const Scene& scene, const Plan& plan, const World& world, Film& film);

  /// True where there is nothing to do.
  [[nodiscard]] bool empty() const { return empty_; }
  /// Adds what the first of the sample's rays that meets something has met.
  void add(const Film::Place& place, const CameraPaths& start);

private:
  using Values = std::array<std::optional<LayerId>, 3>;
  [[nodiscard]] Values find(ExtraLayer layer) const;
  void put(const Film::Place& place, const Values& layers, const dvec3& values);
  [[nodiscard]] Xyz albedo(const Hit& hit, std::size_t material);

  const Plan& plan_;
  const World& world_;
  Film& film_;
  dvec3 eye_, forward_;
  Values depth_, depth_nearest_, distance_, position_, normal_, geometric_, through_, uv_;
  Values deviation_, surfaces_, glass_path_, total_, least_, distance_through_;
  std::optional<LayerId> albedo_, albedo_through_, object_, material_;
  bool looks_through_ = false;
  bool empty_ = true;
  std::vector<std::optional<Xyz>> albedos_; ///< by material, those of one colour that were met
  BandTable textured_;                      ///< scratch
};

} // namespace abbe
