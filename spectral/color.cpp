#include "spectral/color.h"

#include <stdexcept>

namespace abbe {
namespace {

const Matrix3& srgb_to_xyz() {
  static const Matrix3 matrix = rgb_to_xyz_matrix(kSrgbPrimaries, kSrgbWhite);
  return matrix;
}

const Matrix3& xyz_to_srgb() {
  static const Matrix3 matrix = inverse(srgb_to_xyz());
  return matrix;
}

} // namespace

Chromaticity chromaticity(const Xyz& color) {
  const double sum = color.x + color.y + color.z;
  if (sum == 0.0) return {1.0 / 3.0, 1.0 / 3.0};
  return {color.x / sum, color.y / sum};
}

Xyz to_xyz(const Chromaticity& c, double luminance) {
  return {luminance * c.x / c.y, luminance, luminance * (1.0 - c.x - c.y) / c.y};
}

Matrix3 rgb_to_xyz_matrix(const RgbPrimaries& primaries, const Chromaticity& white) {
  if (white.y == 0.0) throw std::invalid_argument("a white point needs y > 0");
  const auto& [r, g, b] = primaries;
  const Matrix3 columns = {
      {{r.x, g.x, b.x}, {r.y, g.y, b.y}, {1.0 - r.x - r.y, 1.0 - g.x - g.y, 1.0 - b.x - b.y}}};
  const Xyz w = to_xyz(white, 1.0);
  const Vector3 scales = multiply(inverse(columns), Vector3{w.x, w.y, w.z});
  return multiply(columns, diagonal(scales));
}

LinearRgb to_linear_srgb(const Xyz& color) {
  const Vector3 rgb = multiply(xyz_to_srgb(), Vector3{color.x, color.y, color.z});
  return {rgb[0], rgb[1], rgb[2]};
}

Xyz to_xyz(const LinearRgb& color) {
  const Vector3 xyz = multiply(srgb_to_xyz(), Vector3{color.r, color.g, color.b});
  return {xyz[0], xyz[1], xyz[2]};
}

double luminance(const LinearRgb& color) {
  return to_xyz(color).y;
}

const Vector3& srgb_luminance_weights() {
  return srgb_to_xyz()[1];
}

DisplayRgb encode_srgb(const LinearRgb& color) {
  return encode(srgb_transfer(), color);
}

LinearRgb decode_srgb(const DisplayRgb& color) {
  return {decode(srgb_transfer(), color.r), decode(srgb_transfer(), color.g),
          decode(srgb_transfer(), color.b)};
}

DisplayRgb encode(const TransferFunction& transfer, const LinearRgb& color) {
  return {encode(transfer, color.r), encode(transfer, color.g), encode(transfer, color.b)};
}

} // namespace abbe
