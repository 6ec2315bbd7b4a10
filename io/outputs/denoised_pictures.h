#pragma once

#include "core/denoise/denoiser.h"
#include "core/film/film.h"
#include "core/image/image.h"
#include "core/plan/plan.h"

#include <string>
#include <vector>

namespace abbe {

/// Makes the pictures of a film without their noise. The film must have what the layer `noise`
/// tells.
class DenoisedPictures {
public:
  /// `asked` are the layers that go into pictures; the others are for the filter only. Keeps
  /// references to the film and the plan.
  DenoisedPictures(const Film& film, const Plan& plan, const ExtraLayers& asked);

  /// True for a layer of the picture that nobody has asked for.
  [[nodiscard]] bool leaves_out(const std::string& layer) const;
  [[nodiscard]] SceneLinearImage scene_linear(SceneLinearSpace space, bool colors_only) const;
  /// Throws std::invalid_argument for a white point that cannot be white.
  [[nodiscard]] DisplayImage display(const DisplaySettings& settings) const;
  /// Part of the film's window, of whole rows. The film must keep bands.
  [[nodiscard]] SpectralImage spectral(const PixelWindow& rows) const;

private:
  const Film& film_;
  const Plan& plan_;
  std::vector<std::string> left_out_; ///< channels that nobody has asked for
  Denoiser denoiser_;
};

} // namespace abbe
