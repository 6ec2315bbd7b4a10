#include "io/commands/info_command.h"

#include "io/console/terminal.h"
#include "io/images/read_picture.h"
#include "io/images/spectral_channels.h"
#include "io/states/read_state.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace abbe {
namespace {

std::string settings_text(const KeptSettings& settings) {
  std::string text;
  for (const auto& [option, value] : settings)
    text += fmt::format(" {} {}", option, value);
  return text;
}

void tell_state(const std::filesystem::path& file) {
  StateReader reader(file);
  reader.check();
  const StateInfo& info = reader.info();
  const PixelWindow& window = reader.window();
  say(fmt::format("{}: the state of a rendering, version {}, by abbe {}, build {:08x}",
                  file.string(), kStateVersion, info.version, info.build));
  for (const SceneFile& scene : info.files)
    say(fmt::format("scene: {}, {} bytes, CRC-32 {:08x}", scene.path.string(), scene.size,
                    scene.checksum));
  if (!info.part.is_whole())
    say(fmt::format("part: {} of {}", info.part.number + 1, info.part.count));
  const SampleRange range = samples_of(info.part, info.samples);
  say(fmt::format("samples a pixel: {} of {}; {}", std::max(reader.done() - range.first, 0),
                  range.last - range.first, reader.complete() ? "complete" : "not complete"));
  say(fmt::format("pixels: {} x {}, layers:", window.width(), window.height()));
  for (const LayerForm& layer : reader.layers())
    say(fmt::format("  {}: {} {} a pixel", layer.name, layer.values(),
                    layer.values() == 1 ? "sum" : "sums"));
  say(fmt::format("rendering time: {:.1f} s", reader.seconds()));
  say("settings:" + settings_text(info.settings));
  say("all checksums are right");
}

std::string window_text(const PixelWindow& window) {
  return fmt::format("{} x {} pixels, x {} to {}, y {} to {}", window.width(), window.height(),
                     window.x0, window.x1 - 1, window.y0, window.y1 - 1);
}

/// Channels of one type after each other, but for bands, which are told by their number.
std::string channels_text(const PictureHeader& header) {
  std::vector<std::string> names;
  for (const PictureChannel& channel : header.channels)
    names.push_back(channel.name);
  const auto bands = spectral_channels(names);
  std::string text, type;
  for (const PictureChannel& channel : header.channels) {
    if (std::ranges::any_of(bands, [&](const auto& band) { return band.name == channel.name; }))
      continue;
    if (!type.empty() && channel.type != type) text += fmt::format(" ({})", type);
    type = channel.type;
    text += (text.empty() ? "" : " ") + channel.name;
  }
  return text.empty() ? "none but bands" : fmt::format("{} ({})", text, type);
}

void tell_picture(const std::filesystem::path& file) {
  const PictureHeader header = read_picture_header(file);
  say(fmt::format("{}: a picture, {}", file.string(), header.format));
  say("pixels: " + window_text(header.data));
  if (header.data != header.display) say("whole frame: " + window_text(header.display));
  say("channels: " + channels_text(header));
  if (!header.wavelengths_nm.empty())
    say(fmt::format("bands: {}, from {:g} to {:g} nm", header.wavelengths_nm.size(),
                    header.wavelengths_nm.front(), header.wavelengths_nm.back()));
  for (const auto& [name, value] : header.metadata)
    say(fmt::format("{}: {}", name, value));
}

} // namespace

void add_options(CLI::App& app, InfoCommand& command) {
  app.add_option("file", command.file, "Picture (EXR, PNG or TIFF), or state of a rendering")
      ->required()
      ->type_name("FILE");
}

int run(const InfoCommand& command) {
  if (is_picture_name(command.file))
    tell_picture(command.file);
  else
    tell_state(command.file);
  return 0;
}

} // namespace abbe
