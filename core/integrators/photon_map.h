#pragma once

#include "core/bands/band_span.h"
#include "geometry/rays/ray_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace abbe {

/// Light that has come from a light by mirrors and glass to a surface that scatters it other than
/// specularly.
struct Photon {
  dvec3 position{0.0};
  dvec3 direction{0.0}; ///< of travel, unit
  dvec3 normal{0.0};    ///< unit, on the side that the light comes from
  BandRange bands;
  ShapeId shape;  ///< where it has landed
  int source = 0; ///< index into Plan::sources, whose spectrum the flux multiplies
  int depth = 0;  ///< how many surfaces its light has met before
  /// It has met as many as the depth limit allows: it counts in what the limit takes alone.
  bool beyond_limit = false;
  std::size_t flux = 0; ///< where its flux per band begins
};

/// Photons with their fluxes, in the order in which they were found.
struct PhotonBatch {
  std::vector<Photon> photons;
  std::vector<float> flux;

  /// Adds a photon with the flux `scale` times `band_flux`, whose bands become the photon's.
  void add(Photon photon, BandSpan<const float> band_flux, double scale);
};
/// How many photons there are within the depth limit.
[[nodiscard]] std::size_t count_within_limit(std::span<const PhotonBatch> batches);

/// Photons of one pass, found by place. What is looked up does not depend on the order in which
/// batches were made, only on that in which they are given.
class PhotonMap {
public:
  /// `splatted`: the light of photons that the camera sees directly reaches the film by splats.
  explicit PhotonMap(bool splatted) : splatted_(splatted) {}

  /// Replaces the photons. `radius` is in scene units.
  void build(std::span<PhotonBatch> batches, double radius);

  [[nodiscard]] bool splatted() const { return splatted_; }
  [[nodiscard]] std::size_t size() const { return photons_.size(); }
  [[nodiscard]] double radius() const { return radius_; }
  /// A photon's share of irradiance at a place near it, per unit of flux: 1 / (pi radius^2).
  [[nodiscard]] double density_factor() const { return density_factor_; }

  /// Calls `visit(photon, flux)` for the photons on the same side of the same surface within the
  /// radius, or on both its sides; flux[0] belongs to band photon.bands.first. A surface goes on in
  /// its plane, whatever shape holds the rest, and with one shape where that turns; what lies above
  /// it or below is another one (docs/decisions/caustics.md).
  template <class Visit>
  void for_each_near(const Hit& hit, bool both_sides, Visit&& visit) const;

private:
  /// The cells of the grid, twice the radius wide, that a ball of the radius can touch.
  using Cells = std::array<std::uint32_t, 8>;
  [[nodiscard]] std::size_t cells_near(const dvec3& place, Cells& cells) const;
  [[nodiscard]] std::uint32_t cell_of(const dvec3& place) const;

  bool splatted_;
  double radius_ = 0.0, density_factor_ = 0.0, cells_per_unit_ = 0.0;
  std::vector<Photon> photons_; ///< sorted by cell
  std::vector<float> flux_;
  std::vector<std::uint32_t> begins_; ///< of each cell, and the end
};

template <class Visit>
void PhotonMap::for_each_near(const Hit& hit, bool both_sides, Visit&& visit) const {
  if (photons_.empty()) return;
  // A plane is as thick as files round their numbers: sheets are farther apart.
  const double thickness = radius_ * 0x1p-10;
  constexpr double kLikeNormals = 0.8;
  const dvec3 normal = hit.entering ? hit.normal : -hit.normal;
  Cells cells;
  const std::size_t count = cells_near(hit.point, cells);
  for (std::size_t c = 0; c < count; ++c)
    for (std::uint32_t i = begins_[cells[c]]; i < begins_[cells[c] + 1]; ++i) {
      const Photon& photon = photons_[i];
      const dvec3 offset = photon.position - hit.point;
      const double distance2 = glm::dot(offset, offset);
      if (distance2 >= radius_ * radius_) continue;
      const double likeness = glm::dot(photon.normal, normal);
      if ((both_sides ? std::abs(likeness) : likeness) < kLikeNormals) continue;
      const double off_plane =
          std::max(std::abs(glm::dot(offset, normal)), std::abs(glm::dot(offset, photon.normal)));
      if (off_plane > thickness) {
        // Where one surface turns by an angle between two places, neither is farther from the
        // other's plane than the chord times that angle.
        const double turn2 = 2.0 - 2.0 * std::abs(likeness);
        if (photon.shape != hit.shape || off_plane * off_plane > distance2 * turn2) continue;
      }
      visit(photon, flux_.data() + photon.flux);
    }
}

} // namespace abbe
