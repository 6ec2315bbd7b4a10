#include "core/drops/drop_optics.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace abbe {
namespace {

double whole_power(double x, int exponent) {
  double power = 1.0;
  for (int k = 0; k < exponent; ++k)
    power *= x;
  return power;
}

/// What is the same for all orders at one incidence: refraction, and the reflectances of the two
/// polarisations (core/optics/fresnel.h has their mean).
struct Meeting {
  double incidence, refraction, s, p;
  double rings; ///< of the disc per radian of incidence: d(sin^2 i) = sin 2i di

  Meeting(double n, double i) : incidence(i) {
    const double sin_i = std::sin(i), cos_i = std::cos(i), sin_r = sin_i / n;
    const double cos_r = std::sqrt(1.0 - sin_r * sin_r);
    refraction = std::asin(sin_r);
    const double r_s = (cos_i - n * cos_r) / (cos_i + n * cos_r);
    const double r_p = (n * cos_i - cos_r) / (n * cos_i + cos_r);
    s = r_s * r_s;
    p = r_p * r_p;
    rings = 2.0 * sin_i * cos_i;
  }

  [[nodiscard]] double deviation(int order) const {
    return 2.0 * incidence - 2.0 * order * refraction + (order - 1) * std::numbers::pi;
  }
  [[nodiscard]] double share(int order) const {
    if (order == 0) return 0.5 * (s + p);
    const auto left = [&](double r) { return (1.0 - r) * (1.0 - r) * whole_power(r, order - 1); };
    return 0.5 * (left(s) + left(p));
  }
  [[nodiscard]] double remainder(int last_order) const {
    // (1 - R)^2 (R^P + R^(P + 1) + ...) = (1 - R) R^P.
    const auto kept = [&](double r) { return (1.0 - r) * whole_power(r, last_order); };
    return 0.5 * (kept(s) + kept(p));
  }
};

/// The parabola through values at 0, 1/2 and 1.
struct Parabola {
  double start, slope, bend; ///< start + slope x + bend x^2

  Parabola(double at0, double at_half, double at1)
      : start(at0), slope(4.0 * at_half - 3.0 * at0 - at1),
        bend(2.0 * (at0 - 2.0 * at_half + at1)) {}

  [[nodiscard]] double integral_to(double x) const {
    return x * (start + x * (slope / 2.0 + x * bend / 3.0));
  }
  /// Where it has a value that it comes by between 0 and 1, on its way up or down.
  [[nodiscard]] double where(double value, bool rising) const {
    const double below = start - value;
    const double root = std::sqrt(std::max(slope * slope - 4.0 * bend * below, 0.0));
    return -2.0 * below / (slope + (rising ? root : -root)); // no difference of equal signs
  }
};

/// Pieces of the quarter circle of incidence. A parabola through a piece of length h misses D by
/// D''' h^3 / (72 sqrt 3), below 1e-8 rad for n of liquids and orders to 12.
constexpr int kPieces = 1024;

/// Cells of the deviation beyond 0 to pi are those of the angle, reflected at both ends as often as
/// it takes.
std::size_t folded(int cell, int count) {
  const int place = (cell % (2 * count) + 2 * count) % (2 * count);
  return static_cast<std::size_t>(place < count ? place : 2 * count - 1 - place);
}

/// Adds the flux of a piece on which the deviation rises or falls all the way.
void add_piece(const std::array<const Meeting*, 3>& at, int order, std::span<double> cells) {
  const auto value = [&](auto f) { return Parabola(f(*at[0]), f(*at[1]), f(*at[2])); };
  const Parabola deviation = value([&](const Meeting& m) { return m.deviation(order); });
  const Parabola flux = value([&](const Meeting& m) { return m.share(order) * m.rings; });
  const double length = at[2]->incidence - at[0]->incidence;
  const double width = std::numbers::pi / static_cast<double>(cells.size());
  const double from = at[0]->deviation(order), to = at[2]->deviation(order);
  const bool rising = to > from;
  double x = 0.0, before = 0.0;
  // Borders strictly between the ends, in the order in which they are met, and the cell before
  // each of them.
  int border =
      static_cast<int>(rising ? std::floor(from / width) + 1.0 : std::ceil(from / width) - 1.0);
  const auto add_up_to = [&](double next) {
    const double sum = flux.integral_to(next);
    const int cell = rising ? border - 1 : border;
    cells[folded(cell, static_cast<int>(cells.size()))] += length * (sum - before);
    x = next;
    before = sum;
  };
  for (; rising ? border * width < to : border * width > to; border += rising ? 1 : -1)
    add_up_to(std::clamp(deviation.where(border * width, rising), x, 1.0));
  add_up_to(1.0);
}

/// The ends and the middles of the pieces.
std::vector<Meeting> meetings(double n) {
  std::vector<Meeting> list;
  for (int k = 0; k <= 2 * kPieces; ++k)
    list.emplace_back(n, 0.25 * std::numbers::pi * k / kPieces);
  return list;
}

} // namespace

double drop_deviation(double n, int order, double incidence) {
  return Meeting(n, incidence).deviation(order);
}

std::optional<double> bow_incidence(double n, int order) {
  if (order < 2 || !(n < order)) return std::nullopt;
  return std::acos(std::sqrt((n * n - 1.0) / (order * order - 1.0)));
}

std::optional<double> bow_angle(double n, int order) {
  const auto incidence = bow_incidence(n, order);
  if (!incidence) return std::nullopt;
  return std::abs(std::remainder(drop_deviation(n, order, *incidence), 2.0 * std::numbers::pi));
}

double drop_share(double n, int order, double incidence) {
  return Meeting(n, incidence).share(order);
}

void add_drop_flux(double n, int first_order, int last_order, std::span<double> cells) {
  assert(n >= 1.0 && first_order >= 0 && !cells.empty());
  const std::vector<Meeting> at = meetings(n);
  for (int order = first_order; order <= last_order; ++order) {
    const double bow = bow_incidence(n, order).value_or(std::numbers::pi);
    for (std::size_t k = 0; k + 2 < at.size(); k += 2) {
      const Meeting &a = at[k], &b = at[k + 2];
      if (bow <= a.incidence || bow >= b.incidence) {
        add_piece({&a, &at[k + 1], &b}, order, cells);
        continue;
      }
      const Meeting top(n, bow);
      const Meeting left(n, 0.5 * (a.incidence + bow)), right(n, 0.5 * (bow + b.incidence));
      add_piece({&a, &left, &top}, order, cells);
      add_piece({&top, &right, &b}, order, cells);
    }
  }
}

double drop_remainder(double n, int last_order) {
  const std::vector<Meeting> at = meetings(n);
  const auto value = [&](const Meeting& m) { return m.remainder(last_order) * m.rings; };
  double sum = 0.0;
  for (std::size_t k = 0; k + 2 < at.size(); k += 2)
    sum += Parabola(value(at[k]), value(at[k + 1]), value(at[k + 2])).integral_to(1.0);
  return sum * 0.5 * std::numbers::pi / kPieces;
}

} // namespace abbe
