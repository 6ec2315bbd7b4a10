#pragma once

#include "core/optics/microfacet.h"

#include <cstddef>
#include <vector>

namespace abbe {

/// A place in a table: between entry `index` and the next, at `fraction` of the way.
struct TablePlace {
  std::size_t index;
  double fraction;
};

/// The place of a ratio of indices.
struct EtaPlace {
  TablePlace place;
  double eta;
};

/// A function of a cosine mu, linear between knots that are even in sqrt(mu): what facets return
/// changes fast at grazing angles.
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
  /// Its mean over directions weighted by their cosine: 2 times the integral of f(mu) mu.
  [[nodiscard]] double mean() const { return mean_; }

private:
  static constexpr std::size_t kKnots = 32;
  /// From half a step to 1: what lies below the first knot has its value.
  [[nodiscard]] static double knot(std::size_t i) {
    return (static_cast<double>(i) + 0.5) / (kKnots - 0.5);
  }
  [[nodiscard]] double weighted_mean() const;

  std::vector<double> values_;
  double mean_ = 0.0;
};

/// What GGX facets that reflect everything return after one reflection, by cosine.
class GgxAlbedo {
public:
  explicit GgxAlbedo(const Ggx& ggx);
  [[nodiscard]] double at(double mu) const { return table_.at(CosineTable::place(mu)); }
  [[nodiscard]] double mean() const { return table_.mean(); }

private:
  CosineTable table_;
};

/// What clear GGX facets return and let through after one interaction, by cosine and by eta = n
/// behind / n on the side of the light, which may be from 1 / eta_max to eta_max.
class DielectricAlbedo {
public:
  /// `eta_max` is above 1. Takes about a quarter of a second.
  DielectricAlbedo(const Ggx& ggx, double eta_max);

  /// Where `eta` lies in the table; the reverse direction, 1 / eta, lies at `reversed`.
  [[nodiscard]] EtaPlace place(double eta) const;
  [[nodiscard]] static EtaPlace reversed(const EtaPlace& eta);

  [[nodiscard]] double reflected(const EtaPlace& eta, const TablePlace& mu) const {
    return between(eta.place, reflected_, mu);
  }
  /// Reflected and transmitted; the rest needs more than one interaction.
  [[nodiscard]] double scattered(const EtaPlace& eta, const TablePlace& mu) const {
    return between(eta.place, scattered_, mu);
  }
  /// Means over directions weighted by their cosine.
  [[nodiscard]] double mean_reflected(const EtaPlace& eta) const {
    return between_means(eta.place, reflected_);
  }
  [[nodiscard]] double mean_scattered(const EtaPlace& eta) const {
    return between_means(eta.place, scattered_);
  }

private:
  /// Knots on each side of eta = 1, which is one itself. They are even in the square root of
  /// |eta - 1| / (eta + 1): near 1 the facets change from letting most light through to returning
  /// it at grazing angles.
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
  /// Eta at a knot, from 0 (1 / eta_max) to 2 kSide (eta_max).
  [[nodiscard]] double eta_of(int knot) const;

  double reach_; ///< sqrt((eta_max - 1) / (eta_max + 1))
  std::vector<CosineTable> reflected_, scattered_;
};

} // namespace abbe
