#pragma once

#include "core/film/file_backed_sums.h"
#include "core/film/id_counts.h"
#include "core/film/strata.h"
#include "spectral/color.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace abbe {

struct LayerRow;

/// What a layer holds of each pixel.
enum class LayerKind : std::uint8_t {
  xyz,     ///< a colour
  bands,   ///< one value for each band
  value,   ///< one value, which may be negative
  ids,     ///< which numbers its samples met, and how often
  nearest, ///< the smallest of the samples' values, which are 0 or more
};

/// A colour in whole quanta.
using ColorSteps = std::array<std::int64_t, 3>;

/// What the mean of a layer is taken over.
enum class LayerMean : std::uint8_t {
  samples,         ///< all camera samples of the pixel
  covered_samples, ///< those that met a surface
  light_passes,    ///< the film's light passes
};

/// A layer without its sums. Films whose layers have the same forms can be merged.
struct LayerForm {
  std::string name;
  LayerKind kind = LayerKind::xyz;
  double quantum = 1.0; ///< a power of two: sums are whole multiples of it. Ids have none.
  int bands = 0;        ///< how many, of the kind `bands`
  LayerMean mean = LayerMean::samples;
  bool strata = false; ///< the sums of the first stratum are kept too

  /// How many sums a pixel has.
  [[nodiscard]] std::size_t values() const;
  friend bool operator==(const LayerForm&, const LayerForm&) = default;
};

/// Values that were refused, and why.
struct RefusedValues {
  std::uint64_t not_finite = 0, negative = 0, overflow = 0;
};

/// Where a film keeps large sums: more than `largest_in_memory` bytes of them in a file in
/// `folder`, unless that is empty. See `layer_places`.
struct BandPlace {
  std::filesystem::path folder = {};
  std::size_t largest_in_memory = std::size_t{512} << 20;
  bool spectra = true; ///< the film keeps the bands of each pixel
  /// How much of each file is in memory at once.
  std::size_t resident = FileBackedSums::kResidentBytes;
};

/// Sums of one quantity for all pixels of a film. They are integers, so their value does not depend
/// on the order in which samples are added.
///
/// A value that is not finite, that is negative in a layer of colours or bands, or that a sum has
/// no room for is left out and counted in `refused`. Two threads must not add to one pixel at once,
/// except by `splat`.
class Layer {
public:
  /// Errors: those of FileBackedSums.
  Layer(LayerForm form, std::size_t pixels, const BandPlace& place);

  [[nodiscard]] const LayerForm& form() const { return form_; }

  /// Adds a sample's value. False when it was refused: a colour is refused as a whole.
  bool add(std::size_t pixel, Stratum stratum, const Xyz& color, RefusedValues& refused);
  /// Of the kind `value`, or `nearest`.
  bool add(std::size_t pixel, Stratum stratum, double value, RefusedValues& refused);
  /// Adds a colour that is in quanta already, parts of which may be negative.
  void add(std::size_t pixel, Stratum stratum, const ColorSteps& steps, RefusedValues& refused);
  /// Adds a value for each band; they are refused one by one.
  void add(std::size_t pixel, Stratum stratum, std::span<const float> radiance,
           RefusedValues& refused);
  void add_id(std::size_t pixel, std::uint32_t id) { ids_.add(pixel, id); }
  /// Makes all samples so far those of the first stratum.
  void close_first_stratum(std::size_t pixel);

  /// Adds a value that is rounded up or down by the number `u` in [0, 1), which becomes another
  /// one. Any number of threads may do so at once.
  void splat(std::size_t pixel, const Xyz& color, double& u, RefusedValues& refused);
  void splat(std::size_t pixel, std::span<const float> radiance, double& u, RefusedValues& refused);

  /// Adds what another layer of the same form holds of a pixel. `all_first`: all of the other's
  /// samples belong to the first stratum here.
  void merge(const Layer& other, std::size_t pixel, bool all_first, RefusedValues& refused);

  /// The sum over all samples, and over those of the first stratum, in quanta.
  [[nodiscard]] std::int64_t sum(std::size_t pixel, std::size_t value = 0) const {
    return sums_[pixel * values_ + value];
  }
  [[nodiscard]] std::int64_t first_sum(std::size_t pixel, std::size_t value = 0) const {
    return first_sums_[pixel * values_ + value];
  }
  /// Of the kind `nearest`: nothing where no sample brought a value.
  [[nodiscard]] std::optional<double> nearest(std::size_t pixel) const;
  [[nodiscard]] const IdCounts& ids() const { return ids_; }

  // What the layer holds of a run of pixels, to keep it and to take it back: core/film/film_row.h.
  void get(std::size_t pixel, std::size_t count, LayerRow& row) const;
  void set(std::size_t pixel, const LayerRow& row);

  /// Tells that the sums of so many pixels were read or written: `FileBackedSums::touched`.
  void touched(std::size_t pixels) const { sums_.touched(pixels * values_); }

private:
  /// Entry `i` of the first stratum's sums, where a sample of this stratum is to be added to them.
  [[nodiscard]] std::int64_t* first_sums(std::size_t i, Stratum stratum) {
    return form_.strata && stratum == Stratum::first ? &first_sums_[i] : nullptr;
  }
  bool come_near(std::size_t pixel, double steps, RefusedValues& refused);
  void splat_value(std::size_t i, double value, double& u, RefusedValues& refused);

  LayerForm form_;
  std::size_t values_; ///< sums per pixel
  FileBackedSums sums_;
  FileBackedSums first_sums_; ///< of the first stratum's samples; empty without strata
  IdCounts ids_;
};

} // namespace abbe
