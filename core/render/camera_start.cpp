#include "core/render/camera_start.h"

#include <concepts>
#include <variant>

namespace abbe {
namespace {

/// A camera that sends all bands of a sample along one ray. Those of others are parted by LensFan.
template <class C>
concept SharesRay = requires(const C& camera, const dvec2& film, const Sampler& sampler) {
  { camera.ray(film, sampler) } -> std::same_as<Ray>;
};

} // namespace

CameraStart::CameraStart(const Plan& plan, const PlacedCamera& camera)
    : plan_(plan), camera_(camera) {
  std::visit(
      [&]<class C>(const C& ready) {
        if constexpr (!SharesRay<C>) lens_fan_.emplace(plan, ready);
      },
      camera.camera);
}

void CameraStart::clear() {
  bundles_.clear();
  states_.clear();
  ends_.clear();
}

void CameraStart::add(const dvec2& film, const Sampler& sampler) {
  std::visit(
      [&]<class C>(const C& ready) {
        if constexpr (SharesRay<C>) {
          bundles_.push_back({.bands = {plan_.first_band, plan_.last_band}});
          states_.push_back({ready.ray(film, sampler), {}, camera_.nesting});
        } else {
          const dvec2 u = sampler.pair(kWavelength);
          lens_fan_->sample(film, sampler.pair(kLens), {plan_.settings.jitter ? u.x : 0.5, u.y},
                            bundles_, states_);
          for (std::size_t i = ends_.empty() ? 0 : ends_.back(); i < states_.size(); ++i)
            states_[i].nesting = camera_.nesting;
        }
      },
      camera_.camera);
  ends_.push_back(states_.size());
}

CameraPaths CameraStart::paths(std::size_t sample, const Hit* hits) const {
  const std::size_t first = first_state(sample);
  return {bundles_.data() + first, states_.data() + first, hits + first, ends_[sample] - first};
}

} // namespace abbe
