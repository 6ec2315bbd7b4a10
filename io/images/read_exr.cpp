#include "io/images/read_exr.h"

#include "io/files/regular_file.h"
#include "io/images/read_image.h"
#include "spectral/adaptation.h"
#include "spectral/color_space.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace abbe {
namespace {

/// Primaries and white.
struct Space {
  RgbPrimaries primaries;
  Chromaticity white;
};

/// The linear spaces of colorInteropID and what colourspaces.csv calls them. (source:
/// ColorInterop2026)
constexpr std::array<std::pair<const char*, const char*>, 5> kInteropSpaces{{
    {"lin_rec709_scene", "rec709"},
    {"lin_ap1_scene", "acescg"},
    {"lin_ap0_scene", "aces2065-1"},
    {"lin_rec2020_scene", "rec2020"},
    {"lin_p3d65_scene", "display-p3"},
}};

Space space_of(const char* name) {
  const ColorSpace space = find_color_space(name).value();
  return {space.primaries, space.white};
}

Chromaticity to_chromaticity(const Imath::V2f& c) {
  return {c.x, c.y};
}

/// True for primaries and white of Rec. 709, to the digits in which files write them.
bool is_rec709(const Space& space) {
  const Space rec709 = space_of("rec709");
  const auto near = [](const Chromaticity& a, const Chromaticity& b) {
    return std::abs(a.x - b.x) < 1e-3 && std::abs(a.y - b.y) < 1e-3;
  };
  return near(space.primaries.red, rec709.primaries.red) &&
         near(space.primaries.green, rec709.primaries.green) &&
         near(space.primaries.blue, rec709.primaries.blue) && near(space.white, rec709.white);
}

/// What the file's tags say; nothing where there is none, or none that we know.
std::optional<Space> tagged_space(const Imf::Header& header, std::string& unknown_tag) {
  if (const auto* tag = header.findTypedAttribute<Imf::StringAttribute>("colorInteropID")) {
    for (const auto& [id, name] : kInteropSpaces)
      if (tag->value() == id) return space_of(name);
    unknown_tag = tag->value();
    return std::nullopt;
  }
  if (!Imf::hasChromaticities(header)) return std::nullopt;
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  return Space{{to_chromaticity(c.red), to_chromaticity(c.green), to_chromaticity(c.blue)},
               to_chromaticity(c.white)};
}

void take_to_rec709(std::vector<float>& rgb, const Space& from) {
  const Space to = space_of("rec709");
  const Matrix3 matrix =
      multiply(inverse(rgb_to_xyz_matrix(to.primaries, to.white)),
               multiply(bradford_adaptation(to_xyz(from.white, 1.0), to_xyz(to.white, 1.0)),
                        rgb_to_xyz_matrix(from.primaries, from.white)));
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    const Vector3 c = multiply(matrix, Vector3{rgb[i], rgb[i + 1], rgb[i + 2]});
    for (std::size_t k = 0; k < 3; ++k)
      rgb[i + k] = static_cast<float>(c[k]);
  }
}

/// The names of the channels to read into red, green and blue.
std::vector<const char*> color_channels(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) {
    const Imf::Channel* channel = channels.findChannel(name);
    return channel != nullptr && channel->xSampling == 1 && channel->ySampling == 1;
  };
  if (has("R") && has("G") && has("B")) return {"R", "G", "B"};
  if (has("Y")) return {"Y"};
  throw std::runtime_error("it has neither full channels R, G and B nor a full channel Y");
}

/// The next number of a header.
std::uint32_t take_number(std::istream& file) {
  std::array<char, 4> bytes{};
  file.read(bytes.data(), bytes.size());
  std::uint32_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) // little-endian
    number = number << 8U | static_cast<unsigned char>(bytes[i]);
  return number;
}

/// OpenEXR takes memory for an attribute of its headers as large as the file says that it is.
/// Throws where that is more than the file holds.
void require_attributes(const std::filesystem::path& path) {
  constexpr std::uint32_t kMagic = 20000630, kSeveralParts = 0x1000;
  const std::uintmax_t file_size = std::filesystem::file_size(path);
  std::ifstream file(path, std::ios::binary);
  if (take_number(file) != kMagic) return; // OpenEXR says so
  const bool several = (take_number(file) & kSeveralParts) != 0;
  std::string name, type;
  bool more = true;
  while (more) { // for each part; one without attributes ends them
    more = false;
    while (std::getline(file, name, '\0') && !name.empty() && std::getline(file, type, '\0')) {
      const std::uint32_t size = take_number(file);
      if (!file || size > file_size - static_cast<std::uintmax_t>(file.tellg()))
        throw std::runtime_error("an attribute of its header is cut off");
      file.seekg(size, std::ios::cur);
      more = several;
    }
  }
}

/// Reads the channels into every third value. Memory is filled as rows come, so that a small file
/// that declares a large image takes little.
ExrImage read_rows(Imf::InputFile& file, const std::vector<const char*>& channels) {
  const Imath::Box2i window = file.header().dataWindow(); // includes its last pixel
  const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1;
  const auto height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
  constexpr std::size_t kPixel = 3 * sizeof(float);
  require_image_memory(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height),
                       kPixel);
  ExrImage image{static_cast<int>(width), static_cast<int>(height), {}, {}};
  image.rgb.reserve(3 * static_cast<std::size_t>(width * height));
  constexpr int kRows = 256; // no kind of compression packs more rows together
  for (std::int64_t y = window.min.y; y <= window.max.y; y += kRows) {
    Imath::Box2i rows = window;
    rows.min.y = static_cast<int>(y);
    rows.max.y = static_cast<int>(std::min<std::int64_t>(y + kRows - 1, window.max.y));
    const std::size_t begin = image.rgb.size();
    image.rgb.resize(begin + 3 * static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(rows.max.y - rows.min.y + 1));
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < channels.size(); ++i)
      frame.insert(channels[i], Imf::Slice::Make(Imf::FLOAT, image.rgb.data() + begin + i, rows,
                                                 kPixel, kPixel * static_cast<std::size_t>(width)));
    file.setFrameBuffer(frame);
    file.readPixels(rows.min.y, rows.max.y);
  }
  return image;
}

} // namespace

ExrImage read_exr_image(const std::filesystem::path& path) {
  require_regular_file(path);
  constexpr int kMostPixels = 65536;
  Imf::Header::setMaxImageSize(kMostPixels, kMostPixels); // OpenEXR has a table of all rows
  require_attributes(path);
  Imf::InputFile file(path.c_str());
  const Imf::Header& header = file.header();
  const auto channels = color_channels(header.channels());
  ExrImage image = read_rows(file, channels);
  if (channels.size() == 1) {
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
      image.rgb[i + 1] = image.rgb[i + 2] = image.rgb[i];
    return image;
  }
  const std::optional<Space> space = tagged_space(header, image.unknown_tag);
  if (space && !is_rec709(*space)) take_to_rec709(image.rgb, *space);
  return image;
}

} // namespace abbe
