#include "core/render/memory_need.h"

#include "core/render/film_layers.h"

#include <algorithm>

namespace abbe {
namespace {

constexpr std::uint64_t kSum = sizeof(std::int64_t);
/// The least of a layer of ids.
constexpr std::uint64_t kIds = 16;
/// Of a picture for screens, encoded and linear, which takes more than the scene-linear one.
constexpr std::uint64_t kPicture = 6 * sizeof(float);
/// Counts of all samples and of those that met a surface.
constexpr std::uint64_t kCounts = 2 * sizeof(std::uint32_t);
/// What pixels of adaptive sampling are known by: rays, shares and numbers of samples, and after
/// the first round what finds the shares.
constexpr std::uint64_t kAdaptive = 3 * 4 + 32;

std::uint64_t bytes_of(const LayerForm& form, std::uint64_t pixels) {
  if (form.kind == LayerKind::ids) return pixels * kIds;
  return pixels * form.values() * kSum * (form.strata ? 2 : 1);
}

std::uint64_t tile_bytes(std::uint64_t tiles) {
  return tiles * (sizeof(Tile) + sizeof(PixelWindow));
}

} // namespace

std::uint64_t memory_need(const Scene& scene, const Plan& plan,
                          const std::optional<BandPlace>& bands) {
  const std::uint64_t pixels = plan.window.pixel_count();
  std::uint64_t bytes = tile_bytes(plan.tiles.size());
  bool strata = false;
  const std::vector<LayerForm> layers = film_layers(scene, plan, bands);
  const LayerPlaces places = layer_places(layers, pixels, bands.value_or(BandPlace{}));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::uint64_t all = bytes_of(layers[i], pixels);
    const std::uint64_t resident = places.resident * (layers[i].strata ? 2 : 1);
    bytes += places.in_file[i] ? std::min(all, resident) : all;
    strata = strata || layers[i].strata;
  }
  std::uint64_t per_pixel = kCounts + kPicture;
  if (strata) per_pixel += sizeof(PixelStrata);
  if (plan.settings.adaptive == AdaptiveSampling::on) per_pixel += kAdaptive;
  return bytes + pixels * per_pixel;
}

std::uint64_t disk_need(const Scene& scene, const Plan& plan,
                        const std::optional<BandPlace>& bands) {
  const std::uint64_t pixels = plan.window.pixel_count();
  const std::vector<LayerForm> layers = film_layers(scene, plan, bands);
  const LayerPlaces places = layer_places(layers, pixels, bands.value_or(BandPlace{}));
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (places.in_file[i]) bytes += bytes_of(layers[i], pixels);
  return bytes;
}

std::uint64_t least_plan_need(const Scene& scene, const RenderSettings& settings) {
  std::uint64_t bytes =
      scene.materials.size() * sizeof(MaterialPlan) + scene.media.size() * sizeof(MediumPlan);
  const auto add = [&](const Dispersion& law) {
    bytes += IndexTable::count(law, settings.skip.constant_indices) * sizeof(double);
  };
  for (const Medium& medium : scene.media)
    add(medium.index);
  for (const Material& material : scene.materials) {
    if (material.film) add(material.film->index);
    if (material.pane) add(material.pane->index);
    if (material.coat) add(*material.coat);
  }
  return bytes;
}

std::uint64_t least_memory_need(const RenderSettings& settings) {
  const PixelWindow window =
      settings.crop.value_or(PixelWindow{0, 0, settings.width, settings.height});
  if (window.width() <= 0 || window.height() <= 0) return 0; // the plan says what is wrong
  const std::uint64_t pixels = window.pixel_count();
  return pixels * (3 * kSum + kCounts + kPicture);
}

} // namespace abbe
