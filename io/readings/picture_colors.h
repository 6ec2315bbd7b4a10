#pragma once

#include "io/images/picture.h"
#include "spectral/observer.h"

#include <optional>
#include <vector>

namespace abbe {

/// Where the colours of a picture file come from.
struct ColorSource {
  /// Who sees the bands. Empty: the 2 degree observer, where bands are used at all.
  std::optional<Observer> observer = {};
  bool prefer_bands = false; ///< where the file has both bands and colours, and no observer is told
};

/// The colours of a picture, of its bands or of its red, green and blue.
class PictureColors {
public:
  /// Throws UserError, which names the file, for a picture that has neither, or has no bands where
  /// an observer is told.
  PictureColors(const PictureHeader& header, const ColorSource& source, const std::string& file);

  [[nodiscard]] bool from_bands() const { return !bands_.empty(); }
  [[nodiscard]] Observer observer() const { return observer_; }
  /// Of a pixel, counted from the upper left one of `picture.part`, which has bands where they are
  /// used.
  [[nodiscard]] Xyz color(const Picture& picture, std::size_t pixel) const;

private:
  Observer observer_;
  std::vector<Xyz> bands_; ///< the colour of each band; empty where the colours are used
};

} // namespace abbe
