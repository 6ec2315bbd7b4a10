#pragma once

#include "core/film/film.h"

#include <cstdint>
#include <span>
#include <vector>

namespace abbe {

/// How many samples each pixel of a film should have in all, row by row, so that a given mean
/// number lowers the picture's relative mean squared error most, as the film's errors tell it. The
/// same on any number of threads.
///
/// The relative mean squared error is the mean over pixels and linear R, G, B of
/// e^2 / (r^2 + 0.01 m^2), with m the mean of r over the film. A pixel whose samples have the
/// relative variance v and cost c each gets a number in proportion to sqrt(v / c), by Lagrange's
/// multiplier, rounded to a power of two: such numbers of samples are the most evenly spread. Its v
/// and c are means over the 5 x 5 pixels around it, weighed by a tent, since the error of one pixel
/// has one degree of freedom. No pixel gets fewer than it has. docs/decisions/noise.md has the
/// measurements.
///
/// `rays` has how many rays the samples of each pixel have taken, row by row. `mean` is the mean
/// number of samples, more than that of the film's. The film must keep errors and have two samples
/// or more in each pixel.
[[nodiscard]] std::vector<std::uint32_t>
allocate_samples(const Film& film, std::span<const std::uint32_t> rays, double mean);

/// The largest share of the samples, as a multiple of the mean: one bright sample by chance must
/// not draw them all.
inline constexpr double kLargestShare = 8.0;
/// What is added to each share, as a multiple of the mean: a pixel may look quiet by chance.
inline constexpr double kSmallestShare = 0.1;

/// The nearest of 1, 2, 4, 8 ... by ratio.
[[nodiscard]] std::uint32_t nearest_power_of_two(double wanted);

} // namespace abbe
