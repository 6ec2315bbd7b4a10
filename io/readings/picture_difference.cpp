#include "io/readings/picture_difference.h"

#include "core/image/relative_error.h"
#include "core/scene/user_error.h"
#include "io/images/read_picture.h"
#include "spectral/color_difference.h"
#include "spectral/square.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace abbe {
namespace {

namespace fs = std::filesystem;

bool is_finite(const Xyz& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

/// All colours of a picture.
std::vector<Xyz> colors_of(const fs::path& file, const PictureHeader& header,
                           const ColorSource& source) {
  const PictureColors colors(header, source, file.string());
  std::vector<Xyz> all;
  all.reserve(header.data.pixel_count());
  const PictureRequest request{.bands = colors.from_bands()};
  read_picture_blocks(file, request, [&](const PictureValues& block) {
    for (std::size_t pixel = 0; pixel < block.part.pixel_count(); ++pixel)
      all.push_back(colors.color(block, pixel));
  });
  return all;
}

/// Compares band by band, by blocks of rows of both at a time.
std::vector<BandDifference> compare_bands(const fs::path& picture, const fs::path& reference,
                                          const std::vector<double>& nm) {
  std::vector<double> differences(nm.size()), squares(nm.size());
  std::size_t count = 0;
  read_picture_blocks(picture, {.bands = true}, [&](const PictureValues& a) {
    const PictureValues b =
        read_picture(reference, {.rows = RowRange{a.part.y0, a.part.y1}, .bands = true});
    for (std::size_t i = 0; i < a.bands.size(); ++i) {
      const double difference = static_cast<double>(a.bands[i]) - static_cast<double>(b.bands[i]);
      if (!std::isfinite(difference)) continue;
      differences[i % nm.size()] += square(difference);
      squares[i % nm.size()] += square(static_cast<double>(b.bands[i]));
    }
    count += a.part.pixel_count();
  });
  std::vector<BandDifference> bands;
  for (std::size_t i = 0; i < nm.size(); ++i)
    bands.push_back({nm[i], std::sqrt(differences[i] / static_cast<double>(count)),
                     differences[i] > 0.0 ? std::sqrt(differences[i] / squares[i]) : 0.0});
  return bands;
}

/// Colours as they are often shown for values from 0 to 1: even steps of lightness from violet to
/// yellow, in codes of 8 bits.
constexpr std::array<std::array<float, 3>, 5> kFalseColors{
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

std::array<float, 3> false_color_of(double value) {
  const double place = std::clamp(value, 0.0, 1.0) * (kFalseColors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kFalseColors.size() - 2);
  const auto part = static_cast<float>(place - static_cast<double>(below));
  std::array<float, 3> color{};
  for (std::size_t c = 0; c < color.size(); ++c)
    color[c] = std::lerp(kFalseColors[below][c], kFalseColors[below + 1][c], part) / 255.0F;
  return color;
}

void check_windows(const fs::path& picture, const PixelWindow& a, const fs::path& reference,
                   const PixelWindow& b) {
  if (a == b) return;
  const auto text = [](const PixelWindow& w) {
    return fmt::format("{} x {} at {}, {}", w.width(), w.height(), w.x0, w.y0);
  };
  throw UserError(fmt::format("{} has the pixels {}, and {} has {}: only pictures of the same "
                              "pixels can be compared",
                              picture.string(), text(a), reference.string(), text(b)));
}

} // namespace

PictureDifference compare_pictures(const fs::path& picture, const fs::path& reference,
                                   const ColorSource& source, const Chromaticity& white) {
  const PictureHeader a = read_picture_header(picture), b = read_picture_header(reference);
  check_windows(picture, a.data, reference, b.data);
  const std::vector<Xyz> colors = colors_of(picture, a, source);
  const std::vector<Xyz> references = colors_of(reference, b, source);
  PictureDifference difference;
  difference.window = a.data;
  const Xyz white_xyz = to_xyz(white, 1.0);
  std::vector<LinearRgb> rgb, reference_rgb;
  std::vector<double> delta_e;
  double squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (!is_finite(colors[i]) || !is_finite(references[i])) {
      ++difference.not_finite;
      difference.delta_e.push_back(std::numeric_limits<float>::quiet_NaN());
      continue;
    }
    rgb.push_back(to_linear_srgb(colors[i]));
    reference_rgb.push_back(to_linear_srgb(references[i]));
    const LinearRgb &x = rgb.back(), &r = reference_rgb.back();
    squares += square(x.r - r.r) + square(x.g - r.g) + square(x.b - r.b);
    delta_e.push_back(delta_e_2000(to_lab(colors[i], white_xyz), to_lab(references[i], white_xyz)));
    sum += delta_e.back();
    difference.delta_e.push_back(static_cast<float>(delta_e.back()));
  }
  if (rgb.empty())
    throw UserError(fmt::format("{} and {} have no pixel with numbers in both", picture.string(),
                                reference.string()));
  const auto count = static_cast<double>(rgb.size());
  difference.rmse = std::sqrt(squares / (3.0 * count));
  const bool black = std::ranges::all_of(
      reference_rgb, [](const LinearRgb& r) { return r.r == 0.0 && r.g == 0.0 && r.b == 0.0; });
  if (squares > 0.0)
    difference.rel_mse =
        black ? std::numeric_limits<double>::infinity() : relative_mse(rgb, reference_rgb);
  difference.mean_delta_e = sum / count;
  difference.worst_delta_e = std::ranges::max(delta_e);
  difference.delta_e_95 = quantile(std::move(delta_e), 0.95);
  if (!a.wavelengths_nm.empty() && a.wavelengths_nm == b.wavelengths_nm)
    difference.bands = compare_bands(picture, reference, a.wavelengths_nm);
  return difference;
}

DisplayImage false_color(const PictureDifference& difference, double most) {
  DisplayImage image;
  image.display = image.data = {0, 0, difference.window.width(), difference.window.height()};
  for (const float value : difference.delta_e) {
    const std::array<float, 3> color = std::isnan(value)
                                           ? std::array<float, 3>{1.0F, 1.0F, 1.0F}
                                           : false_color_of(static_cast<double>(value) / most);
    image.encoded.insert(image.encoded.end(), color.begin(), color.end());
  }
  image.linear = image.encoded; // a drawing has no light; writers of PNG read `encoded`
  return image;
}

} // namespace abbe
