#pragma once

#include "core/bundles/lens_fan.h"
#include "core/cameras/placed_camera.h"
#include "core/plan/plan.h"
#include "core/sampling/sampler.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace abbe {

/// Starts camera samples, a batch at a time: the rays through their places in the image and the
/// bundles that go along them. One object serves one thread.
class CameraStart {
public:
  /// Keeps references to both.
  CameraStart(const Plan& plan, const PlacedCamera& camera);

  /// Begins a new batch.
  void clear();
  /// Starts a sample at a place of the image, in pixels: with one ray for all bands, or with as
  /// many as the camera parts its bands into, or none.
  void add(const dvec2& film, const Sampler& sampler);

  /// The rays of all samples of the batch.
  [[nodiscard]] std::span<const RayState> states() const { return states_; }
  /// The number of the first ray of a sample of the batch.
  [[nodiscard]] std::size_t first_state(std::size_t sample) const {
    return sample == 0 ? 0 : ends_[sample - 1];
  }
  /// The bundles of a sample of the batch, given what all rays of the batch meet.
  [[nodiscard]] CameraPaths paths(std::size_t sample, const Hit* hits) const;

private:
  const Plan& plan_;
  const PlacedCamera& camera_;
  std::optional<LensFan> lens_fan_; ///< of a camera whose bands go their own ways
  std::vector<CameraBundle> bundles_;
  std::vector<RayState> states_;  ///< of the bundles
  std::vector<std::size_t> ends_; ///< of each sample's bundles
};

} // namespace abbe
