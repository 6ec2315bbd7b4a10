#include "io/plots/plot.h"

#include "spectral/band_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace abbe {
namespace {

constexpr int kWidth = 900, kHeight = 420;
constexpr int kLeft = 70, kTop = 15, kBottom = 385; ///< of the field of the curve
constexpr int kParts = 405, kPixelsPerPart = 2;
constexpr float kPaper = 1.0f, kGrid = 0.85f, kFill = 0.78f, kInk = 0.1f;
constexpr int kDigitScale = 2;

/// Digits of 3 x 5 dots, a row of three bits each, the top row first.
struct Sign {
  char sign;
  std::array<unsigned, 5> rows;
};
constexpr Sign kSigns[] = {
    {'0', {7, 5, 5, 5, 7}}, {'1', {2, 6, 2, 2, 7}}, {'2', {7, 1, 7, 4, 7}}, {'3', {7, 1, 7, 1, 7}},
    {'4', {5, 5, 7, 1, 1}}, {'5', {7, 4, 7, 1, 7}}, {'6', {7, 4, 7, 5, 7}}, {'7', {7, 1, 1, 2, 2}},
    {'8', {7, 5, 7, 5, 7}}, {'9', {7, 5, 7, 1, 7}}, {'.', {0, 0, 0, 0, 2}}, {'-', {0, 0, 7, 0, 0}},
    {'e', {0, 7, 7, 4, 7}}, {'+', {0, 2, 7, 2, 0}}, {'n', {0, 6, 5, 5, 5}}, {'m', {0, 7, 7, 5, 5}},
};

class Canvas {
public:
  Canvas() : grey_(static_cast<std::size_t>(kWidth) * kHeight, kPaper) {}

  void fill(int x0, int y0, int x1, int y1, float grey) {
    for (int y = std::max(y0, 0); y < std::min(y1, kHeight); ++y)
      for (int x = std::max(x0, 0); x < std::min(x1, kWidth); ++x)
        grey_[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] = grey;
  }

  void write(int x, int y, std::string_view text) {
    for (const char c : text) {
      for (const Sign& sign : kSigns)
        if (sign.sign == c) draw(x, y, sign);
      x += 4 * kDigitScale;
    }
  }

  [[nodiscard]] DisplayImage image() const {
    DisplayImage image;
    image.display = image.data = {0, 0, kWidth, kHeight};
    for (const float grey : grey_)
      image.encoded.insert(image.encoded.end(), 3, grey);
    image.linear = image.encoded; // a drawing has no light; writers of PNG read `encoded`
    return image;
  }

private:
  void draw(int x, int y, const Sign& sign) {
    for (int row = 0; row < 5; ++row)
      for (int column = 0; column < 3; ++column)
        if (sign.rows[static_cast<std::size_t>(row)] >> (2 - column) & 1u)
          fill(x + column * kDigitScale, y + row * kDigitScale, x + (column + 1) * kDigitScale,
               y + (row + 1) * kDigitScale, kInk);
  }

  std::vector<float> grey_;
};

void draw_axes(Canvas& canvas, const PlotRange& range) {
  const int right = kLeft + kParts * kPixelsPerPart;
  for (int nm = 400; nm <= 750; nm += 50) {
    const int x = kLeft + BandGrid(kParts).band_of(nm) * kPixelsPerPart;
    canvas.fill(x, kTop, x + 1, kBottom + 5, kGrid);
    canvas.write(x - 11, kBottom + 10, fmt::format("{}", nm));
  }
  canvas.write(right - 15, kBottom + 10, "nm");
  for (int i = 0; i <= 2; ++i) {
    const int y = kBottom - (kBottom - kTop) * i / 2;
    canvas.fill(kLeft - 5, y, right, y + 1, kGrid);
    const std::string label =
        fmt::format("{:.5g}", range.lowest + (range.highest - range.lowest) * i / 2.0);
    canvas.write(kLeft - 8 - 4 * kDigitScale * static_cast<int>(label.size()), y - 5, label);
  }
}

} // namespace

DisplayImage plot_image(const Plot& plot) {
  const std::vector<double> values = plot.values(kParts);
  const PlotRange range = range_of(values, plot.from_zero);
  Canvas canvas;
  const auto y_of = [&](double value) {
    const double share = (value - range.lowest) / (range.highest - range.lowest);
    return kBottom - static_cast<int>(std::lround(share * (kBottom - kTop)));
  };
  const auto x_of = [](std::size_t part) {
    return kLeft + static_cast<int>(part) * kPixelsPerPart;
  };
  for (std::size_t i = 0; i < values.size(); ++i)
    canvas.fill(x_of(i), y_of(values[i]), x_of(i + 1), kBottom, kFill);
  draw_axes(canvas, range);
  for (std::size_t i = 0; i < values.size(); ++i) { // joined to its neighbour by a vertical stroke
    const int y = y_of(values[i]), before = i > 0 ? y_of(values[i - 1]) : y;
    canvas.fill(x_of(i), std::min(y, before) - 1, x_of(i + 1), std::max(y, before) + 1, kInk);
  }
  canvas.fill(kLeft, kBottom, x_of(kParts), kBottom + 1, kInk);
  return canvas.image();
}

} // namespace abbe
