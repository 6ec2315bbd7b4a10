#pragma once

#include "core/film/film.h"
#include "core/film/radiance_parts.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// The layers of the beauty's parts that a plan asks for. They share the beauty's quantum. `splats`
/// says whether light paths add to the film.
[[nodiscard]] std::vector<LayerForm> part_layers(const Plan& plan, bool splats);

/// The names of a part's layer of the film, and of that of its splats where light paths add to it.
[[nodiscard]] std::string light_layer(const std::string& group);
[[nodiscard]] std::string unit_layer(const std::string& group);
[[nodiscard]] const char* view_layer(View view);
[[nodiscard]] const char* arrival_layer(Arrival arrival);
[[nodiscard]] std::string band_layer(int band);
[[nodiscard]] std::string splats_of(const std::string& layer);

/// One way in which the light of a splat is divided.
struct SplatPart {
  int group = -1; ///< of lights
  View view = View::direct;
  Arrival arrival = Arrival::caustic;
  std::span<const Xyz> bands = {}; ///< its colours by band, of a rendering of band images
};

/// Adds the parts of samples to the layers of a film. Parts add up to the beauty in its integers:
/// each is rounded down to whole quanta, and what the beauty has more goes to the largest part of
/// the sample. A splat goes whole to one part, rounded by the number that rounds it in the beauty.
class PartLayers {
public:
  /// Finds the layers. Keeps references to both.
  PartLayers(const Plan& plan, Film& film);

  /// True where there is nothing to do.
  [[nodiscard]] bool empty() const { return !divides_ && bands_.empty(); }
  /// True where light is divided by lights and ways, so that `add` has something to do.
  [[nodiscard]] bool divides() const { return divides_; }
  /// Adds a sample's parts, unless the beauty has refused it.
  void add(const Film::Place& place, const Xyz& beauty, RadianceParts& parts);
  /// Adds the parts of its bands.
  void add_bands(const Film::Place& place, const Xyz& beauty, std::span<const Xyz> bands);
  /// Adds a splat's. `unit` are its bands under light of equal energy, empty unless relightable.
  void splat(int x, int y, const Xyz& color, std::span<const float> unit, const SplatPart& part,
             double u);

private:
  /// A part's layer, if it was asked for, and that of its splats.
  struct Ids {
    std::optional<LayerId> samples, splats;
  };
  [[nodiscard]] Ids find(const std::string& layer) const;
  [[nodiscard]] ColorSteps steps_of(const Xyz& beauty) const;
  void divide(const Film::Place& place, const ColorSteps& whole, std::span<const Xyz> parts,
              std::span<const Ids> layers);

  const Plan& plan_;
  Film& film_;
  std::vector<Ids> groups_, units_;
  std::vector<Ids> bands_; ///< empty unless each band has an image
  std::array<Ids, kViews> views_;
  std::array<Ids, kArrivals> arrivals_;
  bool divides_ = false;
  std::vector<ColorSteps> steps_; ///< scratch
};

} // namespace abbe
