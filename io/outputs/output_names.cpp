#include "io/outputs/output_names.h"

#include "core/image/develop.h"
#include "core/image/develop_layers.h"
#include "core/render/film_layers.h"

#include <fmt/format.h>

#include <algorithm>

namespace abbe {

namespace fs = std::filesystem;

fs::path layer_file(const fs::path& image, std::string_view layer) {
  return fs::path(image).replace_extension(fmt::format(".{}.exr", layer));
}

fs::path cube_file(const Outputs& outputs, const std::string& group) {
  return fs::path(outputs.images.front()).replace_extension(fmt::format(".light.{}.exr", group));
}

fs::path band_file(const fs::path& image, int band) {
  return fs::path(image).replace_extension(fmt::format(".band{:03}.exr", band + 1));
}

std::vector<std::string> layer_names(const SceneLinearImage& image) {
  std::vector<std::string> names;
  for (const ImageChannel& channel : image.channels)
    if (const std::string name(layer_of(channel.name));
        std::ranges::find(names, name) == names.end())
      names.push_back(name);
  return names;
}

std::vector<fs::path> further_files(const Scene& scene, const Plan& plan, const Outputs& outputs,
                                    const OutputOptions& options) {
  std::vector<fs::path> files;
  if (outputs.images.empty()) return files;
  if (plan.settings.relightable)
    for (const std::string& group : plan.light_groups)
      files.push_back(cube_file(outputs, group));
  std::vector<std::string> layers;
  if (options.layer_files) {
    // A film without pixels has the layers that the rendering's will have.
    const Film film({}, film_layers(scene, plan, std::nullopt));
    layers = layer_names(develop_scene_linear(film, plan, options.exr_space, FilmPart{{}}));
  }
  for (const fs::path& image : outputs.images) {
    if (!is_scene_linear_extension(image)) continue;
    for (const std::string& layer : layers)
      files.push_back(layer_file(image, layer));
    for (int b = 0; b < plan.grid.count() && plan.settings.band_images; ++b)
      files.push_back(band_file(image, b));
  }
  return files;
}

} // namespace abbe
