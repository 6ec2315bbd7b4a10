#include "io/images/read_exr.h"

#include "io/files/regular_file.h"
#include "io/images/read_image.h"
#include "io/images/spectral_channels.h"
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
#include <limits>
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

/// A channel with a value for each pixel.
bool is_full(const Imf::Channel& channel) {
  return channel.xSampling == 1 && channel.ySampling == 1;
}

/// The names of the channels to read into red, green and blue; none where there are no colours.
std::vector<std::string> color_channels(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) {
    const Imf::Channel* channel = channels.findChannel(name);
    return channel != nullptr && is_full(*channel);
  };
  if (has("R") && has("G") && has("B")) return {"R", "G", "B"};
  if (has("Y")) return {"Y"};
  return {};
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

PixelWindow exclusive(const Imath::Box2i& box) {
  // OpenEXR's windows include their last pixel, ours do not.
  constexpr int kMost = std::numeric_limits<int>::max();
  if (box.max.x == kMost || box.max.y == kMost)
    throw std::runtime_error("its windows end beyond all that pixels are counted to");
  return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}

const char* type_name(Imf::PixelType type) {
  switch (type) {
  case Imf::HALF:
    return "half";
  case Imf::FLOAT:
    return "float";
  default:
    return "uint";
  }
}

Matrix4 from_imath(const Imath::M44f& m) {
  Matrix4 matrix;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double value = m[i][j]; // a damaged file may have anything
      matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          std::isfinite(value) ? value : 0.0;
    }
  return matrix;
}

std::optional<CameraMatrices> camera_of(const Imf::Header& header) {
  if (!Imf::hasWorldToCamera(header)) return std::nullopt;
  CameraMatrices camera{from_imath(Imf::worldToCamera(header)), {}};
  if (Imf::hasWorldToNDC(header)) camera.world_to_image = from_imath(Imf::worldToNDC(header));
  return camera;
}

/// What a header says, but for the colours' tag.
PictureHeader header_of(const Imf::Header& header) {
  PictureHeader said;
  said.format = "OpenEXR";
  said.display = exclusive(header.displayWindow());
  said.data = exclusive(header.dataWindow());
  std::vector<std::string> names;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    said.channels.push_back({it.name(), type_name(it.channel().type)});
    if (is_full(it.channel())) names.emplace_back(it.name());
  }
  for (const SpectralChannel& channel : spectral_channels(names))
    said.wavelengths_nm.push_back(channel.wavelength_nm);
  for (auto it = header.begin(); it != header.end(); ++it)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
      said.metadata.emplace_back(it.name(), text->value());
  said.has_color = !color_channels(header.channels()).empty();
  said.camera = camera_of(header);
  return said;
}

/// The names of all bands, by wavelength.
std::vector<std::string> band_channels(const Imf::ChannelList& channels) {
  std::vector<std::string> names, bands;
  for (auto it = channels.begin(); it != channels.end(); ++it)
    if (is_full(it.channel())) names.emplace_back(it.name());
  for (SpectralChannel& channel : spectral_channels(names))
    bands.push_back(std::move(channel.name));
  return bands;
}

/// Where the values of some channels go: one after the other, `stride` values from pixel to pixel.
struct Target {
  std::vector<std::string> names;
  std::size_t stride;
  std::vector<float>& values;
};

/// Reads rows of the data window. Memory is filled as rows come, so that a small file that declares
/// a large image takes little.
void read_rows(Imf::InputFile& file, const PixelWindow& rows, std::vector<Target> targets) {
  const auto width = static_cast<std::size_t>(rows.width());
  std::size_t pixel_bytes = 0;
  for (const Target& target : targets)
    pixel_bytes += target.stride * sizeof(float);
  require_image_memory(width, static_cast<std::uint64_t>(rows.height()), pixel_bytes);
  for (Target& target : targets)
    target.values.reserve(target.stride * rows.pixel_count());
  constexpr int kRows = 256; // no kind of compression packs more rows together
  for (int y = rows.y0; y < rows.y1;) {
    const int end = rows.y1 - y > kRows ? y + kRows : rows.y1;
    const Imath::Box2i box({rows.x0, y}, {rows.x1 - 1, end - 1});
    Imf::FrameBuffer frame;
    for (Target& target : targets) {
      const std::size_t begin = target.values.size(), pixel = target.stride * sizeof(float);
      target.values.resize(begin + target.stride * width * static_cast<std::size_t>(end - y));
      for (std::size_t i = 0; i < target.names.size(); ++i)
        frame.insert(target.names[i], Imf::Slice::Make(Imf::FLOAT, target.values.data() + begin + i,
                                                       box, pixel, pixel * width));
    }
    file.setFrameBuffer(frame);
    file.readPixels(y, end - 1);
    y = end;
  }
}

} // namespace

PictureValues read_exr_picture(const std::filesystem::path& path, const PictureRequest& request) {
  require_regular_file(path);
  constexpr int kMostPixels = 65536;
  Imf::Header::setMaxImageSize(kMostPixels, kMostPixels); // OpenEXR has a table of all rows
  require_attributes(path);
  Imf::InputFile file(path.c_str());
  const Imf::Header& header = file.header();
  PictureValues picture{header_of(header), {}, {}, {}, {}};
  const auto colors = color_channels(header.channels());
  std::optional<Space> space;
  if (colors.size() == 3) space = tagged_space(header, picture.header.unknown_tag);
  if (request.header_only) return picture;
  picture.part = rows_of(picture.header.data, request);
  if (picture.part.height() <= 0) return picture;
  std::vector<Target> targets;
  if (!colors.empty()) targets.push_back({colors, 3, picture.rgb});
  const auto bands = request.bands ? band_channels(header.channels()) : std::vector<std::string>{};
  if (!bands.empty()) targets.push_back({bands, bands.size(), picture.bands});
  const Imf::Channel* alpha = header.channels().findChannel("A");
  if (request.alpha && alpha != nullptr && is_full(*alpha))
    targets.push_back({{"A"}, 1, picture.alpha});
  if (!request.channels.empty())
    targets.push_back({request.channels, request.channels.size(), picture.layers});
  if (targets.empty()) return picture;
  read_rows(file, picture.part, targets);
  if (colors.size() == 1)
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
      picture.rgb[i + 1] = picture.rgb[i + 2] = picture.rgb[i];
  if (space && !is_rec709(*space)) take_to_rec709(picture.rgb, *space);
  return picture;
}

ExrImage read_exr_image(const std::filesystem::path& path) {
  PictureValues picture = read_exr_picture(path, {});
  if (!picture.header.has_color)
    throw std::runtime_error("it has neither full channels R, G and B nor a full channel Y");
  return {picture.part.width(), picture.part.height(), std::move(picture.rgb),
          std::move(picture.header.unknown_tag)};
}

} // namespace abbe
