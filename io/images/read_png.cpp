#include "io/files/regular_file.h"
#include "io/images/icc_profile.h"
#include "io/images/read_image.h"
#include "spectral/transfer.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace abbe {
namespace {

struct CloseInput {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};

/// libpng's message, copied before it jumps back.
struct PngReadError {
  std::array<char, 256> text{};
};

extern "C" {
static void jump_back_from_reading(png_structp png, png_const_charp message) {
  auto& text = static_cast<PngReadError*>(png_get_error_ptr(png))->text;
  std::snprintf(text.data(), text.size(), "%s", message);
  png_longjmp(png, 1);
}
static void ignore_reading_warning(png_structp, png_const_charp) {}
}

/// libpng's two handles.
class PngReadHandles {
public:
  explicit PngReadHandles(PngReadError& error)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &error, jump_back_from_reading,
                                   ignore_reading_warning)),
        info(png != nullptr ? png_create_info_struct(png) : nullptr) {
    if (info == nullptr) {
      png_destroy_read_struct(&png, nullptr, nullptr);
      throw std::runtime_error(error.text[0] != '\0' ? error.text.data() : "libpng failed");
    }
  }
  PngReadHandles(const PngReadHandles&) = delete;
  PngReadHandles& operator=(const PngReadHandles&) = delete;
  ~PngReadHandles() { png_destroy_read_struct(&png, &info, nullptr); }

  png_structp png;
  png_infop info;
};

// Both return false when libpng reports an error. It does so by `longjmp` back into the function,
// so nothing in there may have a destructor.

/// Makes whatever the file holds three components of 16 bits.
bool read_header(png_structp png, png_infop info, std::FILE* file) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_init_io(png, file);
  png_read_info(png, info);
  png_set_expand_16(png);
  png_set_gray_to_rgb(png);
  png_set_strip_alpha(png);
  if (std::endian::native == std::endian::little) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

/// The linear value of each code.
std::vector<float> decoding_table() {
  std::vector<float> table(65536);
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<float>(decode(srgb_transfer(), static_cast<double>(i) / 65535.0));
  return table;
}

/// The codes of a file that is open: three components of 16 bits.
struct Codes {
  std::size_t width = 0, height = 0;
  std::unique_ptr<std::uint16_t, FreeMemory> memory;

  [[nodiscard]] std::span<const std::uint16_t> values() const {
    return {memory.get(), 3 * width * height};
  }
};

Codes read_codes(const PngReadHandles& handles, const PngReadError& error) {
  Codes codes{png_get_image_width(handles.png, handles.info),
              png_get_image_height(handles.png, handles.info),
              {}};
  require_image_memory(codes.width, codes.height, 3 * (sizeof(std::uint16_t) + sizeof(float)));
  // Zeros that take memory when they are written to: a small file may declare a large image.
  codes.memory.reset(static_cast<std::uint16_t*>(
      std::calloc(3 * codes.width * codes.height, sizeof(std::uint16_t))));
  if (!codes.memory) throw std::bad_alloc();
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < codes.height; ++y)
    rows.push_back(reinterpret_cast<png_bytep>(codes.memory.get() + 3 * codes.width * y));
  if (!read_rows(handles.png, rows.data())) throw std::runtime_error(error.text.data());
  return codes;
}

/// A file that is open, and libpng's handles on it, which have read what stands before the pixels.
struct OpenPng {
  std::unique_ptr<std::FILE, CloseInput> file;
  PngReadError error;
  PngReadHandles handles{error};

  explicit OpenPng(const std::filesystem::path& path) {
    require_regular_file(path);
    file.reset(std::fopen(path.c_str(), "rb"));
    if (!file) throw std::system_error(errno, std::generic_category());
    if (!read_header(handles.png, handles.info, file.get()))
      throw std::runtime_error(error.text.data());
  }
};

/// The file's size and where its pixels lie in the whole frame.
PixelWindow window_of(png_structp png, png_infop info) {
  png_int_32 x = 0, y = 0;
  int unit = PNG_OFFSET_PIXEL;
  if (png_get_oFFs(png, info, &x, &y, &unit) == 0 || unit != PNG_OFFSET_PIXEL) x = y = 0;
  constexpr int kMostPixels = 1 << 30;
  if (x < -kMostPixels || x > kMostPixels || y < -kMostPixels || y > kMostPixels) x = y = 0;
  return {x, y, x + static_cast<int>(png_get_image_width(png, info)),
          y + static_cast<int>(png_get_image_height(png, info))};
}

/// Puts a crop where a text `abbe/crop` tells, such as "2,1,6,5 of 8x6". Others are passed over.
void place_crop(std::string_view text, PictureHeader& header) {
  std::array<int, 6> numbers{};
  for (int& number : numbers) {
    text.remove_prefix(std::min(text.find_first_of("0123456789"), text.size()));
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  const auto [x0, y0, x1, y1, width, height] = numbers;
  const bool fits = x1 <= width && y1 <= height && x1 - x0 == header.data.width() &&
                    y1 - y0 == header.data.height();
  if (!fits) return;
  header.display = {0, 0, width, height};
  header.data = {x0, y0, x1, y1};
}

PictureHeader header_of(png_structp png, png_infop info) {
  PictureHeader header;
  header.format = "PNG";
  header.data = window_of(png, info);
  header.display = {std::min(0, header.data.x0), std::min(0, header.data.y0), header.data.x1,
                    header.data.y1};
  header.has_color = true;
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(png, info, &texts, &count);
  for (const png_text& text : std::span(texts, static_cast<std::size_t>(count)))
    header.metadata.emplace_back(text.key, text.text);
  for (const auto& [key, value] : header.metadata)
    if (key == "abbe/crop") place_crop(value, header);
  return header;
}

/// The colour profile; empty where there is none.
std::vector<std::byte> profile_of(png_structp png, png_infop info) {
  png_charp name = nullptr;
  int compression = 0;
  png_bytep profile = nullptr;
  png_uint_32 size = 0;
  if (png_get_iCCP(png, info, &name, &compression, &profile, &size) == 0) return {};
  const auto bytes = std::as_bytes(std::span(profile, size));
  return {bytes.begin(), bytes.end()};
}

} // namespace

ReflectanceImage read_png(const std::filesystem::path& path) {
  const OpenPng open(path);
  const Codes codes = read_codes(open.handles, open.error);
  const std::vector<float> linear = decoding_table();
  ReflectanceImage image{static_cast<int>(codes.width), static_cast<int>(codes.height), {}};
  image.rgb.reserve(codes.values().size());
  for (const std::uint16_t code : codes.values())
    image.rgb.push_back(linear[code]);
  return image;
}

PictureValues read_png_picture(const std::filesystem::path& path, const PictureRequest& request) {
  const OpenPng open(path);
  const PngReadHandles& handles = open.handles;
  PictureValues picture{header_of(handles.png, handles.info), {}, {}, {}, {}};
  // What the file has, not what libpng makes of it.
  std::array<unsigned char, 2> kind{};
  std::FILE* const file = open.file.get();
  const long place = std::ftell(file);
  constexpr long kKind = 24; // signature, length and name of the first chunk, width, height
  if (std::fseek(file, kKind, SEEK_SET) == 0 &&
      std::fread(kind.data(), 1, kind.size(), file) == kind.size()) {
    const bool grey = (kind[1] & PNG_COLOR_MASK_COLOR) == 0;
    const std::string type = std::to_string(kind[0]) + " bits";
    for (const char* name : {"R", "G", "B"})
      if (!grey) picture.header.channels.push_back({name, type});
    if (grey) picture.header.channels.push_back({"Y", type});
    if ((kind[1] & PNG_COLOR_MASK_ALPHA) != 0) picture.header.channels.push_back({"A", type});
  }
  if (std::fseek(file, place, SEEK_SET) != 0)
    throw std::system_error(errno, std::generic_category());
  if (request.header_only) return picture;
  picture.part = rows_of(picture.header.data, request);
  if (picture.part.height() <= 0) return picture;
  const Codes codes = read_codes(handles, open.error);
  const std::size_t row = 3 * codes.width;
  const auto values = codes.values().subspan(
      row * static_cast<std::size_t>(picture.part.y0 - picture.header.data.y0),
      row * static_cast<std::size_t>(picture.part.height()));
  picture.rgb.reserve(values.size());
  const std::vector<std::byte> profile = profile_of(handles.png, handles.info);
  if (profile.empty()) {
    const std::vector<float> linear = decoding_table();
    for (const std::uint16_t code : values)
      picture.rgb.push_back(linear[code]);
    return picture;
  }
  for (const std::uint16_t code : values)
    picture.rgb.push_back(static_cast<float>(code) / 65535.0F);
  take_to_linear_srgb(picture.rgb, profile);
  return picture;
}

} // namespace abbe
