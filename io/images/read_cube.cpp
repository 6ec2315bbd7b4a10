#include "io/images/read_cube.h"

#include "io/text/numbers.h"
#include "spectral/band_grid.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace abbe {
namespace {

/// The wavelength of a channel `S0.380,000000nm`; nothing for other channels.
std::optional<double> wavelength_of(std::string name) {
  if (!name.starts_with("S0.") || !name.ends_with("nm")) return std::nullopt;
  std::ranges::replace(name, ',', '.');
  return parse_finite(std::string_view(name).substr(3, name.size() - 5));
}

std::vector<std::pair<double, std::string>> bands_of(const Imf::Header& header) {
  std::vector<std::pair<double, std::string>> bands;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
    if (const auto nm = wavelength_of(c.name())) bands.emplace_back(*nm, c.name());
  std::ranges::sort(bands);
  if (bands.empty()) throw std::runtime_error("it has no bands");
  if (bands.size() > static_cast<std::size_t>(BandGrid::kMaxCount))
    throw std::runtime_error("it has more bands than a rendering");
  const BandGrid grid(static_cast<int>(bands.size()));
  for (std::size_t b = 0; b < bands.size(); ++b)
    if (std::abs(bands[b].first - grid.center_nm(static_cast<int>(b))) > 1e-5)
      throw std::runtime_error("its bands are not those of a rendering");
  return bands;
}

PixelWindow window_of(const Imath::Box2i& box) {
  return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}

void read(const std::filesystem::path& file, const std::function<void(const CubeHeader&)>& begin,
          const UseCubePixel& use) {
  Imf::InputFile input(file.c_str());
  const Imf::Header& header = input.header();
  CubeHeader cube{window_of(header.displayWindow()), window_of(header.dataWindow()), 0, {}};
  const auto bands = bands_of(header);
  cube.bands = static_cast<int>(bands.size());
  for (auto a = header.begin(); a != header.end(); ++a)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
      cube.metadata.emplace_back(a.name(), text->value());
  begin(cube);
  const auto width = static_cast<std::size_t>(cube.data.width());
  std::vector<float> row(width * bands.size()), alpha(width, 1.0f);
  for (int y = cube.data.y0; y < cube.data.y1; ++y) {
    const Imath::Box2i line({cube.data.x0, y}, {cube.data.x1 - 1, y});
    Imf::FrameBuffer frame;
    for (std::size_t b = 0; b < bands.size(); ++b)
      frame.insert(bands[b].second,
                   Imf::Slice::Make(Imf::FLOAT, row.data() + b, line, bands.size() * sizeof(float),
                                    width * sizeof(float)));
    if (header.channels().findChannel("A"))
      frame.insert("A", Imf::Slice::Make(Imf::FLOAT, alpha.data(), line, sizeof(float),
                                         width * sizeof(float)));
    input.setFrameBuffer(frame);
    input.readPixels(y);
    for (std::size_t x = 0; x < width; ++x)
      use({row.data() + x * bands.size(), bands.size()}, alpha[x]);
  }
}

} // namespace

void read_cube(const std::filesystem::path& file,
               const std::function<void(const CubeHeader&)>& begin, const UseCubePixel& use) {
  try {
    read(file, begin, use);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("cannot read {}: {}", file.string(), error.what()));
  }
}

} // namespace abbe
