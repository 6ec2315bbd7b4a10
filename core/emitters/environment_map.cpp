#include "core/emitters/environment_map.h"

#include "geometry/solids/circle_point.h"
#include "spectral/smooth_emissions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

using std::numbers::pi;

SmoothCurve smooth_curve(const LinearRgb& color) {
  static const SmoothEmissions emissions;
  return emissions.of(color);
}

} // namespace

std::optional<EnvironmentMap> EnvironmentMap::make(const Environment& environment,
                                                   const std::vector<double>& wavelengths_nm,
                                                   double bright_from) {
  EnvironmentMap map(environment, wavelengths_nm);
  if (std::all_of(map.luminance_.begin(), map.luminance_.end(), [](float v) { return v == 0.0f; }))
    return std::nullopt;
  map.choose_cells(bright_from);
  return map;
}

EnvironmentMap::EnvironmentMap(const Environment& environment,
                               const std::vector<double>& wavelengths_nm)
    : width_(environment.width), height_(environment.height), to_world_(environment.to_world) {
  for (const double nm : wavelengths_nm)
    t_.push_back(static_cast<float>(SmoothCurve::position(nm)));
  const std::size_t count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  for (std::size_t i = 0; i < count; ++i) {
    const auto component = [&](std::size_t k) {
      return environment.factor * std::max(0.0, static_cast<double>(environment.rgb[3 * i + k]));
    };
    const LinearRgb color{component(0), component(1), component(2)};
    const double y = luminance(color);
    const SmoothCurve curve =
        environment.has_colors ? smooth_curve(color) : SmoothCurve{{}, 2.0 * y};
    const auto& c = curve.coefficients;
    pixels_.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
                       static_cast<float>(0.5 * curve.scale)});
    luminance_.push_back(static_cast<float>(y));
  }
}

void EnvironmentMap::choose_cells(double bright_from) {
  row_cosines_.push_back(1.0);
  for (int j = 0; j < height_; ++j)
    row_cosines_.push_back(std::cos(pi * (j + 0.5) / height_));
  row_cosines_.push_back(-1.0);
  choice_ = cells(0.0);
  limit_ = bright_from * total() / (4.0 * pi);
  if (std::ranges::any_of(luminance_, [&](float v) { return static_cast<double>(v) > limit_; }))
    bright_choice_ = cells(limit_);
}

CellChoice EnvironmentMap::cells(double limit) const {
  std::vector<double> weights;
  for (int row = 0; row <= height_; ++row) {
    const auto r = static_cast<std::size_t>(row);
    const double angle = 2.0 * pi / width_ * (row_cosines_[r] - row_cosines_[r + 1]);
    for (int column = 0; column < width_; ++column)
      weights.push_back(angle * mean_luminance(corners(row, column), limit));
  }
  return {weights, static_cast<std::size_t>(width_)};
}

/// Cell (row, column) lies between the middles of pixel rows row - 1 and row, at the poles between
/// a row's middle and the pole; and between those of columns column and column + 1.
EnvironmentMap::Corners EnvironmentMap::corners(int row, int column) const {
  const auto index = [&](int y, int x) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  };
  const int above = std::max(row - 1, 0), below = std::min(row, height_ - 1);
  const int right = column + 1 < width_ ? column + 1 : 0;
  return {{index(above, column), index(above, right), index(below, column), index(below, right)},
          {0.25, 0.25, 0.25, 0.25}};
}

EnvironmentMap::Corners EnvironmentMap::corners(const dvec3& direction) const {
  const dvec3 d = direction * to_world_; // by the transpose, which is the inverse
  const double x = (0.5 + std::atan2(d.x, -d.z) / (2.0 * pi)) * width_ - 0.5;
  const double y = std::acos(std::clamp(d.y, -1.0, 1.0)) / pi * height_ - 0.5;
  const double left = std::floor(x), above = std::floor(y);
  const double fx = x - left, fy = y - above;
  int column = static_cast<int>(left);
  if (column < 0) column += width_;
  if (column >= width_) column -= width_;
  Corners found = corners(std::clamp(static_cast<int>(above) + 1, 0, height_), column);
  const double parts[4] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
  std::copy(std::begin(parts), std::end(parts), std::begin(found.part));
  return found;
}

double EnvironmentMap::mean_luminance(const Corners& corners, double limit) const {
  double sum = 0.0;
  for (const std::size_t i : corners.pixel)
    sum += std::max(0.0, static_cast<double>(luminance_[i]) - limit);
  return 0.25 * sum;
}

void EnvironmentMap::scale(const dvec3& direction, BandSpan<float> values) const {
  const auto [first, last] = values.bands;
  const Corners around = corners(direction);
  Pixel p[4];
  bool grey = true;
  for (int k = 0; k < 4; ++k) {
    p[k] = pixels_[around.pixel[k]];
    p[k].scale *= static_cast<float>(around.part[k]);
    grey = grey && p[k].grey();
  }
  if (grey) {
    const float sum = p[0].scale + p[1].scale + p[2].scale + p[3].scale;
    for (int b = first; b < last; ++b)
      values[b] *= sum;
    return;
  }
  const float* t = t_.data();
  for (int b = first; b < last; ++b) {
    float sum = 0.0f;
    for (const Pixel& q : p) {
      const float x = (q.a * t[b] + q.b) * t[b] + q.c;
      sum += q.scale * (1.0f + x / std::sqrt(1.0f + x * x));
    }
    values[b] *= sum;
  }
}

dvec3 EnvironmentMap::sample(const dvec2& u) const {
  return sample(*choice_, u);
}

dvec3 EnvironmentMap::sample_bright(const dvec2& u) const {
  return sample(*bright_choice_, u);
}

dvec3 EnvironmentMap::sample(const CellChoice& choice, const dvec2& u) const {
  const CellChoice::Choice cell = choice.choose(u);
  const double turn = (static_cast<double>(cell.column) + 0.5 + cell.inside.x) / width_ - 0.5;
  const double y = row_cosines_[cell.row] +
                   cell.inside.y * (row_cosines_[cell.row + 1] - row_cosines_[cell.row]);
  const double across = std::sqrt(std::max(0.0, 1.0 - y * y));
  const dvec2 p = across * circle_point(turn);
  return glm::normalize(to_world_ * dvec3(p.y, y, -p.x));
}

double EnvironmentMap::pdf(const dvec3& direction) const {
  return mean_luminance(corners(direction), 0.0) / total();
}

// Between the middles of pixels luminance is at most that of the brightest corner: where it is
// above the limit, so is a corner, and the pdf is not 0.
double EnvironmentMap::bright_pdf(const dvec3& direction) const {
  return mean_luminance(corners(direction), limit_) / bright_total();
}

double EnvironmentMap::bright_share(const dvec3& direction) const {
  if (!has_bright()) return 0.0;
  const Corners around = corners(direction);
  double luminance = 0.0;
  for (int k = 0; k < 4; ++k)
    luminance += around.part[k] * static_cast<double>(luminance_[around.pixel[k]]);
  return luminance > limit_ ? 1.0 - limit_ / luminance : 0.0;
}

} // namespace abbe
