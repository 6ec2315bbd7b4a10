#pragma once

#include "core/film/layer.h"
#include "core/film/strata.h"
#include "core/scene/pixel_window.h"
#include "spectral/color.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace abbe {

/// Which camera sample of which pixel. The index is the sampler's.
struct FilmSample {
  int x, y;
  std::uint32_t index;
  bool covered; ///< it met a surface
};

struct FilmRow;

/// The number of a layer of a film.
enum class LayerId : std::uint16_t {};

/// The layers that the picture itself is made of: the colours of camera samples (`kBeauty`), their
/// bands where these are kept, and the splats of light paths, which have a count of their own.
struct BeautyForm {
  double quantum = 1.0;
  int bands = 0;         ///< 0 for colours alone, else the number of bands that are kept too
  bool errors = false;   ///< the film keeps what `error` needs
  bool splats = false;   ///< light paths add to the film
  bool halves = false;   ///< the film keeps what `signed_splat_error` needs
  bool evidence = false; ///< what decides where samples go is not the beauty itself
};
[[nodiscard]] std::vector<LayerForm> beauty_layers(const BeautyForm& form);
inline constexpr const char* kBeauty = "beauty";
/// The colours of camera samples without what photon maps bring, with strata. Photon maps are
/// shared by pixels, and what samples share may not decide on their number.
inline constexpr const char* kEvidence = "evidence";
inline constexpr const char* kBands = "bands";
inline constexpr const char* kSplats = "beauty.splats";
inline constexpr const char* kBandSplats = "bands.splats";
/// The splats of every other run of light paths, which tell the noise of all of them.
inline constexpr const char* kHalfSplats = "beauty.splats.half";

/// The share of the light behind the scene that shows in the picture, in luminance, and as a
/// colour: that of D65 of Y = 1 when it has passed through the scene.
inline constexpr const char* kTransparency = "transparency";
inline constexpr const char* kTransmittance = "transmittance";
/// A layer of one of these names. Sums have room for 2^31 samples on which nothing is lost.
[[nodiscard]] LayerForm transparency_layer();
[[nodiscard]] LayerForm transmittance_layer();

/// Which of a film's layers have their sums in files, and how much of each file is in memory.
struct LayerPlaces {
  std::vector<bool> in_file; ///< by layer
  std::size_t resident = FileBackedSums::kResidentBytes;
};
/// The bands of one layer go to a file where they are large. All layers that are written beside the
/// picture go to files where they are large together; what every rendering has stays in memory.
[[nodiscard]] LayerPlaces layer_places(std::span<const LayerForm> layers, std::size_t pixels,
                                       const BandPlace& place);

/// Named sums of what the samples of each pixel bring. All sums and counts are integers, and where
/// a sample belongs follows from its index, so a film does not depend on the order in which samples
/// come, nor on the films over which they were spread before these were merged.
class Film {
public:
  /// A film takes 8 bytes a pixel for its counts, 8 more where a layer has strata, and 8 for each
  /// sum. Layers have names of their own. Errors: those of FileBackedSums.
  Film(PixelWindow window, std::vector<LayerForm> layers, const BandPlace& place = {});
  /// The layers of the beauty, without splats.
  Film(PixelWindow window, double quantum, int bands, bool keep_errors = false,
       const BandPlace& place = {});

  /// Where the values of a sample go that has been counted.
  struct Place {
    std::size_t pixel;
    Stratum stratum;
    bool refused = false; ///< the beauty has refused the sample's
  };

  /// Adds a sample's beauty. `radiance` holds one value per band when the film keeps bands.
  /// What a layer refuses adds nothing, though the sample counts; bands come with their colour or
  /// not at all. Two threads must not add to one pixel at once. The place is where the sample's
  /// values for other layers go.
  Place add(const FilmSample& sample, const Xyz& color, std::span<const float> radiance);

  /// Counts a sample, which its values need before they can be added to layers one by one.
  Place count(const FilmSample& sample);
  bool add(LayerId layer, const Place& place, const Xyz& color) {
    return at(layer).add(place.pixel, place.stratum, color, refused_);
  }
  bool add(LayerId layer, const Place& place, double value) {
    return at(layer).add(place.pixel, place.stratum, value, refused_);
  }
  void add(LayerId layer, const Place& place, std::span<const float> radiance) {
    at(layer).add(place.pixel, place.stratum, radiance, refused_);
  }
  void add(LayerId layer, const Place& place, const ColorSteps& steps) {
    at(layer).add(place.pixel, place.stratum, steps, refused_);
  }
  void add_id(LayerId layer, const Place& place, std::uint32_t id) {
    at(layer).add_id(place.pixel, id);
  }

  /// Adds what a light path brings to a pixel inside the window, as a mean over the light paths of
  /// one pass. Any number of threads may add at once. The random number `u` in [0, 1) rounds it up
  /// or down, so that the mean is right for splats that are much smaller than the quantum. The film
  /// must have splats.
  void add_splat(int x, int y, const Xyz& color, std::span<const float> radiance, double u);
  /// The same in a layer of colours.
  void splat(LayerId layer, int x, int y, const Xyz& color, double u) {
    at(layer).splat(window_.index(x, y), color, u, refused_);
  }
  void splat(LayerId layer, int x, int y, std::span<const float> radiance, double u) {
    at(layer).splat(window_.index(x, y), radiance, u, refused_);
  }
  /// Counts the light paths whose splats were added, in passes; parts of a pass are rounded to
  /// 2^-32.
  void add_light_passes(double passes);

  /// Counts values that were refused where the film's sums come from.
  void add_refused(const RefusedValues& more);

  /// Tells that so many pixels' sums were added to or read, so that those in a file do not fill the
  /// memory. Any number of threads may tell.
  void touched(std::size_t pixels) const;

  [[nodiscard]] const PixelWindow& window() const { return window_; }
  [[nodiscard]] std::size_t layer_count() const { return layers_.size(); }
  [[nodiscard]] std::optional<LayerId> find(std::string_view name) const;
  [[nodiscard]] const Layer& layer(LayerId id) const { return layers_[number(id)]; }
  /// One of a pixel's values, as the layer's mean; 0 where there is nothing to take a mean of.
  [[nodiscard]] double mean(LayerId id, int x, int y, std::size_t value = 0) const;
  [[nodiscard]] std::uint32_t samples(int x, int y) const { return counts_[window_.index(x, y)]; }
  [[nodiscard]] std::uint32_t covered_samples(int x, int y) const {
    return covered_[window_.index(x, y)];
  }
  /// How the pixel's samples are divided; the film must keep errors.
  [[nodiscard]] const PixelStrata& strata(int x, int y) const {
    return strata_[window_.index(x, y)];
  }
  [[nodiscard]] double light_passes() const;
  [[nodiscard]] const RefusedValues& refused() const { return refused_; }

  // The beauty: means over the samples of a pixel, and splats over the light passes.
  [[nodiscard]] int bands() const;
  [[nodiscard]] Xyz color(int x, int y) const;
  /// 1 less the mean of `kTransparency`; 1 where the film has no such layer, and 0 of a pixel that
  /// has no sample. It is not clamped: below 0 it tells that single samples stood for more than
  /// one.
  [[nodiscard]] double alpha(int x, int y) const;
  [[nodiscard]] double radiance(int x, int y, int band) const;
  [[nodiscard]] bool keeps_errors() const { return !strata_.empty(); }
  /// The standard error of `color`, estimated from the difference of the pixel's two strata. With a
  /// and b of its n samples and the means A and B it is sqrt(a b) / n |A - B|, half the difference
  /// of equal halves. Infinite where a stratum is empty, as with fewer than two samples. One degree
  /// of freedom: good in the mean over many pixels only. The film must keep errors.
  [[nodiscard]] Xyz error(int x, int y) const;
  /// The same with the sign of A - B, so that it is linear in the samples: its linear R, G, B are
  /// those of the pixel's error.
  [[nodiscard]] Xyz signed_error(int x, int y) const { return signed_error(*beauty_, x, y); }
  /// The same of any layer of colours with strata.
  [[nodiscard]] Xyz signed_error(LayerId id, int x, int y) const;
  /// The same of the splats: half the difference of what two halves of the light paths bring. 0
  /// where the film has no layer `kHalfSplats`.
  [[nodiscard]] Xyz signed_splat_error(int x, int y) const;

private:
  friend void merge(Film& film, const Film& other);
  friend void set_row(Film& film, int y, const FilmRow& row);
  static std::size_t number(LayerId id) { return static_cast<std::size_t>(id); }
  [[nodiscard]] Layer& at(LayerId id) { return layers_[number(id)]; }
  /// Moves the boundary between the pixel's strata, if it is not there already.
  void raise_boundary(std::size_t pixel, std::uint32_t boundary);
  void merge_pixel(const Film& other, std::size_t pixel);
  /// What the sums of a pixel in this layer are divided by.
  [[nodiscard]] double count(const Layer& layer, std::size_t pixel) const;
  [[nodiscard]] double mean(const Layer& layer, std::size_t pixel, std::size_t value) const;
  [[nodiscard]] Xyz mean_color(const Layer& layer, std::size_t pixel) const;

  PixelWindow window_;
  std::vector<Layer> layers_;
  std::optional<LayerId> beauty_, bands_, splats_, band_splats_, transparency_;
  std::vector<std::uint32_t> counts_;  ///< samples per pixel
  std::vector<std::uint32_t> covered_; ///< of these, those that met a surface
  std::vector<PixelStrata> strata_;    ///< per pixel; empty where no layer has strata
  std::int64_t light_passes_ = 0;      ///< in parts of 2^-32
  RefusedValues refused_;
};

} // namespace abbe
