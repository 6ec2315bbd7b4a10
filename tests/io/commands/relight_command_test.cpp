#include "io/commands/relight_command.h"

#include "core/scene/user_error.h"
#include "io/images/read_exr.h"
#include "io/images/write_exr.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace abbe;

namespace {

namespace fs = std::filesystem;

/// A cube of two pixels and 81 bands, all of one value in each pixel.
fs::path cube(const fs::path& folder, const std::string& group, float left, float right,
              int width = 2) {
  const fs::path file = folder / ((group.empty() ? "lone" : group) + ".exr");
  const PixelWindow window{0, 0, width, 1};
  write_spectral_exr(file, window, [&](const PixelWindow& rows) {
    SpectralImage image{window, rows, {}, {}, {}, {}};
    if (!group.empty()) image.metadata.emplace_back("abbe/lightGroup", group);
    for (int b = 0; b < 81; ++b) {
      image.wavelengths_nm.push_back(380.0 + 5.0 * b);
      for (int x = 0; x < width; ++x)
        image.values.push_back(x == 0 ? left : right);
    }
    image.rgba.assign(4 * static_cast<std::size_t>(width), 1.0f);
    return image;
  });
  return file;
}

std::string mistake(const RelightCommand& command) {
  try {
    (void)run(command);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

} // namespace

// A lamp of the strength s on a cube of the value v is D65 of the luminance s v, which is s v in
// each of the channels of linear sRGB; that of all lamps is the sum.
TEST_CASE("relight adds the cubes up under their lamps") {
  const test::Folder folder;
  RelightCommand command;
  command.cubes = {cube(folder.path, "key", 1.0f, 0.25f), cube(folder.path, "fill", 0.5f, 2.0f)};
  command.lights = {"key=D65,0.5", "fill=D65"};
  command.output = folder.path / "out.exr";
  command.quiet = true;
  REQUIRE(run(command) == 0);
  const ExrImage image = read_exr_image(command.output);
  REQUIRE(image.width == 2);
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(image.rgb[c] == Approx(0.5 * 1.0 + 0.5).epsilon(2e-3));
    CHECK(image.rgb[3 + c] == Approx(0.5 * 0.25 + 2.0).epsilon(2e-3));
  }
}

TEST_CASE("wrong uses of relight are told") {
  const test::Folder folder;
  RelightCommand right;
  right.cubes = {cube(folder.path, "key", 1.0f, 1.0f)};
  right.lights = {"key=E"};
  right.output = folder.path / "out.exr";
  right.quiet = true;
  const auto changed = [&](auto&& change) {
    RelightCommand command = right;
    change(command);
    return mistake(command);
  };
  using Contains = std::string;
  const auto has = [](const std::string& text, const Contains& part) {
    INFO(text);
    return text.find(part) != text.npos;
  };
  CHECK(mistake(right).empty());
  CHECK(has(changed([](RelightCommand& c) { c.lights = {"key"}; }), "NAME=LAMP"));
  CHECK(has(changed([](RelightCommand& c) { c.lights = {"key=D66"}; }), "unknown lamp \"D66\""));
  CHECK(has(changed([](RelightCommand& c) { c.lights = {"key=E,-1"}; }), "0 or more"));
  CHECK(has(changed([](RelightCommand& c) { c.lights = {"key=E", "key=A"}; }), "twice"));
  CHECK(
      has(changed([](RelightCommand& c) { c.lights = {"key=E", "rim=A"}; }), "none of the files"));
  CHECK(has(changed([](RelightCommand& c) { c.lights = {"rim=A"}; }), "which lamp key"));
  CHECK(has(changed([](RelightCommand& c) { c.cubes.push_back(c.cubes[0]); }), "both"));
  CHECK(has(changed([](RelightCommand& c) { c.output.replace_extension(".png"); }), ".exr"));
  CHECK(has(changed([](RelightCommand& c) { c.output = c.cubes[0]; }), "would replace"));
  CHECK(has(changed([&](RelightCommand& c) {
              c.cubes.push_back(cube(folder.path, "fill", 1.0f, 1.0f, 3));
              c.lights.push_back("fill=E");
            }),
            "its pixels"));
  CHECK(has(changed([&](RelightCommand& c) { c.cubes = {cube(folder.path, "", 1.0f, 1.0f)}; }),
            "not the light of one group"));
}
