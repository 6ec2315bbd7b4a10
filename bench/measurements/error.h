#pragma once

#include "bench/measurements/convergence.h"
#include "bench/measurements/image_error.h"
#include "bench/measurements/setup.h"
#include "bench/measurements/timing.h"
#include "bench/measurements/variation.h"

#include <functional>

namespace abbe::bench {

struct ErrorOptions {
  RenderOptions render;
  std::vector<std::string> variations{"default", "exact"};
  std::vector<int> budgets{1, 4, 16, 64}; ///< samples per pixel, ascending
  int reference_samples = 256;
  bool band_noise = false;          ///< keep all bands and tell their noise; slower
  std::uint64_t reference_seed = 1; ///< other than the scene's, so that noise is not shared
};

/// One variation at one budget.
struct BudgetError {
  int samples = 0;
  Summary render_seconds; ///< processor time, summed over the threads
  Summary wall_seconds;
  std::uint64_t rays = 0;
  ImageError error;
};

struct ErrorCurve {
  Variation variation;
  std::vector<BudgetError> budgets;

  [[nodiscard]] std::vector<TimedError> rel_mse_curve() const;
  [[nodiscard]] std::vector<TimedError> delta_e_curve() const; ///< of the mean
};

/// The mean dE2000 at which variations are compared: an image whose error is hard to see.
inline constexpr double kEqualDeltaE = 0.5;

/// The times of two variations to one error.
struct EqualError {
  double mean_delta_e = 0.0;
  double ratio = 1.0; ///< first over second
};

struct ErrorCurves {
  std::string scene;
  RenderSettings reference; ///< exact, with jitter
  double reference_seconds = 0.0;
  std::vector<ErrorCurve> curves;

  /// Compares the variations "default" and "exact" at `kEqualDeltaE`, or at the least mean
  /// difference that both get to. Nothing where one of them is missing.
  [[nodiscard]] std::optional<EqualError> default_over_exact() const;
};

/// Renders every variation at every budget and compares with a reference of `--exact` with jitter.
/// `tell` hears what is being done.
[[nodiscard]] ErrorCurves measure_error(const std::filesystem::path& scene,
                                        const ErrorOptions& options,
                                        const std::function<void(const std::string&)>& tell);

} // namespace abbe::bench
