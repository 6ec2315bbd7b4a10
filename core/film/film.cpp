#include "core/film/film.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace abbe {
namespace {

constexpr double kLightPassParts = 0x1p32;
constexpr double kShareQuantum = 0x1p-32;

std::vector<Layer> make_layers(std::vector<LayerForm> forms, std::size_t pixels,
                               const BandPlace& place) {
  const LayerPlaces places = layer_places(forms, pixels, place);
  const BandPlace file{place.folder, 0, place.spectra, places.resident};
  std::vector<Layer> layers;
  layers.reserve(forms.size());
  for (std::size_t i = 0; i < forms.size(); ++i)
    layers.emplace_back(std::move(forms[i]), pixels, places.in_file[i] ? file : BandPlace{});
  return layers;
}

bool has_strata(const std::vector<Layer>& layers) {
  return std::ranges::any_of(layers, [](const Layer& l) { return l.form().strata; });
}

/// True for what nearly every rendering has.
bool is_of_beauty(const LayerForm& form) {
  constexpr std::array kNames{kBeauty, kSplats, kTransparency};
  return std::ranges::find(kNames, form.name) != kNames.end();
}

std::size_t bytes_of(const LayerForm& form, std::size_t pixels) {
  return pixels * form.values() * sizeof(std::int64_t);
}

} // namespace

LayerPlaces layer_places(std::span<const LayerForm> layers, std::size_t pixels,
                         const BandPlace& place) {
  LayerPlaces places{std::vector<bool>(layers.size(), false)};
  if (place.folder.empty()) return places;
  std::size_t together = 0, files = 0;
  for (const LayerForm& form : layers)
    if (form.kind != LayerKind::bands && !is_of_beauty(form)) together += bytes_of(form, pixels);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const LayerForm& form = layers[i];
    const std::size_t bytes = bytes_of(form, pixels);
    const std::size_t counts = form.kind == LayerKind::bands ? bytes
                               : is_of_beauty(form)          ? 0
                                                             : together;
    places.in_file[i] = bytes > 0 && counts > place.largest_in_memory;
    if (places.in_file[i]) files += form.strata ? 2 : 1;
  }
  // All files share what one may have, but for a few pages each.
  constexpr std::size_t kLeast = std::size_t{4} << 20;
  if (files > 0) places.resident = std::max(FileBackedSums::kResidentBytes / files, kLeast);
  return places;
}

std::vector<LayerForm> beauty_layers(const BeautyForm& form) {
  LayerForm beauty{kBeauty, LayerKind::xyz, form.quantum, 0};
  LayerForm bands{kBands, LayerKind::bands, form.quantum, form.bands};
  LayerForm splats = beauty, band_splats = bands;
  splats.name = kSplats;
  band_splats.name = kBandSplats;
  splats.mean = band_splats.mean = LayerMean::light_passes;
  beauty.strata = form.errors;

  std::vector<LayerForm> layers{beauty};
  if (form.evidence) {
    layers.push_back(beauty);
    layers.back().name = kEvidence;
    layers.back().strata = true;
  }
  if (form.bands > 0) layers.push_back(bands);
  if (form.splats) layers.push_back(splats);
  if (form.splats && form.bands > 0) layers.push_back(band_splats);
  if (form.splats && form.halves) {
    layers.push_back(splats);
    layers.back().name = kHalfSplats;
  }
  return layers;
}

LayerForm transparency_layer() {
  return {kTransparency, LayerKind::value, kShareQuantum, 0};
}

LayerForm transmittance_layer() {
  return {kTransmittance, LayerKind::xyz, kShareQuantum, 0};
}

Film::Film(PixelWindow window, std::vector<LayerForm> layers, const BandPlace& place)
    : window_(window), layers_(make_layers(std::move(layers), window.pixel_count(), place)),
      beauty_(find(kBeauty)), bands_(find(kBands)), splats_(find(kSplats)),
      band_splats_(find(kBandSplats)), transparency_(find(kTransparency)),
      counts_(window.pixel_count()), covered_(window.pixel_count()),
      strata_(has_strata(layers_) ? window.pixel_count() : 0) {
  if (layers_.size() >= std::numeric_limits<std::uint16_t>::max())
    throw std::length_error("a film has fewer than 65535 layers");
}

Film::Film(PixelWindow window, double quantum, int bands, bool keep_errors, const BandPlace& place)
    : Film(window, beauty_layers({quantum, bands, keep_errors, false}), place) {}

Film::Place Film::count(const FilmSample& sample) {
  const std::size_t pixel = window_.index(sample.x, sample.y);
  Stratum stratum = Stratum::second;
  if (keeps_errors()) {
    raise_boundary(pixel, strata_boundary(sample.index));
    PixelStrata& strata = strata_[pixel];
    stratum = strata.of(sample.index);
    strata.first += stratum == Stratum::first ? 1u : 0u;
  }
  ++counts_[pixel];
  covered_[pixel] += sample.covered ? 1u : 0u;
  return {pixel, stratum};
}

void Film::raise_boundary(std::size_t pixel, std::uint32_t boundary) {
  if (boundary <= strata_[pixel].boundary) return;
  strata_[pixel] = {boundary, counts_[pixel]};
  for (Layer& layer : layers_)
    if (layer.form().strata) layer.close_first_stratum(pixel);
}

Film::Place Film::add(const FilmSample& sample, const Xyz& color, std::span<const float> radiance) {
  Place place = count(sample);
  place.refused = !add(*beauty_, place, color);
  if (!place.refused && bands_) add(*bands_, place, radiance);
  return place;
}

void Film::add_splat(int x, int y, const Xyz& color, std::span<const float> radiance, double u) {
  assert(splats_);
  const std::size_t pixel = window_.index(x, y);
  at(*splats_).splat(pixel, color, u, refused_);
  if (band_splats_) at(*band_splats_).splat(pixel, radiance, u, refused_);
}

void Film::add_light_passes(double passes) {
  light_passes_ += std::llround(passes * kLightPassParts);
}

void Film::add_refused(const RefusedValues& more) {
  refused_.not_finite += more.not_finite;
  refused_.negative += more.negative;
  refused_.overflow += more.overflow;
}

double Film::light_passes() const {
  return static_cast<double>(light_passes_) / kLightPassParts;
}

void Film::touched(std::size_t pixels) const {
  for (const Layer& layer : layers_)
    layer.touched(pixels);
}

std::optional<LayerId> Film::find(std::string_view name) const {
  for (std::size_t i = 0; i < layers_.size(); ++i)
    if (layers_[i].form().name == name) return static_cast<LayerId>(i);
  return std::nullopt;
}

double Film::count(const Layer& layer, std::size_t pixel) const {
  switch (layer.form().mean) {
  case LayerMean::samples:
    return counts_[pixel];
  case LayerMean::covered_samples:
    return covered_[pixel];
  case LayerMean::light_passes:
    return light_passes();
  }
  return 0.0;
}

double Film::mean(const Layer& layer, std::size_t pixel, std::size_t value) const {
  if (layer.form().kind == LayerKind::nearest) return layer.nearest(pixel).value_or(0.0);
  const double n = count(layer, pixel);
  const auto sum = static_cast<double>(layer.sum(pixel, value));
  return n > 0.0 ? sum * layer.form().quantum / n : 0.0;
}

Xyz Film::mean_color(const Layer& layer, std::size_t pixel) const {
  const double n = count(layer, pixel), quantum = layer.form().quantum;
  if (!(n > 0.0)) return {0.0, 0.0, 0.0};
  const auto value = [&](std::size_t i) {
    return static_cast<double>(layer.sum(pixel, i)) * quantum / n;
  };
  return {value(0), value(1), value(2)};
}

double Film::mean(LayerId id, int x, int y, std::size_t value) const {
  return mean(layer(id), window_.index(x, y), value);
}

int Film::bands() const {
  return bands_ ? layer(*bands_).form().bands : 0;
}

Xyz Film::color(int x, int y) const {
  const std::size_t pixel = window_.index(x, y);
  const Xyz color = mean_color(layer(*beauty_), pixel);
  return splats_ ? color + mean_color(layer(*splats_), pixel) : color;
}

double Film::radiance(int x, int y, int band) const {
  const std::size_t pixel = window_.index(x, y);
  const auto b = static_cast<std::size_t>(band);
  return mean(layer(*bands_), pixel, b) +
         (band_splats_ ? mean(layer(*band_splats_), pixel, b) : 0.0);
}

double Film::alpha(int x, int y) const {
  if (samples(x, y) == 0) return 0.0;
  return transparency_ ? 1.0 - mean(*transparency_, x, y) : 1.0;
}

Xyz Film::error(int x, int y) const {
  const Xyz e = signed_error(x, y);
  return {std::abs(e.x), std::abs(e.y), std::abs(e.z)};
}

Xyz Film::signed_error(LayerId id, int x, int y) const {
  const std::size_t pixel = window_.index(x, y);
  const Layer& colors = layer(id);
  const double n = counts_[pixel], a = strata_[pixel].first, b = n - a;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (a == 0.0 || b == 0.0) return {unknown, unknown, unknown};
  const double scale = std::sqrt(a * b) / n * colors.form().quantum;
  const auto error = [&](std::size_t i) {
    const auto first = static_cast<double>(colors.first_sum(pixel, i));
    const auto second = static_cast<double>(colors.sum(pixel, i) - colors.first_sum(pixel, i));
    return scale * (first / a - second / b);
  };
  return {error(0), error(1), error(2)};
}

Xyz Film::signed_splat_error(int x, int y) const {
  const auto half = find(kHalfSplats);
  if (!half || !splats_) return {0.0, 0.0, 0.0};
  const std::size_t pixel = window_.index(x, y);
  return mean_color(layer(*half), pixel) * 2.0 + mean_color(layer(*splats_), pixel) * -1.0;
}

} // namespace abbe
