#include "core/integrators/photon_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace abbe {

void PhotonBatch::add(Photon photon, BandSpan<const float> band_flux, double scale) {
  photon.bands = band_flux.bands;
  photon.flux = flux.size();
  photons.push_back(photon);
  const auto s = static_cast<float>(scale);
  for (int b = photon.bands.first; b < photon.bands.last; ++b)
    flux.push_back(band_flux[b] * s);
}

namespace {

/// Spreads the coordinates of cells over the table [Teschner03].
std::uint32_t hashed(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto u = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
  std::uint64_t h = u(x) * 73856093u ^ u(y) * 19349663u ^ u(z) * 83492791u;
  h ^= h >> 29;
  h *= 0xbf58476d1ce4e5b9ull;
  return static_cast<std::uint32_t>(h >> 32);
}

} // namespace

std::uint32_t PhotonMap::cell_of(const dvec3& place) const {
  const dvec3 p = place * cells_per_unit_;
  const auto mask = static_cast<std::uint32_t>(begins_.size() - 2);
  return hashed(std::llround(std::floor(p.x)), std::llround(std::floor(p.y)),
                std::llround(std::floor(p.z))) &
         mask;
}

std::size_t PhotonMap::cells_near(const dvec3& place, Cells& cells) const {
  std::size_t count = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 offset{corner & 1 ? radius_ : -radius_, corner & 2 ? radius_ : -radius_,
                       corner & 4 ? radius_ : -radius_};
    const std::uint32_t cell = cell_of(place + offset);
    if (std::find(cells.begin(), cells.begin() + count, cell) == cells.begin() + count)
      cells[count++] = cell;
  }
  return count;
}

std::size_t count_within_limit(std::span<const PhotonBatch> batches) {
  std::size_t count = 0;
  for (const PhotonBatch& batch : batches)
    count +=
        static_cast<std::size_t>(std::ranges::count(batch.photons, false, &Photon::beyond_limit));
  return count;
}

void PhotonMap::build(std::span<PhotonBatch> batches, double radius) {
  radius_ = radius;
  density_factor_ = 1.0 / (std::numbers::pi * radius * radius);
  cells_per_unit_ = 1.0 / (2.0 * radius);
  std::size_t count = 0, values = 0;
  for (const PhotonBatch& batch : batches) {
    count += batch.photons.size();
    values += batch.flux.size();
  }
  photons_.resize(count);
  flux_.resize(values);
  // What lies beyond the depth limit must not change the cells, which set the order of the others.
  const std::size_t within = count_within_limit(batches);
  begins_.assign(std::bit_ceil(std::max<std::size_t>(within, 1)) + 1, 0);

  // Sorted by counting, which keeps the order of photons in a cell.
  std::vector<std::uint32_t> cell(count);
  std::size_t i = 0;
  for (const PhotonBatch& batch : batches)
    for (const Photon& photon : batch.photons) {
      cell[i] = cell_of(photon.position);
      ++begins_[cell[i++] + 1];
    }
  for (std::size_t c = 1; c < begins_.size(); ++c)
    begins_[c] += begins_[c - 1];
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  i = 0;
  std::size_t flux_begin = 0;
  for (const PhotonBatch& batch : batches) {
    for (Photon photon : batch.photons) {
      photon.flux += flux_begin;
      photons_[next[cell[i++]]++] = photon;
    }
    std::copy(batch.flux.begin(), batch.flux.end(),
              flux_.begin() + static_cast<std::ptrdiff_t>(flux_begin));
    flux_begin += batch.flux.size();
  }
}

} // namespace abbe
