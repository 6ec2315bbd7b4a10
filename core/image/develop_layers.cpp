#include "core/image/develop_layers.h"

#include "core/film/part_layers.h"
#include "core/image/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace abbe {
namespace {

/// What a depth is where nothing is met, as Blender has it.
constexpr float kNoDepth = 1e10f;

float as_float(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMost, kMost));
}

/// The channels of colours, each the sum of some layers of the film.
void add_color(const Film& film, std::span<const LayerId> layers, const std::string& name,
               const Matrix3& to_rgb, SceneLinearImage& image) {
  std::array<ImageChannel, 3> channels;
  for (std::size_t i = 0; i < channels.size(); ++i)
    channels[i].name = fmt::format("{}.{}", name, "RGB"[i]);
  for_each_pixel(film.window(), [&](int x, int y) {
    Vector3 xyz{0.0, 0.0, 0.0};
    if (film.samples(x, y) > 0) // else there is no picture, though light paths may have come
      for (const LayerId layer : layers)
        for (std::size_t i = 0; i < xyz.size(); ++i)
          xyz[i] += film.mean(layer, x, y, i);
    const Vector3 rgb = multiply(to_rgb, xyz);
    for (std::size_t i = 0; i < channels.size(); ++i)
      channels[i].values.push_back(as_float(rgb[i]));
  });
  for (ImageChannel& channel : channels)
    image.channels.push_back(std::move(channel));
}

/// A part of the beauty, with its splats.
void add_part(const Film& film, const std::string& layer, const std::string& name,
              const Matrix3& to_rgb, SceneLinearImage& image) {
  std::vector<LayerId> layers;
  for (const std::string& of : {layer, splats_of(layer)})
    if (const auto id = film.find(of)) layers.push_back(*id);
  if (!layers.empty()) add_color(film, layers, name, to_rgb, image);
}

void add_value(const Film& film, LayerId layer, const std::string& name, SceneLinearImage& image) {
  const bool is_depth = name.ends_with("depth.Z") || name == "distance.Z" ||
                        film.layer(layer).form().kind == LayerKind::nearest;
  ImageChannel channel{name, {}};
  for_each_pixel(film.window(), [&](int x, int y) {
    const bool nothing = is_depth && film.covered_samples(x, y) == 0;
    channel.values.push_back(nothing ? kNoDepth : as_float(film.mean(layer, x, y)));
  });
  image.channels.push_back(std::move(channel));
}

void add_ids(const Film& film, LayerId layer, std::span<const std::string> names,
             std::string_view type, SceneLinearImage& image) {
  for (ImageChannel& channel : cryptomatte_channels(film, layer, names, type))
    image.channels.push_back(std::move(channel));
  for (auto& entry : cryptomatte_metadata(names, type))
    image.metadata.push_back(std::move(entry));
}

/// Counts and variances, which are no sums of the film.
void add_statistics(const Film& film, const ExtraLayers& asked, const Matrix3& to_rgb,
                    SceneLinearImage& image) {
  if (asked.has(ExtraLayer::samples)) {
    ImageChannel samples{"samples.V", {}};
    for_each_pixel(film.window(), [&](int x, int y) {
      samples.values.push_back(static_cast<float>(film.samples(x, y)));
    });
    image.channels.push_back(std::move(samples));
  }
  const auto add_errors = [&](std::string_view name, const auto& of_errors) {
    std::array<ImageChannel, 3> channels;
    for (std::size_t i = 0; i < channels.size(); ++i)
      channels[i].name = fmt::format("{}.{}", name, "RGB"[i]);
    for_each_pixel(film.window(), [&](int x, int y) {
      const Xyz of_samples = film.signed_error(x, y); // infinite where it is unknown
      const Xyz of_splats = film.signed_splat_error(x, y);
      const Vector3 a = multiply(to_rgb, Vector3{of_samples.x, of_samples.y, of_samples.z});
      const Vector3 b = multiply(to_rgb, Vector3{of_splats.x, of_splats.y, of_splats.z});
      for (std::size_t i = 0; i < channels.size(); ++i)
        channels[i].values.push_back(std::isfinite(a[i]) ? as_float(of_errors(a[i], b[i])) : 0.0f);
    });
    for (ImageChannel& channel : channels)
      image.channels.push_back(std::move(channel));
  };
  if (asked.has(ExtraLayer::variance))
    add_errors("variance",
               [](double samples, double splats) { return samples * samples + splats * splats; });
  if (asked.has(ExtraLayer::noise)) add_errors("noise", std::plus<>());
}

} // namespace

void develop_layers(const Film& film, const Plan& plan, const Matrix3& to_rgb,
                    SceneLinearImage& image) {
  const ExtraLayers& asked = plan.settings.layers;
  if (asked.empty()) return;
  for (std::size_t i = 0; i < film.layer_count(); ++i) {
    const auto id = static_cast<LayerId>(i);
    const LayerForm& form = film.layer(id).form();
    if (form.name == "albedo" || form.name == "albedo_through")
      add_color(film, std::array{id}, form.name, to_rgb, image);
    else if (form.name == "object")
      add_ids(film, id, plan.object_names, "CryptoObject", image);
    else if (form.name == "material")
      add_ids(film, id, plan.material_names, "CryptoMaterial", image);
    else if (form.name != kTransparency &&
             (form.kind == LayerKind::value || form.kind == LayerKind::nearest))
      add_value(film, id, form.name, image);
  }
  for (const std::string& group : plan.light_groups)
    add_part(film, light_layer(group), "light_" + group, to_rgb, image);
  for (int i = 0; i < kViews; ++i) {
    const std::string layer = view_layer(static_cast<View>(i));
    add_part(film, layer, "class_" + layer.substr(layer.find(':') + 1), to_rgb, image);
  }
  for (int i = 0; i < kArrivals; ++i) {
    const std::string layer = arrival_layer(static_cast<Arrival>(i));
    add_part(film, layer, layer, to_rgb, image);
  }
  add_statistics(film, asked, to_rgb, image);
}

} // namespace abbe
