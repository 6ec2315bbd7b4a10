#include "core/bundles/lens_fan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace abbe {
namespace {

dvec3 at_depth(const Ray& ray, double z) {
  return ray.at((z - ray.origin.z) / ray.direction.z);
}

} // namespace

LensFan::LensFan(const Plan& plan, const LensCamera& camera)
    : plan_(plan), camera_(camera), achromatic_(camera.lens().achromatic()),
      direction_limit_(plan.settings.tolerance_pixels * camera.pixel_angle()),
      position_limit_(direction_limit_ * camera.focus_distance()), n_(camera.lens().media()),
      band_rays_(static_cast<std::size_t>(plan.grid.count())) {}

std::optional<LensRay> LensFan::traced(double lambda_nm) {
  camera_.lens().look_up_indices(lambda_nm, n_);
  return camera_.trace(film_ray_, n_);
}

const std::optional<LensRay>& LensFan::band_ray(int band) {
  BandRay& ray = band_rays_[static_cast<std::size_t>(band)];
  if (!ray.traced) ray = {traced(plan_.wavelength_nm(band, wavelength_.x)), true};
  return ray.ray;
}

/// True when none of the bands seems to come through. The lens's edge moves with the wavelength to
/// one side, or turns back once, as an achromat's colours do.
bool LensFan::stopped(BandRange range) {
  return !band_ray(range.first) && !band_ray(range.last - 1) &&
         !band_ray((range.first + range.last) / 2);
}

/// How far the rays of the first, the middle and the last band are apart; nothing where one of them
/// is stopped. An achromat's colours turn back, so that the outermost alone say too little.
std::optional<LensFan::Apart> LensFan::apart(BandRange range) {
  const std::array bands{range.first, (range.first + range.last) / 2, range.last - 1};
  const double focus = camera_.focus_distance();
  Apart most;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const auto& a = band_ray(bands[i]);
    if (!a) return std::nullopt;
    for (std::size_t j = 0; j < i; ++j) {
      const auto& b = band_ray(bands[j]);
      most.direction = std::max(most.direction, glm::distance(a->ray.direction, b->ray.direction));
      most.position = std::max(most.position, glm::distance(a->ray.origin, b->ray.origin));
      if (!std::isinf(focus))
        most.in_focus = std::max(most.in_focus,
                                 glm::distance(at_depth(a->ray, -focus), at_depth(b->ray, -focus)));
    }
  }
  return most;
}

bool LensFan::may_share(BandRange range) {
  const auto found = apart(range);
  return found && found->direction <= direction_limit_ && found->position <= position_limit_ &&
         found->in_focus <= position_limit_;
}

void LensFan::add(BandRange range, const std::optional<LensRay>& ray, double weight) {
  if (!ray) return;
  CameraBundle& start = bundles_->emplace_back();
  start.bands = range;
  start.weight = static_cast<float>(weight * film_ray_.weight * ray->transmittance);
  states_->emplace_back().ray = camera_.to_world(ray->ray);
}

void LensFan::add_shared(BandRange range) {
  const auto ray = traced(plan_.shared_wavelength_nm(range.first, range.last, wavelength_.x));
  if (!ray) return;
  add(range, ray, 1.0);
  const Apart found = apart(range).value();
  CameraBundle& bundle = bundles_->back();
  bundle.separation = found.position / camera_.mm_per_unit();
  bundle.divergence = found.direction;
}

/// Rays are traced where they are asked for: nothing is gained by tracing several together.
struct LensFan::Judge {
  LensFan& fan;

  void prepare(std::span<const BandRange>) const {}
  [[nodiscard]] BandVerdict judge(BandRange range) const {
    if (fan.stopped(range)) return BandVerdict::stopped;
    return range.size() == 1 || fan.may_share(range) ? BandVerdict::together : BandVerdict::apart;
  }
};

void LensFan::part(BandRange whole) {
  const std::size_t most = plan_.follows_all() ? static_cast<std::size_t>(whole.size())
                                               : static_cast<std::size_t>(plan_.settings.max_fan);
  for (const BandPart& part : partition_.part(whole, plan_.shares, most, Judge{*this}))
    switch (part.kind) {
    case BandPart::Kind::single:
      add(part.bands, band_ray(part.bands.first), 1.0);
      break;
    case BandPart::Kind::shared:
      add_shared(part.bands);
      break;
    case BandPart::Kind::represented: {
      const auto [kept, weight] = plan_.shares.keep_one(part.bands, wavelength_.y);
      add({kept, kept + 1}, band_ray(kept), static_cast<double>(weight));
      break;
    }
    }
}

void LensFan::sample(const glm::dvec2& position, const glm::dvec2& u_lens,
                     const glm::dvec2& wavelength, std::vector<CameraBundle>& bundles,
                     std::vector<RayState>& states) {
  const BandRange whole{plan_.live_first, plan_.live_last};
  const auto film_ray = camera_.film_ray(position, u_lens);
  if (!film_ray || whole.size() <= 0) return;
  film_ray_ = *film_ray;
  wavelength_ = wavelength;
  bundles_ = &bundles;
  states_ = &states;
  for (int b = whole.first; b < whole.last; ++b)
    band_rays_[static_cast<std::size_t>(b)].traced = false;
  if (achromatic_) {
    add(whole, band_ray(whole.first), 1.0);
  } else if (plan_.settings.exact) {
    for (int b = whole.first; b < whole.last; ++b)
      add({b, b + 1}, band_ray(b), 1.0);
  } else {
    part(whole);
  }
}

} // namespace abbe
