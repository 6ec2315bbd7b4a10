#include "io/readings/picture_reading.h"

#include "core/scene/user_error.h"
#include "io/images/read_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace abbe {
namespace {

bool holds(const PixelWindow& window, const PixelPlace& place) {
  return place.x >= window.x0 && place.x < window.x1 && place.y >= window.y0 && place.y < window.y1;
}

[[noreturn]] void throw_outside(const std::filesystem::path& file, const PixelWindow& held,
                                const std::string& what) {
  throw UserError(fmt::format("{}: {} is not within the picture, which holds the pixels x {} to {} "
                              "and y {} to {}",
                              file.string(), what, held.x0, held.x1 - 1, held.y0, held.y1 - 1));
}

/// Mean and sum of squares about it, of values as they come. (Welford's recurrence)
struct Moments {
  double mean = 0.0, squares = 0.0;

  void add(double value, std::size_t count) {
    const double before = value - mean;
    mean += before / static_cast<double>(count);
    squares += before * (value - mean);
  }
  [[nodiscard]] double deviation(std::size_t count) const {
    return count > 1 ? std::sqrt(squares / static_cast<double>(count - 1)) : 0.0;
  }
};

} // namespace

PictureReading read_pixels(const std::filesystem::path& file, const std::vector<PixelPlace>& places,
                           const ColorSource& source) {
  const PictureHeader header = read_picture_header(file);
  for (const PixelPlace& place : places)
    if (!holds(header.data, place))
      throw_outside(file, header.data, fmt::format("the pixel {}, {}", place.x, place.y));
  const PictureColors colors(header, source, file.string());
  PictureReading reading{header.wavelengths_nm, colors.observer(), {}};
  reading.pixels.resize(places.size());
  const auto [top, bottom] = std::ranges::minmax(places, {}, &PixelPlace::y);
  PictureRequest request{.rows = RowRange{top.y, bottom.y + 1}, .bands = true};
  const std::size_t bands = header.wavelengths_nm.size();
  read_picture_blocks(file, request, [&](const PictureValues& block) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!holds(block.part, places[i])) continue;
      const std::size_t pixel = block.part.index(places[i].x, places[i].y);
      const auto first = block.bands.begin() + static_cast<std::ptrdiff_t>(pixel * bands);
      reading.pixels[i] = {places[i],
                           colors.color(block, pixel),
                           {first, first + static_cast<std::ptrdiff_t>(bands)}};
    }
  });
  return reading;
}

std::vector<PixelPlace> pixels_on_line(const PixelPlace& from, const PixelPlace& to) {
  const double dx = double(to.x) - from.x, dy = double(to.y) - from.y;
  const auto steps = static_cast<std::int64_t>(std::max(std::abs(dx), std::abs(dy)));
  std::vector<PixelPlace> places{from};
  for (std::int64_t i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(steps);
    places.push_back({from.x + static_cast<int>(std::lround(part * dx)),
                      from.y + static_cast<int>(std::lround(part * dy))});
  }
  return places;
}

RegionReading read_region(const std::filesystem::path& file, const PixelWindow& window,
                          const ColorSource& source) {
  const PictureHeader header = read_picture_header(file);
  const std::string name =
      fmt::format("the region {}, {} to {}, {}", window.x0, window.y0, window.x1, window.y1);
  if (window.width() <= 0 || window.height() <= 0)
    throw UserError(fmt::format("{} holds no pixel: its right and lower edges must be beyond the "
                                "left and upper ones",
                                name));
  if (!holds(header.data, {window.x0, window.y0}) ||
      !holds(header.data, {window.x1 - 1, window.y1 - 1}))
    throw_outside(file, header.data, name);
  const PictureColors colors(header, source, file.string());
  const std::size_t bands = header.wavelengths_nm.size();
  std::size_t count = 0;
  Moments x, y, z;
  std::vector<Moments> spectrum(bands);
  const PictureRequest request{.rows = RowRange{window.y0, window.y1}, .bands = true};
  read_picture_blocks(file, request, [&](const PictureValues& block) {
    for_each_pixel({window.x0, block.part.y0, window.x1, block.part.y1}, [&](int column, int row) {
      const std::size_t pixel = block.part.index(column, row);
      ++count;
      const Xyz color = colors.color(block, pixel);
      x.add(color.x, count);
      y.add(color.y, count);
      z.add(color.z, count);
      for (std::size_t band = 0; band < bands; ++band)
        spectrum[band].add(static_cast<double>(block.bands[pixel * bands + band]), count);
    });
  });
  RegionReading reading{header.wavelengths_nm,
                        colors.observer(),
                        count,
                        {x.mean, y.mean, z.mean},
                        {x.deviation(count), y.deviation(count), z.deviation(count)},
                        {},
                        {}};
  for (const Moments& band : spectrum) {
    reading.band_means.push_back(band.mean);
    reading.band_deviations.push_back(band.deviation(count));
  }
  return reading;
}

} // namespace abbe
