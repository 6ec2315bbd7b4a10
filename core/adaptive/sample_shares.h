#pragma once

#include "core/film/film.h"

#include <cstdint>
#include <span>
#include <vector>

namespace abbe {

/// In proportion to what the pixels of a quarter get samples (`allocate_samples`), row by row; 0
/// where a pixel gets just the mean. The film holds the first round, in which all pixels get the
/// same number of samples, at least two; it must keep errors. `rays` has how many rays the samples
/// of each pixel have taken. The same on any number of threads.
///
/// What is to be least is the relative mean squared error, the mean over pixels and linear R, G, B
/// of e^2 / (r^2 + 0.01 m^2), with m the mean of r over the film. A pixel whose samples have the
/// relative variance v and cost c each then gets a number in proportion to sqrt(v / c), by
/// Lagrange's multiplier. Its own samples may not decide on their number, since that would bias
/// their mean: v, c, m and all else on which a pixel's number depends are those of pixels of other
/// quarters. v is the variance of a sample drawn from the eight neighbours together, that is the
/// mean of their variances and the variance of their means. Where these neighbours would have told
/// the pixels of the other quarters the wrong thing, all pixels of the quarter get the same number.
/// docs/decisions/noise.md has the measurements.
[[nodiscard]] std::vector<float> find_shares(const Film& film, std::span<const std::uint32_t> rays);

/// The largest share of the samples, as a multiple of the mean: one bright sample by chance must
/// not draw them all.
inline constexpr double kLargestShare = 8.0;
/// What is added to each share, as a multiple of the mean: a pixel may look quiet by chance.
inline constexpr double kSmallestShare = 0.35;

} // namespace abbe
