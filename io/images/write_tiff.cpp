#include "io/images/write_tiff.h"

#include "io/files/atomic_file.h"
#include "io/images/icc_profile.h"
#include "io/images/tiff_file.h"
#include "io/images/write_pixels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace abbe {
namespace {

/// A row of values in the form in which it goes to the file.
using Encode = void (*)(std::span<const float> values, std::byte* row);

/// How an image goes to the file.
struct Samples {
  std::uint16_t bits;
  std::uint16_t sample_format;
  std::uint16_t predictor;
  std::vector<std::byte> icc_profile;
  const std::vector<float>& values; ///< interleaved R, G, B, row by row
  Encode encode;

  [[nodiscard]] std::size_t row_bytes(int width) const {
    return static_cast<std::size_t>(width) * 3 * bits / 8;
  }
};

/// Little-endian on every machine; 64-bit offsets (BigTIFF) only where 32 bits may not do.
const char* mode_for(std::size_t byte_count) {
  constexpr std::size_t classic_limit = 0xF0000000;
  return byte_count < classic_limit ? "wl" : "wl8";
}

template <class... Values>
void set(TIFF* tiff, std::uint32_t tag, Values... values) {
  if (TIFFSetField(tiff, tag, values...) != 1) throw std::runtime_error("libtiff refused a tag");
}

void set_layout(TIFF* tiff, const PixelWindow& data, const Samples& samples) {
  constexpr std::size_t strip_bytes = 1 << 18; // large enough for deflate, small for readers
  const std::size_t rows = std::max<std::size_t>(1, strip_bytes / samples.row_bytes(data.width()));
  set(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(data.width()));
  set(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(data.height()));
  set(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
  set(tiff, TIFFTAG_BITSPERSAMPLE, samples.bits);
  set(tiff, TIFFTAG_SAMPLEFORMAT, samples.sample_format);
  set(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
  set(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  set(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  set(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  set(tiff, TIFFTAG_PREDICTOR, samples.predictor);
  set(tiff, TIFFTAG_ROWSPERSTRIP,
      static_cast<std::uint32_t>(
          std::min<std::size_t>(rows, static_cast<std::size_t>(data.height()))));
  set(tiff, TIFFTAG_XRESOLUTION, 1.0);
  set(tiff, TIFFTAG_YRESOLUTION, 1.0);
  set(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
}

void set_crop(TIFF* tiff, const PixelWindow& display, const PixelWindow& data) {
  set(tiff, TIFFTAG_PIXAR_IMAGEFULLWIDTH, static_cast<std::uint32_t>(display.width()));
  set(tiff, TIFFTAG_PIXAR_IMAGEFULLLENGTH, static_cast<std::uint32_t>(display.height()));
  // Unsigned in TIFF: a window that begins left of or above the display window has no position.
  if (data.x0 < display.x0 || data.y0 < display.y0) return;
  set(tiff, TIFFTAG_XPOSITION, static_cast<double>(data.x0 - display.x0));
  set(tiff, TIFFTAG_YPOSITION, static_cast<double>(data.y0 - display.y0));
}

void set_texts(TIFF* tiff, const Samples& samples, const Metadata& metadata) {
  std::string description;
  for (const auto& [name, value] : metadata)
    description.append(name).append(": ").append(value) += '\n';
  set(tiff, TIFFTAG_SOFTWARE, "abbe");
  if (!description.empty()) set(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
  if (samples.icc_profile.empty()) return;
  set(tiff, TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(samples.icc_profile.size()),
      samples.icc_profile.data());
}

void save(const std::filesystem::path& path, const DisplayImage& image, const Samples& samples) {
  const std::size_t row_bytes = samples.row_bytes(image.data.width());
  const auto height = static_cast<std::uint32_t>(image.data.height());
  FirstTiffError error;
  TiffFile tiff = open_tiff(path, mode_for(row_bytes * height), error);
  set_layout(tiff.get(), image.data, samples);
  if (image.data != image.display) set_crop(tiff.get(), image.display, image.data);
  set_texts(tiff.get(), samples, image.metadata);
  const std::size_t row_values = 3 * static_cast<std::size_t>(image.data.width());
  std::vector<std::byte> row(row_bytes); // libtiff's predictor works in place
  for (std::uint32_t y = 0; y < height; ++y) {
    samples.encode({samples.values.data() + y * row_values, row_values}, row.data());
    if (TIFFWriteScanline(tiff.get(), row.data(), y) != 1) throw_first(error);
  }
  if (TIFFWriteDirectory(tiff.get()) != 1) throw_first(error);
  tiff.reset();
  if (error.text[0] != '\0') throw_first(error);
}

template <class Code>
void save_integers(const std::filesystem::path& path, const DisplayImage& image,
                   IccVersion profile) {
  require_pixels(image.display, image.data, image.encoded.size(), 3);
  save(path, image,
       {8 * sizeof(Code), SAMPLEFORMAT_UINT, PREDICTOR_HORIZONTAL,
        icc_profile(image.encoding, profile), image.encoded,
        [](std::span<const float> values, std::byte* row) {
          code_values(values, reinterpret_cast<Code*>(row));
        }});
}

void save_floats(const std::filesystem::path& path, const DisplayImage& image, IccVersion profile) {
  require_pixels(image.display, image.data, image.linear.size(), 3);
  // No floating-point predictor: some readers reject it.
  save(path, image,
       {32, SAMPLEFORMAT_IEEEFP, PREDICTOR_NONE,
        icc_profile({image.encoding.space, linear_transfer()}, profile), image.linear,
        [](std::span<const float> values, std::byte* row) {
          std::memcpy(row, values.data(), values.size_bytes());
        }});
}

} // namespace

void write_tiff(const std::filesystem::path& path, const DisplayImage& image, TiffDepth depth,
                IccVersion profile) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    switch (depth) {
    case TiffDepth::bits8:
      return save_integers<std::uint8_t>(temporary, image, profile);
    case TiffDepth::bits16:
      return save_integers<std::uint16_t>(temporary, image, profile);
    case TiffDepth::float32:
      return save_floats(temporary, image, profile);
    }
  });
}

} // namespace abbe
