#include "core/denoise/denoise_guide.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string_view>
#include <utility>

namespace abbe {
namespace {

using Plane = DenoiseGuide::Plane;

/// A layer that tells what is seen.
struct Feature {
  std::string_view layer, components;
  float scale;   ///< pixels that differ by this much are hardly mixed
  bool distance; ///< it counts by its logarithm
};

/// Behind glass what is seen jumps from sample to sample, so it may differ by more.
constexpr std::array kFeatures{
    Feature{"normal", "XYZ", 0.45f, false},       Feature{"normal_through", "XYZ", 0.5f, false},
    Feature{"albedo", "RGB", 0.2f, false},        Feature{"albedo_through", "RGB", 0.2f, false},
    Feature{"depth", "Z", 0.15f, true},           Feature{"distance", "Z", 0.15f, true},
    Feature{"distance_through", "Z", 0.3f, true},
};
/// How much of a pixel is covered.
constexpr float kAlphaScale = 0.1f;

std::vector<std::string> channels_of(std::string_view layer, std::string_view components) {
  std::vector<std::string> names;
  for (const char component : components)
    names.push_back(std::string(layer) + '.' + component);
  return names;
}

const Plane* find_channel(const SceneLinearImage& image, std::string_view name) {
  const auto found = std::ranges::find(image.channels, name, &ImageChannel::name);
  return found == image.channels.end() ? nullptr : &found->values;
}

/// A distance beyond all that a picture holds stands for nothing at all.
bool is_distance(float distance) {
  return distance > 0.0f && distance < 1e10f;
}

/// The logarithm of distances, from 1 for the nearest. Where nothing is met it is 0.
Plane logarithms(const Plane& distances) {
  float nearest = 1e10f;
  for (const float distance : distances)
    if (is_distance(distance)) nearest = std::min(nearest, distance);
  Plane result(distances.size(), 0.0f);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (is_distance(distances[i])) result[i] = 1.0f + std::log(distances[i] / nearest);
  return result;
}

Plane scaled(Plane plane, float scale) {
  for (float& value : plane)
    value /= scale;
  return plane;
}

/// One of the four values of each pixel.
Plane plane_of(const std::vector<float>& rgba, std::size_t component) {
  Plane plane(rgba.size() / 4);
  for (std::size_t i = 0; i < plane.size(); ++i)
    plane[i] = rgba[4 * i + component];
  return plane;
}

} // namespace

std::vector<std::string> noise_channels() {
  return channels_of("noise", "RGB");
}

std::vector<std::string> feature_channels() {
  std::vector<std::string> names;
  for (const Feature& feature : kFeatures)
    for (std::string& name : channels_of(feature.layer, feature.components))
      names.push_back(std::move(name));
  return names;
}

DenoiseGuide guide_of(const SceneLinearImage& image) {
  DenoiseGuide guide;
  guide.width = image.data.width();
  guide.height = image.data.height();
  const std::vector<std::string> noise = noise_channels();
  for (std::size_t c = 0; c < 3; ++c) {
    const Plane* const channel = find_channel(image, noise[c]);
    assert(channel);
    guide.color[c] = plane_of(image.rgba, c);
    guide.noise[c] = *channel;
  }
  for (const Feature& feature : kFeatures)
    for (const std::string& name : channels_of(feature.layer, feature.components))
      if (const Plane* const channel = find_channel(image, name))
        guide.features.push_back(
            scaled(feature.distance ? logarithms(*channel) : *channel, feature.scale));
  guide.features.push_back(scaled(plane_of(image.rgba, 3), kAlphaScale));
  return guide;
}

SceneLinearImage denoised(SceneLinearImage image, const Denoiser& denoiser) {
  std::vector<Plane> planes;
  for (std::size_t c = 0; c < 3; ++c)
    planes.push_back(plane_of(image.rgba, c));
  planes = denoiser.filtered(planes);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < planes[c].size(); ++i)
      image.rgba[4 * i + c] = planes[c][i];
  image.metadata.emplace_back("abbe/denoised", "yes");
  return image;
}

SpectralImage denoised(const SpectralImage& sources, const DenoiseWeights& weights) {
  const DenoiseRows from = weights.sources(), rows = weights.rows();
  const auto width = static_cast<std::size_t>(sources.data.width());
  const std::size_t pixels = width * static_cast<std::size_t>(rows.count());
  const std::size_t source_pixels = width * static_cast<std::size_t>(from.count());
  SpectralImage result{sources.display, sources.data, sources.wavelengths_nm, {}, {},
                       sources.metadata};
  result.data.y0 += rows.first - from.first;
  result.data.y1 = result.data.y0 + rows.count();
  result.values.resize(pixels * sources.wavelengths_nm.size());
  for (std::size_t band = 0; band < sources.wavelengths_nm.size(); ++band)
    weights.apply(sources.values.data() + band * source_pixels,
                  result.values.data() + band * pixels);
  const auto skipped = static_cast<std::ptrdiff_t>(width) * (rows.first - from.first);
  const auto begin = sources.rgba.begin() + 4 * skipped;
  result.rgba.assign(begin, begin + static_cast<std::ptrdiff_t>(4 * pixels));
  Plane target(pixels);
  for (std::size_t c = 0; c < 3; ++c) {
    weights.apply(plane_of(sources.rgba, c).data(), target.data());
    for (std::size_t i = 0; i < pixels; ++i)
      result.rgba[4 * i + c] = target[i];
  }
  result.metadata.emplace_back("abbe/denoised", "yes");
  result.camera = sources.camera;
  return result;
}

} // namespace abbe
