#include "io/images/write_png.h"

#include "io/files/atomic_file.h"
#include "io/images/icc_profile.h"
#include "io/images/write_pixels.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>

namespace abbe {
namespace {

struct CloseOutput {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseOutput>;

/// libpng's message, copied before it jumps back.
struct PngWriteError {
  std::array<char, 256> text{};
};

extern "C" {
static void jump_back(png_structp png, png_const_charp message) {
  auto& text = static_cast<PngWriteError*>(png_get_error_ptr(png))->text;
  std::snprintf(text.data(), text.size(), "%s", message);
  png_longjmp(png, 1);
}
static void ignore_warning(png_structp, png_const_charp) {}
}

/// libpng's two handles.
class PngWriteHandles {
public:
  explicit PngWriteHandles(PngWriteError& error)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, jump_back, ignore_warning)),
        info(png != nullptr ? png_create_info_struct(png) : nullptr) {
    if (info == nullptr) {
      png_destroy_write_struct(&png, nullptr);
      throw std::runtime_error(error.text[0] != '\0' ? error.text.data() : "libpng failed");
    }
  }
  PngWriteHandles(const PngWriteHandles&) = delete;
  PngWriteHandles& operator=(const PngWriteHandles&) = delete;
  ~PngWriteHandles() { png_destroy_write_struct(&png, &info); }

  png_structp png;
  png_infop info;
};

/// All that libpng needs, made ready beforehand.
struct PngContent {
  PixelWindow data;
  int bits;
  const float* values; ///< interleaved R, G, B, row by row
  void (*encode)(std::span<const float> values, png_bytep row);
  png_bytep row; ///< room for one
  std::vector<png_text> texts;
  std::string profile_name;
  bool srgb;
  std::vector<std::byte> profile; ///< empty: none
};

bool is_ascii(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; });
}

/// The entries point into `metadata`. tEXt is Latin-1, iTXt UTF-8.
std::vector<png_text> text_entries(const Metadata& metadata) {
  std::vector<png_text> texts;
  for (const auto& [name, value] : metadata) {
    png_text text{};
    text.compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(name.c_str()); // libpng only reads it
    text.text = const_cast<char*>(value.c_str());
    text.text_length = value.size();
    texts.push_back(text);
  }
  return texts;
}

/// False when libpng reports an error. It does so by `longjmp` back into this function, so nothing
/// in here may have a destructor.
bool encode(png_structp png, png_infop info, std::FILE* file, const PngContent& content) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const auto width = static_cast<png_uint_32>(content.data.width());
  const auto height = static_cast<png_uint_32>(content.data.height());
  png_init_io(png, file);
  png_set_IHDR(png, info, width, height, content.bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (content.srgb) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_RELATIVE);
  if (!content.profile.empty())
    png_set_iCCP(png, info, content.profile_name.c_str(), PNG_COMPRESSION_TYPE_BASE,
                 reinterpret_cast<png_const_bytep>(content.profile.data()),
                 static_cast<png_uint_32>(content.profile.size()));
  png_set_text(png, info, content.texts.data(), static_cast<int>(content.texts.size()));
  png_write_info(png, info);
  if (content.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  const std::size_t row_values = std::size_t{width} * 3;
  for (std::size_t y = 0; y < height; ++y) {
    content.encode({content.values + y * row_values, row_values}, content.row);
    png_write_row(png, content.row);
  }
  png_write_end(png, nullptr);
  return true;
}

/// What the picture says of itself, and where a crop lies.
Metadata texts_of(const DisplayImage& image) {
  Metadata texts = image.metadata;
  const PixelWindow &full = image.display, &part = image.data;
  if (part != full)
    texts.emplace_back("abbe/crop", fmt::format("{},{},{},{} of {}x{}", part.x0 - full.x0,
                                                part.y0 - full.y0, part.x1 - full.x0,
                                                part.y1 - full.y0, full.width(), full.height()));
  return texts;
}

template <class Code>
void save(const std::filesystem::path& path, const DisplayImage& image, IccVersion profile) {
  std::vector<Code> row(3 * static_cast<std::size_t>(image.data.width()));
  const bool srgb = image.encoding == DisplayEncoding{};
  const Metadata texts = texts_of(image);
  const PngContent content{image.data,
                           8 * sizeof(Code),
                           image.encoded.data(),
                           [](std::span<const float> values, png_bytep codes) {
                             code_values(values, reinterpret_cast<Code*>(codes));
                           },
                           reinterpret_cast<png_bytep>(row.data()),
                           text_entries(texts),
                           profile_name(image.encoding),
                           srgb,
                           srgb ? std::vector<std::byte>{} : icc_profile(image.encoding, profile)};
  File file(std::fopen(path.c_str(), "wb"));
  if (!file) throw std::system_error(errno, std::generic_category());
  PngWriteError error;
  const PngWriteHandles handles(error);
  if (!encode(handles.png, handles.info, file.get(), content))
    throw std::runtime_error(error.text.data());
  if (std::fclose(file.release()) != 0) throw std::system_error(errno, std::generic_category());
}

} // namespace

void write_png(const std::filesystem::path& path, const DisplayImage& image, int bits,
               IccVersion profile) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    require_pixels(image.display, image.data, image.encoded.size(), 3);
    if (bits == 8) return save<std::uint8_t>(temporary, image, profile);
    if (bits == 16) return save<std::uint16_t>(temporary, image, profile);
    throw std::runtime_error(fmt::format("PNG takes 8 or 16 bits here, not {}", bits));
  });
}

} // namespace abbe
