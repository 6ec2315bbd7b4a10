#include "spectral/smooth_emissions.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// Per relative component, which is the square of a node's place: the curves change fastest where
/// a component is small.
constexpr int kNodes = 65;
/// As a relative component; at 0 itself the coefficients have no limit.
constexpr double kLeast = 1e-3;

double relative(int i) {
  const double place = i / (kNodes - 1.0);
  return std::max(kLeast, place * place);
}

/// The cell that holds a relative component, and where in it.
struct Place {
  int cell;
  double inside;
};

Place place_of(double relative) {
  const double x = std::sqrt(relative) * (kNodes - 1);
  const int cell = std::min(static_cast<int>(x), kNodes - 2);
  return {cell, x - cell};
}

} // namespace

SmoothEmissions::SmoothEmissions() {
  for (int largest = 0; largest < 3; ++largest)
    for (int i = 0; i < kNodes; ++i)
      for (int j = 0; j < kNodes; ++j) {
        Vector3 c;
        c[static_cast<std::size_t>(largest)] = 1.0;
        c[static_cast<std::size_t>((largest + 1) % 3)] = relative(i);
        c[static_cast<std::size_t>((largest + 2) % 3)] = relative(j);
        nodes_.push_back(smooth_emission({c[0], c[1], c[2]}).coefficients);
      }
}

const Vector3& SmoothEmissions::node(int largest, int i, int j) const {
  return nodes_[static_cast<std::size_t>((largest * kNodes + i) * kNodes + j)];
}

SmoothCurve SmoothEmissions::of(const LinearRgb& color) const {
  const Vector3 c{std::max(color.r, 0.0), std::max(color.g, 0.0), std::max(color.b, 0.0)};
  const auto largest = std::max_element(c.begin(), c.end()) - c.begin();
  const double most = c[static_cast<std::size_t>(largest)];
  if (!(most > 0.0)) return {};
  const int face = static_cast<int>(largest);
  const Place x = place_of(c[static_cast<std::size_t>((largest + 1) % 3)] / most);
  const Place y = place_of(c[static_cast<std::size_t>((largest + 2) % 3)] / most);
  SmoothCurve curve{{}, 2.0 * most};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const double part = (i ? x.inside : 1.0 - x.inside) * (j ? y.inside : 1.0 - y.inside);
      const Vector3& corner = node(face, x.cell + i, y.cell + j);
      for (std::size_t k = 0; k < 3; ++k)
        curve.coefficients[k] += part * corner[k];
    }
  return curve;
}

} // namespace abbe
