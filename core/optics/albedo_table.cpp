#include "core/optics/albedo_table.h"

#include "core/optics/microfacet_albedo.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

TablePlace place_among(double position, std::size_t knots) {
  const double inside = std::clamp(position, 0.0, static_cast<double>(knots - 1));
  const auto index = std::min(static_cast<std::size_t>(inside), knots - 2);
  return {index, inside - static_cast<double>(index)};
}

} // namespace

TablePlace CosineTable::place(double mu) {
  return place_among(std::sqrt(mu) * (kKnots - 0.5) - 0.5, kKnots);
}

double CosineTable::weighted_mean() const {
  // 2 f(mu) mu dmu = 4 f t^3 dt with t = sqrt(mu). In each cell this is of degree 4 in t, which
  // three points of Gauss and Legendre integrate without error.
  const double side = std::sqrt(0.6);
  double sum = values_.front() * std::pow(knot(0), 4);
  for (std::size_t i = 0; i + 1 < kKnots; ++i) {
    const double width = knot(i + 1) - knot(i);
    const auto f = [&](double x) {
      const double t = knot(i) + x * width;
      return 4.0 * at({i, x}) * t * t * t;
    };
    sum += width * (5.0 * f(0.5 - 0.5 * side) + 8.0 * f(0.5) + 5.0 * f(0.5 + 0.5 * side)) / 18.0;
  }
  return sum;
}

GgxAlbedo::GgxAlbedo(const Ggx& ggx)
    : table_([&](double mu) { return std::min(1.0, reflected_once(ggx, mu)); }) {}

double DielectricAlbedo::eta_of(int knot) const {
  const double x = reach_ * (knot - kSide) / kSide;
  const double u = x * std::abs(x);
  return (1.0 + u) / (1.0 - u);
}

DielectricAlbedo::DielectricAlbedo(const Ggx& ggx, double eta_max)
    : reach_(std::sqrt((eta_max - 1.0) / (eta_max + 1.0))) {
  for (int knot = 0; knot <= 2 * kSide; ++knot) {
    const double eta = eta_of(knot);
    std::vector<double> both;
    reflected_.emplace_back([&](double mu) {
      const OnceScattered once = scattered_once(ggx, mu, eta);
      both.push_back(std::min(1.0, once.reflected + once.transmitted));
      return once.reflected;
    });
    auto next = both.begin();
    scattered_.emplace_back([&](double) { return *next++; });
  }
}

EtaPlace DielectricAlbedo::place(double eta) const {
  const double u = (eta - 1.0) / (eta + 1.0);
  const double x = std::copysign(std::sqrt(std::abs(u)), u) / reach_;
  return {place_among((x + 1.0) * kSide, 2 * kSide + 1), eta};
}

EtaPlace DielectricAlbedo::reversed(const EtaPlace& eta) {
  const TablePlace& p = eta.place;
  return {{static_cast<std::size_t>(2 * kSide - 1) - p.index, 1.0 - p.fraction}, 1.0 / eta.eta};
}

} // namespace abbe
