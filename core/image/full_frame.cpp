#include "core/image/full_frame.h"

#include <algorithm>

namespace abbe {
namespace {

/// The pixels that lie in both windows, from one to the other.
std::vector<float> placed(const PixelWindow& frame, const PixelWindow& window,
                          const std::vector<float>& values, std::size_t channels) {
  std::vector<float> all(frame.pixel_count() * channels, 0.0f);
  const auto common = common_part(frame, window);
  if (!common) return all;
  const auto width = static_cast<std::ptrdiff_t>(channels) * common->width();
  for (int y = common->y0; y < common->y1; ++y) {
    const auto from =
        values.begin() + static_cast<std::ptrdiff_t>(channels * window.index(common->x0, y));
    std::copy(from, from + width,
              all.begin() + static_cast<std::ptrdiff_t>(channels * frame.index(common->x0, y)));
  }
  return all;
}

} // namespace

std::optional<PixelWindow> common_part(const PixelWindow& a, const PixelWindow& b) {
  const PixelWindow common{std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1),
                           std::min(a.y1, b.y1)};
  if (common.width() > 0 && common.height() > 0) return common;
  return std::nullopt;
}

SceneLinearImage placed_in(const PixelWindow& frame, const SceneLinearImage& image) {
  SceneLinearImage all{image.display, frame, {}, image.metadata, image.space, {}, image.camera};
  if (!image.rgba.empty() || image.channels.empty())
    all.rgba = placed(frame, image.data, image.rgba, 4);
  for (const ImageChannel& channel : image.channels)
    all.channels.push_back({channel.name, placed(frame, image.data, channel.values, 1)});
  return all;
}

SpectralImage placed_in(const PixelWindow& frame, const SpectralImage& image) {
  SpectralImage all{image.display,  frame,       image.wavelengths_nm, {}, {},
                    image.metadata, image.camera};
  all.rgba = placed(frame, image.data, image.rgba, 4);
  const auto pixels = static_cast<std::ptrdiff_t>(image.data.pixel_count());
  for (std::size_t b = 0; b < image.wavelengths_nm.size(); ++b) {
    const auto begin = image.values.begin() + static_cast<std::ptrdiff_t>(b) * pixels;
    const std::vector<float> plane =
        placed(frame, image.data, std::vector<float>(begin, begin + pixels), 1);
    all.values.insert(all.values.end(), plane.begin(), plane.end());
  }
  return all;
}

DisplayImage in_full_frame(const DisplayImage& image) {
  DisplayImage all = image;
  all.data = image.display;
  all.encoded = placed(all.data, image.data, image.encoded, 3);
  all.linear = placed(all.data, image.data, image.linear, 3);
  return all;
}

} // namespace abbe
