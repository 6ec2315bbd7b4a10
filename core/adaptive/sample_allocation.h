#pragma once

#include "core/film/film.h"

#include <cstdint>
#include <span>
#include <vector>

namespace abbe {

/// How many samples each pixel of a film should have in all, row by row, so that their mean over
/// each quarter of the pixels is a given one: in proportion to the shares (`find_shares`), rounded
/// to powers of two, since such numbers of samples are the most evenly spread. No pixel gets fewer
/// than it has, nor more than `kLargestShare` times the mean, rounded. `mean` is more than the mean
/// of the film's numbers.
[[nodiscard]] std::vector<std::uint32_t>
allocate_samples(const Film& film, std::span<const float> shares, double mean);

/// The nearest of 1, 2, 4, 8 ... by ratio.
[[nodiscard]] std::uint32_t nearest_power_of_two(double wanted);

} // namespace abbe
