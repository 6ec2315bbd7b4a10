#pragma once

#include "core/scene/pixel_window.h"
#include "geometry/world/world.h"
#include "spectral/observer.h"

#include <cstdint>
#include <optional>

namespace abbe {

/// `whitted`: the thesis's model, lamps and mirror images alone. `path`: all light, by random
/// paths.
enum class Integrator : std::uint8_t { whitted, path };

/// How a shadow ray treats what lies between a surface and a lamp: any surface stops it, or
/// transparent ones let it pass straight on, weakened by their transmittance (as the thesis's
/// author hoped to add).
///
/// `automatic` is `attenuated` with `whitted` and `opaque` with `path`, whose paths find the light
/// behind glass themselves.
enum class ShadowRule : std::uint8_t { none, opaque, attenuated, automatic };

/// Whether light that reaches a surface by mirrors and glass is found from its lamps, with `path`.
/// `automatic`: from all lamps that can send out light paths; `on`: an error where one cannot.
enum class Caustics : std::uint8_t { automatic, on, off };

/// Whether a pixel gets the more samples the noisier it is, instead of each the same number.
/// `automatic`: where it is known to pay, see docs/decisions/noise.md.
enum class AdaptiveSampling : std::uint8_t { automatic, on, off };

/// The reconstruction filter, sampled in proportion to its value; `gaussian` has a standard
/// deviation of half a pixel and ends at 1.5 pixels, `tent` ends at 1, `box` at half a pixel.
enum class PixelFilter : std::uint8_t { box, tent, gaussian };

/// What a plan leaves out where it finds it to be without effect; no byte of a picture depends on
/// it. One `bool` stands for all of them.
struct Skips {
  bool empty_tiles;      ///< rays where no shape's bounds reach
  bool dead_bands;       ///< bands in which nothing shines or nothing is seen
  bool constant_curves;  ///< looking up, band by band, a curve that has one value
  bool constant_indices; ///< the same for the index of a medium

  constexpr Skips(bool all = true)
      : empty_tiles(all), dead_bands(all), constant_curves(all), constant_indices(all) {}
  friend constexpr bool operator==(const Skips&, const Skips&) = default;
};

inline constexpr int kSamplesPerPixel = 16, kMostSamplesPerPixel = 4096;
/// Adaptive sampling is `automatic` with fewer samples: errors are then hardly known.
inline constexpr int kLeastAdaptiveSamples = 8;

/// Everything about a rendering that is not the scene itself. A scene file may set it, the command
/// line overrides it.
struct RenderSettings {
  int width = 512, height = 512;
  std::optional<PixelWindow> crop; ///< only these pixels are rendered
  int bands = 81;
  Observer observer = Observer::cie1931_2deg; ///< whose eye makes colours of the bands
  /// What a pixel gets, with `adaptive` in the mean, with noise the most. 0, which is never in a
  /// plan, stands for `kSamplesPerPixel`, or for `kMostSamplesPerPixel` where noise or time says
  /// when to stop.
  int samples_per_pixel = 0;
  double noise = 0.0;   ///< a tile is done when its `relative_error` is at most this; 0: never
  double seconds = 0.0; ///< the rendering ends after this time; 0: never
  AdaptiveSampling adaptive = AdaptiveSampling::automatic; ///< in a plan `on` or `off`
  bool keep_errors = false; ///< errors are told, even if neither noise nor time ends it
  std::uint64_t seed = 0;
  Integrator integrator = Integrator::whitted;
  PixelFilter filter = PixelFilter::gaussian;

  int max_depth = 16;            ///< how often a path may be reflected or refracted
  double min_throughput = 1e-3;  ///< a branch whose every band carries less is dropped
  double min_reflectivity = 0.0; ///< the thesis's: no reflected ray from surfaces below it
  double min_transparency = 0.0; ///< the thesis's: no refracted ray through surfaces below it
  ShadowRule shadows = ShadowRule::automatic;

  Caustics caustics = Caustics::automatic;
  double light_paths = 1.0;   ///< light paths per camera sample
  double photon_radius = 0.0; ///< of the first pass, in scene units; 0: by the scene's size

  bool exact = false;             ///< every band its own ray: neither tolerance nor roulette
  bool jitter = true;             ///< wavelengths drawn inside the bands instead of their centres
  double tolerance_pixels = 0.25; ///< bands share a ray while their spread is below this
  int max_fan = 4;                ///< at most so many sub-bundles of one path are followed

  /// True where something else than the number of samples may end the rendering.
  [[nodiscard]] bool may_end_early() const { return noise > 0.0 || seconds > 0.0; }
  /// True where errors are written with the picture.
  [[nodiscard]] bool reports_errors() const { return keep_errors || may_end_early(); }
  /// True in a plan whose film must keep errors.
  [[nodiscard]] bool needs_errors() const {
    return reports_errors() || adaptive == AdaptiveSampling::on;
  }

  int threads = 0; ///< 0: one per processor
  Skips skip;
  Tracing tracing = Tracing::packets;
};

} // namespace abbe
