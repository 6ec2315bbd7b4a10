#include "io/outputs/write_outputs.h"

#include "core/image/develop.h"
#include "core/image/metadata.h"
#include "io/console/terminal.h"
#include "io/outputs/output_names.h"
#include "io/outputs/picture_warnings.h"
#include "io/outputs/write_each.h"
#include "io/outputs/write_film_exr.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace abbe {
namespace {

DisplayImage by_ocio(const Rendered& rendered, const OcioTransform& ocio,
                     const DisplaySettings& settings) {
  const Film& film = rendered.rendering.film;
  SceneLinearImage linear =
      rendered.denoised
          ? rendered.denoised->scene_linear(ocio.space(), true)
          : develop_scene_linear(film, rendered.plan, ocio.space(),
                                 FilmPart{.window = film.window(), .colors_only = true});
  // Those of a part come without metadata, those without noise say so and have all.
  if (!rendered.denoised) linear.metadata = render_metadata(rendered.plan);
  return ocio_picture(ocio, linear, settings);
}

DisplayImage display_picture(const Rendered& rendered, const std::optional<OcioLook>& ocio,
                             const DisplaySettings& settings) {
  const Film& film = rendered.rendering.film;
  DisplayImage image = ocio                ? by_ocio(rendered, OcioTransform(*ocio), settings)
                       : rendered.denoised ? rendered.denoised->display(settings)
                                           : develop_display(film, rendered.plan, settings);
  say_warning(warning_of_exposure(film, image));
  return image;
}

/// The EXRs of the rendering, but for that of all bands.
std::vector<OutputJob> exr_jobs(const FilmExrs& exrs, const Plan& plan, const Outputs& outputs,
                                const OutputOptions& options) {
  std::vector<OutputJob> jobs;
  std::vector<std::string> layers;
  if (options.layer_files) layers = exrs.layers();
  for (const std::filesystem::path& path : outputs.images) {
    if (!is_scene_linear_extension(path)) continue;
    for (const std::string& layer : layers) {
      const std::filesystem::path file = layer_file(path, layer);
      jobs.push_back({file, [&exrs, file, layer] { return exrs.write_layer(file, layer); }});
    }
    jobs.push_back({path, [&exrs, path] { return exrs.write_picture(path); }});
    for (int band = 0; band < plan.grid.count() && plan.settings.band_images; ++band) {
      const std::filesystem::path file = band_file(path, band);
      jobs.push_back({file, [&exrs, file, band] { return exrs.write_band(file, band); }});
    }
  }
  for (const std::string& group : plan.light_groups) {
    if (!plan.settings.relightable) break;
    const std::filesystem::path file = cube_file(outputs, group);
    jobs.push_back({file, [&exrs, file, group] { return exrs.write_unit(file, group); }});
  }
  return jobs;
}

} // namespace

bool write_outputs(const Rendered& rendered, const Outputs& outputs, const OutputOptions& options,
                   const DisplaySettings& display_settings, bool quiet) {
  const Plan& plan = rendered.plan;
  bool all = true;
  const bool has_exr = std::ranges::any_of(outputs.images, is_scene_linear_extension);
  if (has_exr || plan.settings.relightable || outputs.spectral) {
    const FilmExrs exrs(rendered.rendering.film, plan, options, rendered.denoised);
    std::vector<OutputJob> jobs = exr_jobs(exrs, plan, outputs, options);
    if (outputs.spectral)
      jobs.push_back({*outputs.spectral, [&] { return exrs.write_bands(*outputs.spectral); }});
    all = write_each(jobs, quiet);
  }
  if (std::ranges::all_of(outputs.images, is_scene_linear_extension)) return all;
  const DisplayImage display = display_picture(rendered, options.ocio, display_settings);
  std::vector<OutputJob> jobs;
  for (const std::filesystem::path& path : outputs.images)
    if (!is_scene_linear_extension(path))
      jobs.push_back({path, [&, path] { return write_image(path, {}, display, options); }});
  return write_each(jobs, quiet) && all;
}

} // namespace abbe
