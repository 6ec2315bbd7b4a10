#include "core/sampling/sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

std::uint64_t mixed(std::uint64_t x) { // the finaliser of SplitMix64 [Steele14]
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

std::uint32_t bits_reversed(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Applies Owen's nested uniform scramble, by hashing from the low bits upwards [Laine11,
/// Vegdahl21], to a number that is given with its bits reversed.
std::uint32_t owen_scrambled_reverse_of(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return bits_reversed(x);
}

/// The second dimension of Sobol's sequence with its bits reversed. (The first dimension is the
/// reversed index.) Bit j is the sum modulo 2 of the index's bits i with odd binomial(i, j), that
/// is (Lucas) of those i that have every bit of j: a sum over supersets, one bit of the numbers i
/// at a time.
std::uint32_t sobol_second_reversed(std::uint32_t x) {
  x ^= (x >> 16) & 0x0000ffffu;
  x ^= (x >> 8) & 0x00ff00ffu;
  x ^= (x >> 4) & 0x0f0f0f0fu;
  x ^= (x >> 2) & 0x33333333u;
  return x ^ ((x >> 1) & 0x55555555u);
}

double unit(std::uint32_t x) {
  return x * 0x1p-32;
}

constexpr double kGaussianSigma = 0.5, kGaussianRadius = 1.5;

/// The inverse of the truncated normal distribution's cumulative distribution function. The first
/// call tabulates it by bisection.
double gaussian_offset(double u) {
  constexpr int kSteps = 1024;
  static const auto table = [] {
    const auto cumulative = [](double x) {
      return 0.5 * (1.0 + std::erf(x / (kGaussianSigma * std::sqrt(2.0))));
    };
    const double low = cumulative(-kGaussianRadius), high = cumulative(kGaussianRadius);
    std::array<double, kSteps + 1> inverse{};
    for (int i = 0; i <= kSteps; ++i) {
      double a = -kGaussianRadius, b = kGaussianRadius;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (a + b);
        (cumulative(middle) < low + (high - low) * i / kSteps ? a : b) = middle;
      }
      inverse[static_cast<std::size_t>(i)] = 0.5 * (a + b);
    }
    return inverse;
  }();
  const double x = u * kSteps;
  const auto i = static_cast<std::size_t>(std::min(x, kSteps - 1.0));
  return table[i] + (table[i + 1] - table[i]) * (x - static_cast<double>(i));
}

double tent_offset(double u) {
  return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * u);
}

} // namespace

Sampler::Sampler(int pixel_x, int pixel_y, std::uint32_t sample_index, std::uint64_t seed)
    : reversed_index_(bits_reversed(sample_index)),
      key_(mixed(mixed(seed) ^
                 (static_cast<std::uint64_t>(static_cast<std::uint32_t>(pixel_x)) << 32 |
                  static_cast<std::uint32_t>(pixel_y)))) {}

dvec2 Sampler::pair(std::uint32_t purpose) const {
  const std::uint64_t a = mixed(key_ + purpose), b = mixed(a);
  const std::uint32_t index =
      owen_scrambled_reverse_of(reversed_index_, static_cast<std::uint32_t>(a));
  return {
      unit(owen_scrambled_reverse_of(index, static_cast<std::uint32_t>(a >> 32))),
      unit(owen_scrambled_reverse_of(sobol_second_reversed(index), static_cast<std::uint32_t>(b)))};
}

DecisionStream Sampler::decisions(std::uint64_t stream) const {
  const std::uint64_t key = mixed(key_ ^ mixed(bits_reversed(reversed_index_)));
  return DecisionStream(stream == 0 ? key : mixed(key ^ mixed(stream)));
}

double DecisionStream::next() {
  state_ += 0x9e3779b97f4a7c15ull;
  return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
}

dvec2 filter_offset(PixelFilter filter, const dvec2& u) {
  switch (filter) {
  case PixelFilter::box:
    return u - 0.5;
  case PixelFilter::tent:
    return {tent_offset(u.x), tent_offset(u.y)};
  case PixelFilter::gaussian:
    return {gaussian_offset(u.x), gaussian_offset(u.y)};
  }
  return {};
}

double filter_pdf(PixelFilter filter, double offset) {
  const double x = std::abs(offset);
  switch (filter) {
  case PixelFilter::box:
    return offset >= -0.5 && offset < 0.5 ? 1.0 : 0.0;
  case PixelFilter::tent:
    return std::max(0.0, 1.0 - x);
  case PixelFilter::gaussian: {
    if (x > kGaussianRadius) return 0.0;
    static const double whole = kGaussianSigma * std::sqrt(2.0 * std::numbers::pi) *
                                std::erf(kGaussianRadius / (kGaussianSigma * std::numbers::sqrt2));
    return std::exp(-0.5 * x * x / (kGaussianSigma * kGaussianSigma)) / whole;
  }
  }
  return 0.0;
}

double filter_radius(PixelFilter filter) {
  switch (filter) {
  case PixelFilter::box:
    return 0.5;
  case PixelFilter::tent:
    return 1.0;
  case PixelFilter::gaussian:
    return kGaussianRadius;
  }
  return 0.0;
}

} // namespace abbe
