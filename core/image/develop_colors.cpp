#include "core/image/develop_colors.h"

#include "core/image/metadata.h"
#include "core/image/scene_linear_space.h"

namespace abbe {

SceneLinearImage scene_linear_of(const PixelWindow& display, const PixelWindow& data,
                                 std::span<const Xyz> colors, SceneLinearSpace space) {
  SceneLinearImage image{display, data, {}, {}, space};
  image.rgba.reserve(4 * colors.size());
  const Matrix3 to_rgb = matrix_to(space);
  for (const Xyz& color : colors) {
    const Vector3 c = multiply(to_rgb, Vector3{color.x, color.y, color.z});
    for (const double v : {c[0], c[1], c[2], 1.0})
      image.rgba.push_back(as_float(v));
  }
  return image;
}

DisplayImage display_of(const PixelWindow& display, const PixelWindow& data,
                        std::span<const Xyz> colors, const DisplaySettings& settings,
                        Observer observer) {
  DisplayImage image{
      display, data, {}, {}, display_metadata(settings, observer), encoding_of(settings)};
  image.linear.reserve(3 * colors.size());
  image.encoded.reserve(3 * colors.size());
  const DisplayTransform transform(settings, observer);
  for (const Xyz& color : colors) {
    const LinearRgb c = transform.unclipped(color);
    const DisplayRgb e = transform.encoded(transform.linear(color));
    for (const double v : {c.r, c.g, c.b})
      image.linear.push_back(as_float(v));
    for (const double v : {e.r, e.g, e.b})
      image.encoded.push_back(static_cast<float>(v));
  }
  return image;
}

} // namespace abbe
