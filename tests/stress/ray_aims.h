#pragma once

#include "geometry/world/world.h"
#include "tests/stress/ray_judge.h"
#include "tests/stress/ray_scenes.h"

#include <optional>
#include <vector>

namespace abbe::stress {

struct AimedRay {
  const char* kind;
  RayState state;
};

/// Makes rays for a scene, one in a few of each kind that is hard.
class RayAims {
public:
  /// Rays from outside start up to `far` sizes away.
  RayAims(const RayScene& scene, const World& world, RayJudge& judge, double far, Random& random);

  /// Nothing where no ray of its kind can be made.
  [[nodiscard]] std::optional<AimedRay> next();

private:
  struct SurfacePoint {
    dvec3 point, normal;
    SurfaceContact contact;
  };
  [[nodiscard]] dvec3 outside();
  [[nodiscard]] dvec3 anywhere();
  void gather_points();
  void gather_corners();
  void gather_edges();
  [[nodiscard]] std::optional<AimedRay> free(const char* kind, const dvec3& origin,
                                             const dvec3& direction);
  [[nodiscard]] std::optional<AimedRay> tangent();
  [[nodiscard]] std::optional<AimedRay> parallel();
  [[nodiscard]] std::optional<AimedRay> at_edge();
  [[nodiscard]] std::optional<AimedRay> from_surface();
  [[nodiscard]] std::optional<AimedRay> odd_numbers();

  const RayScene& scene_;
  const World& world_;
  RayJudge& judge_;
  double far_;
  Random& random_;
  std::vector<SurfacePoint> points_;
  std::vector<dvec3> edges_; ///< corners, and places where the face that is met changes
  std::vector<Ray> grazing_; ///< rays beside which another face is met, or none
};

} // namespace abbe::stress
