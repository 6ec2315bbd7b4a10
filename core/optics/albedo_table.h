#pragma once

#include "core/optics/microfacet.h"

#include <cstddef>
#include <vector>

namespace abbe {

/// A place in a table: at `fraction` of the step from entry `index` to the next.
struct TablePlace {
  std::size_t index;
  double fraction;
};

/// A ratio of indices, with its place in the table.
struct EtaPlace {
  TablePlace place;
  double eta;
};

/// A function of a cosine mu, linear between knots at equal steps of sqrt(mu), since what facets
/// reflect changes fast at grazing angles.
class CosineTable {
public:
  template <class Function>
  explicit CosineTable(Function f) {
    for (std::size_t i = 0; i < kKnots; ++i)
      values_.push_back(f(knot(i) * knot(i)));
    mean_ = weighted_mean();
  }
  [[nodiscard]] static TablePlace place(double mu);
  [[nodiscard]] double at(const TablePlace& place) const {
    return values_[place.index] +
           place.fraction * (values_[place.index + 1] - values_[place.index]);
  }
  /// The mean over directions, weighted by their cosine: 2 times the integral of f(mu) mu.
  [[nodiscard]] double mean() const { return mean_; }

private:
  static constexpr std::size_t kKnots = 32;
  /// Knots lie from half a step to 1. Below the first knot the function has the value there.
  [[nodiscard]] static double knot(std::size_t i) {
    return (static_cast<double>(i) + 0.5) / (kKnots - 0.5);
  }
  [[nodiscard]] double weighted_mean() const;

  std::vector<double> values_;
  double mean_ = 0.0;
};

/// The part of the light that leaves perfectly reflecting GGX facets after one reflection, by the
/// cosine of its direction.
class GgxAlbedo {
public:
  explicit GgxAlbedo(const Ggx& ggx);
  [[nodiscard]] double at(double mu) const { return table_.at(CosineTable::place(mu)); }
  [[nodiscard]] double mean() const { return table_.mean(); }

private:
  CosineTable table_;
};

/// The parts of the light that clear GGX facets reflect and transmit after one interaction, by the
/// cosine of its direction and by eta = n behind / n on the side of the light, which may be from
/// 1 / eta_max to eta_max.
class DielectricAlbedo {
public:
  /// `eta_max` is above 1. The construction takes about a quarter of a second.
  DielectricAlbedo(const Ggx& ggx, double eta_max);

  /// The place of `eta` in the table. The place of 1 / eta, for light from behind, is `reversed`.
  [[nodiscard]] EtaPlace place(double eta) const;
  [[nodiscard]] static EtaPlace reversed(const EtaPlace& eta);

  [[nodiscard]] double reflected(const EtaPlace& eta, const TablePlace& mu) const {
    return between(eta.place, reflected_, mu);
  }
  /// The sum of reflected and transmitted light. The rest needs more than one interaction.
  [[nodiscard]] double scattered(const EtaPlace& eta, const TablePlace& mu) const {
    return between(eta.place, scattered_, mu);
  }
  /// Means over directions, weighted by their cosine.
  [[nodiscard]] double mean_reflected(const EtaPlace& eta) const {
    return between_means(eta.place, reflected_);
  }
  [[nodiscard]] double mean_scattered(const EtaPlace& eta) const {
    return between_means(eta.place, scattered_);
  }

private:
  /// The number of knots on each side of eta = 1, which is a knot itself. Knots lie at equal steps
  /// of the square root of |eta - 1| / (eta + 1), since near 1 facets change from transmitting most
  /// light to reflecting it at grazing angles.
  static constexpr int kSide = 12;
  static double between(const TablePlace& eta, const std::vector<CosineTable>& tables,
                        const TablePlace& mu) {
    const double a = tables[eta.index].at(mu), b = tables[eta.index + 1].at(mu);
    return a + eta.fraction * (b - a);
  }
  static double between_means(const TablePlace& eta, const std::vector<CosineTable>& tables) {
    const double a = tables[eta.index].mean(), b = tables[eta.index + 1].mean();
    return a + eta.fraction * (b - a);
  }
  /// The eta of a knot: 1 / eta_max at knot 0, eta_max at knot 2 kSide.
  [[nodiscard]] double eta_of(int knot) const;

  double reach_; ///< sqrt((eta_max - 1) / (eta_max + 1))
  std::vector<CosineTable> reflected_, scattered_;
};

} // namespace abbe
