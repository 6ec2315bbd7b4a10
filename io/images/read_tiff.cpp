#include "io/images/read_tiff.h"

#include "io/files/regular_file.h"
#include "io/images/icc_profile.h"
#include "io/images/read_image.h"
#include "io/images/tiff_file.h"
#include "spectral/transfer.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>

namespace abbe {
namespace {

/// How the pixels lie in the file.
struct Layout {
  std::uint32_t width = 0, height = 0;
  std::uint16_t samples = 1, bits = 1, format = SAMPLEFORMAT_UINT;
  std::uint16_t planes = PLANARCONFIG_CONTIG, photometric = 0, orientation = ORIENTATION_TOPLEFT;

  [[nodiscard]] bool is_float() const { return format == SAMPLEFORMAT_IEEEFP; }
  [[nodiscard]] bool is_grey() const { return photometric == PHOTOMETRIC_MINISBLACK; }
};

/// Throws for what is not read.
Layout layout_of(TIFF* tiff) {
  Layout layout;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &layout.width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &layout.height);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &layout.samples);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &layout.bits);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &layout.format);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &layout.planes);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &layout.orientation);
  TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &layout.photometric);
  constexpr std::uint32_t kMostPixels = 1U << 24U;
  if (layout.width == 0 || layout.height == 0 || layout.width > kMostPixels ||
      layout.height > kMostPixels)
    throw std::runtime_error("it has no pixels, or too many");
  if (TIFFIsTiled(tiff) != 0) throw std::runtime_error("it is stored in tiles, not in strips");
  if (layout.orientation != ORIENTATION_TOPLEFT)
    throw std::runtime_error("its first pixel is not that of the upper left corner");
  if (!layout.is_grey() && layout.photometric != PHOTOMETRIC_RGB)
    throw std::runtime_error("its colours are neither grey nor RGB");
  if (layout.samples < (layout.is_grey() ? 1 : 3))
    throw std::runtime_error("it has less than three colours");
  const bool whole = layout.format == SAMPLEFORMAT_UINT;
  if (!(whole && (layout.bits == 8 || layout.bits == 16)) &&
      !(layout.is_float() && layout.bits == 32))
    throw std::runtime_error(
        fmt::format("its channels are neither of 8 or 16 bits nor of 32 bits in floating point"));
  return layout;
}

PictureHeader header_of(TIFF* tiff, const Layout& layout) {
  PictureHeader header;
  header.format = "TIFF";
  header.data =
      header.display = {0, 0, static_cast<int>(layout.width), static_cast<int>(layout.height)};
  header.has_color = true;
  const std::string type = layout.is_float() ? "float" : fmt::format("{} bits", layout.bits);
  const int colors = layout.is_grey() ? 1 : 3;
  for (int i = 0; i < layout.samples; ++i)
    header.channels.push_back({i >= colors        ? "A"
                               : layout.is_grey() ? "Y"
                                                  : std::string(1, "RGB"[i]),
                               type});
  const auto add_text = [&](std::uint32_t tag, const char* name) {
    const char* text = nullptr;
    if (TIFFGetField(tiff, tag, &text) == 1 && text != nullptr)
      header.metadata.emplace_back(name, text);
  };
  add_text(TIFFTAG_IMAGEDESCRIPTION, "ImageDescription");
  add_text(TIFFTAG_SOFTWARE, "Software");
  return header;
}

/// A value of a row as a fraction of full scale, or as it is in floating point.
float value_at(const std::vector<std::byte>& row, std::size_t index, const Layout& layout) {
  if (layout.bits == 8) return static_cast<float>(std::to_integer<unsigned>(row[index])) / 255.0F;
  if (layout.bits == 16) {
    std::uint16_t code = 0; // libtiff gives the machine's order of bytes
    std::memcpy(&code, row.data() + index * sizeof code, sizeof code);
    return static_cast<float>(code) / 65535.0F;
  }
  float value = 0.0F;
  std::memcpy(&value, row.data() + index * sizeof value, sizeof value);
  return value;
}

/// Three values for each pixel of some rows.
std::vector<float> read_values(TIFF* tiff, const Layout& layout, const PixelWindow& rows,
                               const FirstTiffError& error) {
  require_image_memory(layout.width, static_cast<std::uint64_t>(rows.height()), 3 * sizeof(float));
  std::vector<std::byte> row(static_cast<std::size_t>(TIFFScanlineSize(tiff)));
  const bool apart = layout.planes == PLANARCONFIG_SEPARATE;
  const std::size_t step = apart ? 1 : layout.samples, width = layout.width;
  if (row.size() < width * step * layout.bits / 8) throw std::runtime_error("its rows are cut off");
  std::vector<float> values(3 * rows.pixel_count());
  // With planes apart, libtiff reads all rows of one plane before those of the next.
  const std::uint16_t planes = apart && !layout.is_grey() ? 3 : 1;
  for (std::uint16_t plane = 0; plane < planes; ++plane)
    for (int y = 0; y < rows.y1; ++y) {
      if (TIFFReadScanline(tiff, row.data(), static_cast<std::uint32_t>(y), plane) != 1)
        throw_first(error);
      if (y < rows.y0) continue;
      float* to = values.data() + 3 * width * static_cast<std::size_t>(y - rows.y0);
      for (std::size_t x = 0; x < width; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          if (planes == 3 && c != plane) continue;
          const std::size_t sample = apart || layout.is_grey() ? 0 : c;
          to[3 * x + c] = value_at(row, x * step + sample, layout);
        }
    }
  return values;
}

} // namespace

PictureValues read_tiff_picture(const std::filesystem::path& path, const PictureRequest& request) {
  require_regular_file(path);
  FirstTiffError error;
  const TiffFile tiff = open_tiff(path, "r", error);
  const Layout layout = layout_of(tiff.get());
  PictureValues picture{header_of(tiff.get(), layout), {}, {}, {}, {}};
  if (request.header_only) return picture;
  picture.part = rows_of(picture.header.data, request);
  if (picture.part.height() <= 0) return picture;
  picture.rgb = read_values(tiff.get(), layout, picture.part, error);
  std::uint32_t size = 0;
  const void* profile = nullptr;
  if (TIFFGetField(tiff.get(), TIFFTAG_ICCPROFILE, &size, &profile) == 1 && !layout.is_grey()) {
    take_to_linear_srgb(picture.rgb, {static_cast<const std::byte*>(profile), size});
  } else if (!layout.is_float()) {
    for (float& value : picture.rgb)
      value = static_cast<float>(decode(srgb_transfer(), static_cast<double>(value)));
  }
  return picture;
}

} // namespace abbe
