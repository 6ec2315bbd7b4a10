#pragma once

#include "core/film.h"

#include <cstdint>
#include <span>
#include <vector>

namespace abbe {

/// How many samples each pixel of a film should have in all, row by row, so that a given mean
/// number lowers the picture's relative mean squared error most. `seen` are the samples that the
/// film has; its errors are what they tell. None of it depends on the number of threads.
///
/// The relative mean squared error is the mean over pixels and linear R, G, B of
/// e^2 / (r^2 + 0.01 m^2), with m the mean of r over the film. A pixel whose samples have the
/// relative variance v and cost c each gets a number in proportion to sqrt(v / c), by Lagrange's
/// multiplier. Its v is the mean over the pixels around it, weighed by a tent, since that of one
/// pixel has one degree of freedom. No pixel gets fewer than it has, and none more than
/// `kLargestShare` times the mean. docs/decisions/noise.md has the measurements.
///
/// `costs` has what a sample of each pixel costs, in any unit, more than 0. `mean` is the mean
/// number of samples, at least that of the film's. The film must keep errors and have two samples
/// or more in each pixel.
[[nodiscard]] std::vector<std::uint32_t>
allocate_samples(const Film& film, std::span<const float> costs, double mean);

/// The largest share of the samples, as a multiple of the mean: one bright sample by chance must
/// not draw them all.
inline constexpr double kLargestShare = 8.0;
/// What is added to each share, as a multiple of the mean: a pixel may look quiet by chance.
inline constexpr double kSmallestShare = 0.1;

/// The nearest of 1, 2, 3, 4, 6, 8, 12, 16, 24 ... (powers of two and halfway between), by ratio:
/// the numbers of samples for which the sampler's sequences are evenly spread. 1 below 1.
[[nodiscard]] std::uint32_t evenly_spread_count(double wanted);

} // namespace abbe
