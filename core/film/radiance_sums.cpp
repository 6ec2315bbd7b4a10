#include "core/film/radiance_sums.h"

#include "core/bands/band_math.h"

#include <algorithm>
#include <cstring>

namespace abbe {
namespace {

constexpr int kLanes = 4;
using Sums = double __attribute__((vector_size(kLanes * sizeof(double))));
using Weights = float __attribute__((vector_size(kLanes * sizeof(float))));

/// The sums of sums[i] * weights[i] for three rows of weights, each in four lanes of a register,
/// whose order is fixed. Reads whole registers: the arrays are padded.
class Dots {
public:
  void add(const double* sums, const AccumulatorPlan& weights, std::size_t begin,
           std::size_t count) {
    Sums x{}, y{}, z{};
    for (std::size_t i = 0; i < count; i += kLanes) {
      Sums s;
      std::memcpy(&s, sums + i, sizeof s);
      x += s * loaded(weights.x.data() + begin + i);
      y += s * loaded(weights.y.data() + begin + i);
      z += s * loaded(weights.z.data() + begin + i);
    }
    color_.x += total(x);
    color_.y += total(y);
    color_.z += total(z);
  }
  [[nodiscard]] const Xyz& color() const { return color_; }

private:
  static Sums loaded(const float* from) {
    Weights weights;
    std::memcpy(&weights, from, sizeof weights);
    return __builtin_convertvector(weights, Sums);
  }
  static double total(const Sums& lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

  Xyz color_{0.0, 0.0, 0.0};
};

} // namespace

RadianceSums::RadianceSums(const Plan& plan, bool apart)
    : plan_(plan), mapped_(apart ? plan.accumulators.size() : 0),
      sums_((mapped_ + plan.accumulators.size()) * plan.stride), radiance_(plan.stride) {}

void RadianceSums::clear() {
  const std::size_t count = sums_.size() / plan_.stride;
  for (std::size_t i = 0; i < count; ++i)
    std::fill(sums(i) + used_.first, sums(i) + used_.last, 0.0);
  used_ = {};
  transparency_ = 0.0;
  transmittance_ = {0.0, 0.0, 0.0};
}

void RadianceSums::add(int source, BandSpan<const float> throughput, const BandTable& reflectance,
                       float factor) {
  const SourcePlan& s = plan_.sources[static_cast<std::size_t>(source)];
  if (parts_) [[unlikely]]
    parts_->add(s, throughput, reflectance, factor);
  add_to(sums(static_cast<std::size_t>(s.accumulator)), s.factor, throughput, reflectance, factor);
}

void RadianceSums::add_mapped(int source, BandSpan<const float> throughput,
                              const BandTable& reflectance, float factor) {
  const SourcePlan& s = plan_.sources[static_cast<std::size_t>(source)];
  if (parts_) [[unlikely]]
    parts_->add(s, throughput, reflectance, factor);
  add_to(sums(mapped_ + static_cast<std::size_t>(s.accumulator)), s.factor, throughput, reflectance,
         factor);
}

void RadianceSums::add_to(double* sum, const BandTable& light, BandSpan<const float> throughput,
                          const BandTable& reflectance, float factor) {
  if (light.zero()) return;
  const auto [first, last] = throughput.bands;
  used_ = used_.empty() ? BandRange{first, last}
                        : BandRange{std::min(used_.first, first), std::max(used_.last, last)};
  const auto constant = light.constant(), part = reflectance.constant();
  if (constant && part) {
    const float product = *constant * *part * factor;
    for (int b = first; b < last; ++b)
      sum[b] += static_cast<double>(throughput[b] * product);
  } else {
    for (int b = first; b < last; ++b)
      sum[b] += static_cast<double>(throughput[b] * (light[b] * reflectance[b] * factor));
  }
}

void RadianceSums::let_through(BandSpan<const float> throughput, bool alpha) {
  const SkyPlan& sky = plan_.sky;
  const auto sum = [&](const std::vector<float>& weights) {
    return static_cast<double>(weighted_sum(throughput.data, weights.data(), throughput.bands.first,
                                            throughput.bands.last));
  };
  const double y = sum(sky.y);
  if (alpha && y != 0.0) transparency_ += y / sky.clear.y;
  if (!sky.tints || y == 0.0) return;
  static const Xyz white = to_xyz(kSrgbWhite, 1.0);
  const auto part = [&](const std::vector<float>& weights, double clear) {
    return clear > 0.0 ? sum(weights) / clear : y / sky.clear.y;
  };
  transmittance_ +=
      {white.x * part(sky.x, sky.clear.x), y / sky.clear.y, white.z * part(sky.z, sky.clear.z)};
}

Xyz RadianceSums::color() const {
  return mapped_ == 0 ? color_from(0) : color_from(0) + color_from(mapped_);
}

Xyz RadianceSums::own_color() const {
  return color_from(0);
}

Xyz RadianceSums::color_from(std::size_t accumulator) const {
  Dots dots;
  const int begin = used_.first & -kLanes; // a band's lane does not depend on which are used
  const auto from = static_cast<std::size_t>(begin);
  const auto count = static_cast<std::size_t>(used_.last - begin);
  for (std::size_t i = 0; i < plan_.accumulators.size(); ++i)
    dots.add(sums_.data() + (accumulator + i) * plan_.stride + from, plan_.accumulators[i], from,
             count);
  return dots.color();
}

std::span<const Xyz> RadianceSums::band_colors() {
  const auto bands = static_cast<std::size_t>(plan_.grid.count());
  band_colors_.assign(bands, {0.0, 0.0, 0.0});
  const std::size_t count = plan_.accumulators.size();
  for (std::size_t i = 0; i < count; ++i) {
    const AccumulatorPlan& weights = plan_.accumulators[i];
    for (std::size_t b = 0; b < bands; ++b) {
      const double light = sums(i)[b] + (mapped_ == 0 ? 0.0 : sums(mapped_ + i)[b]);
      band_colors_[b] += Xyz{static_cast<double>(weights.x[b]), static_cast<double>(weights.y[b]),
                             static_cast<double>(weights.z[b])} *
                         light;
    }
  }
  return band_colors_;
}

std::span<const float> RadianceSums::radiance() {
  const auto bands = static_cast<std::size_t>(plan_.grid.count());
  for (std::size_t b = 0; b < bands; ++b) {
    double mean = 0.0;
    for (std::size_t i = 0; i < plan_.accumulators.size(); ++i)
      mean +=
          (mapped_ == 0 ? sums_[i * plan_.stride + b]
                        : sums_[i * plan_.stride + b] + sums_[(mapped_ + i) * plan_.stride + b]) *
          static_cast<double>(plan_.accumulators[i].radiance[static_cast<int>(b)]);
    radiance_[b] = static_cast<float>(mean);
  }
  return {radiance_.data(), bands};
}

} // namespace abbe
