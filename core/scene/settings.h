#pragma once

#include "core/scene/extra_layers.h"
#include "core/scene/pixel_window.h"
#include "geometry/world/world.h"
#include "spectral/observer.h"

#include <cstdint>
#include <optional>

namespace abbe {

/// `whitted` is the thesis's model: direct light and mirror images alone. `path` finds all light by
/// random paths.
enum class Integrator : std::uint8_t { whitted, path };

/// How a shadow ray treats what lies between a surface and a light. `none`: nothing stops it.
/// `opaque`: any surface stops it. `attenuated`: transparent surfaces let it pass straight on,
/// weakened by their transmittance (as the thesis's author hoped to add).
///
/// `automatic` is `attenuated` with `whitted` and `opaque` with `path`, whose paths find the light
/// behind glass themselves.
enum class ShadowRule : std::uint8_t { none, opaque, attenuated, automatic };

/// Whether `path` also follows light paths, which find the light that reaches a surface by mirrors
/// and glass. `automatic`: from all lights that can send out light paths; `on`: it is an error if
/// one cannot.
enum class Caustics : std::uint8_t { automatic, on, off };

/// Whether noisier pixels get more samples, instead of the same number for each pixel. `automatic`:
/// where it is known to pay, see docs/decisions/noise.md.
enum class AdaptiveSampling : std::uint8_t { automatic, on, off };

/// What becomes of the sky, which is all that a camera ray sees beyond the scene: the background,
/// the environment and the discs of suns. `visible`: it is a part of the picture. `transparent`:
/// the picture is to be laid over another one, and where the sky would show, that one does.
enum class Sky : std::uint8_t { visible, transparent };

/// The reconstruction filter, which is sampled in proportion to its value. `gaussian` has a
/// standard deviation of half a pixel and ends at 1.5 pixels, `tent` ends at 1, `box` at half a
/// pixel.
enum class PixelFilter : std::uint8_t { box, tent, gaussian };

/// Kinds of work that a plan leaves out where it finds them to be without effect. No byte of an
/// image depends on them. One `bool` stands for all of them.
struct Skips {
  bool empty_tiles;      ///< rays that cannot meet any shape's bounds
  bool dead_bands;       ///< bands without light, or to which the observer is blind
  bool constant_curves;  ///< looking up, band by band, a curve that has one value
  bool constant_indices; ///< the same for the index of a medium

  constexpr Skips(bool all = true)
      : empty_tiles(all), dead_bands(all), constant_curves(all), constant_indices(all) {}
  friend constexpr bool operator==(const Skips&, const Skips&) = default;
};

/// The largest limit of depth: as good as none, since paths end at random before.
inline constexpr int kNoDepthLimit = 1000000;

inline constexpr int kSamplesPerPixel = 16, kMostSamplesPerPixel = 4096;
/// With fewer samples `automatic` adaptive sampling is off, since errors are then hardly known.
inline constexpr int kLeastAdaptiveSamples = 8;

/// Everything about a rendering that is not the scene itself. A scene file may set it, and the
/// command line overrides that.
struct RenderSettings {
  int width = 512, height = 512;
  std::optional<PixelWindow> crop; ///< only these pixels are rendered
  int bands = 81;
  Observer observer = Observer::cie1931_2deg; ///< turns bands into colours
  /// The number of samples of each pixel; with `adaptive` the mean, with `noise` or `seconds` the
  /// largest. 0, which no plan has, stands for `kSamplesPerPixel`, or for `kMostSamplesPerPixel`
  /// with `noise` or `seconds`.
  int samples_per_pixel = 0;
  double noise = 0.0;   ///< a tile is done when its `relative_error` is at most this; 0: never
  double seconds = 0.0; ///< the rendering ends after this time; 0: never
  AdaptiveSampling adaptive = AdaptiveSampling::automatic; ///< in a plan `on` or `off`
  bool keep_errors = false; ///< errors are written even without `noise` and `seconds`
  std::uint64_t seed = 0;
  Integrator integrator = Integrator::whitted;
  PixelFilter filter = PixelFilter::gaussian;
  Sky sky = Sky::visible;
  ExtraLayers layers;
  /// The bands of each group of lights are kept under light of equal energy, and all decisions are
  /// those under such light, so that lamps can be changed without tracing a ray.
  bool relightable = false;
  /// Each band's part of the picture is kept as a colour.
  bool band_images = false;

  int max_depth = kNoDepthLimit; ///< how often a path may be reflected or refracted
  /// A branch whose every band carries less is followed at random, and then carries this.
  double min_throughput = 1e-3;
  double min_reflectivity = 0.0; ///< of the thesis: surfaces below it reflect no ray
  double min_transparency = 0.0; ///< of the thesis: surfaces below it refract no ray
  ShadowRule shadows = ShadowRule::automatic;

  Caustics caustics = Caustics::automatic;
  double light_paths = 1.0; ///< light paths per camera sample
  /// Light of the environment above this many times its mean luminance goes by light paths, too.
  double bright_sky = 8.0;
  double photon_radius = 0.0; ///< of the first pass, in scene units; 0: by the scene's size

  bool exact = false;             ///< each band has its own ray: no tolerance, no roulette
  bool jitter = true;             ///< wavelengths are drawn inside the bands, not centres
  double tolerance_pixels = 0.25; ///< bands share a ray while their footprint is below this
  int max_fan = 4;                ///< the most sub-bundles of one path that are followed

  /// True when noise or time may end the rendering before all samples are taken.
  [[nodiscard]] bool may_end_early() const { return noise > 0.0 || seconds > 0.0; }
  /// True when errors are written with the image.
  [[nodiscard]] bool reports_errors() const { return keep_errors || may_end_early(); }
  /// True in a plan when the film must keep errors.
  [[nodiscard]] bool needs_errors() const {
    return reports_errors() || adaptive == AdaptiveSampling::on || layers.tells_noise();
  }

  int threads = 0; ///< 0: one per processor
  Skips skip;
  Tracing tracing = Tracing::packets;
};

} // namespace abbe
