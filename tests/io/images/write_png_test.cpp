#include "io/images/write_png.h"

#include "io/images/icc_profile.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <png.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

using namespace abbe;
namespace fs = std::filesystem;
using test::content;
using test::Folder;

namespace {

/// A whole image, by libpng itself. An error of libpng ends the test program (its default).
struct Png {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  explicit Png(const fs::path& path) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    REQUIRE(file != nullptr);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    std::fclose(file);
  }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;
  ~Png() { png_destroy_read_struct(&png, &info, nullptr); }

  [[nodiscard]] std::vector<int> codes() const {
    std::vector<int> codes;
    png_bytepp rows = png_get_rows(png, info);
    const std::size_t samples = std::size_t{png_get_image_width(png, info)} * 3;
    for (png_uint_32 y = 0; y < png_get_image_height(png, info); ++y)
      for (std::size_t i = 0; i < samples; ++i)
        codes.push_back(png_get_bit_depth(png, info) == 16
                            ? 256 * rows[y][2 * i] + rows[y][2 * i + 1] // big-endian
                            : rows[y][i]);
    return codes;
  }
};

DisplayImage ramp(const PixelWindow& display, const PixelWindow& data, int max) {
  DisplayImage image{display, data, {}, {}, {{"abbe/seed", "7"}, {"abbe/lamp", "\u03bb 589 nm"}}};
  for (std::size_t i = 0; i < data.pixel_count() * 3; ++i)
    image.encoded.push_back(static_cast<float>(i * 7 % static_cast<std::size_t>(max + 1)) /
                            static_cast<float>(max));
  return image;
}

const PixelWindow full_frame{0, 0, 60, 20}, crop{7, 5, 47, 15};

} // namespace

TEST_CASE("PNG has the sRGB chunks and the metadata, and no time") {
  const Folder folder;
  const fs::path path = folder.path / "picture.png";
  for (const int bits : {8, 16}) {
    write_png(path, ramp(full_frame, full_frame, 255), bits);
    const Png file(path);
    CHECK(png_get_image_width(file.png, file.info) == 60);
    CHECK(png_get_image_height(file.png, file.info) == 20);
    CHECK(png_get_bit_depth(file.png, file.info) == bits);
    CHECK(png_get_color_type(file.png, file.info) == PNG_COLOR_TYPE_RGB);
    int intent = -1;
    CHECK(png_get_sRGB(file.png, file.info, &intent) != 0);
    CHECK(intent == PNG_sRGB_INTENT_RELATIVE);
    CHECK(png_get_valid(file.png, file.info, PNG_INFO_tIME) == 0);
    CHECK(png_get_valid(file.png, file.info, PNG_INFO_oFFs) == 0);
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(file.png, file.info, &texts, &count);
    REQUIRE(count == 2);
    CHECK(std::string(texts[0].key) == "abbe/seed");
    CHECK(std::string(texts[0].text) == "7");
    CHECK(texts[0].compression == PNG_TEXT_COMPRESSION_NONE); // tEXt
    CHECK(std::string(texts[1].key) == "abbe/lamp");
    CHECK(std::string(texts[1].text) == "\u03bb 589 nm");
    CHECK(texts[1].compression == PNG_ITXT_COMPRESSION_NONE); // iTXt
  }
}

TEST_CASE("a crop's place is told by a text, and by no chunk that hides it") {
  const Folder folder;
  const fs::path path = folder.path / "picture.png";
  write_png(path, ramp(full_frame, crop, 255), 8);
  const Png file(path);
  CHECK(png_get_image_width(file.png, file.info) == 40);
  CHECK(png_get_valid(file.png, file.info, PNG_INFO_oFFs) == 0);
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(file.png, file.info, &texts, &count);
  REQUIRE(count == 3);
  CHECK(std::string(texts[2].key) == "abbe/crop");
  CHECK(std::string(texts[2].text) == "7,5,47,15 of 60x20");
}

TEST_CASE("PNG has the encoded values rounded to nearest") {
  const Folder folder;
  const fs::path path = folder.path / "picture.png";
  SECTION("every code comes back") {
    for (const int bits : {8, 16}) {
      const int max = bits == 8 ? 255 : 65535;
      write_png(path, ramp(full_frame, crop, max), bits);
      std::vector<int> expected;
      for (int i = 0; i < 40 * 10 * 3; ++i)
        expected.push_back(i * 7 % (max + 1));
      CHECK(Png(path).codes() == expected);
    }
  }
  SECTION("between codes, out of range, not finite") {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const PixelWindow window{0, 0, 3, 1};
    const DisplayImage image{
        window,
        window,
        {99.49f / 255, 99.51f / 255, 254.6f / 255, -0.5f, 1.5f, -0.0f, nan, infinity, -infinity},
        {},
        {}};
    write_png(path, image);
    CHECK(Png(path).codes() == std::vector<int>{99, 100, 255, 0, 255, 0, 0, 255, 0});
  }
}

TEST_CASE("two PNG writes give the same bytes") {
  const Folder folder;
  const fs::path a = folder.path / "a.png", b = folder.path / "other name.png";
  for (const int bits : {8, 16}) {
    write_png(a, ramp(full_frame, crop, 255), bits);
    write_png(b, ramp(full_frame, crop, 255), bits);
    CHECK(content(a) == content(b));
  }
}

TEST_CASE("a PNG without pixels or of unknown depth is an error and no file") {
  const Folder folder;
  const fs::path path = folder.path / "picture.png";
  CHECK_THROWS_WITH(write_png(path, {}),
                    "cannot write " + path.string() + ": the image has no pixels");
  CHECK_THROWS_WITH(write_png(path, ramp(full_frame, crop, 255), 12),
                    "cannot write " + path.string() + ": PNG takes 8 or 16 bits here, not 12");
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a PNG for another display than sRGB has its profile, the same every time") {
  const Folder folder;
  DisplayImage image = ramp(full_frame, full_frame, 255);
  image.encoding.space = find_color_space("display-p3").value();
  write_png(folder.path / "p3.png", image);
  const Png file(folder.path / "p3.png");
  int intent = -1;
  CHECK(png_get_sRGB(file.png, file.info, &intent) == 0);
  png_charp name = nullptr;
  int compression = -1;
  png_bytep profile = nullptr;
  png_uint_32 size = 0;
  REQUIRE(png_get_iCCP(file.png, file.info, &name, &compression, &profile, &size) != 0);
  CHECK(std::string(name) == "Display P3");
  const std::vector<std::byte> expected = icc_profile(image.encoding);
  REQUIRE(size == expected.size());
  CHECK(std::memcmp(profile, expected.data(), size) == 0);
  write_png(folder.path / "again.png", image);
  CHECK(content(folder.path / "p3.png") == content(folder.path / "again.png"));
}

TEST_CASE("every display's profile is one that libpng takes") {
  const Folder folder;
  DisplayImage image = ramp(full_frame, full_frame, 255);
  for (const ColorSpace& space : color_spaces())
    for (const TransferFunction& transfer : {space.transfer, power_transfer(2.2)}) {
      INFO(space.name);
      image.encoding = {space, transfer};
      if (image.encoding == DisplayEncoding{}) continue;
      write_png(folder.path / "any.png", image);
      const Png file(folder.path / "any.png");
      CHECK(png_get_valid(file.png, file.info, PNG_INFO_iCCP) != 0);
    }
}
