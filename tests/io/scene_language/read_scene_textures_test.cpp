#include "tests/io/scene_language/read_scene_helpers.h"

#include "io/images/read_image.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <png.h>

#include <array>
#include <cmath>
#include <limits>

using namespace abbe;
namespace fs = std::filesystem;
using test::Folder;

namespace {

void save_png(const fs::path& path, int width, int height, std::uint32_t format,
              const void* pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  REQUIRE(png_image_write_to_file(&image, path.c_str(), 0, pixels, 0, nullptr) != 0);
}

/// Channels of 2 x 1 pixels in a data window that does not begin at 0.
void save_exr(const fs::path& path, const std::string& channels, const std::array<float, 6>& rgb) {
  const Imath::Box2i data{{3, 5}, {4, 5}};
  Imf::Header header({{0, 0}, {9, 9}}, data);
  Imf::FrameBuffer frame;
  std::array<float, 6> pixels = rgb;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::string name(1, channels[i]);
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, pixels.data() + i, data, 3 * sizeof(float),
                                        6 * sizeof(float)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(1);
}

/// The scene's first image, and what was warned of.
ReflectanceImage image_of(const fs::path& file, std::vector<std::string>* warnings = nullptr) {
  const Scene scene = read_scene_text("imageTexture " + file.filename().string() + " sphere",
                                      file.parent_path() / "s.sdl", [&](const std::string& text) {
                                        if (warnings) warnings->push_back(text);
                                      });
  REQUIRE(scene.images.size() == 1);
  const Material& finish = scene.materials[scene.shapes[0].material.index()];
  REQUIRE(std::get<ImageTexture>(finish.texture.value()).image == 0);
  return scene.images[0];
}

std::string image_error(const fs::path& file) {
  try {
    (void)image_of(file);
  } catch (const ReadError& error) {
    const std::string text = error.what(), folder = file.parent_path().string() + "/";
    std::string short_text = text;
    for (std::size_t at; (at = short_text.find(folder)) != short_text.npos;)
      short_text.erase(at, folder.size());
    return short_text;
  }
  return "no error";
}

/// sRGB's definition [IEC99].
double linear(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

const Material& finish_of(const Scene& scene, std::size_t shape) {
  return scene.materials[scene.shapes[shape].material.index()];
}

} // namespace

TEST_CASE("checker and grid have their numbers and colours") {
  const Scene scene = scene_of("checker 8 4.5 0.75 0.75 0.75 StrongOrangeYellow sphere "
                               "grid 3 2 0.125 0.5 0.5 0.5 0.25 0.25 0.25 sphere");
  const auto& checker = std::get<CheckerTexture>(finish_of(scene, 0).texture.value());
  CHECK(checker.across == 8.0);
  CHECK(checker.up == 4.5);
  CHECK(checker.first.constant_value() == 0.75);
  CHECK(checker.second == finish_of(scene_of("UseMaterial StrongOrangeYellow sphere"), 0).diffuse);
  const auto& grid = std::get<GridTexture>(finish_of(scene, 1).texture.value());
  CHECK(grid.across == 3.0);
  CHECK(grid.up == 2.0);
  CHECK(grid.width == 0.125);
  CHECK(grid.lines.constant_value() == 0.5);
  CHECK(grid.fields.constant_value() == 0.25);
}

TEST_CASE("a texture changes the diffuse part only, and diffuse takes its place") {
  const Scene scene =
      scene_of("specular 1 1 1 checker 1 1 1 1 1 0 0 0 sphere diffuse 0.5 0.5 0.5 sphere");
  CHECK(finish_of(scene, 0).specular.constant_value() == 1.0);
  CHECK(finish_of(scene, 0).ambient.constant_value() == 0.1);
  CHECK_FALSE(finish_of(scene, 1).texture);
  CHECK(finish_of(scene, 1).diffuse.constant_value() == 0.5);
}

TEST_CASE("a texture's colour above 1 counts as 1, with a warning") {
  std::vector<std::string> warnings;
  const Scene scene = scene_of("checker 1 1 2 2 2 0 0 0 sphere", &warnings);
  CHECK(std::get<CheckerTexture>(*finish_of(scene, 0).texture).first.constant_value() == 1.0);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("test.sdl:1:1: checker above 1 counts as 1") != std::string::npos);
}

TEST_CASE("PNG: codes of 8 and 16 bits, colour and grey, with and without alpha") {
  const Folder folder;
  const fs::path file = folder.path / "a.png";
  const std::array<std::uint8_t, 12> rgb{255, 0, 10, 20, 128, 200, 1, 2, 3, 0, 255, 254};
  save_png(file, 2, 2, PNG_FORMAT_RGB, rgb.data());
  const ReflectanceImage image = image_of(file);
  CHECK(image.width == 2);
  CHECK(image.height == 2);
  REQUIRE(image.rgb.size() == 12);
  for (std::size_t i = 0; i < 12; ++i)
    CHECK(static_cast<double>(image.rgb[i]) == Approx(linear(rgb[i] / 255.0)).epsilon(1e-6));

  const std::array<std::uint8_t, 3> grey{0, 77, 255};
  save_png(file, 3, 1, PNG_FORMAT_GRAY, grey.data());
  const ReflectanceImage dull = image_of(file);
  REQUIRE(dull.rgb.size() == 9);
  for (std::size_t i = 0; i < 9; ++i)
    CHECK(static_cast<double>(dull.rgb[i]) == Approx(linear(grey[i / 3] / 255.0)).epsilon(1e-6));

  const std::array<std::uint8_t, 8> rgba{200, 100, 50, 0, 10, 20, 30, 255};
  save_png(file, 2, 1, PNG_FORMAT_RGBA, rgba.data());
  const ReflectanceImage opaque = image_of(file);
  REQUIRE(opaque.rgb.size() == 6);
  CHECK(static_cast<double>(opaque.rgb[0]) == Approx(linear(200 / 255.0)));
  CHECK(static_cast<double>(opaque.rgb[3]) == Approx(linear(10 / 255.0)));

  // libpng writes linear 16 bits as they are; they are taken as sRGB codes all the same.
  const std::array<std::uint16_t, 3> deep{0, 12345, 65535};
  save_png(file, 1, 1, PNG_FORMAT_LINEAR_RGB, deep.data());
  const ReflectanceImage fine = image_of(file);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(static_cast<double>(fine.rgb[i]) == Approx(linear(deep[i] / 65535.0)).epsilon(1e-6));
}

TEST_CASE("EXR: linear, from its data window; what is beyond 0 and 1 is clamped with a warning") {
  const Folder folder;
  const fs::path file = folder.path / "a.exr";
  std::vector<std::string> warnings;
  save_exr(file, "RGB", {0.0f, 0.25f, 1.0f, 0.5f, 0.125f, 0.75f});
  const ReflectanceImage image = image_of(file, &warnings);
  CHECK(image.width == 2);
  CHECK(image.height == 1);
  CHECK(image.rgb == std::vector<float>{0.0f, 0.25f, 1.0f, 0.5f, 0.125f, 0.75f});
  CHECK(warnings.empty());

  save_exr(file, "RGB", {-1.0f, 0.25f, 1.0f, 0.5f, 0.125f, 7.0f});
  CHECK(image_of(file, &warnings).rgb == std::vector<float>{0.0f, 0.25f, 1.0f, 0.5f, 0.125f, 1.0f});
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("s.sdl:1:14: \"" + file.string() +
                         "\" has components below 0 or above 1, which count as 0 and 1") !=
        std::string::npos);
}

TEST_CASE("an image is read once, and found from the file that names it") {
  const Folder folder;
  const std::array<std::uint8_t, 3> white{255, 255, 255};
  fs::create_directory(folder.path / "sub");
  save_png(folder.path / "sub/a.png", 1, 1, PNG_FORMAT_RGB, white.data());
  std::ofstream(folder.path / "sub/part.sdl") << "imageTexture a.png sphere";
  const Scene scene =
      read_scene_text("include sub/part.sdl specular 1 1 1 imageTexture sub/../sub/a.png sphere",
                      folder.path / "s.sdl", {});
  CHECK(scene.images.size() == 1);
  CHECK(scene.materials.size() == 2);
}

TEST_CASE("errors of textures") {
  CHECK(scene_error("checker 0 1") == "s.sdl:1:9: 0 is out of range for checker (it is a number of "
                                      "fields). Give a number more than 0");
  CHECK(scene_error("grid 1 1 1.5") ==
        "s.sdl:1:10: 1.5 is out of range for grid (it is the breadth "
        "of a line in fields). Give a number from 0 to 1");
  CHECK(scene_error("checker 1 1") ==
        "s.sdl:1:12: the end of the file stands where a colour or the name of a material should "
        "(checker takes nu nv FIRST SECOND). Give a name; one with spaces goes in double quotes");
  const std::string made = "checker 1 1 1 1 1 0 0 0 defMaterial a ";
  CHECK(scene_error(made + "checker 1 1 a a") ==
        "s.sdl:1:51: \"a\" has no single diffuse colour (it has a texture). Name a material with "
        "one, or give three numbers");
  CHECK(scene_error(made + "mix a a 0.5 defMaterial b defaultMaterials grid 1 1 0 b b") ==
        "s.sdl:1:93: \"b\" has no single diffuse colour (it is a mixture). Name a material with "
        "one, or give three numbers");
  CHECK(scene_error("imageTexture a.gif") ==
        "s.sdl:1:14: \"a.gif\" is no image (its name ends neither in .png nor in .exr). Give a "
        "file of one of these formats");
  CHECK(scene_error("imageTexture a.png") ==
        "s.sdl:1:14: there is no file \"no_such_folder/a.png\" (images are found relative to the "
        "file that names them). Check the name, or write the whole path");
}

TEST_CASE("errors of images") {
  const Folder folder;
  const fs::path png = folder.path / "a.png", exr = folder.path / "a.exr";
  std::ofstream(png) << "no picture";
  CHECK(image_error(png) ==
        "s.sdl:1:14: \"a.png\" cannot be read (Not a PNG file). Write the image "
        "again, as PNG or EXR");
  const std::array<std::uint8_t, 12> rgb{};
  save_png(png, 2, 2, PNG_FORMAT_RGB, rgb.data());
  fs::resize_file(png, fs::file_size(png) - 20);
  CHECK_THAT(image_error(png), Catch::Matchers::ContainsSubstring("\"a.png\" cannot be read ("));
  std::ofstream(exr) << "no picture";
  CHECK_THAT(image_error(exr), Catch::Matchers::ContainsSubstring("\"a.exr\" cannot be read ("));
  save_exr(exr, "RG", {});
  CHECK(image_error(exr) ==
        "s.sdl:1:14: \"a.exr\" cannot be read (it has neither full channels R, G "
        "and B nor a full channel Y). Write the image again, as PNG or EXR");
  save_exr(exr, "RGB", {0.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f});
  CHECK(image_error(exr) ==
        "s.sdl:1:14: \"a.exr\" holds what is no number (a component is infinite "
        "or not a number). Write the image again");
  CHECK_NOTHROW(require_image_memory(16384, 8192, 12));
  REQUIRE_THROWS_WITH(
      require_image_memory(65536, 65536, 12),
      "its 65536 x 65536 pixels would take 48.0 GiB of memory, and 2 GiB is the most "
      "for an image");
  CHECK_THROWS(require_image_memory(std::uint64_t{1} << 63, std::uint64_t{1} << 63, 12));
}
