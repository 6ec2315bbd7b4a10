#include "io/images/write_tiff.h"

#include "io/images/icc_profile.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <tiffio.h>

#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

using namespace abbe;
namespace fs = std::filesystem;
using test::content;
using test::Folder;

namespace {

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

/// An open file with libtiff's typed look-up of tags.
struct Tiff {
  std::unique_ptr<TIFF, CloseTiff> tiff;
  explicit Tiff(const fs::path& path) : tiff(TIFFOpen(path.c_str(), "r")) {
    REQUIRE(tiff != nullptr);
  }
  [[nodiscard]] bool has(std::uint32_t tag) const {
    // Large enough for whatever a tag of one or two values stores.
    std::array<std::uint64_t, 4> first{}, second{};
    return TIFFGetField(tiff.get(), tag, first.data(), second.data()) == 1;
  }
  template <class Value>
  [[nodiscard]] Value get(std::uint32_t tag) const {
    Value value{};
    CHECK(TIFFGetFieldDefaulted(tiff.get(), tag, &value) == 1);
    return value;
  }
  template <class Code>
  [[nodiscard]] std::vector<Code> pixels() const {
    const auto width = get<std::uint32_t>(TIFFTAG_IMAGEWIDTH);
    const auto height = get<std::uint32_t>(TIFFTAG_IMAGELENGTH);
    std::vector<Code> codes(std::size_t{width} * height * 3);
    for (std::uint32_t y = 0; y < height; ++y)
      REQUIRE(TIFFReadScanline(tiff.get(), codes.data() + std::size_t{y} * width * 3, y) == 1);
    return codes;
  }
  [[nodiscard]] std::vector<std::byte> icc_profile() const {
    std::uint32_t size = 0;
    void* bytes = nullptr;
    REQUIRE(TIFFGetField(tiff.get(), TIFFTAG_ICCPROFILE, &size, &bytes) == 1);
    std::vector<std::byte> profile(size);
    std::memcpy(profile.data(), bytes, size);
    return profile;
  }
};

/// `encoded` runs through k / 255 and k / 65535 exactly; `linear` is something else altogether.
DisplayImage ramp(const PixelWindow& display, const PixelWindow& data, int max) {
  DisplayImage image{display, data, {}, {}, {{"abbe/scene", "prism"}, {"abbe/seed", "7"}}};
  for (std::size_t i = 0; i < data.pixel_count() * 3; ++i) {
    const int code = static_cast<int>(i * 7 % static_cast<std::size_t>(max + 1));
    image.encoded.push_back(static_cast<float>(code) / static_cast<float>(max));
    image.linear.push_back(static_cast<float>(i) / 3.0e5f);
  }
  return image;
}

DisplayImage one_row(std::vector<float> values) {
  const PixelWindow window{0, 0, static_cast<int>(values.size() / 3), 1};
  return {window, window, values, values, {}};
}

const PixelWindow full_frame{0, 0, 300, 70}, crop{20, 30, 220, 60};

} // namespace

TEST_CASE("TIFF has the tags of its depth, and no date, host or alpha") {
  const Folder folder;
  const fs::path path = folder.path / "picture.tif";
  for (const TiffDepth depth : {TiffDepth::bits8, TiffDepth::bits16, TiffDepth::float32}) {
    write_tiff(path, ramp(full_frame, full_frame, 255), depth);
    const Tiff tiff(path);
    const bool is_float = depth == TiffDepth::float32;
    const int bits = is_float ? 32 : depth == TiffDepth::bits16 ? 16 : 8;
    CHECK(tiff.get<std::uint32_t>(TIFFTAG_IMAGEWIDTH) == 300);
    CHECK(tiff.get<std::uint32_t>(TIFFTAG_IMAGELENGTH) == 70);
    CHECK(tiff.get<std::uint16_t>(TIFFTAG_BITSPERSAMPLE) == bits);
    CHECK(tiff.get<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL) == 3);
    CHECK(tiff.get<std::uint16_t>(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_RGB);
    CHECK(tiff.get<std::uint16_t>(TIFFTAG_SAMPLEFORMAT) ==
          (is_float ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT));
    CHECK(tiff.get<std::uint16_t>(TIFFTAG_COMPRESSION) == COMPRESSION_ADOBE_DEFLATE);
    CHECK(tiff.get<std::uint16_t>(TIFFTAG_PREDICTOR) ==
          (is_float ? PREDICTOR_NONE : PREDICTOR_HORIZONTAL));
    CHECK(tiff.get<const char*>(TIFFTAG_SOFTWARE) == std::string("abbe"));
    CHECK(tiff.get<const char*>(TIFFTAG_IMAGEDESCRIPTION) ==
          std::string("abbe/scene: prism\nabbe/seed: 7\n"));
    CHECK(tiff.icc_profile() ==
          (is_float ? icc_profile({srgb_space(), linear_transfer()}) : icc_profile({})));
    for (const std::uint32_t tag :
         {TIFFTAG_DATETIME, TIFFTAG_HOSTCOMPUTER, TIFFTAG_ARTIST, TIFFTAG_DOCUMENTNAME,
          TIFFTAG_XPOSITION, TIFFTAG_YPOSITION, TIFFTAG_PIXAR_IMAGEFULLWIDTH})
      CHECK_FALSE(tiff.has(tag));
    std::uint16_t extra = 0;
    const std::uint16_t* kinds = nullptr;
    TIFFGetFieldDefaulted(tiff.tiff.get(), TIFFTAG_EXTRASAMPLES, &extra, &kinds);
    CHECK(extra == 0);
    CHECK(TIFFLastDirectory(tiff.tiff.get()) == 1);
  }
}

TEST_CASE("TIFF integers are the encoded values rounded to nearest") {
  const Folder folder;
  const fs::path path = folder.path / "picture.tif";
  SECTION("8 bits: every code comes back") {
    write_tiff(path, ramp(full_frame, full_frame, 255), TiffDepth::bits8);
    const auto codes = Tiff(path).pixels<std::uint8_t>();
    bool all_equal = true;
    for (std::size_t i = 0; i < codes.size(); ++i)
      all_equal = all_equal && codes[i] == i * 7 % 256;
    CHECK(all_equal);
  }
  SECTION("16 bits: every code comes back") {
    write_tiff(path, ramp(full_frame, full_frame, 65535), TiffDepth::bits16);
    const auto codes = Tiff(path).pixels<std::uint16_t>();
    bool all_equal = true;
    for (std::size_t i = 0; i < codes.size(); ++i)
      all_equal = all_equal && codes[i] == i * 7 % 65536;
    CHECK(all_equal);
  }
  SECTION("between codes, out of range, not finite") {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const DisplayImage image = one_row({99.49f / 255, 99.51f / 255, 254.6f / 255, //
                                        -0.5f, 1.5f, -0.0f,                       //
                                        nan, infinity, -infinity});
    write_tiff(path, image, TiffDepth::bits8);
    CHECK(Tiff(path).pixels<std::uint8_t>() ==
          std::vector<std::uint8_t>{99, 100, 255, 0, 255, 0, 0, 255, 0});
  }
}

TEST_CASE("float TIFF has the linear values, bit for bit") {
  const Folder folder;
  const fs::path path = folder.path / "picture.tif";
  const DisplayImage image = ramp(full_frame, crop, 255);
  write_tiff(path, image, TiffDepth::float32);
  CHECK(Tiff(path).pixels<float>() == image.linear);
  const float infinity = std::numeric_limits<float>::infinity();
  write_tiff(path, one_row({0.5f, infinity, std::numeric_limits<float>::quiet_NaN()}),
             TiffDepth::float32);
  CHECK(Tiff(path).pixels<float>().at(1) == infinity);
}

TEST_CASE("a crop is its data window with a position in the full frame") {
  const Folder folder;
  const fs::path path = folder.path / "picture.tif";
  write_tiff(path, ramp(full_frame, crop, 255), TiffDepth::bits8);
  const Tiff tiff(path);
  CHECK(tiff.get<std::uint32_t>(TIFFTAG_IMAGEWIDTH) == 200);
  CHECK(tiff.get<std::uint32_t>(TIFFTAG_IMAGELENGTH) == 30);
  CHECK(tiff.get<float>(TIFFTAG_XPOSITION) == 20.0f);
  CHECK(tiff.get<float>(TIFFTAG_YPOSITION) == 30.0f);
  CHECK(tiff.get<float>(TIFFTAG_XRESOLUTION) == 1.0f);
  CHECK(tiff.get<std::uint16_t>(TIFFTAG_RESOLUTIONUNIT) == RESUNIT_NONE);
  CHECK(tiff.get<std::uint32_t>(TIFFTAG_PIXAR_IMAGEFULLWIDTH) == 300);
  CHECK(tiff.get<std::uint32_t>(TIFFTAG_PIXAR_IMAGEFULLLENGTH) == 70);
}

TEST_CASE("two TIFF writes give the same bytes") {
  const Folder folder;
  const fs::path a = folder.path / "a.tif", b = folder.path / "other name.tif";
  for (const TiffDepth depth : {TiffDepth::bits8, TiffDepth::bits16, TiffDepth::float32}) {
    write_tiff(a, ramp(full_frame, crop, 255), depth);
    write_tiff(b, ramp(full_frame, crop, 255), depth);
    CHECK(content(a) == content(b));
  }
}

TEST_CASE("a TIFF without pixels is an error and no file") {
  const Folder folder;
  const fs::path path = folder.path / "picture.tif";
  for (const TiffDepth depth : {TiffDepth::bits8, TiffDepth::bits16, TiffDepth::float32}) {
    CHECK_THROWS_WITH(write_tiff(path, {}, depth),
                      "cannot write " + path.string() + ": the image has no pixels");
    CHECK(fs::is_empty(folder.path));
  }
}

TEST_CASE("a TIFF for another display has its profile, linear in floats") {
  const Folder folder;
  const fs::path path = folder.path / "picture.tif";
  DisplayImage image = ramp(full_frame, full_frame, 255);
  image.encoding = {find_color_space("ntsc").value(), power_transfer(2.5)};
  write_tiff(path, image, TiffDepth::bits16);
  CHECK(Tiff(path).icc_profile() == icc_profile(image.encoding));
  write_tiff(path, image, TiffDepth::float32);
  CHECK(Tiff(path).icc_profile() == icc_profile({image.encoding.space, linear_transfer()}));
}
