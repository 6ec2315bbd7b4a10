// The sign of a sum of products, by expansions: a number is held exactly as a sum of doubles that
// do not overlap, in the order of their magnitudes, so that the last one has the sum's sign.

#include "io/meshes/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace abbe {
namespace {

constexpr double kRounding = 0.5 * std::numeric_limits<double>::epsilon(); // 2^-53

/// An exact sum of doubles. `Parts` is where they are held.
template <class Parts>
struct Expansion {
  Parts parts{};
  std::size_t count = 0;

  /// Adds a double: Shewchuk's GROW-EXPANSION, without the parts that are zero.
  void add(double term) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double sum = term + parts[i];
      const double other = sum - term;
      const double rest = (term - (sum - other)) + (parts[i] - other); // Knuth's TWO-SUM
      if (rest != 0.0) parts[kept++] = rest;
      term = sum;
    }
    count = kept;
    if (term == 0.0) return;
    make_room();
    parts[count++] = term;
  }
  /// Adds the product of two doubles.
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product)); // what rounding took
    add(product);
  }
  [[nodiscard]] int sign() const {
    if (count == 0) return 0;
    return parts[count - 1] > 0.0 ? 1 : -1;
  }

private:
  void make_room() {
    if constexpr (requires { parts.resize(count + 1); })
      if (parts.size() == count) parts.resize(2 * count + 16);
  }
};

int exact_orientation(const dvec2& a, const dvec2& b, const dvec2& c) {
  Expansion<std::array<double, 12>> sum; // six products of two parts each
  sum.add_product(a.x, b.y);
  sum.add_product(-a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.add_product(-b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.add_product(-c.y, a.x);
  return sum.sign();
}

} // namespace

int orientation(const dvec2& a, const dvec2& b, const dvec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  // Each of the seven operations rounds by 2^-53 at most, and an underflow by less than the
  // smallest normal number. (source: Shewchuk1997, section 4.1)
  const double bound = (3.0 + 16.0 * kRounding) * kRounding * (std::abs(left) + std::abs(right)) +
                       std::numeric_limits<double>::min();
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_orientation(a, b, c);
}

int area_sign(std::span<const dvec2> corners) {
  double area = 0.0, magnitude = 0.0;
  const auto edge = [&](std::size_t i, auto use) {
    use(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
  };
  for (std::size_t i = 0; i < corners.size(); ++i)
    edge(i, [&](const dvec2& p, const dvec2& q) {
      area += p.x * q.y - p.y * q.x;
      magnitude += std::abs(p.x * q.y) + std::abs(p.y * q.x);
    });
  // A sum of n terms, in any order, is wrong by less than n roundings of the sum of magnitudes.
  const double bound = 4.0 * (static_cast<double>(corners.size()) + 4.0) * kRounding * magnitude +
                       static_cast<double>(corners.size()) * std::numeric_limits<double>::min();
  if (area > bound) return 1;
  if (area < -bound) return -1;
  Expansion<std::vector<double>> sum;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edge(i, [&](const dvec2& p, const dvec2& q) {
      sum.add_product(p.x, q.y);
      sum.add_product(-p.y, q.x);
    });
  return sum.sign();
}

} // namespace abbe
