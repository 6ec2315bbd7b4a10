#include "core/integrators/light_paths.h"

#include "core/film/lost_light.h"
#include "core/integrators/absorption.h"
#include "core/integrators/beyond_limit.h"
#include "core/integrators/straight_on.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
    sum += values[static_cast<std::size_t>(i)] = filter_pdf(filter, place - (first + i + 0.5));
  double rest = u * sum;
  int chosen = 0;
  while (chosen < kMost - 1 && rest >= values[static_cast<std::size_t>(chosen)])
    rest -= values[static_cast<std::size_t>(chosen++)];
  return {first + chosen, sum};
}

} // namespace

LightPaths::LightPaths(const Plan& plan, const World& world, const Emission& emission,
                       const PlacedCamera* camera, Film& film)
    : RandomWalk(plan, world, camera ? camera->pixel_angle() : 0.0, Transport::flux),
      emission_(emission), camera_(camera), film_(film), lost_splats_(film.find(kLostSplats)),
      half_splats_(film.find(kHalfSplats)), to_camera_(plan, world), sums_(plan),
      light_(plan.stride), limit_(depth_limit(plan.settings)), part_layers_(plan, film),
      parts_(plan) {
  if (plan.settings.relightable) sums_.divide(&parts_);
}

bool LightPaths::trace(const EmittedRay& ray, const Sampler& sampler, double share,
                       PhotonBatch* photons, double photon_share, RayCounts& counts) {
  begin(sampler, counts);
  source_ = ray.source;
  flux_ = ray.flux;
  share_ = share;
  photons_ = photons;
  photon_share_ = photon_share;
  // One number decides for all of its branches.
  goes_beyond_ = limit_ < std::numeric_limits<int>::max() &&
                 sampler.decisions(1).next() * BeyondLimit::kOneIn < 1.0;
  if (!start(ray)) return true;
  wait();
  while (take()) {
    if (end_check_.gives_up()) {
      give_up();
      return false;
    }
    extend();
    shade();
  }
  return true;
}

void LightPaths::add_splats() {
  const std::size_t bands = static_cast<std::size_t>(film_.bands());
  const std::size_t units =
      plan_.settings.relightable ? static_cast<std::size_t>(plan_.grid.count()) : 0;
  const std::size_t parts =
      plan_.settings.band_images ? static_cast<std::size_t>(plan_.grid.count()) : 0;
  const float* radiance = held_radiance_.data();
  const float* unit = held_unit_.data();
  const Xyz* part = held_bands_.data();
  for (const HeldSplat& s : held_) {
    if (s.lost) {
      film_.splat(*lost_splats_, s.x, s.y, s.color, s.rounding);
      continue;
    }
    film_.add_splat(s.x, s.y, s.color, {radiance, bands}, s.rounding);
    radiance += bands;
    if (half_splats_ && s.first_half) film_.splat(*half_splats_, s.x, s.y, s.color, s.rounding);
    if (part_layers_.empty()) continue;
    part_layers_.splat(s.x, s.y, s.color, {unit, units},
                       {plan_.sources[static_cast<std::size_t>(s.source)].group,
                        View::direct,
                        s.arrival,
                        {part, parts}},
                       s.rounding);
    unit += units;
    part += parts;
  }
  drop_splats();
}

void LightPaths::drop_splats() {
  held_.clear();
  held_radiance_.clear();
  held_unit_.clear();
  held_bands_.clear();
}

bool LightPaths::start(const EmittedRay& ray) {
  const SourcePlan& source = plan_.sources[static_cast<std::size_t>(ray.source)];
  BandRange lit{plan_.first_band, plan_.last_band};
  // A relightable rendering decides as if the light were in all bands.
  const bool all = plan_.settings.relightable;
  while (!all && !lit.empty() && source.factor[lit.first] == 0.0f)
    ++lit.first;
  while (!all && !lit.empty() && source.factor[lit.last - 1] == 0.0f)
    --lit.last;
  if (lit.empty()) return false;
  bundle() = Bundle{};
  bundle().bands = lit;
  bundle().state = ray.state;
  bundle().kind = RayKind::light;
  bundle().has_pixel_footprint = false;
  // Both tables are read in every band, so that the loop runs in whole registers.
  const float *const factor = source.factor.data(), *const live = plan_.live.data();
  float* const row = throughput().data;
  for (int b = lit.first; b < lit.last; ++b) {
    const float carried = live[b];
    row[b] = all || factor[b] != 0.0f ? carried : 0.0f;
  }
  if (ray.environment) plan_.environment->scale(-ray.state.ray.direction, {row, lit});
  return true;
}

bool LightPaths::arrive() {
  const Hit& hit = bundle().hit;
  absorb(plan_.medium(hit.medium_before), hit.t, throughput());
  if (!plan_.unseen(hit)) return true;
  go_straight_on(bundle());
  return false;
}

void LightPaths::shade() {
  const Hit& hit = bundle().hit;
  if (!hit.met() || (beyond_limit() && !goes_beyond_)) return;
  if (!arrive()) return wait();
  const MaterialPlan& material = find_material();
  // Light that comes straight from its light, or that a surface has just scattered other than
  // specularly, is left to the camera paths.
  const bool at_once = bundle().depth == 0 || bundle().pdf > 0.0;
  if (at_once && !material.facts().specular()) return;
  prepare_scattering();
  if (!at_once) {
    if (camera_ && scattering_.has_nonspecular()) splat(hit);
    // On a mixture photons are all light that arrives: who looks them up chooses the part.
    const MaterialPlan& whole = plan_.materials[hit.material.index()];
    const bool first = bundle().nonspecular_bounces == 0;
    if (camera_ && first && scattering_.has_nonspecular()) branch_off_to_specular(hit);
    if (photons_ && first && (whole.mixture ? whole.lit() : scattering_.has_nonspecular()))
      keep(hit);
  }
  const auto [kind, chance] =
      scattering_.choose_specular(scattering_.certain() ? 0.0 : numbers(kScatter).x);
  switch (kind) {
  case ScatterKind::reflect:
    return reflect(chance);
  case ScatterKind::refract:
    return refract(chance);
  case ScatterKind::pass:
    return pass(chance);
  case ScatterKind::none:
  case ScatterKind::nonspecular:
    break;
  }
}

/// A sub-bundle towards something that mirrors or refracts: what comes that way to a surface that
/// the camera sees would reach it by rare and strong photons otherwise.
void LightPaths::branch_off_to_specular(const Hit& hit) {
  const DirectionSample chosen = towards(emission_.targets(), hit.point, numbers(kDirection));
  if (!(scattering_.evaluate(chosen.direction, light_.data()) > 0.0)) return;
  const bool through = (glm::dot(chosen.direction, hit.normal) > 0.0) != hit.entering;
  Bundle& next = branch_off(bundle().bands, light_.data(), 1.0 / chosen.pdf);
  set_off(bundle(), chosen.direction, through, RayKind::scattered, next);
  next.pdf = chosen.pdf;
  next.nonspecular_bounces = 1;
}

/// Connects the surface with the camera.
void LightPaths::splat(const Hit& hit) {
  const auto seen = camera_->connect(hit.point);
  if (!seen) return;
  const dvec2 u = numbers(kSplat);
  const FilteredPixel column = filtered_pixel(plan_.settings.filter, seen->film.x, u.x);
  const FilteredPixel row = filtered_pixel(plan_.settings.filter, seen->film.y, u.y);
  const PixelWindow& window = film_.window();
  if (column.pixel < window.x0 || column.pixel >= window.x1 || row.pixel < window.y0 ||
      row.pixel >= window.y1)
    return;
  const dvec3& direction = seen->direction;
  const double distance = seen->distance;
  const BandSpan<float> light{light_.data(), bundle().bands};
  if (!(scattering_.evaluate(direction, light.data) > 0.0)) return;
  const bool through = (glm::dot(direction, hit.normal) > 0.0) != hit.entering;
  const RayState to_eye = hit.going_on(direction, through);
  const float* arriving = nullptr;
  if (plan_.dims_on_the_way()) {
    arriving = to_camera_.along(to_eye, distance, light.bands, wavelengths_, *counts_);
    if (!arriving) return;
  } else {
    counts_->add_any_hit(RayKind::shadow, to_eye, distance);
    if (world_.occluded(to_eye, distance)) return;
  }
  const BandSpan<const float> carried = throughput();
  for (int b = light.bands.first; b < light.bands.last; ++b)
    light[b] *= carried[b] * (arriving ? arriving[b] : 1.0f);
  if (!arriving)
    absorb(plan_.medium(through ? hit.medium_after : hit.medium_before), distance, light);
  const double stands_for = beyond_limit() ? BeyondLimit::kOneIn : 1.0;
  const double weight =
      stands_for * flux_ * share_ * column.weight * row.weight / seen->inverse_importance;
  sums_.clear();
  if (sums_.divided()) parts_.clear();
  sums_.add(source_, light, ones_, static_cast<float>(weight));
  hold_back(column.pixel, row.pixel);
}

void LightPaths::hold_back(int x, int y) {
  const double rounding = numbers(kSplatRounding).x;
  if (beyond_limit()) {
    if (lost_splats_)
      held_.push_back({x, y, lost_light(sums_.color().y, plan_.quantum), rounding, true, source_,
                       Arrival::caustic, first_half_});
    return;
  }
  ++counts_->splats;
  const Arrival arrival = bundle().nonspecular_bounces == 0 ? Arrival::caustic : Arrival::indirect;
  held_.push_back({x, y, sums_.color(), rounding, false, source_, arrival, first_half_});
  const int group = plan_.sources[static_cast<std::size_t>(source_)].group;
  if (plan_.settings.relightable && group >= 0) {
    const std::span<const float> unit = parts_.unit_radiance(static_cast<std::size_t>(group));
    held_unit_.insert(held_unit_.end(), unit.begin(), unit.end());
  }
  if (plan_.settings.band_images) {
    const std::span<const Xyz> bands = sums_.band_colors();
    held_bands_.insert(held_bands_.end(), bands.begin(), bands.end());
  }
  if (film_.bands() == 0) return;
  const std::span<const float> radiance = sums_.radiance();
  held_radiance_.insert(held_radiance_.end(), radiance.begin(), radiance.end());
}

void LightPaths::keep(const Hit& hit) {
  Photon photon;
  photon.position = hit.point;
  photon.direction = bundle().state.ray.direction;
  photon.normal = hit.entering ? hit.normal : -hit.normal;
  photon.shape = hit.shape;
  photon.source = source_;
  photon.depth = bundle().depth;
  photon.beyond_limit = beyond_limit();
  counts_->photons += photon.beyond_limit ? 0 : 1;
  const double stands_for = photon.beyond_limit ? BeyondLimit::kOneIn : 1.0;
  photons_->add(photon, throughput(), stands_for * flux_ * photon_share_);
}

} // namespace abbe
