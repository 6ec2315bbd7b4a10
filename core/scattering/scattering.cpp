#include "core/scattering/scattering.h"

#include "core/bands/band_math.h"
#include "core/emitters/cone.h"
#include "core/optics/coated_diffuse.h"
#include "core/optics/rough_conductor.h"
#include "core/optics/rough_dielectric.h"
#include "core/scattering/conductor.h"
#include "core/scattering/material_optics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

/// A direction with density cos / pi about z, by projecting a disc up.
dvec3 cosine_direction(const dvec2& u) {
  const dvec2 p = disc_point(u);
  return {p.x, p.y, std::sqrt(std::max(0.0, 1.0 - glm::dot(p, p)))};
}

/// The coat of a coated material, which has one.
CoatedDiffuse coated(const MaterialPlan& material, const BandTable& diffuse) {
  CoatedDiffuse surface{diffuse.data(), std::nullopt, nullptr};
  if (material.glass_albedo) {
    surface.rough = Ggx::from_roughness(material.roughness);
    surface.albedo = &*material.glass_albedo;
  }
  return surface;
}

} // namespace

Scattering::Scattering(const Plan& plan, Transport transport)
    : plan_(plan), transport_(transport), facet_light_(plan.stride) {
  factors_.reflected.resize(plan.stride);
  factors_.transmitted.resize(plan.stride);
}

/// The sum over bands of throughput times a part's factors.
double Scattering::brought(const float* factors) const {
  return static_cast<double>(weighted_sum(throughput_, factors, first_, last_));
}

/// A rough boundary between media of the same index is none, and so is not rough.
bool Scattering::rough() const {
  if (material_->roughness == 0.0 || !(to_eye_.z > 0.0)) return false;
  if (!material_->dielectric) return true;
  for (int b = first_; b < last_; ++b)
    if (optics_.n_before[b] != optics_.n_after[b]) return true;
  return false;
}

void Scattering::prepare(const MaterialPlan& material, const BandTable& diffuse, const Hit& hit,
                         const dvec3& direction, int first, int last, const float* throughput,
                         PathWavelengths& wavelengths) {
  material_ = &material;
  diffuse_ = &diffuse;
  hit_ = &hit;
  first_ = first;
  last_ = last;
  throughput_ = throughput;
  reflect_ = refract_ = spread_ = facets_ = 0.0;
  const dvec3 normal = hit.entering ? hit.normal : -hit.normal;
  if (material.lit || material.roughness > 0.0) {
    frame_ = Frame(normal);
    to_eye_ = frame_.to_local(-direction);
  } else {
    frame_.z = normal;
    to_eye_ = {0.0, 0.0, -glm::dot(direction, normal)};
  }
  if (material.reflects || material.transmits) find_smooth_parts(wavelengths);
  find_spreading_parts();
  const double total = reflect_ + refract_ + spread_;
  if (!(total > 0.0)) return;
  reflect_ /= total;
  refract_ /= total;
  spread_ /= total;
}

void Scattering::find_smooth_parts(PathWavelengths& wavelengths) {
  const double cos_i = std::min(1.0, std::abs(to_eye_.z));
  const MaterialPlan& material = *material_;
  const bool layered = material.film >= 0 || material.coat >= 0;
  if (layered || material.roughness > 0.0)
    optics_ = material_optics(material, hit_->medium_before, hit_->medium_after, wavelengths);
  float* reflected = factors_.reflected.data();
  if (layered) {
    scatter_smooth(optics_, cos_i, first_, last_, transport_, reflected,
                   material.transmits ? factors_.transmitted.data() : nullptr);
  } else if (material.dielectric) {
    scatter_dielectric(material, cos_i, wavelengths.indices(hit_->medium_before),
                       wavelengths.indices(hit_->medium_after), first_, last_, factors_,
                       transport_);
  } else if (material.conductor) {
    reflect_conductor(material, cos_i, wavelengths.indices(hit_->medium_before), first_, last_,
                      reflected);
  } else {
    std::copy_n(material.reflectivity.data() + first_, last_ - first_, reflected + first_);
  }
  if (material.transmits) {
    // Radiance in a dense medium is n^2 times that outside and will lose this again: what counts
    // is the flux.
    const int b = std::max(first_, plan_.live_first); // whether or not dead bands are carried
    const double eta = transport_ == Transport::radiance
                           ? wavelengths.indices(hit_->medium_after)[b] /
                                 wavelengths.indices(hit_->medium_before)[b]
                           : 1.0;
    refract_ = eta * eta * brought(factors_.transmitted.data());
  }
  if (material.reflects) reflect_ = brought(reflected);
}

/// What facets reflect and refract is spread, in proportion to what a smooth surface would bring.
void Scattering::find_spreading_parts() {
  // Lambert's part alone needs no comparing.
  if (!material_->reflects && !material_->transmits && material_->specular.zero()) {
    spread_ = diffuse_->zero() ? 0.0 : 1.0;
    lambert_ = 1.0;
    return;
  }
  double diffuse = brought(diffuse_->data());
  const double phong = brought(material_->specular.data());
  if (material_->coat >= 0 && rough()) {
    diffuse += reflect_;
    reflect_ = 0.0;
  }
  spread_ = diffuse + phong;
  lambert_ = spread_ > 0.0 ? diffuse / spread_ : 1.0;
  if (!material_->specular_part() && material_->coat < 0 &&
      (material_->reflects || material_->transmits)) {
    if (!rough()) return; // seen along the surface, or through none
    const double facets = reflect_ + refract_;
    reflect_ = refract_ = 0.0;
    spread_ += facets;
    facets_ = spread_ > 0.0 ? facets / spread_ : 0.0;
  }
}

Scattering::Choice Scattering::choose(double u) const {
  if (u < spread_) return {ScatterKind::spread, spread_};
  if (u < spread_ + reflect_) return {ScatterKind::reflect, reflect_};
  if (refract_ > 0.0) return {ScatterKind::refract, refract_};
  if (reflect_ > 0.0) return {ScatterKind::reflect, reflect_}; // u was rounded past the sum
  if (spread_ > 0.0) return {ScatterKind::spread, spread_};
  return {};
}

Scattering::Branches Scattering::branch(double u, double eagerness) const {
  const double other = spread_ + refract_;
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
    branches.on = chosen < spread_ || refract_ == 0.0
                      ? Choice{ScatterKind::spread, on * (spread_ / other)}
                      : Choice{ScatterKind::refract, on * (refract_ / other)};
  }
  return branches;
}

Scattering::Choice Scattering::choose_specular(double u) const {
  const double sum = reflect_ + refract_;
  if (!(sum > 0.0)) return {};
  const double share = reflect_ / sum;
  if (refract_ == 0.0 || u < share) return {ScatterKind::reflect, share};
  return {ScatterKind::refract, refract_ / sum};
}

/// Of Blinn's half vector: (e + 1) / (2 pi) cos^e about z, over four times the cosine between the
/// eye and it.
double Scattering::phong_density(const dvec3& local) const {
  const dvec3 half = glm::normalize(to_eye_ + local);
  const double e = static_cast<double>(material_->specular_exponent);
  const double cosine = glm::dot(to_eye_, half);
  if (!(cosine > 0.0)) return 0.0;
  return (e + 1.0) / (8.0 * kPi * cosine) * std::pow(std::max(0.0, half.z), e);
}

double Scattering::evaluate_facets(const dvec3& local, float* f_cos) const {
  const BandSet bands{first_, last_, throughput_};
  const Ggx ggx = Ggx::from_roughness(material_->roughness);
  const auto table = [](const auto& albedo) { return albedo ? &*albedo : nullptr; };
  if (material_->dielectric)
    return evaluate_rough_dielectric({ggx, table(material_->glass_albedo)}, optics_, to_eye_, local,
                                     bands, transport_, f_cos);
  return evaluate_rough_conductor({ggx, table(material_->mirror_albedo)}, optics_, to_eye_, local,
                                  bands, f_cos);
}

std::optional<dvec3> Scattering::sample_facets(const dvec2& u, const dvec2& lobe) const {
  const Ggx ggx = Ggx::from_roughness(material_->roughness);
  const auto table = [](const auto& albedo) { return albedo ? &*albedo : nullptr; };
  if (material_->dielectric)
    return sample_rough_dielectric({ggx, table(material_->glass_albedo)}, optics_, to_eye_,
                                   live_band(lobe.y), u, lobe.x);
  return sample_rough_conductor({ggx, table(material_->mirror_albedo)}, to_eye_, u, lobe.x);
}

/// Lambert's part, or that of a coated ground.
double Scattering::evaluate_diffuse(const dvec3& local, float* f_cos) const {
  if (material_->coat >= 0 && to_eye_.z > 0.0) {
    const double density = evaluate_coated_diffuse(coated(*material_, *diffuse_), optics_, to_eye_,
                                                   local, {first_, last_, throughput_}, f_cos);
    return material_->roughness > 0.0 ? density : local.z / kPi;
  }
  const float lambert = static_cast<float>(local.z / kPi);
  const float* diffuse = diffuse_->data();
  for (int b = first_; b < last_; ++b)
    f_cos[b] = diffuse[b] * lambert;
  return local.z / kPi;
}

std::optional<dvec3> Scattering::sample_diffuse(const dvec2& u, const dvec2& lobe) const {
  if (material_->coat >= 0 && rough())
    return sample_coated_diffuse(coated(*material_, *diffuse_), optics_, to_eye_, live_band(lobe.y),
                                 u, lobe.x);
  return cosine_direction(u);
}

dvec3 Scattering::sample_phong(const dvec2& u) const {
  const double e = static_cast<double>(material_->specular_exponent);
  const double z = std::pow(u.x, 1.0 / (e + 1.0));
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  const dvec3 half(r * circle_point(u.y), z);
  return 2.0 * glm::dot(to_eye_, half) * half - to_eye_;
}

/// One of the bands that carry light.
int Scattering::live_band(double choice) const {
  const auto live = [&](int b) { return throughput_[b] != 0.0f; };
  int count = 0;
  for (int b = first_; b < last_; ++b)
    count += live(b);
  int left = static_cast<int>(choice * count);
  for (int b = first_; b < last_; ++b)
    if (live(b) && left-- == 0) return b;
  return first_;
}

double Scattering::evaluate(const dvec3& towards, float* f_cos) {
  const double cosine = glm::dot(towards, frame_.z);
  double density = 0.0;
  if (cosine > 0.0 && facets_ < 1.0) {
    const dvec3 local = frame_.to_local(towards);
    density = lambert_ * evaluate_diffuse(local, f_cos);
    if (!material_->specular.zero()) {
      // The thesis's highlight has no cosine; see docs/decisions/materials-and-light.md.
      const dvec3 half = glm::normalize(to_eye_ + local);
      const double e = static_cast<double>(material_->specular_exponent);
      const auto phong = static_cast<float>(std::pow(std::max(0.0, half.z), e) / kPi);
      const float* specular = material_->specular.data();
      for (int b = first_; b < last_; ++b)
        f_cos[b] += specular[b] * phong;
      density += (1.0 - lambert_) * phong_density(local);
    }
    density *= 1.0 - facets_;
  } else {
    std::fill(f_cos + first_, f_cos + last_, 0.0f);
  }
  if (facets_ > 0.0) {
    density += facets_ * evaluate_facets(frame_.to_local(towards), facet_light_.data());
    for (int b = first_; b < last_; ++b)
      f_cos[b] += facet_light_[static_cast<std::size_t>(b)];
  }
  return spread_ * density;
}

std::optional<dvec3> Scattering::sample(const dvec2& u, const dvec2& lobe) const {
  std::optional<dvec3> local;
  if (lobe.x < facets_) {
    local = sample_facets(u, {lobe.x / facets_, lobe.y});
  } else {
    const dvec2 rest{(lobe.x - facets_) / (1.0 - facets_), lobe.y};
    if (u.x < lambert_)
      local = sample_diffuse({u.x / lambert_, u.y}, rest);
    else
      local = sample_phong({(u.x - lambert_) / (1.0 - lambert_), u.y});
    if (!(local && local->z > 0.0)) return std::nullopt;
  }
  if (!local) return std::nullopt;
  return frame_.to_world(*local);
}

} // namespace abbe
