#pragma once

#include "core/bands/band_span.h"
#include "core/emitters/cell_choice.h"
#include "core/scene/environment.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace abbe {

using glm::dvec3;

/// An environment at the bands, ready to be looked up and aimed at. Between the middles of pixels
/// light is bilinear; directions are chosen among the cells between these middles, in proportion
/// to the cell's mean luminance and solid angle.
class EnvironmentMap {
public:
  /// `wavelengths_nm`: where the pixels' smooth curves are read, one per band. `bright_from`: times
  /// the mean luminance over all directions, what is above counts as bright. Nothing for a black
  /// picture.
  [[nodiscard]] static std::optional<EnvironmentMap>
  make(const Environment& environment, const std::vector<double>& wavelengths_nm,
       double bright_from = std::numeric_limits<double>::infinity());

  /// Multiplies values per band by the radiance from this direction (unit) relative to
  /// Environment::light.
  void scale(const dvec3& direction, BandSpan<float> values) const;

  /// A unit direction for two numbers in [0, 1).
  [[nodiscard]] dvec3 sample(const dvec2& u) const;
  /// With which `sample` chooses it, per steradian.
  [[nodiscard]] double pdf(const dvec3& direction) const;

  /// Luminance, relative to that of Environment::light, times solid angle, over all directions.
  [[nodiscard]] double total() const { return choice_->total(); }

  // The bright part of the light, such as the sun in a picture of the sky: from each direction what
  // its luminance has above a limit, in the colour that the direction has.

  [[nodiscard]] bool has_bright() const { return bright_choice_.has_value(); }
  /// The bright part of the radiance from this direction, 0 to 1.
  [[nodiscard]] double bright_share(const dvec3& direction) const;
  /// A unit direction for two numbers in [0, 1); its pdf, per steradian, is above 0 wherever light
  /// is bright. Both need bright light.
  [[nodiscard]] dvec3 sample_bright(const dvec2& u) const;
  [[nodiscard]] double bright_pdf(const dvec3& direction) const;
  /// As `total`, of the corners' bright light: near that of the directions between them.
  [[nodiscard]] double bright_total() const { return bright_choice_->total(); }

private:
  /// Radiance is scale (1 + x / sqrt(1 + x^2)), x = (a t + b) t + c; see SmoothCurve.
  struct Pixel {
    float a, b, c, scale;
    [[nodiscard]] bool grey() const { return a == 0.0f && b == 0.0f && c == 0.0f; }
  };
  /// The four pixels about a direction and their parts; of a cell, the first is the upper left.
  struct Corners {
    std::size_t pixel[4];
    double part[4];
  };

  EnvironmentMap(const Environment& environment, const std::vector<double>& wavelengths_nm);
  void choose_cells(double bright_from);
  [[nodiscard]] Corners corners(const dvec3& direction) const;
  [[nodiscard]] Corners corners(int row, int column) const;
  /// The mean over the corners of what luminance has above `limit`.
  [[nodiscard]] double mean_luminance(const Corners& corners, double limit) const;
  [[nodiscard]] CellChoice cells(double limit) const;
  [[nodiscard]] dvec3 sample(const CellChoice& choice, const dvec2& u) const;

  int width_, height_;
  glm::dmat3 to_world_;
  std::vector<float> t_; ///< by band
  std::vector<Pixel> pixels_;
  std::vector<float> luminance_;
  std::vector<double> row_cosines_; ///< where rows of cells begin: 1, ..., and -1 as the last end
  std::optional<CellChoice> choice_;
  double limit_ = 0.0; ///< luminance above this is bright
  std::optional<CellChoice> bright_choice_;
};

} // namespace abbe
