#include "spectral/dominant_wavelength.h"

#include "spectral/line_lamp.h"

#include <cmath>
#include <vector>

namespace abbe {
namespace {

constexpr int kFirstNm = 380, kLastNm = 780;

std::vector<Chromaticity> locus_of(Observer observer) {
  std::vector<Chromaticity> points;
  for (int nm = kFirstNm; nm <= kLastNm; ++nm)
    points.push_back(chromaticity(to_xyz(line_lamp(nm), observer)));
  return points;
}

/// The chromaticities of single wavelengths, 1 nm apart.
const std::vector<Chromaticity>& locus(Observer observer) {
  static const std::vector<Chromaticity> small = locus_of(Observer::cie1931_2deg);
  static const std::vector<Chromaticity> large = locus_of(Observer::cie1964_10deg);
  return observer == Observer::cie1931_2deg ? small : large;
}

struct Step {
  double x, y;
};
Step between(const Chromaticity& from, const Chromaticity& to) {
  return {to.x - from.x, to.y - from.y};
}
double cross(const Step& a, const Step& b) {
  return a.x * b.y - a.y * b.x;
}

/// Where a ray crosses the piece from `a` to `b`.
struct Crossing {
  double along_ray;   ///< in lengths of its direction
  double along_piece; ///< 0 at `a`, 1 at `b`
};
std::optional<Crossing> crossing(const Chromaticity& origin, const Step& direction,
                                 const Chromaticity& a, const Chromaticity& b) {
  const Step piece = between(a, b), to_a = between(origin, a);
  const double determinant = cross(direction, piece);
  if (determinant == 0.0) return std::nullopt;
  const Crossing at{cross(to_a, piece) / determinant, cross(to_a, direction) / determinant};
  if (!(at.along_ray > 0.0) || !(at.along_piece >= 0.0 && at.along_piece <= 1.0))
    return std::nullopt;
  return at;
}

/// Where a ray from the white leaves all colours, on the side of single wavelengths.
struct Exit {
  double nm, along_ray;
};
std::optional<Exit> exit_of(const Chromaticity& white, const Step& direction, Observer observer) {
  const std::vector<Chromaticity>& points = locus(observer);
  // Points that rounding puts in another order, far in the red, may be crossed more than once.
  std::optional<Exit> farthest;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (const auto at = crossing(white, direction, points[i], points[i + 1]))
      if (!farthest || at->along_ray > farthest->along_ray)
        farthest = {kFirstNm + static_cast<double>(i) + at->along_piece, at->along_ray};
  return farthest;
}

} // namespace

std::optional<DominantWavelength>
dominant_wavelength(const Chromaticity& c, const Chromaticity& white, Observer observer) {
  const Step direction = between(white, c);
  if (!std::isfinite(direction.x) || !std::isfinite(direction.y)) return std::nullopt;
  // Rounding of colours that are white.
  constexpr double kWhite = 1e-6;
  if (std::hypot(direction.x, direction.y) < kWhite) return std::nullopt;
  if (const auto exit = exit_of(white, direction, observer))
    return DominantWavelength{exit->nm, false, 1.0 / exit->along_ray};
  const std::vector<Chromaticity>& points = locus(observer);
  const auto purple = crossing(white, direction, points.back(), points.front());
  const auto opposite = exit_of(white, {-direction.x, -direction.y}, observer);
  if (!purple || !opposite) return std::nullopt; // the white is no colour of light
  return DominantWavelength{opposite->nm, true, 1.0 / purple->along_ray};
}

} // namespace abbe
