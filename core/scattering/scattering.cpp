#include "core/scattering/scattering.h"

#include "core/bands/band_math.h"
#include "core/optics/shading_side.h"
#include "core/scattering/surface_incidence.h"

#include <algorithm>
#include <cmath>

namespace abbe {

Scattering::Scattering(const Plan& plan, Transport transport)
    : plan_(plan), transport_(transport), reflected_(plan.stride), transmitted_(plan.stride),
      facet_light_(plan.stride), bent_light_(plan.stride) {}

/// The sum over bands of throughput times a part's factors.
double Scattering::brought(const float* factors) const {
  return static_cast<double>(weighted_sum(in_.live, factors, in_.bands.first, in_.bands.last));
}

/// A rough boundary between media of the same index bends no light and counts as smooth.
bool Scattering::rough() const {
  if (!facts_.rough || !(in_.wo.z > 0.0)) return false;
  if (!facts_.transmits) return true;
  for (int b = in_.bands.first; b < in_.bands.last; ++b)
    if (in_.n_before[b] != in_.n_after[b]) return true;
  return false;
}

void Scattering::prepare(const MaterialPlan& material, const BandTable& diffuse, const Hit& hit,
                         const dvec3& direction, BandSpan<const float> throughput,
                         PathWavelengths& wavelengths) {
  material_ = &material;
  facts_ = facts_of(material.bsdf);
  diffuse_ = &diffuse;
  in_.bands = throughput.bands;
  in_.live = throughput.data;
  reflect_ = refract_ = nonspecular_ = facets_ = 0.0;
  const dvec3 normal = hit.facing_shading_normal();
  bent_ = hit.bent;
  if (bent_) {
    true_normal_ = hit.facing_normal();
    from_ = direction;
  }
  dvec3 wo{0.0};
  if (material.lit() || facts_.rough) {
    frame_ = Frame(normal);
    wo = frame_.to_local(-direction);
  } else {
    frame_.z = normal;
    wo = {0.0, 0.0, -glm::dot(direction, normal)};
  }
  in_.wo = wo;
  if (facts_.goes_on()) find_smooth_parts(hit, wavelengths);
  in_.ground = diffuse.data();
  find_nonspecular_parts();
  const double total = reflect_ + refract_ + nonspecular_;
  if (!(total > 0.0)) return;
  reflect_ /= total;
  refract_ /= total;
  nonspecular_ /= total;
}

void Scattering::find_smooth_parts(const Hit& hit, PathWavelengths& wavelengths) {
  const Incidence at = surface_incidence(material_->bsdf, hit, in_.bands, wavelengths);
  in_.n_before = at.n_before;
  in_.n_after = at.n_after;
  in_.n_layer = at.n_layer;
  in_.lambda_nm = at.lambda_nm;
  in_.transport = transport_;
  specular_factors(material_->bsdf, in_, {reflected_.data(), transmitted_.data()});
  if (facts_.transmits) {
    // Radiance in a dense medium is n^2 times that outside and will lose this again: what counts
    // is the flux.
    const int b =
        std::max(in_.bands.first, plan_.live_first); // whether or not dead bands are carried
    const double eta = transport_ == Transport::radiance ? in_.n_after[b] / in_.n_before[b] : 1.0;
    refract_ = eta * eta * brought(transmitted_.data());
  }
  if (facts_.passes) refract_ = brought(transmitted_.data());
  if (facts_.reflects) reflect_ = brought(reflected_.data());
}

/// What facets reflect and refract is nonspecular, in proportion to what a smooth surface would
/// bring.
void Scattering::find_nonspecular_parts() {
  // Lambert's part alone needs no comparing.
  if (!facts_.goes_on() && !material_->phong.present()) {
    nonspecular_ = diffuse_->zero() ? 0.0 : 1.0;
    lambert_ = 1.0;
    return;
  }
  double diffuse = brought(diffuse_->data());
  const double phong = brought(material_->phong.reflectance.data());
  const bool rough = this->rough();
  if (facts_.coats && rough) {
    diffuse += reflect_;
    reflect_ = 0.0;
  }
  nonspecular_ = diffuse + phong;
  lambert_ = nonspecular_ > 0.0 ? diffuse / nonspecular_ : 1.0;
  if (!facts_.rough || facts_.coats || !rough) return; // not rough when seen along the surface
  const double facets = reflect_ + refract_;
  reflect_ = refract_ = 0.0;
  nonspecular_ += facets;
  facets_ = nonspecular_ > 0.0 ? facets / nonspecular_ : 0.0;
}

Scattering::Choice Scattering::choose(double u) const {
  if (u < nonspecular_) return {ScatterKind::nonspecular, nonspecular_};
  if (u < nonspecular_ + reflect_) return {ScatterKind::reflect, reflect_};
  if (refract_ > 0.0) return {through(), refract_};
  if (reflect_ > 0.0) return {ScatterKind::reflect, reflect_}; // u was rounded past the sum
  if (nonspecular_ > 0.0) return {ScatterKind::nonspecular, nonspecular_};
  return {};
}

Scattering::Branches Scattering::branch(double u, double eagerness) const {
  const double other = nonspecular_ + refract_;
  if (!(eagerness > 1.0) || reflect_ == 0.0 || other == 0.0) {
    const Choice one = choose(u);
    if (one.kind == ScatterKind::reflect) return {one.chance, {}};
    return {0.0, one};
  }
  Branches branches;
  const double reflect = std::min(1.0, reflect_ * eagerness);
  const double on = std::min(1.0, other * eagerness);
  if (u < reflect) branches.reflect_chance = reflect;
  if (u >= 1.0 - on) {
    const double chosen = (u - (1.0 - on)) / on * other;
    branches.on = chosen < nonspecular_ || refract_ == 0.0
                      ? Choice{ScatterKind::nonspecular, on * (nonspecular_ / other)}
                      : Choice{through(), on * (refract_ / other)};
  }
  return branches;
}

Scattering::Choice Scattering::choose_specular(double u) const {
  const double sum = reflect_ + refract_;
  if (!(sum > 0.0)) return {};
  const double share = reflect_ / sum;
  if (refract_ == 0.0 || u < share) return {ScatterKind::reflect, share};
  return {through(), refract_ / sum};
}

double Scattering::evaluate(const dvec3& towards, float* f_cos) {
  return bent_ ? evaluate_bent(towards, f_cos) : evaluate_by_shading(towards, f_cos);
}

/// Directions that are on the wrong side of the true surface have been mirrored at it, so each
/// direction stands for itself and for its mirror image, as far as these are kept.
double Scattering::evaluate_bent(const dvec3& towards, float* f_cos) {
  std::fill(f_cos + in_.bands.first, f_cos + in_.bands.last, 0.0f);
  const double along = glm::dot(towards, true_normal_);
  const bool above = along > 0.0;
  return add_if_kept(towards, above, f_cos) +
         add_if_kept(towards - 2.0 * along * true_normal_, above, f_cos);
}

/// Adds what goes to a direction that the shading normal puts on a side. Returns its pdf.
double Scattering::add_if_kept(const dvec3& towards, bool above, float* f_cos) {
  if ((glm::dot(towards, frame_.z) > 0.0) != above) return 0.0;
  const double pdf = evaluate_by_shading(towards, bent_light_.data());
  if (!(pdf > 0.0)) return 0.0;
  const auto factor = static_cast<float>(
      transport_ == Transport::flux ? adjoint_factor(from_, towards, frame_.z, true_normal_) : 1.0);
  for (int b = in_.bands.first; b < in_.bands.last; ++b)
    f_cos[b] += factor * bent_light_[static_cast<std::size_t>(b)];
  return pdf;
}

double Scattering::evaluate_by_shading(const dvec3& towards, float* f_cos) {
  const double cosine = glm::dot(towards, frame_.z);
  double pdf = 0.0;
  if (cosine > 0.0 && facets_ < 1.0) {
    const dvec3 local = frame_.to_local(towards);
    pdf = lambert_ * (facts_.coats ? abbe::evaluate(material_->bsdf, in_, local, f_cos)
                                   : Diffuse().evaluate(in_, local, f_cos));
    if (material_->phong.present())
      pdf += (1.0 - lambert_) * material_->phong.add(in_, local, f_cos);
    pdf *= 1.0 - facets_;
  } else {
    std::fill(f_cos + in_.bands.first, f_cos + in_.bands.last, 0.0f);
  }
  if (facets_ > 0.0) {
    pdf += facets_ *
           abbe::evaluate(material_->bsdf, in_, frame_.to_local(towards), facet_light_.data());
    for (int b = in_.bands.first; b < in_.bands.last; ++b)
      f_cos[b] += facet_light_[static_cast<std::size_t>(b)];
  }
  return nonspecular_ * pdf;
}

std::optional<dvec3> Scattering::sample_local(const dvec2& u, const dvec2& lobe) const {
  if (lobe.x < facets_) return abbe::sample(material_->bsdf, in_, u, {lobe.x / facets_, lobe.y});
  std::optional<dvec3> local;
  if (u.x < lambert_) {
    const dvec2 rest{u.x / lambert_, u.y};
    const dvec2 rest_of_lobe{(lobe.x - facets_) / (1.0 - facets_), lobe.y};
    local = facts_.coats ? abbe::sample(material_->bsdf, in_, rest, rest_of_lobe)
                         : Diffuse().sample(in_, rest, rest_of_lobe);
  } else {
    local = material_->phong.sample(in_, {(u.x - lambert_) / (1.0 - lambert_), u.y});
  }
  if (!(local && local->z > 0.0)) return std::nullopt;
  return local;
}

std::optional<BsdfSample> Scattering::sample(const dvec2& u, const dvec2& lobe, float* f_cos) {
  const auto local = sample_local(u, lobe);
  if (!local) return std::nullopt;
  dvec3 direction = frame_.to_world(*local);
  if (bent_) direction = kept_on_side(direction, true_normal_, local->z > 0.0);
  const double pdf = evaluate(direction, f_cos);
  if (!(pdf > 0.0)) return std::nullopt;
  return BsdfSample{direction, pdf};
}

} // namespace abbe
