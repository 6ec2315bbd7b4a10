#include "core/image/develop_layers.h"

#include "core/film/part_layers.h"
#include "core/image/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abbe {
namespace {

/// What a depth is where nothing is met, as Blender has it.
constexpr float kNoDepth = 1e10f;

constexpr const char *kObjects = "CryptoObject", *kMaterials = "CryptoMaterial";

float as_float(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMost, kMost));
}

/// What is to be added to which picture.
struct Target {
  SceneLinearImage& image;
  const Matrix3& to_rgb;
  std::string_view layer; ///< the only one that is wanted, unless it is empty

  [[nodiscard]] bool wants(std::string_view channel) const {
    return layer.empty() || layer_of(channel) == layer;
  }
};

/// The channels of colours, each the sum of some layers of the film.
void add_color(const Film& film, std::span<const LayerId> layers, const std::string& name,
               const Target& target) {
  if (!target.wants(name + ".R")) return;
  std::array<ImageChannel, 3> channels;
  for (std::size_t i = 0; i < channels.size(); ++i)
    channels[i].name = fmt::format("{}.{}", name, "RGB"[i]);
  for_each_pixel(target.image.data, [&](int x, int y) {
    Vector3 xyz{0.0, 0.0, 0.0};
    if (film.samples(x, y) > 0) // else there is no picture, though light paths may have come
      for (const LayerId layer : layers)
        for (std::size_t i = 0; i < xyz.size(); ++i)
          xyz[i] += film.mean(layer, x, y, i);
    const Vector3 rgb = multiply(target.to_rgb, xyz);
    for (std::size_t i = 0; i < channels.size(); ++i)
      channels[i].values.push_back(as_float(rgb[i]));
  });
  for (ImageChannel& channel : channels)
    target.image.channels.push_back(std::move(channel));
}

/// A part of the beauty, with its splats.
void add_part(const Film& film, const std::string& layer, const std::string& name,
              const Target& target) {
  std::vector<LayerId> layers;
  for (const std::string& of : {layer, splats_of(layer)})
    if (const auto id = film.find(of)) layers.push_back(*id);
  if (!layers.empty()) add_color(film, layers, name, target);
}

void add_value(const Film& film, LayerId layer, const std::string& name, const Target& target) {
  if (!target.wants(name)) return;
  const bool is_depth = name.ends_with(".Z") && !name.starts_with("normal") && name != "position.Z";
  ImageChannel channel{name, {}};
  for_each_pixel(target.image.data, [&](int x, int y) {
    const bool nothing = is_depth && film.covered_samples(x, y) == 0;
    channel.values.push_back(nothing ? kNoDepth : as_float(film.mean(layer, x, y)));
  });
  target.image.channels.push_back(std::move(channel));
}

void add_ids(const Film& film, LayerId layer, std::span<const std::string> names,
             const std::string& type, const Target& target) {
  if (!target.wants(type + "00.R")) return;
  for (ImageChannel& channel : cryptomatte_channels(film, layer, target.image.data, names, type))
    target.image.channels.push_back(std::move(channel));
}

/// Counts and variances, which are no sums of the film.
void add_statistics(const Film& film, const ExtraLayers& asked, const Target& target) {
  if (asked.has(ExtraLayer::samples) && target.wants("samples.V")) {
    ImageChannel samples{"samples.V", {}};
    for_each_pixel(target.image.data, [&](int x, int y) {
      samples.values.push_back(static_cast<float>(film.samples(x, y)));
    });
    target.image.channels.push_back(std::move(samples));
  }
  const auto add_errors = [&](const std::string& name, const auto& of_errors) {
    if (!target.wants(name + ".R")) return;
    std::array<ImageChannel, 3> channels;
    for (std::size_t i = 0; i < channels.size(); ++i)
      channels[i].name = fmt::format("{}.{}", name, "RGB"[i]);
    for_each_pixel(target.image.data, [&](int x, int y) {
      const Xyz of_samples = film.signed_error(x, y); // infinite where it is unknown
      const Xyz of_splats = film.signed_splat_error(x, y);
      const Vector3 a = multiply(target.to_rgb, Vector3{of_samples.x, of_samples.y, of_samples.z});
      const Vector3 b = multiply(target.to_rgb, Vector3{of_splats.x, of_splats.y, of_splats.z});
      for (std::size_t i = 0; i < channels.size(); ++i)
        channels[i].values.push_back(std::isfinite(a[i]) ? as_float(of_errors(a[i], b[i])) : 0.0f);
    });
    for (ImageChannel& channel : channels)
      target.image.channels.push_back(std::move(channel));
  };
  if (asked.has(ExtraLayer::variance))
    add_errors("variance",
               [](double samples, double splats) { return samples * samples + splats * splats; });
  if (asked.has(ExtraLayer::noise)) add_errors("noise", std::plus<>());
}

} // namespace

std::string_view layer_of(std::string_view channel) {
  std::string_view layer = channel.substr(0, channel.rfind('.'));
  if (layer.starts_with("Crypto") && layer.size() > 2) layer.remove_suffix(2);
  return layer;
}

Metadata layer_metadata(const Plan& plan) {
  Metadata all;
  const auto add = [&](ExtraLayer layer, std::span<const std::string> names, const char* type) {
    if (!plan.settings.layers.has(layer)) return;
    for (auto& entry : cryptomatte_metadata(names, type))
      all.push_back(std::move(entry));
  };
  add(ExtraLayer::object, plan.object_names, kObjects);
  add(ExtraLayer::material, plan.material_names, kMaterials);
  return all;
}

void develop_layers(const Film& film, const Plan& plan, const Matrix3& to_rgb,
                    std::string_view only, SceneLinearImage& image) {
  const ExtraLayers& asked = plan.settings.layers;
  if (asked.empty()) return;
  const Target target{image, to_rgb, only};
  for (std::size_t i = 0; i < film.layer_count(); ++i) {
    const auto id = static_cast<LayerId>(i);
    const LayerForm& form = film.layer(id).form();
    if (form.name == "albedo" || form.name == "albedo_through")
      add_color(film, std::array{id}, form.name, target);
    else if (form.name == "object")
      add_ids(film, id, plan.object_names, kObjects, target);
    else if (form.name == "material")
      add_ids(film, id, plan.material_names, kMaterials, target);
    else if (form.name != kTransparency &&
             (form.kind == LayerKind::value || form.kind == LayerKind::nearest))
      add_value(film, id, form.name, target);
  }
  for (const std::string& group : plan.light_groups)
    add_part(film, light_layer(group), "light_" + group, target);
  for (int i = 0; i < kViews; ++i) {
    const std::string layer = view_layer(static_cast<View>(i));
    add_part(film, layer, "class_" + layer.substr(layer.find(':') + 1), target);
  }
  for (int i = 0; i < kArrivals; ++i) {
    const std::string layer = arrival_layer(static_cast<Arrival>(i));
    add_part(film, layer, layer, target);
  }
  add_statistics(film, asked, target);
}

} // namespace abbe
