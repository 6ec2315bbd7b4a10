#pragma once

#include "core/bands/band_span.h"
#include "core/bundles/path_wavelengths.h"
#include "core/optics/frame.h"
#include "geometry/rays/ray_state.h"

#include <optional>
#include <vector>

namespace abbe {

using glm::dvec2;

/// How a path goes on from a surface: along the one reflected ray, along the refracted rays (one
/// for each band), straight through a pane, or along a direction sampled from a pdf.
enum class ScatterKind : std::uint8_t { none, reflect, refract, pass, nonspecular };

/// A direction sampled from the nonspecular part of a surface.
struct BsdfSample {
  dvec3 direction{0.0}; ///< where light comes from, unit
  double pdf = 0.0;     ///< per steradian, as Scattering::evaluate gives it
};

/// What one surface does with one bundle. A material is a sum: Lambert's part, Phong's highlight
/// and its BSDF. Of these the specular light is factors per band on the reflected and the refracted
/// rays; all else is scattered other than specularly, as a function of direction.
class Scattering {
public:
  Scattering(const Plan& plan, Transport transport);

  /// Prepares for bands [first, last) of a ray along `direction` that meets `hit`, where the
  /// diffuse reflectance is `diffuse` (see diffuse_at), which stays in use. The parts are chosen in
  /// proportion to what they would bring of `throughput`, summed over the bands; bands without
  /// throughput take no part in what follows. Keeps references to all.
  void prepare(const MaterialPlan& material, const BandTable& diffuse, const Hit& hit,
               const dvec3& direction, BandSpan<const float> throughput,
               PathWavelengths& wavelengths);

  /// True when some of the light is scattered other than specularly, so that lights can be sampled.
  [[nodiscard]] bool has_nonspecular() const { return nonspecular_ > 0.0; }
  /// True when some of it comes from the other side of the surface.
  [[nodiscard]] bool transmits_nonspecular() const {
    return has_nonspecular() && facets_ > 0.0 && facts_.transmits;
  }

  /// True when there is but one part, or none, to choose.
  [[nodiscard]] bool certain() const {
    return (reflect_ > 0.0) + (refract_ > 0.0) + (nonspecular_ > 0.0) < 2;
  }

  /// One of the parts, by a number in [0, 1), and the chance with which it was chosen.
  struct Choice {
    ScatterKind kind = ScatterKind::none;
    double chance = 1.0;
  };
  [[nodiscard]] Choice choose(double u) const;
  /// Which parts to follow where a path may branch: beside one of the others, chosen, the
  /// reflected ray. A chance of 0 means that the reflected ray is not followed. `on` may be of no
  /// kind, whatever the reflected ray does.
  struct Branches {
    double reflect_chance = 0.0;
    Choice on;
  };
  /// Follows a part for sure that would be chosen with a chance of 1 / `eagerness` or more; with an
  /// eagerness of 1 or less, one part alone.
  [[nodiscard]] Branches branch(double u, double eagerness) const;
  /// The chance with which `choose` takes the nonspecular part; `evaluate` counts it in its pdf.
  [[nodiscard]] double nonspecular_chance() const { return nonspecular_; }
  /// The same as `choose`, but among the reflected and the refracted ray alone.
  [[nodiscard]] Choice choose_specular(double u) const;

  /// Factors on what comes along the reflected ray, and along the refracted or the straight one.
  [[nodiscard]] const float* reflected() const { return reflected_.data(); }
  [[nodiscard]] const float* transmitted() const { return transmitted_.data(); }

  /// Evaluates the nonspecular part for light from the unit direction `towards`: fills the bands of
  /// `f_cos` with the BSDF times the cosine. Returns the pdf per steradian with which `sample`
  /// chooses the direction, the chance of choosing the part included; 0 where nothing is scattered.
  double evaluate(const dvec3& towards, float* f_cos);

  /// Samples a direction from which the nonspecular part brings light, evaluated as `evaluate`
  /// does, for four numbers in [0, 1): `u` gives the direction, `lobe` the lobe and the band by
  /// which a rough surface sends it. The part has been chosen already. Returns nothing where the
  /// direction has no light to bring.
  [[nodiscard]] std::optional<BsdfSample> sample(const dvec2& u, const dvec2& lobe, float* f_cos);
  /// False when `sample` makes no use of `lobe`.
  [[nodiscard]] bool has_lobes() const { return facets_ > 0.0 || facts_.coats; }

private:
  [[nodiscard]] ScatterKind through() const {
    return facts_.passes ? ScatterKind::pass : ScatterKind::refract;
  }
  void find_smooth_parts(const Hit& hit, PathWavelengths& wavelengths);
  void find_nonspecular_parts();
  double evaluate_by_shading(const dvec3& towards, float* f_cos);
  double evaluate_bent(const dvec3& towards, float* f_cos);
  double add_if_kept(const dvec3& towards, bool above, float* f_cos);
  [[nodiscard]] bool rough() const;
  [[nodiscard]] double brought(const float* factors) const;
  [[nodiscard]] std::optional<dvec3> sample_local(const dvec2& u, const dvec2& lobe) const;

  const Plan& plan_;
  Transport transport_;
  const MaterialPlan* material_ = nullptr;
  BsdfFacts facts_; ///< of its BSDF
  const BandTable* diffuse_ = nullptr;
  Incidence in_;                      ///< its directions are in frame_
  Frame frame_{dvec3(0.0, 0.0, 1.0)}; ///< z: the normal on the side that the ray comes from
  bool bent_ = false;                 ///< the shading normal is not the true one
  dvec3 true_normal_{0.0};            ///< of the surface, on the same side; set where it is bent
  dvec3 from_{0.0};                   ///< the direction of the ray, likewise
  std::vector<float> reflected_, transmitted_;
  /// Chances of the parts; `refract_` is that of a pane's straight ray too.
  double reflect_ = 0.0, refract_ = 0.0, nonspecular_ = 0.0;
  double facets_ = 0.0;  ///< chance of a rough surface's facets, given the nonspecular part
  double lambert_ = 1.0; ///< chance of the diffuse part against the highlight, given neither
  std::vector<float> facet_light_, bent_light_; ///< scratch
};

} // namespace abbe
