#include "io/outputs/write_outputs.h"

#include "core/image/develop.h"
#include "core/image/metadata.h"
#include "core/image/relight.h"
#include "io/console/terminal.h"
#include "io/images/write_exr.h"
#include "io/outputs/picture_warnings.h"
#include "io/outputs/write_each.h"
#include "io/outputs/write_layer_files.h"

#include <algorithm>
#include <vector>

namespace abbe {
namespace {

SceneLinearImage scene_linear_picture(const Rendered& rendered, SceneLinearSpace space) {
  return rendered.denoised ? rendered.denoised->scene_linear(space)
                           : develop_scene_linear(rendered.rendering.film, rendered.plan, space);
}

DisplayImage display_picture(const Rendered& rendered, const DisplaySettings& settings) {
  const Film& film = rendered.rendering.film;
  DisplayImage image = rendered.denoised ? rendered.denoised->display(settings)
                                         : develop_display(film, rendered.plan, settings);
  say_warning(warning_of_exposure(film, image));
  return image;
}

/// The bands of each group of lights under light of equal energy: NAME.light.GROUP.exr.
bool write_cubes(const Film& film, const Plan& plan, const Outputs& outputs, bool quiet) {
  std::vector<OutputJob> jobs;
  for (const std::string& group : plan.light_groups) {
    std::filesystem::path file = outputs.images.front();
    file.replace_extension(".light." + group + ".exr");
    jobs.push_back({file, [&film, &plan, &group, file] {
                      write_spectral_exr(file, film.window(), [&](const PixelWindow& rows) {
                        return develop_unit(film, plan, group, rows);
                      });
                      return std::string();
                    }});
  }
  return write_each(jobs, quiet);
}

} // namespace

bool write_outputs(const Rendered& rendered, const Outputs& outputs, const OutputOptions& options,
                   const DisplaySettings& display_settings, bool quiet) {
  const Film& film = rendered.rendering.film;
  const Plan& plan = rendered.plan;
  const auto write_all = [&](bool scene_linear, const SceneLinearImage& linear,
                             const DisplayImage& display) {
    std::vector<OutputJob> jobs;
    for (const std::filesystem::path& path : outputs.images)
      if (is_scene_linear_extension(path) == scene_linear)
        jobs.push_back({path, [&, path] { return write_image(path, linear, display, options); }});
    return write_each(jobs, quiet);
  };
  bool all = true;
  if (std::ranges::any_of(outputs.images, is_scene_linear_extension)) {
    SceneLinearImage image = scene_linear_picture(rendered, options.exr_space);
    if (options.layer_files) all = write_layer_files(image, outputs, options, quiet);
    all = write_all(true, image, {}) && all;
  }
  if (!std::ranges::all_of(outputs.images, is_scene_linear_extension))
    all = write_all(false, {}, display_picture(rendered, display_settings)) && all;
  if (plan.settings.relightable) all = write_cubes(film, plan, outputs, quiet) && all;
  if (!outputs.spectral) return all;
  const auto write_spectral = [&] {
    const Metadata lost = lost_metadata(film); // found once, not for each block of rows
    const auto develop = [&](const PixelWindow& rows) {
      SpectralImage image = rendered.denoised ? rendered.denoised->spectral(rows)
                                              : develop_spectral(film, plan, rows);
      image.metadata.insert(image.metadata.end(), lost.begin(), lost.end());
      return image;
    };
    write_spectral_exr(*outputs.spectral, film.window(), develop);
    return std::string();
  };
  return write_each({{*outputs.spectral, write_spectral}}, quiet) && all;
}

} // namespace abbe
