#include "core/materials/scattering.h"

#include "core/materials/conductor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

/// The sum over bands of throughput times a part's factors.
double brought(const float* throughput, const float* factors, int first, int last) {
  float sum = 0.0f;
  for (int b = first; b < last; ++b)
    sum += throughput[b] * factors[b];
  return static_cast<double>(sum);
}

/// A direction with density cos / pi about z, by projecting a disc of concentric rings up
/// [Shirley97].
dvec3 cosine_direction(const dvec2& u) {
  const dvec2 d = 2.0 * u - 1.0;
  if (d.x == 0.0 && d.y == 0.0) return {0.0, 0.0, 1.0};
  const bool by_x = std::abs(d.x) > std::abs(d.y);
  const double radius = by_x ? d.x : d.y;
  const double angle = by_x ? kPi / 4.0 * (d.y / d.x) : kPi / 2.0 - kPi / 4.0 * (d.x / d.y);
  return {radius * std::cos(angle), radius * std::sin(angle),
          std::sqrt(std::max(0.0, 1.0 - radius * radius))};
}

} // namespace

Scattering::Scattering(const Plan& plan, Transport transport) : plan_(plan), transport_(transport) {
  factors_.reflected.resize(plan.stride);
  factors_.transmitted.resize(plan.stride);
}

void Scattering::prepare(const MaterialPlan& material, const Hit& hit, const dvec3& direction,
                         int first, int last, const float* throughput,
                         PathWavelengths& wavelengths) {
  material_ = &material;
  hit_ = &hit;
  first_ = first;
  last_ = last;
  reflect_ = refract_ = spread_ = 0.0;
  if (material.reflects || material.transmits) {
    frame_.z = hit.entering ? hit.normal : -hit.normal;
    to_eye_ = {0.0, 0.0, -glm::dot(direction, frame_.z)};
    find_smooth_parts(throughput, wavelengths);
  }
  if (material.lit) {
    frame_ = Frame(hit.entering ? hit.normal : -hit.normal);
    to_eye_ = frame_.to_local(-direction);
    const double diffuse = brought(throughput, material.diffuse.data(), first, last);
    const double specular = brought(throughput, material.specular.data(), first, last);
    spread_ = diffuse + specular;
    lambert_ = spread_ > 0.0 ? diffuse / spread_ : 1.0;
  }
  const double total = reflect_ + refract_ + spread_;
  if (!(total > 0.0)) return;
  reflect_ /= total;
  refract_ /= total;
  spread_ /= total;
}

void Scattering::find_smooth_parts(const float* throughput, PathWavelengths& wavelengths) {
  const double cos_i = std::min(1.0, std::abs(to_eye_.z));
  const MaterialPlan& material = *material_;
  if (material.dielectric) {
    const double* before = wavelengths.indices(hit_->medium_before);
    const double* after = wavelengths.indices(hit_->medium_after);
    scatter_dielectric(material, cos_i, before, after, first_, last_, factors_, transport_);
    // Radiance in a dense medium is n^2 times that outside and will lose this again: what counts
    // is the flux.
    const int b = std::max(first_, plan_.live_first); // whether or not dead bands are carried
    const double eta = transport_ == Transport::radiance ? after[b] / before[b] : 1.0;
    if (material.transmits)
      refract_ = eta * eta * brought(throughput, factors_.transmitted.data(), first_, last_);
  } else if (material.conductor) {
    reflect_conductor(material, cos_i, wavelengths.indices(hit_->medium_before), first_, last_,
                      factors_.reflected.data());
  } else {
    std::copy_n(material.reflectivity.data() + first_, last_ - first_,
                factors_.reflected.data() + first_);
  }
  if (material.reflects) reflect_ = brought(throughput, factors_.reflected.data(), first_, last_);
}

Scattering::Choice Scattering::choose(double u) const {
  if (u < spread_) return {ScatterKind::spread, spread_};
  if (u < spread_ + reflect_) return {ScatterKind::reflect, reflect_};
  if (refract_ > 0.0) return {ScatterKind::refract, refract_};
  if (reflect_ > 0.0) return {ScatterKind::reflect, reflect_}; // u was rounded past the sum
  if (spread_ > 0.0) return {ScatterKind::spread, spread_};
  return {};
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

double Scattering::evaluate(const dvec3& towards, float* f_cos) const {
  const double cosine = glm::dot(towards, frame_.z);
  if (!(cosine > 0.0)) return 0.0;
  const float lambert = static_cast<float>(cosine / kPi);
  const float* diffuse = material_->diffuse.data();
  for (int b = first_; b < last_; ++b)
    f_cos[b] = diffuse[b] * lambert;
  double density = lambert_ * cosine / kPi;
  if (!material_->specular.zero()) {
    // The thesis's highlight has no cosine; see docs/decisions/materials-and-light.md.
    const dvec3 local = frame_.to_local(towards);
    const dvec3 half = glm::normalize(to_eye_ + local);
    const double e = static_cast<double>(material_->specular_exponent);
    const auto phong = static_cast<float>(std::pow(std::max(0.0, half.z), e) / kPi);
    const float* specular = material_->specular.data();
    for (int b = first_; b < last_; ++b)
      f_cos[b] += specular[b] * phong;
    density += (1.0 - lambert_) * phong_density(local);
  }
  return spread_ * density;
}

std::optional<dvec3> Scattering::sample(const dvec2& u) const {
  dvec3 local;
  if (u.x < lambert_) {
    local = cosine_direction({u.x / lambert_, u.y});
  } else {
    const double x = (u.x - lambert_) / (1.0 - lambert_);
    const double e = static_cast<double>(material_->specular_exponent);
    const double z = std::pow(x, 1.0 / (e + 1.0));
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    const dvec3 half{r * std::cos(2.0 * kPi * u.y), r * std::sin(2.0 * kPi * u.y), z};
    local = 2.0 * glm::dot(to_eye_, half) * half - to_eye_;
  }
  if (!(local.z > 0.0)) return std::nullopt;
  return glm::normalize(frame_.to_world(local));
}

} // namespace abbe
