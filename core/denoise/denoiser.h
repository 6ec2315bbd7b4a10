#pragma once

#include <array>
#include <vector>

namespace abbe {

/// What the filter decides by: planes with one value for each pixel, row by row from the top.
struct DenoiseGuide {
  using Plane = std::vector<float>;

  int width = 0, height = 0;
  std::array<Plane, 3> color; ///< the noisy picture
  std::array<Plane, 3> noise; ///< half the difference of two pictures with half the samples each
  /// What is seen there, such as a component of the normal. Values are scaled so that pixels that
  /// differ by 1 are hardly mixed.
  std::vector<Plane> features;
};

/// Rows of a picture.
struct DenoiseRows {
  int first = 0, last = 0; ///< without the last

  [[nodiscard]] int count() const { return last - first; }
};

/// The weights by which the pixels of some rows are mixed. They are the same for all channels, so
/// that bands which add up to a colour still do.
class DenoiseWeights {
public:
  [[nodiscard]] DenoiseRows rows() const { return rows_; }
  /// The rows whose pixels are mixed into those.
  [[nodiscard]] DenoiseRows sources() const { return sources_; }
  /// Filters one channel. `source` is a plane of the rows `sources`, `target` one of `rows`.
  void apply(const float* source, float* target) const;

private:
  friend class Denoiser;

  /// The weight of each pixel and its neighbour at one offset. The opposite offset has the same.
  struct Neighbor {
    int dx, dy;
    std::vector<float> weights; ///< of the rows `known_`
  };

  /// Adds up what all neighbours of a row bring. `plane` has the rows from `plane_first` on, and
  /// neighbours outside of `within` are left out.
  void gather(int y, const float* plane, DenoiseRows within, float* sums) const;
  void balance();
  void find_own_shares();

  int width_ = 0, height_ = 0;
  DenoiseRows rows_, sources_, known_;
  std::vector<Neighbor> neighbors_;
  std::vector<float> scale_; ///< of the rows `known_`: a weight is scaled by that of both pixels
  std::vector<float> own_;   ///< of `rows_`: what a pixel keeps of its own
};

/// A filter that mixes each pixel with those around it that are alike. The weight of two pixels is
/// that of either for the other, and the weights of each pixel add up to 1, so that no light is
/// lost and none is won: the mean of every channel stays as it is. docs/decisions/denoising.md
class Denoiser {
public:
  explicit Denoiser(DenoiseGuide guide);

  /// How far, in rows and columns, a pixel's light may go.
  static constexpr int kReach = 5;

  [[nodiscard]] int width() const { return guide_.width; }
  [[nodiscard]] int height() const { return guide_.height; }
  /// They do not depend on which other rows are asked for.
  [[nodiscard]] DenoiseWeights weights(DenoiseRows rows) const;
  /// Filters channels of the whole picture.
  [[nodiscard]] std::vector<DenoiseGuide::Plane>
  filtered(const std::vector<DenoiseGuide::Plane>& planes) const;

private:
  void find_weights(DenoiseWeights::Neighbor& neighbor, DenoiseRows known, DenoiseRows rows) const;
  void add_color_differences(int y, int dx, int dy, float* differences) const;

  DenoiseGuide guide_;
  std::array<DenoiseGuide::Plane, 3> first_, second_; ///< the two pictures with half the samples
  std::array<DenoiseGuide::Plane, 3> variance_;       ///< of the picture, as a mean around a pixel
};

} // namespace abbe
