#include "io/images/read_environment.h"

#include "io/images/read_exr.h"
#include "io/images/write_exr.h"
#include "spectral/illuminant.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"
#include "tests/io/temporary_folder.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <array>
#include <fstream>
#include <limits>

using namespace abbe;
using test::Folder;

namespace {

/// An image of 3 x 2 pixels beside which scenes lie.
struct Pictures {
  Folder folder;
  std::vector<std::string> warnings;

  Pictures() { write("sky.exr", {}); }

  void write(const std::string& name, std::optional<float> value) {
    const PixelWindow window{0, 0, 3, 2};
    SceneLinearImage image{window, window, {}, {}};
    for (int i = 0; i < 24; ++i)
      image.rgba.push_back(0.25f * static_cast<float>(i));
    if (value) image.rgba[4 * 4 + 1] = *value; // column 1, row 1
    write_exr(folder.path / name, image, ExrPixel::single);
  }
  /// By OpenEXR: one channel that counts pixels.
  void write_one_channel(const std::string& name, const char* channel) {
    Imf::Header header(3, 2);
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    Imf::Chromaticities wide;
    wide.green.y = 0.9f;
    Imf::addChromaticities(header, wide);
    const float values[] = {0, 1, 2, 3, 4, 5};
    Imf::FrameBuffer frame;
    frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, values, header.dataWindow(), sizeof(float),
                                           3 * sizeof(float)));
    Imf::OutputFile file((folder.path / name).c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(2);
  }
  Scene read(const std::string& text) {
    return read_scene_text(text, folder.path / "s.sdl",
                           [&](const std::string& message) { warnings.push_back(message); });
  }
  /// The message without the folder's name.
  std::string error(const std::string& text) {
    try {
      (void)read(text);
    } catch (const ReadError& fault) {
      std::string message = fault.what();
      const std::string path = folder.path.string() + "/";
      for (std::size_t at; (at = message.find(path)) != std::string::npos;)
        message.erase(at, path.size());
      return message;
    }
    return "no error";
  }
};

} // namespace

TEST_CASE("an attribute that declares more bytes than the file has takes no memory") {
  const Pictures pictures;
  std::string bytes = test::content(pictures.folder.path / "sky.exr");
  const std::string attribute = std::string("compression\0compression\0", 24);
  const std::size_t size = bytes.find(attribute) + attribute.size();
  REQUIRE(bytes.substr(size, 4) == std::string("\1\0\0\0", 4));
  bytes.replace(size, 4, "\x7f\x7f\x7f\x7f"); // 2 GiB
  std::ofstream(pictures.folder.path / "large.exr") << bytes;
  std::string message;
  try {
    (void)read_exr_image(pictures.folder.path / "large.exr");
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  CHECK(message == "an attribute of its header is cut off");
}

TEST_CASE("an environment is an image with its colours") {
  Pictures pictures;
  const Scene scene = pictures.read("environment sky.exr sphere");
  REQUIRE(scene.environment);
  const Environment& e = *scene.environment;
  CHECK(e.width == 3);
  CHECK(e.height == 2);
  REQUIRE(e.rgb.size() == 18);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(e.rgb[3 * i + c] == 0.25f * static_cast<float>(4 * i + c));
  CHECK(e.factor == 1.0);
  CHECK(e.has_colors);
  CHECK(e.light == *find_illuminant("D65"));
  CHECK(e.to_world == glm::dmat3(1.0));
  CHECK(scene.shapes.size() == 1);
  CHECK_FALSE(pictures.read("sphere").environment.has_value());
}

TEST_CASE("an environment takes a factor, a spectrum, and the turn of the current transform") {
  Pictures pictures;
  CHECK(pictures.read("environment sky.exr 2.5").environment->factor == 2.5);
  const Scene lit = pictures.read("environment sky.exr A 3");
  CHECK(lit.environment->factor == 3.0);
  CHECK_FALSE(lit.environment->has_colors);
  CHECK(lit.environment->light == *find_illuminant("A"));
  CHECK(pictures.read("environment sky.exr \"E\" plane").environment->light.constant_value() ==
        1.0);
  const glm::dmat3 turn =
      pictures.read("translate 1 2 3 scale 4 4 4 rotate 90 0 1 0 environment sky.exr")
          .environment->to_world;
  CHECK(glm::length(turn[0] - dvec3(0, 0, -1)) < 1e-14);
  CHECK(glm::length(turn[1] - dvec3(0, 1, 0)) < 1e-14);
  CHECK(glm::length(turn[2] - dvec3(1, 0, 0)) < 1e-14);
}

TEST_CASE("an image of luminance alone is grey, whatever its primaries") {
  Pictures pictures;
  pictures.write_one_channel("grey.exr", "Y");
  const Scene scene = pictures.read("environment grey.exr");
  for (std::size_t i = 0; i < 18; ++i)
    CHECK(scene.environment->rgb[i] == static_cast<float>(i / 3));
  CHECK(pictures.warnings.empty());
}

TEST_CASE("the tags of an image say what its colours are") {
  Pictures pictures;
  // Red, green and blue of ACEScg in linear sRGB, Bradford-adapted to D65. (source: the matrix that
  // OpenColorIO's ACES configurations and Lindbloom's formulas give, five digits)
  const double expected[3][3] = {
      {1.70505, -0.13026, -0.02400}, {-0.62179, 1.14080, -0.12897}, {-0.08326, -0.01055, 1.15297}};
  const PixelWindow window{0, 0, 3, 1};
  const std::vector<float> rgba{1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
  SceneLinearImage image{window, window, rgba, {}, SceneLinearSpace::acescg};
  write_exr(pictures.folder.path / "tagged.exr", image, ExrPixel::single);
  Imf::Header header(3, 1);
  Imf::addChromaticities(header, Imf::Chromaticities({0.713f, 0.293f}, {0.165f, 0.830f},
                                                     {0.128f, 0.044f}, {0.32168f, 0.33767f}));
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < 3; ++c) {
    const char* const name = std::array{"R", "G", "B"}[c];
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, rgba.data() + c, header.dataWindow(),
                                        4 * sizeof(float), 12 * sizeof(float)));
  }
  {
    Imf::OutputFile file((pictures.folder.path / "primaries.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
  }
  for (const char* name : {"tagged.exr", "primaries.exr"}) {
    const Scene scene = pictures.read(std::string("environment ") + name);
    for (std::size_t pixel = 0; pixel < 3; ++pixel)
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(scene.environment->rgb[3 * pixel + c] == Approx(expected[pixel][c]).margin(2e-5));
  }
  // Components below 0 are told of; they are colours that sRGB does not have.
  REQUIRE(pictures.warnings.size() == 2);
  CHECK(pictures.warnings[0].find("has negative components, which count as 0") !=
        std::string::npos);
}

TEST_CASE("a tag that is not known is told of") {
  Pictures pictures;
  Imf::Header header(1, 1);
  header.insert("colorInteropID", Imf::StringAttribute("g22_rec709_scene"));
  const float values[] = {0.5f};
  Imf::FrameBuffer frame;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, values, header.dataWindow()));
  }
  {
    Imf::OutputFile file((pictures.folder.path / "odd.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
  }
  (void)pictures.read("environment odd.exr");
  REQUIRE(pictures.warnings.size() == 1);
  CHECK(pictures.warnings[0].find("is tagged as \"g22_rec709_scene\", which is not known; it is "
                                  "read as linear sRGB") != std::string::npos);
}

TEST_CASE("an image that declares more than memory may hold is refused by its header") {
  Pictures pictures;
  // A header for 60000 x 60000 pixels, as OpenEXR writes it, and nothing after it.
  Imf::Header header(60000, 60000);
  for (const char* name : {"R", "G", "B"})
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  {
    const Imf::OutputFile file((pictures.folder.path / "vast.exr").c_str(), header);
  }
  CHECK(pictures.error("environment vast.exr") ==
        "s.sdl:1:13: \"vast.exr\" cannot be read (its 60000 x 60000 pixels would take 40.2 GiB of "
        "memory, and 2 GiB is the most for an image). Write the image again, as OpenEXR");
}

TEST_CASE("errors of environments") {
  Pictures pictures;
  CHECK(pictures.error("environment nowhere.exr") ==
        "s.sdl:1:13: there is no file \"nowhere.exr\" (images are found relative to the file "
        "that names them). Check the name, or write the whole path");
  std::ofstream(pictures.folder.path / "text.exr") << "no picture";
  CHECK(pictures.error("environment text.exr").find("s.sdl:1:13: \"text.exr\" cannot be read (") ==
        0);
  CHECK(pictures.error("environment .") ==
        "s.sdl:1:13: \".\" cannot be read (it is a folder). Write the image again, as OpenEXR");
  pictures.write_one_channel("depth.exr", "Z");
  CHECK(pictures.error("environment depth.exr") ==
        "s.sdl:1:13: \"depth.exr\" cannot be read (it has neither full channels R, G and B nor a "
        "full channel Y). Write the image again, as OpenEXR");
  for (const float value :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    pictures.write("bad.exr", value);
    CHECK(pictures.error("environment bad.exr") ==
          "s.sdl:1:13: \"bad.exr\" has a pixel that is no number (the one in column 1, row 1). "
          "Mend the image");
  }
  CHECK(pictures.error("environment sky.exr -1") ==
        "s.sdl:1:21: -1 is out of range for environment (it is a factor on the picture). Give a "
        "number from 0 to 1000000000000000");
  CHECK(pictures.error("scale 1 2 1 environment sky.exr") ==
        "s.sdl:1:13: the current transform stretches the environment (angles would no longer be "
        "those of the picture). Give it before the scale, or scale all axes alike");
  CHECK(pictures.error("environment sky.exr D66").find("s.sdl:1:21: unknown light \"D66\"") == 0);
  CHECK(pictures.error("environment {")
            .find("s.sdl:1:13: \"{\" stands where the name of a file "
                  "should") == 0);
}
