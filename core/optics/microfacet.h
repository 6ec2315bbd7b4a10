#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace abbe {

using glm::dvec2;
using glm::dvec3;

/// The isotropic GGX distribution of microfacets with Smith's masking [Walter07, Heitz14].
/// Directions are unit and point away from the surface, whose normal is +z; `h` is the normal of a
/// facet, with h.z > 0.
struct Ggx {
  double alpha; ///< width of the distribution of slopes, above 0

  /// Scenes give a roughness from 0 to 1. Its square is alpha, which makes equal steps of roughness
  /// look equal [Burley12].
  [[nodiscard]] static Ggx from_roughness(double roughness) { return {roughness * roughness}; }

  /// The distribution D of facet normals, per steradian. The integral of D(h) h.z over the
  /// hemisphere is 1.
  [[nodiscard]] double density(const dvec3& h) const;
  /// Smith's Lambda of the angle between `w` and the surface, on either side; infinite at grazing
  /// directions.
  [[nodiscard]] double lambda(const dvec3& w) const;
  /// Smith's masking: the part of the facets facing `w` that is visible from there,
  /// 1 / (1 + Lambda).
  [[nodiscard]] double g1(const dvec3& w) const { return 1.0 / (1.0 + lambda(w)); }
  /// The part of the facets that is visible from both directions, correlated by the facet's height
  /// [Heitz14]: 1 / (1 + Lambda_o + Lambda_i) for directions on the same side, and
  /// Beta(1 + Lambda_o, 1 + Lambda_i) for directions on opposite sides.
  [[nodiscard]] double g2(const dvec3& wo, const dvec3& wi) const;

  /// A facet normal with the pdf D(h) G1(wo) (wo . h) / wo.z of the normals visible from `wo`, for
  /// wo.z > 0 and two numbers in [0, 1), by Dupuy and Benyoub's spherical caps [Dupuy23].
  [[nodiscard]] dvec3 sample_visible_normal(const dvec3& wo, const dvec2& u) const;
  /// The pdf of that normal, per steradian of h; 0 where the facet is turned away from `wo`.
  [[nodiscard]] double visible_pdf(const dvec3& wo, const dvec3& h) const;
};

/// A direction of the upper hemisphere with the pdf cos / pi, for two numbers in [0, 1).
[[nodiscard]] dvec3 sample_cosine_hemisphere(const dvec2& u);

} // namespace abbe
