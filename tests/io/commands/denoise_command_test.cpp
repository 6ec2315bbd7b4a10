#include "io/commands/denoise_command.h"

#include "core/scene/user_error.h"
#include "io/images/read_picture.h"
#include "io/images/write_exr.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <cmath>
#include <limits>
#include <string>

using namespace abbe;

namespace {

namespace fs = std::filesystem;

constexpr int kSize = 8;
constexpr PixelWindow kWindow{0, 0, kSize, kSize};

/// A grey picture on which half of the pixels are brighter by chance; the halves of the samples
/// tell that: one has it, the other has not.
SceneLinearImage noisy_picture() {
  SceneLinearImage image{kWindow, kWindow, {}, {{"abbe/seed", "5"}}};
  for (const char* const name : {"noise.R", "noise.G", "noise.B", "albedo_through.R"})
    image.channels.push_back({name, {}});
  for (int i = 0; i < kSize * kSize; ++i) {
    const float extra = (i * 37) % 64 < 32 ? 0.25f : 0.0f;
    for (int c = 0; c < 3; ++c)
      image.rgba.push_back(1.0f + extra);
    image.rgba.push_back(1.0f);
    for (std::size_t c = 0; c < 3; ++c)
      image.channels[c].values.push_back(i % 2 == 0 ? extra : -extra);
    image.channels[3].values.push_back(0.5f);
  }
  return image;
}

fs::path written(const fs::path& file, const SceneLinearImage& image) {
  write_exr(file, image, ExrPixel::single);
  return file;
}

/// Three bands, each a third of the picture.
fs::path bands_of(const fs::path& file, const SceneLinearImage& picture, int width = kSize) {
  write_spectral_exr(file, {0, 0, width, kSize}, [&](const PixelWindow& rows) {
    SpectralImage image{{0, 0, width, kSize}, rows, {450.0, 550.0, 650.0}, {}, {}, {}};
    image.values.resize(3 * rows.pixel_count());
    image.rgba.resize(4 * rows.pixel_count(), 1.0f);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
      const std::size_t pixel = i % rows.pixel_count() +
                                static_cast<std::size_t>(rows.y0) * static_cast<std::size_t>(width);
      image.values[i] = picture.rgba[4 * (pixel % (kSize * kSize))] / 3.0f;
    }
    return image;
  });
  return file;
}

std::string mistake(const DenoiseCommand& command) {
  try {
    (void)run(command);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

double variance(const std::vector<float>& values) {
  double sum = 0.0, squares = 0.0;
  for (const float value : values) {
    sum += static_cast<double>(value);
    squares += std::pow(static_cast<double>(value), 2);
  }
  const auto count = static_cast<double>(values.size());
  return squares / count - std::pow(sum / count, 2);
}

} // namespace

TEST_CASE("denoise takes the noise out of a picture and of its bands alike") {
  const test::Folder folder;
  const SceneLinearImage picture = noisy_picture();
  DenoiseCommand command;
  command.file = written(folder.path / "noisy.exr", picture);
  command.output = folder.path / "clean.exr";
  command.spectral = {bands_of(folder.path / "bands.exr", picture),
                      folder.path / "clean_bands.exr"};
  command.quiet = true;
  REQUIRE(run(command) == 0);
  const PictureValues before = read_picture(command.file, {});
  const PictureValues clean = read_picture(command.output, {});
  CHECK(variance(clean.rgb) < 0.2 * variance(before.rgb));
  const PictureValues bands = read_picture(command.spectral[1], {.bands = true});
  REQUIRE(bands.bands.size() == clean.rgb.size());
  double sum = 0.0, sum_before = 0.0;
  for (std::size_t i = 0; i < bands.bands.size(); i += 3) {
    REQUIRE(bands.bands[i] + bands.bands[i + 1] + bands.bands[i + 2] ==
            Approx(clean.rgb[i]).epsilon(1e-5));
    sum += static_cast<double>(clean.rgb[i]);
    sum_before += static_cast<double>(before.rgb[i]);
  }
  CHECK(sum == Approx(sum_before).epsilon(1e-6));
  const auto has = [&](std::string_view name) {
    return std::ranges::find(clean.header.metadata, name, [](const auto& entry) {
             return std::string_view(entry.first);
           }) != clean.header.metadata.end();
  };
  CHECK(has("abbe/seed"));
  CHECK(has("abbe/denoised"));
}

TEST_CASE("wrong uses of denoise are told") {
  const test::Folder folder;
  const SceneLinearImage picture = noisy_picture();
  DenoiseCommand right;
  right.file = written(folder.path / "noisy.exr", picture);
  right.output = folder.path / "clean.exr";
  right.quiet = true;
  const auto changed = [&](const auto& change) {
    DenoiseCommand command = right;
    change(command);
    return mistake(command);
  };
  const auto of_picture = [&](const auto& change) {
    SceneLinearImage other = picture;
    change(other);
    DenoiseCommand command = right;
    command.file = written(folder.path / "other.exr", other);
    return mistake(command);
  };
  const auto has = [](const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != text.npos;
  };
  using Image = SceneLinearImage;
  CHECK(has(changed([](DenoiseCommand& c) { c.output.replace_extension(".png"); }), "into an EXR"));
  CHECK(has(changed([](DenoiseCommand& c) { c.output = c.file; }), "would replace"));
  CHECK(has(changed([](DenoiseCommand& c) { c.file = "none.exr"; }), "there is no file"));
  CHECK(
      has(of_picture([](Image& i) { i.channels.erase(i.channels.begin()); }), "--layers denoise"));
  CHECK(has(of_picture([](Image& i) { i.rgba.clear(); }), "no colours"));
  CHECK(has(of_picture([](Image& i) { i.metadata.emplace_back("abbe/denoised", "yes"); }),
            "already"));
  CHECK(has(of_picture([](Image& i) { i.rgba[5] = std::numeric_limits<float>::infinity(); }),
            "finite"));
  CHECK(has(of_picture([](Image& i) {
              for (ImageChannel& channel : i.channels)
                channel.values.assign(channel.values.size(), 0.0f);
            }),
            "two samples"));
  CHECK(has(changed([&](DenoiseCommand& c) { c.spectral = {c.file, folder.path / "b.exr"}; }),
            "no bands"));
  CHECK(has(changed([&](DenoiseCommand& c) {
              c.spectral = {bands_of(folder.path / "wide.exr", picture, 9), folder.path / "b.exr"};
            }),
            "are not those of"));
  CHECK(mistake(right).empty());
}
