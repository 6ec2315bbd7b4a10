#pragma once

#include "core/image/image.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A channel of a picture file, and how its values are stored: "half", "8 bits".
struct PictureChannel {
  std::string name, type;
};

/// What a picture file says of itself.
struct PictureHeader {
  std::string format;        ///< "OpenEXR", "PNG" or "TIFF"
  PixelWindow display, data; ///< the whole frame, and the part of it that the file holds
  std::vector<PictureChannel> channels;
  std::vector<double> wavelengths_nm; ///< of its bands, ascending; empty where it has none
  bool has_color = false;             ///< false where it holds other things only
  Metadata metadata;                  ///< its texts by their names
  std::string unknown_tag;            ///< of its colour space, where we do not know it
  std::optional<CameraMatrices> camera = {};

  /// The text of this name; empty where the file has none.
  [[nodiscard]] std::string text(std::string_view name) const {
    for (const auto& [key, value] : metadata)
      if (key == name) return value;
    return "";
  }
  /// What a rendering of ours says of itself there.
  [[nodiscard]] Metadata of_abbe() const {
    Metadata kept;
    for (const auto& entry : metadata)
      if (entry.first.starts_with("abbe/")) kept.push_back(entry);
    return kept;
  }
};

/// Rows of a picture, counted as its windows do.
struct RowRange {
  int first = 0, last = 0; ///< without the last
};

/// What is to be read of a picture file.
struct PictureRequest {
  std::optional<RowRange> rows = {}; ///< empty: all
  bool bands = false, alpha = false;
  bool header_only = false;
  std::vector<std::string> channels = {}; ///< of an EXR, full ones that it has beside these
};

/// The part of a file's window that is asked for; it has no height where that lies outside.
[[nodiscard]] inline PixelWindow rows_of(const PixelWindow& data, const PictureRequest& request) {
  if (!request.rows) return data;
  return {data.x0, std::max(data.y0, request.rows->first), data.x1,
          std::min(data.y1, request.rows->last)};
}

/// Part of a picture, as values: rows from the top of `part`, each over the data window's width.
struct PictureValues {
  PictureHeader header;
  PixelWindow part;
  std::vector<float> rgb;   ///< linear sRGB, interleaved; empty where the file has no colours
  std::vector<float> bands; ///< all bands of a pixel side by side, per nm; empty unless asked for
  std::vector<float> alpha; ///< empty unless asked for, and where the file has none
  std::vector<float> layers = {}; ///< the channels asked for by name, side by side by pixel
};

} // namespace abbe
