#include "io/files/regular_file.h"
#include "io/images/read_image.h"
#include "spectral/transfer.h"

#include <png.h>

#include <array>
#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace abbe {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};

/// libpng's message, copied before it jumps back.
struct PngError {
  std::array<char, 256> text{};
};

extern "C" {
static void jump_back_from_reading(png_structp png, png_const_charp message) {
  auto& text = static_cast<PngError*>(png_get_error_ptr(png))->text;
  std::snprintf(text.data(), text.size(), "%s", message);
  png_longjmp(png, 1);
}
static void ignore_reading_warning(png_structp, png_const_charp) {}
}

/// libpng's two handles.
class PngHandles {
public:
  explicit PngHandles(PngError& error)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &error, jump_back_from_reading,
                                   ignore_reading_warning)),
        info(png != nullptr ? png_create_info_struct(png) : nullptr) {
    if (info == nullptr) {
      png_destroy_read_struct(&png, nullptr, nullptr);
      throw std::runtime_error(error.text[0] != '\0' ? error.text.data() : "libpng failed");
    }
  }
  PngHandles(const PngHandles&) = delete;
  PngHandles& operator=(const PngHandles&) = delete;
  ~PngHandles() { png_destroy_read_struct(&png, &info, nullptr); }

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

} // namespace

ReflectanceImage read_png(const std::filesystem::path& path) {
  require_regular_file(path);
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw std::system_error(errno, std::generic_category());
  PngError error;
  const PngHandles handles(error);
  if (!read_header(handles.png, handles.info, file.get()))
    throw std::runtime_error(error.text.data());
  const std::size_t width = png_get_image_width(handles.png, handles.info);
  const std::size_t height = png_get_image_height(handles.png, handles.info);
  require_image_memory(width, height, 3 * (sizeof(std::uint16_t) + sizeof(float)));
  // Zeros that take memory when they are written to: a small file may declare a large image.
  const std::unique_ptr<std::uint16_t, FreeMemory> memory(
      static_cast<std::uint16_t*>(std::calloc(3 * width * height, sizeof(std::uint16_t))));
  if (!memory) throw std::bad_alloc();
  const std::span<const std::uint16_t> codes(memory.get(), 3 * width * height);
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < height; ++y)
    rows.push_back(reinterpret_cast<png_bytep>(memory.get() + 3 * width * y));
  if (!read_rows(handles.png, rows.data())) throw std::runtime_error(error.text.data());

  const std::vector<float> linear = decoding_table();
  ReflectanceImage image{static_cast<int>(width), static_cast<int>(height), {}};
  image.rgb.reserve(codes.size());
  for (const std::uint16_t code : codes)
    image.rgb.push_back(linear[code]);
  return image;
}

} // namespace abbe
