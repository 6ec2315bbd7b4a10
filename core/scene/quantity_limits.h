#pragma once

namespace abbe {

/// The refractive indices of media. Every clear medium that is known lies well inside: germanium
/// has 4, a bubble in glass 0.5.
inline constexpr double kLeastIndex = 0.1, kMostIndex = 10.0;

/// Light beyond this overflows single precision where it is summed up and squared.
inline constexpr double kMostLight = 1e15;

} // namespace abbe
