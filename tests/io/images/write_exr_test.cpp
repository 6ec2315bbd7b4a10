#include "io/images/write_exr.h"

#include "tests/catch.h"
#include "tests/io/libraries/spectral_rows.h"
#include "tests/io/temporary_folder.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVersion.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

using namespace abbe;
namespace fs = std::filesystem;
using test::content;
using test::Folder;

namespace {

/// Exact in 16 bits (at most 11 significant bits): below 0 and above 1 too.
float pattern(int x, int y, int channel) {
  return 0.25f * static_cast<float>(x) - 1.5f * static_cast<float>(y) +
         16.0f * static_cast<float>(channel);
}

const PixelWindow full_frame{0, 0, 16, 9}, crop{3, 2, 8, 6};

std::vector<float> rgba_pattern(const PixelWindow& data) {
  std::vector<float> rgba;
  for (int y = data.y0; y < data.y1; ++y)
    for (int x = data.x0; x < data.x1; ++x)
      for (int c = 0; c < 4; ++c)
        rgba.push_back(pattern(x, y, c));
  return rgba;
}

SceneLinearImage scene_linear(const PixelWindow& data) {
  return {full_frame, data, rgba_pattern(data), {{"abbe/bands", "81"}, {"abbe/seed", "7"}}};
}

SceneLinearImage one_row(std::vector<float> rgba) {
  const PixelWindow window{0, 0, static_cast<int>(rgba.size() / 4), 1};
  return {window, window, std::move(rgba), {}};
}

/// One channel as floats, by OpenEXR itself.
std::vector<float> read_channel(const fs::path& path, const std::string& name) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  // NaN where the file brings nothing.
  std::vector<float> values(static_cast<std::size_t>(width * height),
                            std::numeric_limits<float>::quiet_NaN());
  Imf::FrameBuffer frame;
  frame.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), window));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return values;
}

std::string text_attribute(const Imf::Header& header, const char* name) {
  const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
  return attribute != nullptr ? attribute->value() : "(none)";
}

std::set<std::string> attribute_names(const Imf::Header& header) {
  std::set<std::string> names;
  for (auto it = header.begin(); it != header.end(); ++it)
    names.insert(it.name());
  return names;
}

const std::set<std::string> required_names = {
    "channels",  "compression",      "dataWindow",         "displayWindow",
    "lineOrder", "pixelAspectRatio", "screenWindowCenter", "screenWindowWidth"};

/// Mean of band b at the pixel: negative never, above 1 often, and different everywhere.
float band_pattern(std::size_t band, std::size_t pixel) {
  return static_cast<float>(band) + static_cast<float>(pixel) / 64.0f + 1e-5f;
}

SpectralImage spectral(const PixelWindow& data, std::size_t bands) {
  SpectralImage image{full_frame, data, {}, {}, rgba_pattern(data), {{"abbe/bands", "n"}}};
  for (std::size_t b = 0; b < bands; ++b) {
    // Centres of n equal cells from 377.5 to 782.5 nm.
    image.wavelengths_nm.push_back(377.5 + 405.0 * (static_cast<double>(b) + 0.5) /
                                               static_cast<double>(bands));
    for (std::size_t pixel = 0; pixel < data.pixel_count(); ++pixel)
      image.values.push_back(band_pattern(b, pixel));
  }
  return image;
}

} // namespace

TEST_CASE("EXR tells its colours by the tag that is asked for") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  for (const ExrTag tag :
       {ExrTag::interop_id, ExrTag::chromaticities, ExrTag::both, ExrTag::none}) {
    SceneLinearImage image = scene_linear(crop);
    image.space = SceneLinearSpace::acescg;
    write_exr(path, image, ExrPixel::half, tag);
    const Imf::InputFile file(path.c_str());
    const bool id = tag == ExrTag::interop_id || tag == ExrTag::both;
    const bool primaries = tag == ExrTag::chromaticities || tag == ExrTag::both;
    CHECK(text_attribute(file.header(), "colorInteropID") == (id ? "lin_ap1_scene" : "(none)"));
    REQUIRE(Imf::hasChromaticities(file.header()) == primaries);
    if (!primaries) continue;
    // AP1 and its white (S-2014-004).
    const Imf::Chromaticities& c = Imf::chromaticities(file.header());
    CHECK(c.red.x == Approx(0.713));
    CHECK(c.green.y == Approx(0.830));
    CHECK(c.blue.x == Approx(0.128));
    CHECK(c.white.x == Approx(0.32168));
  }
}

TEST_CASE("EXR tells where its camera stands, where that is known") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  SceneLinearImage image = scene_linear(crop);
  image.camera.emplace();
  image.camera->world_to_camera[3][1] = -2.5;
  write_exr(path, image, ExrPixel::half);
  {
    const Imf::InputFile file(path.c_str());
    REQUIRE(Imf::hasWorldToCamera(file.header()));
    CHECK(Imf::worldToCamera(file.header())[3][1] == -2.5f);
    CHECK_FALSE(Imf::hasWorldToNDC(file.header()));
  }
  image.camera->world_to_image.emplace()[1][2] = 4.0;
  write_exr(path, image, ExrPixel::half);
  const Imf::InputFile file(path.c_str());
  REQUIRE(Imf::hasWorldToNDC(file.header()));
  CHECK(Imf::worldToNDC(file.header())[1][2] == 4.0f);
}

TEST_CASE("scene-linear EXR has bare R G B A, the crop's windows and the colour tag") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  for (const ExrPixel pixel : {ExrPixel::half, ExrPixel::single}) {
    write_exr(path, scene_linear(crop), pixel);

    const Imf::InputFile file(path.c_str());
    const Imf::Header& header = file.header();
    std::string channels;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
      channels += it.name();
      CHECK(it.channel().type == (pixel == ExrPixel::half ? Imf::HALF : Imf::FLOAT));
    }
    CHECK(channels == "ABGR"); // the order of the file is that of the alphabet
    CHECK(header.displayWindow() == Imath::Box2i({0, 0}, {15, 8}));
    CHECK(header.dataWindow() == Imath::Box2i({3, 2}, {7, 5}));
    CHECK(header.compression() == Imf::ZIP_COMPRESSION);
    CHECK(text_attribute(header, "colorInteropID") == "lin_rec709_scene");
    CHECK(text_attribute(header, "abbe/bands") == "81");
    CHECK(text_attribute(header, "abbe/seed") == "7");
    // Nothing else, so no chromaticities, no date, no host.
    std::set<std::string> expected = required_names;
    expected.insert({"colorInteropID", "abbe/bands", "abbe/seed"});
    CHECK(attribute_names(header) == expected);
  }
}

TEST_CASE("further channels are written in 32 bits beside the colours") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  constexpr float kOdd = 2049.0f; // no half float
  for (const ExrPixel pixel : {ExrPixel::half, ExrPixel::single}) {
    SceneLinearImage image = scene_linear(crop);
    std::vector<float> samples, error;
    for (std::size_t i = 0; i < crop.pixel_count(); ++i) {
      samples.push_back(kOdd + static_cast<float>(i));
      error.push_back(1e-3f * static_cast<float>(i));
    }
    error[0] = std::numeric_limits<float>::infinity();
    image.channels = {{"samples", samples}, {"error.Y", error}};
    write_exr(path, image, pixel);
    CHECK(read_channel(path, "samples") == samples);
    CHECK(read_channel(path, "error.Y") == error);
    const Imf::InputFile file(path.c_str());
    const Imf::ChannelList& channels = file.header().channels();
    CHECK(channels.findChannel("samples")->type == Imf::FLOAT);
    CHECK(channels.findChannel("error.Y")->type == Imf::FLOAT);
    CHECK(channels.findChannel("R")->type == (pixel == ExrPixel::half ? Imf::HALF : Imf::FLOAT));
  }
}

TEST_CASE("EXR in another space has its colour tag") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  SceneLinearImage image = scene_linear(crop);
  for (const auto& [space, id] : {std::pair{SceneLinearSpace::acescg, "lin_ap1_scene"},
                                  {SceneLinearSpace::aces2065_1, "lin_ap0_scene"},
                                  {SceneLinearSpace::rec2020, "lin_rec2020_scene"}}) {
    image.space = space;
    write_exr(path, image, ExrPixel::half);
    CHECK(text_attribute(Imf::InputFile(path.c_str()).header(), "colorInteropID") == id);
  }
}

TEST_CASE("scene-linear EXR keeps every pixel, below 0 and above 1 too") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  for (const ExrPixel pixel : {ExrPixel::half, ExrPixel::single}) {
    for (const PixelWindow& data : {full_frame, crop, PixelWindow{-2, -3, 20, 12}}) {
      write_exr(path, scene_linear(data), pixel);
      const char* names[] = {"R", "G", "B", "A"};
      for (int c = 0; c < 4; ++c) {
        std::vector<float> expected;
        for (int y = data.y0; y < data.y1; ++y)
          for (int x = data.x0; x < data.x1; ++x)
            expected.push_back(pattern(x, y, c));
        CHECK(read_channel(path, names[c]) == expected);
      }
    }
  }
}

TEST_CASE("half rounds to the nearest even, single keeps all bits") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  // A half has 10 bits after the binary point: from 1 the next ones are 1 + 2^-10 and 1 + 2^-9.
  const float ulp = std::ldexp(1.0f, -10);
  const std::vector<float> red = {1 + 0.49f * ulp, 1 + 0.5f * ulp, 1 + 0.51f * ulp,
                                  1 + 1.5f * ulp,  -0.1f,          65519.0f,
                                  -65519.0f,       65504.0f,       std::ldexp(1.0f, -24)};
  std::vector<float> rgba;
  for (const float r : red)
    rgba.insert(rgba.end(), {r, 0.0f, 0.0f, 1.0f});

  CHECK(write_exr(path, one_row(rgba), ExrPixel::half) == ExrPixel::half);
  // 0.1 lies in [2^-4, 2^-3), so its steps are 2^-14: 0.1 * 2^14 = 1638.4.
  CHECK(read_channel(path, "R") == std::vector<float>{1.0f, 1.0f, 1 + ulp, 1 + 2 * ulp,
                                                      std::ldexp(-1638.0f, -14), 65504.0f,
                                                      -65504.0f, 65504.0f, std::ldexp(1.0f, -24)});
  write_exr(path, one_row(rgba), ExrPixel::single);
  CHECK(read_channel(path, "R") == red);
}

TEST_CASE("values beyond the range of half floats are written as floats") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  for (const float beyond : {65520.0f, -65520.0f, 3e38f}) {
    CHECK(write_exr(path, one_row({1.1f, 0.0f, 0.0f, 1.0f, 0.0f, beyond, 0.0f, 1.0f}),
                    ExrPixel::half) == ExrPixel::single);
    CHECK(read_channel(path, "R") == std::vector<float>{1.1f, 0.0f});
    CHECK(read_channel(path, "G") == std::vector<float>{0.0f, beyond});
  }
}

TEST_CASE("NaN and infinity are written as they are") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  for (const ExrPixel pixel : {ExrPixel::half, ExrPixel::single}) {
    const float infinity = std::numeric_limits<float>::infinity();
    write_exr(path, one_row({std::nanf(""), infinity, -infinity, 1.0f}), pixel);
    CHECK(std::isnan(read_channel(path, "R").at(0)));
    CHECK(read_channel(path, "G").at(0) == infinity);
    CHECK(read_channel(path, "B").at(0) == -infinity);
  }
}

TEST_CASE("spectral EXR follows the layout 1.0") {
  const Folder folder;
  const fs::path path = folder.path / "cube.exr";
  test::write_whole_spectral_exr(path, spectral(crop, 81));

  const Imf::InputFile file(path.c_str());
  const Imf::Header& header = file.header();
  std::vector<std::string> names;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    names.emplace_back(it.name());
    CHECK(it.channel().type == Imf::FLOAT);
  }
  std::vector<std::string> expected = {"A", "B", "G", "R"};
  for (int k = 0; k < 81; ++k)
    expected.push_back("S0." + std::to_string(380 + 5 * k) + ",000000nm");
  CHECK(names == expected);
  CHECK(header.dataWindow() == Imath::Box2i({3, 2}, {7, 5}));
  CHECK(header.displayWindow() == Imath::Box2i({0, 0}, {15, 8}));
  CHECK(header.compression() == Imf::ZIP_COMPRESSION);
  CHECK(text_attribute(header, "spectralLayoutVersion") == "1.0");
  CHECK(text_attribute(header, "emissiveUnits") == "W.m^-2.sr^-1");
  CHECK(text_attribute(header, "colorInteropID") == "lin_rec709_scene");
  const auto* ev = header.findTypedAttribute<Imf::FloatAttribute>("EV");
  REQUIRE(ev != nullptr);
  CHECK(ev->value() == 0.0f);
  CHECK((file.version() & Imf::LONG_NAMES_FLAG) ==
        0); // of channels or attributes: old readers fail
  std::set<std::string> attributes = required_names;
  attributes.insert({"colorInteropID", "spectralLayoutVersion", "emissiveUnits", "EV"});
  attributes.insert("abbe/bands");
  CHECK(attribute_names(header) == attributes);
}

TEST_CASE("spectral EXR keeps all bits of every band and an unclipped preview") {
  const Folder folder;
  const fs::path path = folder.path / "cube.exr";
  const SpectralImage image = spectral(crop, 9); // cells of 45 nm: centres 400, 445 ... 760
  test::write_whole_spectral_exr(path, image);
  for (std::size_t b = 0; b < 9; ++b) {
    const std::string name = "S0." + std::to_string(400 + 45 * b) + ",000000nm";
    std::vector<float> expected;
    for (std::size_t pixel = 0; pixel < crop.pixel_count(); ++pixel)
      expected.push_back(band_pattern(b, pixel));
    CHECK(read_channel(path, name) == expected);
  }
  CHECK(read_channel(path, "R").at(0) == pattern(crop.x0, crop.y0, 0));
  CHECK(pattern(crop.x0, crop.y0, 0) < 0.0f);
}

TEST_CASE("a spectral EXR is written some rows at a time, each once and from the top") {
  const Folder folder;
  const fs::path path = folder.path / "cube.exr";
  const PixelWindow tall{3, 2, 6, 402};
  SpectralImage image = spectral(tall, 2);
  image.display = {0, 0, 10, 500};
  int next = tall.y0, most = 0;
  write_spectral_exr(path, tall, [&](const PixelWindow& rows) {
    CHECK(rows.x0 == tall.x0);
    CHECK(rows.x1 == tall.x1);
    CHECK((rows.y0 == next || rows.y0 == tall.y0)); // the first row is asked for the header too
    next = rows.y1;
    most = std::max(most, rows.height());
    return test::rows_of(image, rows);
  });
  CHECK(next == tall.y1);
  CHECK(most <= 128);
  for (std::size_t b = 0; b < 2; ++b)
    CHECK(read_channel(path, b == 0 ? "S0.478,750000nm" : "S0.681,250000nm") ==
          std::vector<float>(image.values.begin() + static_cast<std::ptrdiff_t>(b * 1200),
                             image.values.begin() + static_cast<std::ptrdiff_t>((b + 1) * 1200)));
  CHECK(Imf::InputFile(path.c_str()).header().dataWindow() == Imath::Box2i({3, 2}, {5, 401}));
}

TEST_CASE("a band's centre keeps six decimals, rounded") {
  const Folder folder;
  const fs::path path = folder.path / "cube.exr";
  test::write_whole_spectral_exr(path,
                                 spectral(crop, 7)); // cells of 405 / 7 nm; 377.5 + 28.92857142...
  const Imf::InputFile file(path.c_str());
  CHECK(file.header().channels().findChannel("S0.406,428571nm") != nullptr);
}

TEST_CASE("two EXR writes give the same bytes") {
  const Folder folder;
  const fs::path a = folder.path / "a.exr", b = folder.path / "other name.exr";
  for (const ExrPixel pixel : {ExrPixel::half, ExrPixel::single}) {
    write_exr(a, scene_linear(crop), pixel);
    write_exr(b, scene_linear(crop), pixel);
    CHECK(content(a) == content(b));
  }
  test::write_whole_spectral_exr(a, spectral(crop, 81));
  test::write_whole_spectral_exr(b, spectral(crop, 81));
  CHECK(content(a) == content(b));
}

TEST_CASE("an EXR without pixels is an error and no file") {
  const Folder folder;
  const fs::path path = folder.path / "picture.exr";
  CHECK_THROWS_WITH(write_exr(path, {}, ExrPixel::half),
                    "cannot write " + path.string() + ": the image has no pixels");
  CHECK_THROWS_AS(test::write_whole_spectral_exr(path, {}), std::runtime_error);
  CHECK(fs::is_empty(folder.path));
}
