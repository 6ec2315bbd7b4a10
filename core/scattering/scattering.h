#pragma once

#include "core/bundles/path_wavelengths.h"
#include "core/optics/frame.h"
#include "core/optics/surface_optics.h"
#include "core/scattering/dielectric.h"
#include "geometry/ray_state.h"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace abbe {

using glm::dvec2;

/// How a path goes on from a surface: along the one reflected ray, along the refracted rays (each
/// band its own), or to any side by a density.
enum class ScatterKind : std::uint8_t { none, reflect, refract, spread };

/// What one surface does with one bundle: the mirror's part and the glass's part as factors per
/// band, and the part that spreads light as a function of direction.
class Scattering {
public:
  Scattering(const Plan& plan, Transport transport);

  /// Prepares for bands [first, last) of a ray along `direction` that meets `hit`, where the
  /// diffuse reflectance is `diffuse` (see diffuse_at), which stays in use. The parts are chosen in
  /// proportion to what they would bring of `throughput`, summed over the bands; bands without
  /// throughput take no part in what follows. Keeps references to all.
  void prepare(const MaterialPlan& material, const BandTable& diffuse, const Hit& hit,
               const dvec3& direction, int first, int last, const float* throughput,
               PathWavelengths& wavelengths);

  /// True when some of the light is spread, so that lamps can be aimed at.
  [[nodiscard]] bool spreads() const { return spread_ > 0.0; }
  /// True when some of it comes from the other side of the surface.
  [[nodiscard]] bool spreads_through() const {
    return spreads() && facets_ > 0.0 && material_->transmits;
  }

  /// True when there is but one part, or none, to choose.
  [[nodiscard]] bool certain() const {
    return (reflect_ > 0.0) + (refract_ > 0.0) + (spread_ > 0.0) < 2;
  }

  /// One of the parts, by a number in [0, 1), and the chance with which it was chosen.
  struct Choice {
    ScatterKind kind = ScatterKind::none;
    double chance = 1.0;
  };
  [[nodiscard]] Choice choose(double u) const;
  /// Which parts to follow where a path may branch: beside one of the others, chosen, the
  /// reflected ray. With the chance 0 that is not followed; `on` may be of no kind then, or else.
  struct Branches {
    double reflect_chance = 0.0;
    Choice on;
  };
  /// Follows a part for sure that would be chosen with a chance of 1 / `eagerness` or more; with an
  /// eagerness of 1 or less, one part alone.
  [[nodiscard]] Branches branch(double u, double eagerness) const;
  /// With which `choose` spreads, and `evaluate` reckons.
  [[nodiscard]] double spread_chance() const { return spread_; }
  /// The same as `choose` among the reflected and the refracted ray alone.
  [[nodiscard]] Choice choose_specular(double u) const;

  /// Factors on radiance that comes along the reflected and the refracted ray.
  [[nodiscard]] const float* reflected() const { return factors_.reflected.data(); }
  [[nodiscard]] const float* transmitted() const { return factors_.transmitted.data(); }

  /// The spreading part for light from the unit direction `towards`: fills [first, last) of
  /// `f_cos` with the scattering function times the cosine. Returns the density per steradian with
  /// which `sample` chooses the direction, the chance of choosing the part included; 0 where
  /// nothing is scattered.
  double evaluate(const dvec3& towards, float* f_cos);

  /// A direction from which the spreading part brings light, for four numbers in [0, 1): `u` gives
  /// the direction, `lobe` the way and the band by which a rough surface sends it. The part has
  /// been chosen already. Nothing where the direction has no light to bring.
  [[nodiscard]] std::optional<dvec3> sample(const dvec2& u, const dvec2& lobe) const;
  /// False when `sample` makes no use of `lobe`.
  [[nodiscard]] bool has_lobes() const { return facets_ > 0.0 || material_->coat >= 0; }

private:
  void find_smooth_parts(PathWavelengths& wavelengths);
  void find_spreading_parts();
  [[nodiscard]] bool rough() const;
  [[nodiscard]] double brought(const float* factors) const;
  double evaluate_facets(const dvec3& local, float* f_cos) const;
  [[nodiscard]] std::optional<dvec3> sample_facets(const dvec2& u, const dvec2& lobe) const;
  double evaluate_diffuse(const dvec3& local, float* f_cos) const;
  [[nodiscard]] std::optional<dvec3> sample_diffuse(const dvec2& u, const dvec2& lobe) const;
  [[nodiscard]] dvec3 sample_phong(const dvec2& u) const;
  [[nodiscard]] int live_band(double choice) const;
  [[nodiscard]] double phong_density(const dvec3& local) const;

  const Plan& plan_;
  Transport transport_;
  const MaterialPlan* material_ = nullptr;
  const BandTable* diffuse_ = nullptr;
  const Hit* hit_ = nullptr;
  const float* throughput_ = nullptr;
  SurfaceOptics optics_;
  int first_ = 0, last_ = 0;
  Frame frame_{dvec3(0.0, 0.0, 1.0)}; ///< z: the normal on the side that the ray comes from
  dvec3 to_eye_{0.0};                 ///< in that frame
  DielectricScatter factors_;
  double reflect_ = 0.0, refract_ = 0.0, spread_ = 0.0; ///< chances of the parts
  double facets_ = 0.0;  ///< chance of a rough surface's facets, given spread
  double lambert_ = 1.0; ///< chance of the diffuse part against the highlight, given neither
  std::vector<float> facet_light_; ///< scratch
};

} // namespace abbe
