#include "core/planning/plan_lines.h"

#include "spectral/observer.h"

#include <algorithm>

namespace abbe {
namespace {

std::vector<const Curve*> spectra_of(const Scene& scene) {
  std::vector<const Curve*> spectra{&scene.background, &scene.global_ambient};
  for (const Light& light : scene.lights)
    spectra.push_back(&light.spectrum);
  if (scene.environment) spectra.push_back(&scene.environment->light);
  for (const Material& material : scene.materials)
    spectra.push_back(&material.emission);
  return spectra;
}

void add_lines(std::vector<std::vector<SpectralLine>>& bands, const BandGrid& grid,
               const Curve& spectrum) {
  for (const SpectralLine& line : spectrum.spectral_lines())
    if (line.power > 0.0) bands[static_cast<std::size_t>(grid.band_of(line.nm))].push_back(line);
}

void clear_where_continuous(std::vector<std::vector<SpectralLine>>& bands, const BandGrid& grid,
                            const Curve& spectrum) {
  if (!spectrum.spectral_lines().empty()) return;
  const std::vector<double> means = band_means(grid, spectrum);
  for (std::size_t b = 0; b < bands.size(); ++b)
    if (means[b] > 0.0) bands[b].clear();
}

void normalize(std::vector<SpectralLine>& lines) {
  double power = 0.0;
  for (const SpectralLine& line : lines)
    power += line.power;
  for (SpectralLine& line : lines)
    line.power /= power;
  std::sort(lines.begin(), lines.end(),
            [](const SpectralLine& a, const SpectralLine& b) { return a.nm < b.nm; });
}

} // namespace

std::vector<std::vector<SpectralLine>> lines_of_bands(const Scene& scene, const BandGrid& grid) {
  std::vector<std::vector<SpectralLine>> bands(static_cast<std::size_t>(grid.count()));
  const auto spectra = spectra_of(scene);
  for (const Curve* spectrum : spectra)
    add_lines(bands, grid, *spectrum);
  for (const Curve* spectrum : spectra)
    clear_where_continuous(bands, grid, *spectrum);
  const auto empty = [](const auto& lines) { return lines.empty(); };
  if (std::all_of(bands.begin(), bands.end(), empty)) return {};
  for (auto& lines : bands)
    normalize(lines);
  return bands;
}

} // namespace abbe
