#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace abbe::stress {

/// Random numbers that are the same with every standard library: std::mt19937_64's are laid down,
/// those of the distributions are not.
class RandomNumbers {
public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  /// As many to each factor.
  double log_between(double low, double high) { return low * std::pow(high / low, uniform()); }
  int below(int n) { return static_cast<int>(uniform() * n); }
  bool chance(double p) { return uniform() < p; }
  template <class T>
  T one_of(std::initializer_list<T> values) {
    return values.begin()[below(static_cast<int>(values.size()))];
  }

private:
  std::mt19937_64 engine_;
};

} // namespace abbe::stress
