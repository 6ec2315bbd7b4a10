#include "io/images/read_picture.h"

#include "core/image/display.h"
#include "core/scene/user_error.h"
#include "io/images/read_exr.h"
#include "io/images/write_exr.h"
#include "io/images/write_image.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <tiffio.h>

#include <array>
#include <cstring>
#include <functional>
#include <memory>

using namespace abbe;
using test::Folder;

namespace {

/// A crop of 3 x 2 pixels at (2, 1) of a frame of 8 x 6.
constexpr PixelWindow kFrame{0, 0, 8, 6}, kCrop{2, 1, 5, 3};

/// The value of a channel at a pixel of the crop.
float value(int channel, std::size_t pixel) {
  return 0.125F * static_cast<float>(channel + 1) + 0.01F * static_cast<float>(pixel);
}

/// Written by OpenEXR alone, as another program does it: half-float colours and bands in any order.
void write_foreign(const std::filesystem::path& path, const std::vector<std::string>& names) {
  Imf::Header header({{0, 0}, {7, 5}}, {{2, 1}, {4, 2}});
  std::vector<std::array<float, 6>> values(names.size());
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t pixel = 0; pixel < 6; ++pixel)
      values[i][pixel] = value(static_cast<int>(i), pixel);
    header.channels().insert(names[i], Imf::Channel(Imf::FLOAT));
    frame.insert(names[i], Imf::Slice::Make(Imf::FLOAT, values[i].data(), header.dataWindow(),
                                            sizeof(float), 3 * sizeof(float)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(2);
}

std::string error(const std::filesystem::path& path) {
  try {
    (void)read_picture(path, {});
  } catch (const UserError& fault) {
    std::string message = fault.what();
    const std::string folder = path.parent_path().string() + "/";
    if (const std::size_t at = message.find(folder); at != message.npos)
      message.erase(at, folder.size());
    return message;
  }
  return "no error";
}

/// A picture of 3 x 2 pixels through the program's own writers, as a screen shows it.
void write_for_screens(const std::filesystem::path& path, const std::vector<float>& linear,
                       const OutputOptions& options, const char* space = "srgb") {
  DisplaySettings settings;
  settings.space = find_color_space(space).value();
  const DisplayTransform transform(settings, Observer::cie1931_2deg);
  const PixelWindow window{0, 0, 3, 2};
  DisplayImage image{window, window, {}, {}, {}, encoding_of(settings)};
  for (std::size_t i = 0; i < linear.size(); i += 3) {
    const Xyz xyz = to_xyz(LinearRgb{linear[i], linear[i + 1], linear[i + 2]});
    const LinearRgb c = transform.unclipped(xyz);
    const DisplayRgb e = transform.encoded(c);
    for (const double v : {c.r, c.g, c.b})
      image.linear.push_back(static_cast<float>(v));
    for (const double v : {e.r, e.g, e.b})
      image.encoded.push_back(static_cast<float>(v));
  }
  (void)write_image(path, {}, image, options);
}

const std::vector<float> kColors{0.5F, 0.25F, 0.125F, 0.0F, 1.0F, 0.0F, 0.9F, 0.8F, 0.7F,
                                 0.2F, 0.2F,  0.2F,   1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 0.01F};

void check_near(const std::vector<float>& a, const std::vector<float>& b, double margin) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    CHECK(a[i] == Approx(b[i]).margin(margin));
}

} // namespace

TEST_CASE("an EXR of another program is read with its windows, colours and bands") {
  const Folder folder;
  const auto path = folder.path / "foreign.exr";
  write_foreign(path, {"R", "G", "B", "S0.600nm", "S0.400,5nm", "Z"});
  const Picture picture = read_picture(path, {.bands = true});
  CHECK(picture.header.format == "OpenEXR");
  CHECK(picture.header.display == kFrame);
  CHECK(picture.header.data == kCrop);
  CHECK(picture.part == kCrop);
  CHECK(picture.header.has_color);
  CHECK(picture.header.wavelengths_nm == std::vector<double>{400.5, 600.0});
  REQUIRE(picture.header.channels.size() == 6);
  CHECK(picture.header.channels[0].name == "B");
  CHECK(picture.header.channels[0].type == "float");
  REQUIRE(picture.rgb.size() == 18);
  REQUIRE(picture.bands.size() == 12);
  for (std::size_t pixel = 0; pixel < 6; ++pixel) {
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(picture.rgb[3 * pixel + c] == value(static_cast<int>(c), pixel));
    CHECK(picture.bands[2 * pixel] == value(4, pixel)); // by wavelength
    CHECK(picture.bands[2 * pixel + 1] == value(3, pixel));
  }
}

TEST_CASE("rows are read alone, and those outside of the window are none") {
  const Folder folder;
  const auto path = folder.path / "foreign.exr";
  write_foreign(path, {"R", "G", "B", "S0.600nm"});
  const Picture second = read_picture(path, {.rows = RowRange{2, 3}, .bands = true});
  CHECK(second.part == PixelWindow{2, 2, 5, 3});
  REQUIRE(second.rgb.size() == 9);
  CHECK(second.rgb[0] == value(0, 3));
  REQUIRE(second.bands.size() == 3);
  CHECK(second.bands[2] == value(3, 5));
  CHECK(read_picture(path, {.rows = RowRange{-5, 99}}).part == kCrop);
  CHECK(read_picture(path, {.rows = RowRange{3, 9}}).rgb.empty());
  CHECK(read_picture(path, {}).bands.empty());
}

TEST_CASE("blocks of rows are the whole picture") {
  const Folder folder;
  const auto path = folder.path / "tall.exr";
  const PixelWindow window{0, 0, 2, 3000};
  SceneLinearImage image{window, window, {}, {}};
  for (std::size_t i = 0; i < 4 * window.pixel_count(); ++i)
    image.rgba.push_back(static_cast<float>(i));
  write_exr(path, image, ExrPixel::single);
  std::vector<float> red;
  int next = 0;
  read_picture_blocks(path, {}, [&](const Picture& block) {
    CHECK(block.part.y0 == next);
    next = block.part.y1;
    for (std::size_t i = 0; i < block.rgb.size(); i += 3)
      red.push_back(block.rgb[i]);
  });
  CHECK(next == 3000);
  REQUIRE(red.size() == window.pixel_count());
  CHECK(red.back() == image.rgba[image.rgba.size() - 4]);
}

TEST_CASE("an EXR with bands alone has no colours, one with a grey channel has grey ones") {
  const Folder folder;
  write_foreign(folder.path / "bands.exr", {"S0.600nm", "S0.500nm"});
  const Picture bands = read_picture(folder.path / "bands.exr", {.bands = true});
  CHECK_FALSE(bands.header.has_color);
  CHECK(bands.rgb.empty());
  CHECK(bands.bands.size() == 12);
  CHECK_THROWS_AS(read_exr_image(folder.path / "bands.exr"), std::runtime_error);
  write_foreign(folder.path / "grey.exr", {"Y"});
  const Picture grey = read_picture(folder.path / "grey.exr", {});
  CHECK(grey.rgb[0] == value(0, 0));
  CHECK(grey.rgb[2] == value(0, 0));
}

TEST_CASE("PNG and TIFF are read as the light that they show") {
  const Folder folder;
  OutputOptions fine;
  fine.png_bits = 16;
  fine.tiff_depth = TiffDepth::bits16;
  for (const char* name : {"a.png", "a.tif"}) {
    INFO(name);
    write_for_screens(folder.path / name, kColors, fine);
    const Picture picture = read_picture(folder.path / name, {});
    CHECK(picture.part == PixelWindow{0, 0, 3, 2});
    check_near(picture.rgb, kColors, 1e-4);
    CHECK(picture.header.channels.size() == 3);
    CHECK(picture.header.channels[2].name == "B");
    CHECK(picture.header.channels[2].type == "16 bits");
    const Picture second = read_picture(folder.path / name, {.rows = RowRange{1, 2}});
    check_near(second.rgb, {kColors.begin() + 9, kColors.end()}, 1e-4);
  }
  OutputOptions light;
  light.tiff_depth = TiffDepth::float32;
  const std::vector<float> bright{4.0F,  0.5F, -0.25F, 1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 0.0F,
                                  1e-4F, 2.0F, 0.1F,   1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 9.0F};
  write_for_screens(folder.path / "f.tiff", bright, light);
  check_near(read_picture(folder.path / "f.tiff", {}).rgb, bright, 1e-3);
}

TEST_CASE("a display's profile is applied") {
  const Folder folder;
  OutputOptions fine;
  fine.png_bits = 16;
  fine.tiff_depth = TiffDepth::bits16;
  for (const char* name : {"p3.png", "p3.tif"}) {
    write_for_screens(folder.path / name, kColors, fine, "display-p3");
    check_near(read_picture(folder.path / name, {}).rgb, kColors, 2e-4);
  }
}

TEST_CASE("a TIFF of another program: 8 bits, planes apart, big-endian, no profile") {
  const Folder folder;
  const auto path = folder.path / "planes.tif";
  {
    const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(path.c_str(), "wb"), TIFFClose);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, 2);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, 2);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_SEPARATE);
    for (unsigned plane = 0; plane < 3; ++plane)
      for (unsigned y = 0; y < 2; ++y) {
        std::array<unsigned char, 2> row{static_cast<unsigned char>(plane == 0 ? 255 : 0),
                                         static_cast<unsigned char>(plane == y ? 188 : 0)};
        TIFFWriteScanline(tiff.get(), row.data(), y, static_cast<std::uint16_t>(plane));
      }
  }
  // 188 is 0.50289 of full light in sRGB: ((188 / 255 + 0.055) / 1.055)^2.4.
  check_near(read_picture(path, {}).rgb,
             {1.0F, 0.0F, 0.0F, 0.50289F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.50289F, 0.0F},
             1e-5);
}

TEST_CASE("what is no picture is told") {
  const Folder folder;
  CHECK(error(folder.path / "none.exr") == "there is no file none.exr");
  test::put(folder.path / "text.jpg", "text");
  CHECK(error(folder.path / "text.jpg") ==
        "text.jpg: no picture is read under this name. It should end in .exr, .tif, .tiff or .png");
  for (const char* name : {"text.exr", "text.png", "text.tif"}) {
    test::put(folder.path / name, "this is no picture");
    CHECK(error(folder.path / name).starts_with(std::string(name) + " cannot be read: "));
  }
}
