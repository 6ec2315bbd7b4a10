#include "io/commands/denoise_command.h"

#include "core/denoise/denoise_guide.h"
#include "core/scene/user_error.h"
#include "io/commands/reading_options.h"
#include "io/console/exit_codes.h"
#include "io/console/terminal.h"
#include "io/images/read_picture.h"
#include "io/images/write_exr.h"
#include "io/images/write_image.h"
#include "io/outputs/check_outputs.h"
#include "io/outputs/write_each.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

SceneLinearSpace space_of(const PictureHeader& header, const fs::path& file) {
  const std::string tag = header.text("colorInteropID");
  for (const SceneLinearSpace space : {SceneLinearSpace::rec709, SceneLinearSpace::acescg,
                                       SceneLinearSpace::aces2065_1, SceneLinearSpace::rec2020})
    if (tag == interop_id(space)) return space;
  throw UserError(fmt::format("{}: it does not say in which space its colours are, as pictures of "
                              "abbe render do by colorInteropID. Render it with --exr-tag "
                              "colorInteropID or both",
                              file.string()));
}

bool has_channel(const PictureHeader& header, std::string_view name) {
  return std::ranges::find(header.channels, name, &PictureChannel::name) != header.channels.end();
}

/// The layers that the filter needs and those that help it, as far as the file has them.
std::vector<std::string> guide_channels(const PictureHeader& header, const fs::path& file) {
  std::vector<std::string> names = noise_channels();
  for (const std::string& name : names)
    if (!has_channel(header, name))
      throw UserError(fmt::format("{}: it has no layer that tells its noise. Render it with "
                                  "--layers denoise",
                                  file.string()));
  const std::size_t needed = names.size();
  for (std::string& name : feature_channels())
    if (has_channel(header, name)) names.push_back(std::move(name));
  if (names.size() == needed)
    say_warning(fmt::format("{} has no layers of what is seen, such as normal and albedo: faint "
                            "edges may go with the noise. --layers denoise renders them",
                            file.string()));
  return names;
}

/// The picture with these layers, its colours in its own space.
SceneLinearImage read_noisy(const fs::path& file, const PictureHeader& header) {
  for (const char* const name : {"R", "G", "B"})
    if (!has_channel(header, name))
      throw UserError(fmt::format("{}: it has no colours R, G and B", file.string()));
  if (!header.text("abbe/denoised").empty())
    throw UserError(fmt::format("{}: its noise has been taken out already", file.string()));
  const std::vector<std::string> layers = guide_channels(header, file);
  SceneLinearImage image{header.display, header.data, {}, header.of_abbe(), space_of(header, file)};
  image.camera = header.camera;
  for (const std::string& name : layers)
    image.channels.push_back({name, {}});
  PictureRequest request{.alpha = true, .channels = {"R", "G", "B"}};
  request.channels.insert(request.channels.end(), layers.begin(), layers.end());
  const PictureValues values = read_picture(file, request);
  if (!std::ranges::all_of(values.layers, [](float v) { return std::isfinite(v); }))
    throw UserError(fmt::format("{}: some of its values are no finite numbers", file.string()));
  const std::size_t stride = request.channels.size();
  for (std::size_t pixel = 0; pixel < values.part.pixel_count(); ++pixel) {
    const float* const channels = values.layers.data() + pixel * stride;
    image.rgba.insert(image.rgba.end(), channels, channels + 3);
    image.rgba.push_back(values.alpha.empty() ? 1.0f : values.alpha[pixel]);
    for (std::size_t i = 0; i < layers.size(); ++i)
      image.channels[i].values.push_back(channels[3 + i]);
  }
  const auto is_noisy = [&](const std::string& name) {
    const auto channel = std::ranges::find(image.channels, name, &ImageChannel::name);
    return std::ranges::any_of(channel->values, [](float v) { return v != 0.0f; });
  };
  if (std::ranges::none_of(noise_channels(), is_noisy))
    throw UserError(
        fmt::format("{}: its noise is not known. It takes two samples per pixel", file.string()));
  return image;
}

/// Throws UserError for an EXR of bands that is not of the same picture.
void check_bands(const PictureHeader& bands, const SceneLinearImage& image, const fs::path& file,
                 const fs::path& guide) {
  require_bands(bands.wavelengths_nm, file, "--spectral");
  if (bands.data != image.data || bands.display != image.display)
    throw UserError(
        fmt::format("{}: its pixels are not those of {}", file.string(), guide.string()));
}

/// Some rows of the bands of a file.
SpectralImage read_bands(const fs::path& file, const PictureHeader& header, DenoiseRows rows) {
  const PictureValues values =
      read_picture(file, {.rows = RowRange{header.data.y0 + rows.first, header.data.y0 + rows.last},
                          .bands = true,
                          .alpha = true});
  SpectralImage image{header.display, values.part, header.wavelengths_nm, {}, {}, header.of_abbe()};
  image.camera = header.camera;
  const std::size_t pixels = values.part.pixel_count(), bands = header.wavelengths_nm.size();
  image.values.resize(pixels * bands);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    for (std::size_t band = 0; band < bands; ++band)
      image.values[band * pixels + pixel] = values.bands[pixel * bands + band];
    for (std::size_t c = 0; c < 3; ++c)
      image.rgba.push_back(values.rgb.empty() ? 0.0f : values.rgb[3 * pixel + c]);
    image.rgba.push_back(values.alpha.empty() ? 1.0f : values.alpha[pixel]);
  }
  return image;
}

void write_bands(const fs::path& from, const fs::path& to, const PictureHeader& header,
                 const Denoiser& denoiser) {
  write_spectral_exr(to, header.data, [&](const PixelWindow& rows) {
    const DenoiseWeights weights =
        denoiser.weights({rows.y0 - header.data.y0, rows.y1 - header.data.y0});
    return denoised(read_bands(from, header, weights.sources()), weights);
  });
}

} // namespace

void add_options(CLI::App& app, DenoiseCommand& command) {
  add_picture(app, "file", command.file, "Picture of render --layers denoise (.exr)");
  app.add_option("-o,--output", command.output, "Picture to write (.exr)")
      ->required()
      ->type_name("FILE");
  app.add_option("--spectral", command.spectral,
                 "The EXR of all bands of the same picture, and the one to write without noise")
      ->expected(2)
      ->type_name("FILE FILE");
  app.add_flag("-q,--quiet", command.quiet, "Print warnings and errors only");
}

int run(const DenoiseCommand& command) {
  if (!is_scene_linear_extension(command.output))
    throw UserError(fmt::format("{}: a picture without noise goes into an EXR; abbe develop makes "
                                "others of it. The name should end in .exr",
                                command.output.string()));
  Outputs outputs{{command.output}, {}, {}};
  std::vector<fs::path> inputs{command.file};
  if (!command.spectral.empty()) {
    outputs.spectral = command.spectral[1];
    inputs.push_back(command.spectral[0]);
  }
  check_outputs(outputs, inputs);
  const PictureHeader header = read_picture_header(command.file);
  SceneLinearImage image = read_noisy(command.file, header);
  std::optional<PictureHeader> bands;
  if (outputs.spectral) {
    bands = read_picture_header(inputs[1]);
    check_bands(*bands, image, inputs[1], command.file);
  }
  const Denoiser denoiser(guide_of(image));
  OutputOptions options;
  const auto red = std::ranges::find(header.channels, "R", &PictureChannel::name);
  options.exr_pixel = red->type == "half" ? ExrPixel::half : ExrPixel::single;
  image.channels.clear();
  image = denoised(std::move(image), denoiser);
  std::vector<OutputJob> jobs{
      {command.output, [&] { return write_image(command.output, image, {}, options); }}};
  if (bands)
    jobs.push_back({*outputs.spectral, [&] {
                      write_bands(inputs[1], *outputs.spectral, *bands, denoiser);
                      return std::string();
                    }});
  return write_each(jobs, command.quiet) ? 0 : kExitFailure;
}

} // namespace abbe
