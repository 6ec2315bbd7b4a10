#include "core/integrators/photon_radius.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// Photons that are compared, and those of them whose neighbours are counted.
constexpr std::size_t kMostCompared = 1u << 15, kAsked = 128;

/// Fewest neighbours that tell how dense photons are.
constexpr double kFewest = 4.0;

} // namespace

double first_photon_radius(std::span<const PhotonBatch> batches, double largest) {
  const std::size_t count = count_within_limit(batches);
  // Every so many of them stands for those beside it.
  const std::size_t step = (count + kMostCompared - 1) / kMostCompared;
  std::vector<dvec3> places;
  std::size_t i = 0;
  for (const PhotonBatch& batch : batches)
    for (const Photon& photon : batch.photons)
      if (!photon.beyond_limit && i++ % step == 0) places.push_back(photon.position);
  if (places.size() < 2) return largest;

  // Photons lie on surfaces: their number grows with the square of the distance.
  const double wanted = static_cast<double>(kPhotonsWithin) / static_cast<double>(step);
  const double counted =
      std::min(std::round(std::max(wanted, kFewest)), static_cast<double>(places.size() - 1));
  const double scale = std::sqrt(std::min(1.0, wanted / counted));
  std::vector<double> radii, distances(places.size());
  const std::size_t stride = std::max<std::size_t>(1, places.size() / kAsked);
  for (std::size_t p = 0; p < places.size(); p += stride) {
    for (std::size_t q = 0; q < places.size(); ++q)
      distances[q] = glm::distance(places[p], places[q]);
    // The nearest is the photon itself.
    const auto nth = distances.begin() + static_cast<std::ptrdiff_t>(counted);
    std::nth_element(distances.begin(), nth, distances.end());
    radii.push_back(*nth);
  }
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle > 0.0 ? std::min(scale * *middle, largest) : largest;
}

double photon_radius(double first_radius, int pass) {
  constexpr double kAlpha = 1.0 / 2.0;
  double square = first_radius * first_radius;
  for (int i = 1; i <= pass; ++i)
    square *= (i + kAlpha) / (i + 1.0);
  return std::sqrt(square);
}

} // namespace abbe
