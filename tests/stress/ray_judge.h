#pragma once

#include "geometry/world/world.h"
#include "tests/stress/exact_body.h"
#include "tests/stress/ray_scenes.h"
#include "tests/stress/tally.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abbe::stress {

/// Where a ray's line crosses a shape of the scene.
struct SceneCrossing {
  int shape = -1;
  ExactCrossing crossing;
};

/// Compares what the world says of rays with exact bodies.
class RayJudge {
public:
  RayJudge(const RayScene& scene, const World& world, std::uint64_t round, Tally& tally);

  /// Judges one answer: what the ray, in this state, meets first.
  void check(const RayState& state, const Hit& hit, bool behind_others);
  /// Judges whether something lies between the ray's origin and this distance, given what it meets
  /// first.
  void check_occluded(const RayState& state, const Hit& hit, double distance);
  /// Judges the solids around a place.
  void check_nesting(const dvec3& place, const Nesting& nesting);

  /// All crossings ahead, ascending.
  const std::vector<SceneCrossing>& ahead(const Vec& origin, const Vec& direction);
  [[nodiscard]] const std::vector<ExactBody>& bodies() const { return bodies_; }
  /// Whether the walk has met a fault that is known; what follows from it is not judged.
  [[nodiscard]] bool spoilt() const { return spoilt_; }
  /// A new walk begins, of a ray of this kind.
  void begin(const char* kind) {
    kind_ = kind;
    previous_.reset();
    came_with_ = 0;
    spoilt_ = false;
  }

private:
  struct Place {
    bool certain = false;
    std::vector<bool> inside;
  };
  void judge(const RayState& state, const Hit& hit, bool behind_others);
  /// How far rounding may put a surface off its place, for a ray that may have come from afar.
  [[nodiscard]] Real blur(std::size_t shape, const Vec& origin, Real t) const;
  /// What a point is in, unless it is so close to a surface that rounding may tell.
  void look(const RayState& state, Real t);
  void check_before(const RayState& state, const Hit& hit);
  void check_behind(const RayState& state, const Hit& hit, const ExactCrossing& same, Real error);
  void check_flat_ones(const RayState& state, const Hit& hit);
  void check_hit(const RayState& state, const Hit& hit);
  void check_distance(const RayState& state, const Hit& hit);
  [[nodiscard]] MediumId medium() const;
  [[nodiscard]] bool same_solids(const Nesting& nesting) const;
  void open(const char* what);
  void fail(const char* what, const RayState& state, const Hit& hit);

  const World& world_;
  Tally& tally_;
  std::string name_;
  std::uint64_t round_;
  const char* kind_ = "";
  Real extent_;
  Real came_with_ = 0; ///< the largest blur of the walk so far
  std::vector<ExactBody> bodies_;
  std::vector<SceneCrossing> crossed_, ahead_; ///< by the whole line, and ahead of the ray
  std::vector<ExactCrossing> found_;
  Place place_;
  bool spoilt_ = false;
  std::optional<std::pair<RayState, Hit>> previous_; ///< of the walk
};

} // namespace abbe::stress
