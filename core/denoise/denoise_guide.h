#pragma once

#include "core/denoise/denoiser.h"
#include "core/image/image.h"

#include <string>
#include <vector>

namespace abbe {

/// The channels that tell a picture's noise, of the layer `noise`. A guide needs them.
[[nodiscard]] std::vector<std::string> noise_channels();

/// The channels of layers that tell what is seen in a picture. The more of them there are, the
/// better edges are kept.
[[nodiscard]] std::vector<std::string> feature_channels();

/// What a filter needs to know of a picture with such channels. It must have those of its noise.
[[nodiscard]] DenoiseGuide guide_of(const SceneLinearImage& image);

/// The picture without its noise. Its alpha and its channels stay as they are.
[[nodiscard]] SceneLinearImage denoised(SceneLinearImage image, const Denoiser& denoiser);

/// The rows of a spectral picture, which has all rows that are mixed into them, without their
/// noise.
[[nodiscard]] SpectralImage denoised(const SpectralImage& sources, const DenoiseWeights& weights);

} // namespace abbe
