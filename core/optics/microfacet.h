#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace abbe {

using glm::dvec2;
using glm::dvec3;

/// The GGX distribution of microfacets, alike in all directions, with Smith's masking [Walter07,
/// Heitz14]. Directions are unit and point away from the surface, whose normal is +z; `h` is the
/// normal of a facet and has h.z > 0.
struct Ggx {
  double alpha; ///< width of the distribution of slopes, above 0

  /// Scenes give a roughness from 0 to 1, which looks even in its steps: alpha is its square
  /// [Burley12].
  [[nodiscard]] static Ggx from_roughness(double roughness) { return {roughness * roughness}; }

  /// D, per steradian: the integral of D(h) h.z over the hemisphere is 1.
  [[nodiscard]] double density(const dvec3& h) const;
  /// Smith's Lambda of the angle between `w` and the surface, on either side; infinite at grazing
  /// directions.
  [[nodiscard]] double lambda(const dvec3& w) const;
  /// The part of the facets turned to `w` that is seen from there: 1 / (1 + Lambda).
  [[nodiscard]] double g1(const dvec3& w) const { return 1.0 / (1.0 + lambda(w)); }
  /// The part of the facets seen from both directions, by the height the facets share [Heitz14].
  /// On the same side it is 1 / (1 + Lambda_o + Lambda_i); on opposite sides, where the one looks
  /// from above and the other from below, Beta(1 + Lambda_o, 1 + Lambda_i).
  [[nodiscard]] double g2(const dvec3& wo, const dvec3& wi) const;

  /// A facet normal with the density D(h) G1(wo) (wo . h) / wo.z of the normals visible from `wo`,
  /// which has wo.z > 0. By reflecting `wo` on a cap of the unit sphere [Dupuy23].
  [[nodiscard]] dvec3 sample_visible_normal(const dvec3& wo, const dvec2& u) const;
  /// That density, per steradian of h; 0 where the facet is turned away from `wo`.
  [[nodiscard]] double visible_density(const dvec3& wo, const dvec3& h) const;
};

/// A direction of the upper hemisphere with density cos / pi.
[[nodiscard]] dvec3 sample_cosine_hemisphere(const dvec2& u);

} // namespace abbe
