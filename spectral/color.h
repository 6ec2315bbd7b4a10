#pragma once

#include "spectral/matrix3.h"
#include "spectral/transfer.h"

namespace abbe {

/// CIE tristimulus values; Y = 1 is a perfect reflector under a light of unit luminance.
struct Xyz {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend bool operator==(const Xyz&, const Xyz&) = default;
  friend constexpr Xyz operator+(const Xyz& a, const Xyz& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Xyz operator*(const Xyz& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Xyz operator*(double s, const Xyz& a) { return a * s; }
  constexpr Xyz& operator+=(const Xyz& other) { return *this = *this + other; }
};

/// Linear light in the primaries of sRGB (Rec. 709), or of a display where one is named; not
/// limited to 0..1.
struct LinearRgb {
  double r = 0.0;
  double g = 0.0;
  double b = 0.0;
  friend bool operator==(const LinearRgb&, const LinearRgb&) = default;
};

/// Code values of a display as fractions of full scale, with its transfer function applied.
struct DisplayRgb {
  double r = 0.0;
  double g = 0.0;
  double b = 0.0;
  friend bool operator==(const DisplayRgb&, const DisplayRgb&) = default;
};

/// CIE chromaticity coordinates x, y.
struct Chromaticity {
  double x = 0.0;
  double y = 0.0;
  friend bool operator==(const Chromaticity&, const Chromaticity&) = default;
};

/// The chromaticities of a display's three primaries.
struct RgbPrimaries {
  Chromaticity red;
  Chromaticity green;
  Chromaticity blue;
  friend bool operator==(const RgbPrimaries&, const RgbPrimaries&) = default;
};

/// Primaries and white of sRGB and Rec. 709 [IEC99].
inline constexpr RgbPrimaries kSrgbPrimaries{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
inline constexpr Chromaticity kSrgbWhite{0.3127, 0.3290};

/// X/(X+Y+Z) and Y/(X+Y+Z). Black has no chromaticity: the result is then that of equal energy.
[[nodiscard]] Chromaticity chromaticity(const Xyz& color);

/// Tristimulus values of chromaticity `c` and luminance Y; c.y must not be 0.
[[nodiscard]] Xyz to_xyz(const Chromaticity& c, double luminance);

/// The matrix T = C L from linear RGB to XYZ [War05]: the columns of C are the x, y, z of
/// the primaries, and the diagonal matrix L scales them so that RGB (1, 1, 1) is the white with Y
/// = 1. Throws std::invalid_argument when the primaries lie on one line or the white has y = 0.
[[nodiscard]] Matrix3 rgb_to_xyz_matrix(const RgbPrimaries& primaries, const Chromaticity& white);

/// Linear sRGB of tristimulus values; out-of-gamut colours keep their negative components.
[[nodiscard]] LinearRgb to_linear_srgb(const Xyz& color);
[[nodiscard]] Xyz to_xyz(const LinearRgb& color);

/// Y of a linear sRGB colour.
[[nodiscard]] double luminance(const LinearRgb& color);
/// The parts of r, g and b in Y; they sum to 1.
[[nodiscard]] const Vector3& srgb_luminance_weights();

/// The sRGB transfer curve [IEC99] per component, and its inverse. Both are odd functions, so that
/// negative components survive the round trip; values above 1 follow the power law.
[[nodiscard]] DisplayRgb encode_srgb(const LinearRgb& color);
[[nodiscard]] LinearRgb decode_srgb(const DisplayRgb& color);

/// A transfer function per component.
[[nodiscard]] DisplayRgb encode(const TransferFunction& transfer, const LinearRgb& color);

} // namespace abbe
