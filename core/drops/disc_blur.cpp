#include "core/drops/disc_blur.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

double safe_acos(double x) {
  return std::acos(std::clamp(x, -1.0, 1.0));
}

/// The area of a cap over 2 pi, 1 - cos.
double cap_height(double radius) {
  const double s = std::sin(0.5 * radius);
  return 2.0 * s * s;
}

} // namespace

double cap_share(double radius, double distance, double reach) {
  // Seen from the other pole the rest of the spot is within pi - reach.
  if (distance > 0.5 * std::numbers::pi)
    return 1.0 - cap_share(radius, std::numbers::pi - distance, std::numbers::pi - reach);
  if (reach >= distance + radius) return 1.0;
  if (reach <= distance - radius) return 0.0;
  if (reach <= radius - distance) return cap_height(reach) / cap_height(radius);
  const double cd = std::cos(distance), cr = std::cos(radius), ct = std::cos(reach);
  const double sd = std::sin(distance), sr = std::sin(radius), st = std::sin(reach);
  const double area = 2.0 * (std::numbers::pi - safe_acos((cd - cr * ct) / (sr * st)) -
                             cr * safe_acos((ct - cd * cr) / (sd * sr)) -
                             ct * safe_acos((cr - cd * ct) / (sd * st)));
  return std::clamp(area / (2.0 * std::numbers::pi * cap_height(radius)), 0.0, 1.0);
}

DiscBlur::DiscBlur(std::size_t cells, double radius) {
  assert(cells > 0 && radius >= 0.0 && radius < 0.5 * std::numbers::pi);
  if (radius == 0.0) return;
  const double width = std::numbers::pi / static_cast<double>(cells);
  const auto cell_at = [&](double angle) {
    return std::min(static_cast<std::size_t>(std::max(angle, 0.0) / width), cells - 1);
  };
  spreads_.resize(cells);
  for (std::size_t j = 0; j < cells; ++j) {
    const double low = static_cast<double>(j) * width, high = low + width;
    Spread& spread = spreads_[j];
    spread.first = cell_at(low - radius);
    const std::size_t last = cell_at(std::min(high + radius, std::numbers::pi));
    spread.shares.resize(last - spread.first + 1);
    // Light of the cell comes from its rings; four of equal area stand for all.
    constexpr int kRings = 4;
    const double upper = std::cos(low), lower = std::cos(high);
    for (int ring = 0; ring < kRings; ++ring) {
      const double angle = safe_acos(upper + (lower - upper) * (ring + 0.5) / kRings);
      double below = 0.0;
      for (std::size_t k = 0; k < spread.shares.size(); ++k) {
        const bool end = k + 1 == spread.shares.size();
        const double border = static_cast<double>(spread.first + k + 1) * width;
        const double within = end ? 1.0 : std::max(below, cap_share(radius, angle, border));
        spread.shares[k] += (within - below) / kRings;
        below = within;
      }
    }
  }
}

void DiscBlur::apply(std::span<double> flux) const {
  if (spreads_.empty()) return;
  assert(flux.size() == spreads_.size());
  std::vector<double> blurred(flux.size());
  for (std::size_t j = 0; j < flux.size(); ++j)
    for (std::size_t k = 0; k < spreads_[j].shares.size(); ++k)
      blurred[spreads_[j].first + k] += flux[j] * spreads_[j].shares[k];
  std::copy(blurred.begin(), blurred.end(), flux.begin());
}

} // namespace abbe
