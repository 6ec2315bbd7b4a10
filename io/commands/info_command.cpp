#include "io/commands/info_command.h"

#include "io/console/terminal.h"
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

} // namespace

void add_options(CLI::App& app, InfoCommand& command) {
  app.add_option("file", command.file, "State of a rendering")->required()->type_name("FILE");
}

int run(const InfoCommand& command) {
  tell_state(command.file);
  return 0;
}

} // namespace abbe
