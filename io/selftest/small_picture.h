#pragma once

#include "core/render/render.h"

#include <string>
#include <vector>

namespace abbe {

/// Renders a scene and keeps its bands. Throws std::runtime_error where the film had to refuse a
/// value.
[[nodiscard]] Rendering rendered(const std::string& text);
[[nodiscard]] Rendering rendered(const Scene& scene);

/// A scene from text, without its warnings.
[[nodiscard]] Scene scene_of_text(const std::string& text);

/// Along -z, and from the side by an angle, at the origin: a view so narrow that all of its rays
/// are one. It has one pixel and one sample, with the wavelengths of its 81 bands at their centres.
[[nodiscard]] std::string narrow_view(double angle_deg = 0.0);

/// The radiance of one band of 81 in such a picture of `text`, by the wavelength at its centre.
[[nodiscard]] double radiance_seen(const std::string& text, double lambda_nm,
                                   double angle_deg = 0.0);

/// A number as scenes write it, with all of its digits.
[[nodiscard]] std::string exact_text(double value);

} // namespace abbe
