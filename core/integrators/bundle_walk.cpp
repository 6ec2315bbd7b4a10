#include "core/integrators/bundle_walk.h"

#include "core/bands/band_math.h"
#include "core/optics/fresnel.h"
#include "core/optics/shading_side.h"

#include <algorithm>

namespace abbe {

BundleWalk::BundleWalk(const Plan& plan, const World& world, double pixel_angle,
                       Transport transport)
    : plan_(plan), world_(world), wavelengths_(plan), ones_(1.0f, plan.grid.count()),
      transport_(transport), fan_(plan, world, pixel_angle), waiting_(plan.stride),
      carried_(std::make_unique<CarriedBundle>(plan.stride)) {}

void BundleWalk::begin_path(const dvec2& wavelength, RayCounts& counts) {
  counts_ = &counts;
  wavelengths_.begin_path(plan_.settings.jitter ? wavelength.x : 0.5);
  band_choice_ = wavelength.y;
}

void BundleWalk::scale(const float* factors, double weight) {
  const auto w = static_cast<float>(weight);
  const BandSpan<float> target = throughput();
  for (int b = target.bands.first; b < target.bands.last; ++b)
    target[b] *= factors[b] * w;
}

Bundle& BundleWalk::branch_off(BandRange bands, const float* factors, double weight) {
  const auto w = static_cast<float>(weight);
  CarriedBundle& next = waiting_.add(bands);
  const float* source = throughput().data;
  float* target = next.row.data();
  for (int b = bands.first; b < bands.last; ++b)
    target[b] = source[b] * factors[b] * w;
  return next.bundle;
}

dvec3 BundleWalk::reflected_direction() const {
  const Hit& hit = bundle().hit;
  const dvec3 direction = reflected(bundle().state.ray.direction, hit.facing_shading_normal());
  return hit.bent ? kept_on_side(direction, hit.facing_normal(), true) : direction;
}

double BundleWalk::reflected_adjoint() const {
  const Hit& hit = bundle().hit;
  if (transport_ == Transport::radiance || !hit.bent) return 1.0;
  const dvec3& from = bundle().state.ray.direction;
  return adjoint_factor(from, reflected(from, hit.facing_shading_normal()), hit.shading_normal,
                        hit.normal);
}

Bundle& BundleWalk::branch_off_reflection(const float* factors, double weight) {
  Bundle& next = branch_off(bundle().bands, factors, weight);
  set_off(bundle(), reflected_direction(), false, RayKind::reflected, next);
  return next;
}

void BundleWalk::branch_off_refraction(BandRange run, double importance) {
  for (const FanCell& cell :
       fan_.refract(bundle(), run, {importance, band_choice_}, wavelengths_, *counts_))
    go_on_as(cell, bundle(),
             branch_off(cell.bands, ones_.data(),
                        static_cast<double>(cell.weight) *
                            (transport_ == Transport::flux ? cell.adjoint : 1.0)));
}

/// Radiance, but not flux, is n^2 times that outside in a medium of index n. The index is that of
/// the first band that can carry light, whether or not bands before it are carried too: what the
/// plan leaves out must not change a path.
double BundleWalk::importance(float most, int first, MediumId medium) {
  const auto largest = static_cast<double>(most);
  if (transport_ == Transport::flux || !medium.valid()) return largest;
  const double n = wavelengths_.indices(medium)[std::max(first, plan_.live_first)];
  return largest * n * n;
}

double BundleWalk::importance(MediumId medium) {
  const BandSpan<const float> row = throughput();
  return importance(largest_of(row), row.bands.first, medium);
}

} // namespace abbe
