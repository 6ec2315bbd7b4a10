#include "core/cameras/exit_pupil.h"

#include "geometry/booleans/lens.h"
#include "spectral/band_grid.h"
#include "spectral/fraunhofer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace abbe {
namespace {

using glm::dvec2;

constexpr int kIntervals = 64;
constexpr int kSpokes = 24; ///< over half of the pupil; the other half is its mirror image
constexpr int kHalvings = 16;

/// Between two spokes, 7.5 degrees apart, a round edge bulges by 1 - cos 3.75 degrees = 0.2 %
/// beyond its chord; between two film radii and two wavelengths a pupil's size changes by less.
constexpr double kMargin = 1.005;

/// The ends of the spectrum, and the greens about which an achromat's colours turn back.
constexpr std::array kWavelengths_nm{kLowerNm, 450.0, 550.0, kUpperNm};

/// Finds the pupil of points at one distance from the film's middle, at one wavelength.
class PupilFinder {
public:
  PupilFinder(const FocusedLens& focused, double lambda_nm)
      : lens_(focused.lens), distance_(focused.film_distance), n_(lens_.indices(lambda_nm)) {
    const LensSystem::Surface& last = lens_.surfaces().back();
    semi_ = last.semi_diameter;
    rim_ = last.profile.most_sag(semi_);
  }

  [[nodiscard]] bool passes(double film_radius, const dvec2& pupil) const {
    const dvec3 film{film_radius, 0.0, lens_.last_vertex() + distance_};
    const dvec3 to{pupil.x, pupil.y, lens_.last_vertex()};
    return lens_.trace_from_film({film, glm::normalize(to - film)}, n_).has_value();
  }

  /// Farther from the axis no ray from the point meets the last surface: all of it lies between the
  /// vertex's plane and that of its rim, no wider than the rim.
  [[nodiscard]] double farthest(double film_radius) const {
    return std::max(semi_, film_radius + (film_radius + semi_) * distance_ / (distance_ - rim_));
  }

  /// A point inside the pupil near the last one, if there is any: the mean of those of a raster
  /// that pass. Pupils move by no more than `shift` times a few.
  [[nodiscard]] std::optional<dvec2> inside(double film_radius, const PupilEllipse& last,
                                            double shift) const {
    const dvec2 middle{last.center, 0.0};
    if (passes(film_radius, middle)) return middle;
    constexpr int kRaster = 32;
    const dvec2 half = last.semi_axes + dvec2(4.0 * shift);
    dvec2 sum{0.0};
    int found = 0;
    for (int i = -kRaster; i <= kRaster; ++i)
      for (int j = 0; j <= kRaster; ++j) {
        const dvec2 point = middle + half * dvec2(i, j) / static_cast<double>(kRaster);
        if (!passes(film_radius, point)) continue;
        sum.x += point.x;
        ++found;
      }
    if (found == 0) return std::nullopt;
    return dvec2(sum.x / found, 0.0);
  }

  /// The edge of the pupil along a spoke from a point inside.
  [[nodiscard]] dvec2 edge(double film_radius, const dvec2& inside, double angle) const {
    const dvec2 spoke{std::cos(angle), std::sin(angle)};
    double in = 0.0, out = farthest(film_radius) + std::abs(inside.x);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (in + out);
      (passes(film_radius, inside + middle * spoke) ? in : out) = middle;
    }
    return inside + out * spoke;
  }

private:
  const LensSystem& lens_;
  double distance_;
  std::vector<double> n_;
  double semi_, rim_;
};

/// An ellipse that holds the points and their mirror images.
PupilEllipse ellipse_around(std::span<const dvec2> points) {
  dvec2 lower = points[0], upper = points[0];
  for (const dvec2& p : points) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
  }
  PupilEllipse ellipse{0.5 * (lower.x + upper.x), {0.5 * (upper.x - lower.x), upper.y}};
  double scale = 1.0;
  for (const dvec2& p : points) {
    const dvec2 q = (p - dvec2(ellipse.center, 0.0)) / ellipse.semi_axes;
    scale = std::max(scale, std::sqrt(q.x * q.x + q.y * q.y));
  }
  ellipse.semi_axes *= kMargin * scale;
  return ellipse;
}

/// The edges of the pupils of all wavelengths for one distance; empty where there is none. `last`
/// are the ellipses of the distance before, by wavelength.
std::vector<dvec2> edges(std::span<const PupilFinder> finders, std::span<PupilEllipse> last,
                         double film_radius, double shift) {
  std::vector<dvec2> all;
  for (std::size_t i = 0; i < finders.size(); ++i) {
    const auto inside = finders[i].inside(film_radius, last[i], shift);
    if (!inside) continue;
    const std::size_t first = all.size();
    for (int k = 0; k <= kSpokes; ++k)
      all.push_back(finders[i].edge(film_radius, *inside, std::numbers::pi * k / kSpokes));
    last[i] = ellipse_around(std::span(all).subspan(first));
  }
  return all;
}

} // namespace

double PupilEllipse::area() const {
  return std::numbers::pi * semi_axes.x * semi_axes.y;
}

ExitPupil::ExitPupil(const FocusedLens& lens, double film_radius)
    : interval_(film_radius / kIntervals) {
  const double axial = PupilFinder(lens, kLineD_nm).edge(0.0, {0.0, 0.0}, 0.0).x;
  axial_irradiance_ =
      std::numbers::pi * axial * axial / (axial * axial + lens.film_distance * lens.film_distance);
  std::vector<PupilFinder> finders;
  for (const double nm : kWavelengths_nm)
    finders.emplace_back(lens, nm);
  std::vector<PupilEllipse> last(finders.size()); // on the axis, its middle is inside
  std::vector<dvec2> inner = edges(finders, last, 0.0, 0.0);
  for (int i = 1; i <= kIntervals && !inner.empty(); ++i) {
    std::vector<dvec2> outer = edges(finders, last, i * interval_, interval_);
    inner.insert(inner.end(), outer.begin(), outer.end());
    ellipses_.push_back(ellipse_around(inner));
    inner = std::move(outer);
  }
}

const PupilEllipse* ExitPupil::at(double film_radius) const {
  const auto i = static_cast<std::size_t>(film_radius / interval_);
  if (i < ellipses_.size()) return &ellipses_[i];
  // The outermost point itself, within rounding.
  return i == ellipses_.size() && i == kIntervals ? &ellipses_.back() : nullptr;
}

} // namespace abbe
