#pragma once

#include "core/film/film.h"

namespace abbe {

/// The estimated relative error of a part of the film's window: the root of the mean over pixels
/// and X, Y, Z of e^2 / (r^2 + 0.01 m^2), with e the standard error (`Film::error`) of a pixel's
/// mean r, and m the mean of r over the part. The second term lets pixels that are much darker than
/// the part count little. 0 for a part that is black; infinite where a pixel has fewer than two
/// samples. The film must keep errors.
[[nodiscard]] double relative_error(const Film& film, const PixelWindow& part);

/// How many samples the pixels of a film have.
struct SampleCounts {
  std::uint32_t least = 0, most = 0;
  double mean = 0.0;
};
[[nodiscard]] SampleCounts sample_counts(const Film& film);

} // namespace abbe
