#include "core/integrators/light_paths.h"

#include "core/integrators/absorption.h"
#include "core/integrators/unseen_boundary.h"

#include <algorithm>
#include <cmath>

namespace abbe {

LightPaths::LightPaths(const Plan& plan, const World& world, const CameraRays* camera, Film& film)
    : BundleWalk(plan, world, camera ? camera->pixel_angle() : 0.0, Transport::flux),
      camera_(camera), film_(film), to_camera_(plan, world), sums_(plan), light_(plan.stride) {}

void LightPaths::trace(const EmittedRay& ray, const Sampler& sampler, double share,
                       PhotonBatch* photons, double photon_share, RayCounts& counts) {
  begin(sampler, counts);
  path_sampler_ = &sampler;
  source_ = ray.source;
  flux_ = ray.flux;
  share_ = share;
  photons_ = photons;
  photon_share_ = photon_share;
  bundle_ = Bundle{};
  bundle_.spread = true; // no pixel's width says what is close together
  bundle_.state = ray.state;
  const SourcePlan& source = plan_.sources[static_cast<std::size_t>(ray.source)];
  int first = plan_.first_band, last = plan_.last_band;
  while (first < last && source.factor[first] == 0.0f)
    ++first;
  while (last > first && source.factor[last - 1] == 0.0f)
    --last;
  if (first == last) return;
  bundle_.first = first;
  bundle_.last = last;
  for (int b = first; b < last; ++b)
    throughput_[static_cast<std::size_t>(b)] =
        source.factor[b] != 0.0f ? plan_.live[static_cast<std::size_t>(b)] : 0.0f;
  bundle_.hit = world_.closest(bundle_.state);
  counts.add(RayKind::light, bundle_.state);
  do
    follow();
  while (resume());
}

void LightPaths::follow() {
  while (bundle_.hit && bundle_.depth < plan_.settings.max_depth)
    if (!go_on()) return;
}

bool LightPaths::arrive() {
  for (;;) {
    const Hit& hit = *bundle_.hit;
    absorb(plan_.medium(hit.medium_before), hit.t, bundle_.first, bundle_.last, throughput_.data());
    if (!plan_.unseen(hit)) return true;
    pass_unseen_boundary(bundle_, world_, *counts_);
    if (!bundle_.hit) return false;
  }
}

bool LightPaths::go_on() {
  if (!arrive()) return false;
  const Hit& hit = *bundle_.hit;
  const MaterialPlan& material = plan_.materials[hit.material.index()];
  // Light that is spread at once is the camera paths' to find.
  if (bundle_.depth == 0 && !material.specular_part()) return false;
  scattering_.prepare(material, hit, bundle_.state.ray.direction, bundle_.first, bundle_.last,
                      throughput_.data(), wavelengths_);
  if (bundle_.depth > 0 && scattering_.spreads()) {
    if (camera_) splat(hit);
    if (photons_) keep(hit);
  }
  const auto [kind, chance] =
      scattering_.choose_specular(scattering_.certain() ? 0.0 : numbers(kScatter).x);
  switch (kind) {
  case ScatterKind::reflect:
    return reflect(chance);
  case ScatterKind::refract:
    return refract(chance);
  case ScatterKind::none:
  case ScatterKind::spread:
    break;
  }
  return false;
}

/// Connects the surface with the eye. With the pixels' area A at unit distance along the axis, a
/// place seen at the angle c from the axis and at the distance d adds to the mean radiance of its
/// pixel flux * f * cos / (d^2 cos^3(c) A).
void LightPaths::splat(const Hit& hit) {
  const auto seen = camera_->project(hit.point);
  if (!seen) return;
  // One pixel gets all, chosen by the filter, which is symmetric.
  const dvec2 offset =
      filter_offset(plan_.settings.filter,
                    path_sampler_->pair(kPixelPosition +
                                        kPerSurface * static_cast<std::uint32_t>(bundle_.depth)));
  const dvec2 place = *seen + offset;
  const PixelWindow& window = film_.window();
  if (!(place.x >= window.x0 && place.x < window.x1 && place.y >= window.y0 && place.y < window.y1))
    return;
  const dvec3 way = camera_->eye() - hit.point;
  const double distance2 = glm::dot(way, way);
  const double distance = std::sqrt(distance2);
  const dvec3 direction = way / distance;
  if (!(scattering_.evaluate(direction, light_.data()) > 0.0)) return;
  const bool through = (glm::dot(direction, hit.normal) > 0.0) != hit.entering;
  const RayState to_eye{{hit.point, direction},
                        through ? hit.other_side : hit.same_side,
                        through ? hit.nesting_after : hit.nesting_before};
  const float* arriving = nullptr;
  if (plan_.has_drops) {
    arriving = to_camera_.transmittance(to_eye, distance, bundle_.first, bundle_.last, wavelengths_,
                                        *counts_);
    if (!arriving) return;
  } else {
    counts_->add_any_hit(RayKind::shadow, to_eye, distance);
    if (world_.occluded(to_eye, distance)) return;
  }
  for (int b = bundle_.first; b < bundle_.last; ++b)
    light_[static_cast<std::size_t>(b)] *=
        throughput_[static_cast<std::size_t>(b)] * (arriving ? arriving[b] : 1.0f);
  if (!arriving)
    absorb(plan_.medium(through ? hit.medium_after : hit.medium_before), distance, bundle_.first,
           bundle_.last, light_.data());
  const double cos_c = -glm::dot(direction, camera_->forward());
  const double area = camera_->pixel_angle() * camera_->pixel_angle();
  const double weight = flux_ * share_ / (distance2 * cos_c * cos_c * cos_c * area);
  sums_.clear();
  sums_.add(source_, light_.data(), ones_, static_cast<float>(weight), bundle_.first, bundle_.last);
  film_.add_splat(static_cast<int>(std::floor(place.x)), static_cast<int>(std::floor(place.y)),
                  sums_.color(), film_.bands() > 0 ? sums_.radiance() : std::span<const float>());
}

void LightPaths::keep(const Hit& hit) {
  Photon photon;
  photon.position = hit.point;
  photon.direction = bundle_.state.ray.direction;
  photon.normal = hit.entering ? hit.normal : -hit.normal;
  photon.first = bundle_.first;
  photon.last = bundle_.last;
  photon.source = source_;
  photons_->add(photon, throughput_.data() + bundle_.first, flux_ * photon_share_);
}

} // namespace abbe
