#pragma once

#include "tests/stress/furnace/reference_solid.h"

namespace abbe::stress {

/// Where the light along a ray of the camera comes from. The three shares add up to 1: of light
/// that was sent out along the ray backwards, they left the scene, were taken by it, or were no
/// longer followed.
struct LightShares {
  Real escaped = 0, absorbed = 0, dropped = 0;
};

/// Follows both rays at each boundary of a lossy scene, without random numbers, until what is left
/// is very faint. It has its own geometry (`crossings`), its own nesting (places are asked, rays
/// remember nothing) and its own optics (characteristic matrices for films, sums for panes).
class ReferenceWalk {
public:
  ReferenceWalk(const RandomScene& scene, double lambda_nm);

  [[nodiscard]] LightShares follow(const Line& ray) const;

private:
  struct Event;
  struct Boundary;
  struct Branch;
  /// The item that fills a place, given what holds it: the highest priority, then the last.
  [[nodiscard]] int filling(const std::vector<bool>& holds) const;
  [[nodiscard]] bool next_boundary(const Line& ray, Boundary& found) const;
  [[nodiscard]] bool same_medium(int a, int b) const;
  [[nodiscard]] Real index_of(int item) const;

  const RandomScene& scene_;
  Real lambda_nm_;
  std::vector<Real> indices_;
};

} // namespace abbe::stress
