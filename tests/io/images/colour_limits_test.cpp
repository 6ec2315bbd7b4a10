// Radiances at the limits through the film, the development and every format of files: no light,
// 1e-30, 1e+30, a colour outside of every screen's gamut, and more than single precision holds.

#include "core/film/film.h"
#include "core/image/develop.h"
#include "core/planning/make_plan.h"
#include "io/images/read_exr.h"
#include "io/images/read_image.h"
#include "io/images/write_image.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <tiffio.h>

#include <cmath>
#include <limits>
#include <memory>

using namespace abbe;
using test::Folder;

namespace {

/// A pixel for each of these colours, of which a film has one sample. Its quantum is as that of a
/// scene whose brightest light is `brightest`.
struct ColorRow {
  std::vector<Xyz> colours;
  Film film;
  Plan plan;

  ColorRow(const std::vector<Xyz>& given, double brightest)
      : colours(given), film({0, 0, static_cast<int>(given.size()), 1},
                             std::ldexp(1.0, std::ilogb(brightest) - 36), 0),
        plan(planned(static_cast<int>(given.size()))) {
    for (int x = 0; x < static_cast<int>(given.size()); ++x)
      film.add({x, 0, 0, true}, given[static_cast<std::size_t>(x)], {});
  }

private:
  static Plan planned(int width) {
    Scene scene;
    RenderSettings settings;
    settings.width = width;
    settings.height = 1;
    return make_plan(scene, settings);
  }
};

const Xyz kGrey = to_xyz(LinearRgb{0.25, 0.25, 0.25});
/// Of which red is below 0 and green above 1.
const Xyz kOutside{0.3, 1.0, 0.1};

std::vector<float> tiff_floats(const std::filesystem::path& path) {
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(path.c_str(), "r"), TIFFClose);
  REQUIRE(tiff);
  std::uint32_t width = 0;
  REQUIRE(TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width) == 1);
  std::vector<float> values(3 * std::size_t{width});
  REQUIRE(TIFFReadScanline(tiff.get(), values.data(), 0) == 1);
  return values;
}

} // namespace

TEST_CASE("radiances of 1e-30 and 1e+30 come through the film and float files as they are") {
  const Folder folder;
  for (const double scale : {1e-30, 1.0, 1e30}) {
    const ColorRow picture({{0.0, 0.0, 0.0}, kGrey * scale, kOutside * scale}, scale);
    CHECK(picture.film.refused().overflow == 0);
    const auto linear = develop_scene_linear(picture.film, picture.plan, SceneLinearSpace::rec709);
    const auto display = develop_display(picture.film, picture.plan, {});
    OutputOptions options;
    options.exr_pixel = ExrPixel::single;
    options.tiff_depth = TiffDepth::float32;
    CHECK(write_image(folder.path / "f.exr", linear, display, options).empty());
    CHECK(write_image(folder.path / "f.tiff", linear, display, options).empty());
    for (const std::vector<float>& values :
         {read_exr_image(folder.path / "f.exr").rgb, tiff_floats(folder.path / "f.tiff")}) {
      CAPTURE(scale);
      REQUIRE(values.size() == 9);
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(values[c] == 0.0f);
        CHECK(values[3 + c] / scale == Approx(0.25).epsilon(1e-6));
      }
      const LinearRgb outside = to_linear_srgb(kOutside);
      CHECK(values[6] / scale == Approx(outside.r).epsilon(1e-6));
      CHECK(values[6] < 0.0f);
      CHECK(values[7] / scale == Approx(outside.g).epsilon(1e-6));
    }
  }
}

TEST_CASE("half floats give way to floats where a picture is too bright for them") {
  const Folder folder;
  const ColorRow bright({kGrey * 1e30, kGrey}, 1e30);
  const auto linear = develop_scene_linear(bright.film, bright.plan, SceneLinearSpace::rec709);
  CHECK_FALSE(write_image(folder.path / "h.exr", linear, {}, {}).empty()); // and that is told
  CHECK(read_exr_image(folder.path / "h.exr").rgb[0] == Approx(0.25e30).epsilon(1e-6));
  // Less than the half's least number, 6e-8, is black.
  const ColorRow faint({kGrey * 1e-30}, 1e-30);
  const auto dark = develop_scene_linear(faint.film, faint.plan, SceneLinearSpace::rec709);
  CHECK(write_image(folder.path / "d.exr", dark, {}, {}).empty());
  CHECK(read_exr_image(folder.path / "d.exr").rgb == std::vector<float>{0.0f, 0.0f, 0.0f});
}

TEST_CASE("what is beyond single precision is the largest number there, and not infinite") {
  const Folder folder;
  DisplaySettings settings;
  settings.exposure_ev = 64.0;
  const ColorRow picture({kGrey * 1e30, kOutside * 1e30}, 1e30);
  const auto display = develop_display(picture.film, picture.plan, settings);
  OutputOptions options;
  options.tiff_depth = TiffDepth::float32;
  CHECK(write_image(folder.path / "f.tiff", {}, display, options).empty());
  const std::vector<float> values = tiff_floats(folder.path / "f.tiff");
  CHECK(values[0] == std::numeric_limits<float>::max());
  CHECK(values[3] == -std::numeric_limits<float>::max()); // red of the colour outside
}

TEST_CASE("integer files show light at the limits as black, white, and the colour between") {
  const Folder folder;
  for (const GamutMapping gamut :
       {GamutMapping::clip, GamutMapping::scale, GamutMapping::desaturate})
    for (const char* name : {"i.png", "i.tiff"})
      for (const bool deep : {false, true}) {
        DisplaySettings settings;
        settings.gamut = gamut;
        const ColorRow picture({{0.0, 0.0, 0.0}, kGrey * 1e-30, kGrey, kGrey * 1e30, kOutside},
                               1e30);
        // The quantum of a picture with such a light is larger than its greys.
        CHECK(picture.film.color(2, 0).y == 0.0);
        const ColorRow moderate({{0.0, 0.0, 0.0}, kGrey * 1e-30, kGrey, kGrey * 1e8, kOutside},
                                1.0);
        const auto display = develop_display(moderate.film, moderate.plan, settings);
        OutputOptions options;
        options.png_bits = deep ? 16 : 8;
        options.tiff_depth = deep ? TiffDepth::bits16 : TiffDepth::bits8;
        CHECK(write_image(folder.path / name, {}, display, options).empty());
        const double code = encode(srgb_transfer(), 0.25);
        for (std::size_t c = 0; c < 3; ++c) {
          CAPTURE(name, deep, gamut, c);
          CHECK(display.encoded[c] == 0.0f);
          CHECK(display.encoded[3 + c] == 0.0f);
          CHECK(display.encoded[6 + c] == Approx(code).epsilon(1e-6));
          CHECK(display.encoded[9 + c] == Approx(1.0f).epsilon(1e-6));
          CHECK(display.encoded[12 + c] >= 0.0f);
          CHECK(display.encoded[12 + c] <= 1.0f);
        }
        if (std::string(name) == "i.png") {
          const ReflectanceImage png = read_png(folder.path / name); // linear again
          REQUIRE(png.rgb.size() == 15);
          CHECK(png.rgb[0] == 0.0f);
          CHECK(png.rgb[3] == 0.0f);
          CHECK(png.rgb[6] == Approx(0.25).margin(deep ? 1e-5 : 4e-3));
          CHECK(png.rgb[9] == 1.0f);
        }
      }
}
