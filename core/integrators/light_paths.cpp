#include "core/integrators/light_paths.h"

#include "core/integrators/absorption.h"
#include "core/integrators/unseen_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace abbe {
namespace {

/// One of the pixels of a row or column whose filters reach a place.
struct FilteredPixel {
  int pixel;
  double weight; ///< the filter's value there over the chance of this pixel
};

/// Chosen in proportion to the filters' values, by a number in [0, 1).
FilteredPixel filtered_pixel(PixelFilter filter, double place, double u) {
  const double radius = filter_radius(filter);
  const int first = static_cast<int>(std::floor(std::clamp(place, -1e9, 1e9) - radius - 0.5));
  constexpr int kMost = 5;
  std::array<double, kMost> values{};
  double sum = 0.0;
  for (int i = 0; i < kMost; ++i)
    sum += values[static_cast<std::size_t>(i)] = filter_density(filter, place - (first + i + 0.5));
  double rest = u * sum;
  int chosen = 0;
  while (chosen < kMost - 1 && rest >= values[static_cast<std::size_t>(chosen)])
    rest -= values[static_cast<std::size_t>(chosen++)];
  return {first + chosen, sum};
}

} // namespace

LightPaths::LightPaths(const Plan& plan, const World& world, const Emission& emission,
                       const CameraRays* camera, Film& film)
    : BundleWalk(plan, world, camera ? camera->pixel_angle() : 0.0, Transport::flux),
      emission_(emission), camera_(camera), film_(film), to_camera_(plan, world), sums_(plan),
      light_(plan.stride) {}

void LightPaths::trace(const EmittedRay& ray, const Sampler& sampler, double share,
                       PhotonBatch* photons, double photon_share, RayCounts& counts) {
  begin(sampler, counts);
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
  world_.find_closest(bundle_.state, bundle_.hit);
  counts.add(RayKind::light, bundle_.state);
  do
    follow();
  while (resume());
}

void LightPaths::follow() {
  while (bundle_.hit.met() && bundle_.depth < plan_.settings.max_depth)
    if (!go_on()) return;
}

bool LightPaths::arrive() {
  Passage passage;
  for (;;) {
    const Hit& hit = bundle_.hit;
    absorb(plan_.medium(hit.medium_before), hit.t, bundle_.first, bundle_.last, throughput_.data());
    if (!plan_.unseen(hit)) return true;
    pass_unseen_boundary(bundle_, world_, passage, *counts_);
    if (!bundle_.hit.met()) return false;
  }
}

bool LightPaths::go_on() {
  if (!arrive()) return false;
  const Hit& hit = bundle_.hit;
  const MaterialPlan& material = find_material();
  // Light that is spread at once, from its lamp or again, is the camera paths' to find.
  const bool at_once = bundle_.depth == 0 || bundle_.density > 0.0;
  if (at_once && !material.specular_part()) return false;
  prepare_scattering();
  if (!at_once) {
    if (camera_ && scattering_.spreads()) splat(hit);
    // On a mixture photons are all light that arrives: who looks them up chooses the part.
    const MaterialPlan& whole = plan_.materials[hit.material.index()];
    const bool first = bundle_.spreads == 0;
    if (camera_ && first && scattering_.spreads()) go_on_from_spread(hit);
    if (photons_ && first && (whole.mixed() ? whole.lit : scattering_.spreads())) keep(hit);
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

/// A sub-bundle towards something that mirrors or refracts: what comes that way to a surface that
/// the camera sees would reach it by rare and strong photons otherwise.
void LightPaths::go_on_from_spread(const Hit& hit) {
  const DirectionSample way = towards(emission_.targets(), hit.point, numbers(kDirection));
  if (!(scattering_.evaluate(way.direction, light_.data()) > 0.0)) return;
  const bool through = (glm::dot(way.direction, hit.normal) > 0.0) != hit.entering;
  Bundle& next = push(bundle_.first, bundle_.last, light_.data(), 1.0 / way.density);
  trace_from(bundle_, way.direction, through, RayKind::spread, next);
  next.density = way.density;
  next.spreads = 1;
}

/// Connects the surface with the eye. With the pixels' area A at unit distance along the axis, a
/// place seen at the angle c from the axis and at the distance d adds to the mean radiance of its
/// pixel flux * f * cos / (d^2 cos^3(c) A).
void LightPaths::splat(const Hit& hit) {
  const auto seen = camera_->project(hit.point);
  if (!seen) return;
  const dvec2 u = numbers(kSplat);
  const FilteredPixel column = filtered_pixel(plan_.settings.filter, seen->x, u.x);
  const FilteredPixel row = filtered_pixel(plan_.settings.filter, seen->y, u.y);
  const PixelWindow& window = film_.window();
  if (column.pixel < window.x0 || column.pixel >= window.x1 || row.pixel < window.y0 ||
      row.pixel >= window.y1)
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
  const double weight =
      flux_ * share_ * column.weight * row.weight / (distance2 * cos_c * cos_c * cos_c * area);
  sums_.clear();
  sums_.add(source_, light_.data(), ones_, static_cast<float>(weight), bundle_.first, bundle_.last);
  ++counts_->splats;
  film_.add_splat(column.pixel, row.pixel, sums_.color(),
                  film_.bands() > 0 ? sums_.radiance() : std::span<const float>(),
                  numbers(kSplatRounding).x);
}

void LightPaths::keep(const Hit& hit) {
  Photon photon;
  photon.position = hit.point;
  photon.direction = bundle_.state.ray.direction;
  photon.normal = hit.entering ? hit.normal : -hit.normal;
  photon.first = bundle_.first;
  photon.last = bundle_.last;
  photon.source = source_;
  ++counts_->photons;
  photons_->add(photon, throughput_.data() + bundle_.first, flux_ * photon_share_);
}

} // namespace abbe
