#include "io/outputs/write_layer_files.h"

#include "io/outputs/write_each.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace abbe {

std::string_view layer_of(std::string_view channel) {
  std::string_view layer = channel.substr(0, channel.rfind('.'));
  if (layer.starts_with("Crypto") && layer.size() > 2) layer.remove_suffix(2);
  return layer;
}

bool write_layer_files(SceneLinearImage& image, const Outputs& outputs,
                       const OutputOptions& options, bool quiet) {
  std::vector<SceneLinearImage> layers;
  std::vector<std::string> names;
  for (ImageChannel& channel : std::exchange(image.channels, {})) {
    const std::string name(layer_of(channel.name));
    const auto known = std::ranges::find(names, name);
    const auto number = static_cast<std::size_t>(known - names.begin());
    if (known == names.end()) {
      names.push_back(name);
      layers.push_back({image.display, image.data, {}, image.metadata, image.space});
    }
    layers[number].channels.push_back(std::move(channel));
  }
  std::vector<OutputJob> jobs;
  for (const std::filesystem::path& path : outputs.images) {
    if (!is_scene_linear_extension(path)) continue;
    for (std::size_t i = 0; i < layers.size(); ++i) {
      std::filesystem::path file = path;
      file.replace_extension("." + names[i] + ".exr");
      jobs.push_back({file, [&layers, &options, i, file] {
                        return write_image(file, layers[i], {}, options);
                      }});
    }
  }
  return write_each(jobs, quiet);
}

} // namespace abbe
