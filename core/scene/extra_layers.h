#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A layer that can be written beside the picture. docs/layers.md says what each holds.
enum class ExtraLayer : std::uint8_t {
  transmittance,
  depth,
  depth_nearest,
  distance,
  position,
  normal,
  normal_geometric,
  normal_through,
  albedo,
  uv,
  object,
  material,
  samples,
  variance,
  direct,
  indirect,
  caustic,
  class_direct,
  class_reflection,
  class_refraction,
  deviation,
  surfaces,
  glass_path,
  total_reflections,
  least_deviation,
  noise,
  albedo_through,
  distance_through,
};
inline constexpr int kExtraLayerCount = static_cast<int>(ExtraLayer::distance_through) + 1;

/// The name by which a layer is asked for.
struct ExtraLayerName {
  std::string_view name;
  ExtraLayer layer;
};
[[nodiscard]] std::span<const ExtraLayerName> extra_layer_names();

/// Layers that are written beside the picture.
struct ExtraLayers {
  std::uint32_t kinds = 0; ///< a bit for each ExtraLayer
  /// Lights, or groups of them, whose part of the picture is a layer. "*" stands for all.
  std::vector<std::string> lights = {};

  void add(ExtraLayer layer) { kinds |= bit(layer); }
  [[nodiscard]] bool has(ExtraLayer layer) const { return (kinds & bit(layer)) != 0; }
  [[nodiscard]] bool has_light(std::string_view name) const;
  [[nodiscard]] bool empty() const { return kinds == 0 && lights.empty(); }
  /// True where the film is to know how noisy the picture is.
  [[nodiscard]] bool tells_noise() const {
    return has(ExtraLayer::variance) || has(ExtraLayer::noise);
  }
  /// True where the picture's light is to be divided.
  [[nodiscard]] bool divides_light() const;

  friend bool operator==(const ExtraLayers&, const ExtraLayers&) = default;

private:
  static constexpr std::uint32_t bit(ExtraLayer layer) {
    return std::uint32_t{1} << static_cast<unsigned>(layer);
  }
};

/// Adds what a list such as "depth,normal,light:*" names. False where a name is none of the
/// layers'.
[[nodiscard]] bool add_layers(std::string_view list, ExtraLayers& layers);
/// The list, in an order of its own; "none" where there is nothing.
[[nodiscard]] std::string layer_list(const ExtraLayers& layers);

} // namespace abbe
