#pragma once

#include "core/emitters/cone.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace abbe::test {

/// How the directions that a function draws compare with the pdf that is claimed for them.
struct SamplingCheck {
  double integral = 0.0; ///< of the pdf, over the expected directions
  double drawn = 0.0;    ///< the part of the draws that gave a direction
  double outside = 0.0;  ///< the part that gave an unexpected direction
  double chi_square = 0.0;
  double limit = 0.0; ///< which chi_square exceeds by chance once in a million (Wilson, Hilferty)

  [[nodiscard]] bool agrees() const { return chi_square < limit && outside == 0.0; }
};

/// `sample(u)` gives an optional unit direction, `pdf(direction)` is per steradian, and `asked` is
/// the cone of all directions that can be drawn. The cone is cut into 8 x 16 cells of equal solid
/// angle. The expected count of each is summed over `fine` x `fine` of its directions.
template <class Sample, class Pdf>
SamplingCheck check_sampling(const Cone& asked, const Sample& sample, const Pdf& pdf,
                             int draws = 40000, int fine = 48) {
  constexpr int kRings = 8, kSectors = 16, kCells = kRings * kSectors;
  const Frame frame(asked.axis);
  const double cell_angle = 2.0 * std::numbers::pi * asked.one_minus_cos / kCells;
  std::vector<double> expected(kCells), counts(kCells);
  SamplingCheck check;
  for (int i = 0; i < kRings * fine; ++i)
    for (int j = 0; j < kSectors * fine; ++j) {
      const double off = (i + 0.5) / (kRings * fine) * asked.one_minus_cos;
      const double angle = 2.0 * std::numbers::pi * (j + 0.5) / (kSectors * fine);
      const double sine = std::sqrt(off * (2.0 - off));
      const dvec3 local{sine * std::cos(angle), sine * std::sin(angle), 1.0 - off};
      const double part = pdf(frame.to_world(local)) * cell_angle / (fine * fine);
      expected[static_cast<std::size_t>(i / fine * kSectors + j / fine)] += part;
      check.integral += part;
    }
  std::mt19937_64 engine(1);
  const auto number = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
  for (int i = 0; i < draws; ++i) {
    const double x = number();
    const std::optional<dvec3> direction = sample(dvec2(x, number()));
    if (!direction) continue;
    check.drawn += 1.0 / draws;
    const dvec3 local = frame.to_local(*direction);
    const double off = (local.x * local.x + local.y * local.y) / (1.0 + local.z);
    double turn = std::atan2(local.y, local.x) / (2.0 * std::numbers::pi);
    if (turn < 0.0) turn += 1.0;
    const int ring = static_cast<int>(off / asked.one_minus_cos * kRings);
    const int sector = static_cast<int>(turn * kSectors) % kSectors;
    // At the edge of the cone rounding decides.
    if (off > asked.one_minus_cos * (1.0 + 1e-9)) {
      check.outside += 1.0 / draws;
      continue;
    }
    counts[static_cast<std::size_t>((ring < kRings ? ring : kRings - 1) * kSectors + sector)] += 1;
  }
  double freedom = 0.0, rest_expected = 0.0, rest_count = 0.0;
  const auto add = [&](double should, double is) {
    check.chi_square += (is - should) * (is - should) / should;
    freedom += 1.0;
  };
  for (std::size_t c = 0; c < kCells; ++c) {
    const double should = expected[c] * draws;
    if (should >= 20.0) {
      add(should, counts[c]);
    } else {
      rest_expected += should;
      rest_count += counts[c];
    }
  }
  if (rest_expected >= 20.0)
    add(rest_expected, rest_count);
  else if (rest_count > 60.0)
    check.outside += rest_count / draws;
  const double w = 2.0 / (9.0 * freedom);
  check.limit = freedom * std::pow(1.0 - w + 4.75 * std::sqrt(w), 3);
  return check;
}

} // namespace abbe::test
