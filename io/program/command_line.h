#pragma once

#include "core/scene/scene.h"
#include "io/images/write_image.h"
#include "io/libraries/read_display.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// Settings given on the command line; those that are given replace the scene's.
struct SettingsOverride {
  std::optional<int> width, height, bands, samples_per_pixel, max_depth, max_fan, threads;
  std::optional<PixelWindow> crop;
  std::optional<std::uint64_t> seed;
  std::optional<double> noise, seconds, min_throughput, tolerance_pixels, light_paths,
      photon_radius;
  std::optional<Integrator> integrator;
  std::optional<PixelFilter> filter;
  std::optional<ShadowRule> shadows;
  std::optional<Caustics> caustics;
  std::optional<Observer> observer;
  std::optional<AdaptiveSampling> adaptive;
  std::optional<bool> keep_errors, exact, jitter, skip;
  std::optional<Tracing> tracing;
};

/// The same for screens. A white point without a value takes the scene's away.
struct DisplayOverride {
  std::optional<double> exposure_ev;
  std::optional<GamutMapping> gamut;
  std::optional<ColorSpace> space;
  std::optional<TransferFunction> transfer;
  std::optional<std::optional<WhitePoint>> white_point;
};

/// The scene's settings with those of the command line in their place.
[[nodiscard]] RenderSettings overridden(RenderSettings scene, const SettingsOverride& given);
[[nodiscard]] DisplaySettings overridden(DisplaySettings scene, const DisplayOverride& given);

enum class Command { render, plan, list, done };

/// What the user asks for. `done`: the command line itself was answered (help, version, a mistake)
/// and `exit_code` is all that is left to return.
struct Options {
  Command command = Command::done;
  int exit_code = 0;
  std::filesystem::path scene_path;
  SettingsOverride settings;
  DisplayOverride display;
  OutputOptions output;
  std::vector<std::filesystem::path> outputs; ///< empty: NAME.exr and NAME.tiff
  std::optional<std::filesystem::path> spectral_output;
  bool quiet = false;
  std::string list_what; ///< glasses, lights, materials or metals; empty: all, for a plot
  std::optional<std::filesystem::path> list_library;
  std::optional<std::string> plot_name; ///< the curve to draw instead of a list
  std::optional<std::filesystem::path> plot_file;
};

/// Exit codes: a mistake of the user's is 2, any other failure 1, an interruption 130.
inline constexpr int kExitFailure = 1, kExitUsage = 2, kExitInterrupted = 130;

/// Reads the command line. Help, version and usage errors are printed here.
[[nodiscard]] Options parse_command_line(int argc, const char* const* argv);

} // namespace abbe
