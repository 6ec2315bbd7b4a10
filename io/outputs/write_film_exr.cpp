#include "io/outputs/write_film_exr.h"

#include "core/image/develop.h"
#include "core/image/full_frame.h"
#include "core/image/metadata.h"
#include "core/image/relight.h"
#include "io/outputs/output_names.h"
#include "io/states/state_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// Rows of the whole frame, of what gives rows of a part of it.
template <class Develop>
auto framed(const PixelWindow& part, const Develop& develop) {
  return [part, develop](const PixelWindow& rows) {
    // Rows beside the part have its channels, too.
    const PixelWindow first_row{part.x0, part.y0, part.x1, part.y0 + 1};
    return placed_in(rows, develop(common_part(rows, part).value_or(first_row)));
  };
}

/// True when half floats hold all colours of the film.
bool half_holds(const Film& film, const Plan& plan, SceneLinearSpace space) {
  bool fits = true;
  PixelWindow row = film.window();
  for (int y = film.window().y0; y < film.window().y1 && fits; ++y) {
    row.y0 = y;
    row.y1 = y + 1;
    const FilmPart part{.window = row, .colors_only = true};
    fits = fits_half(develop_scene_linear(film, plan, space, part).rgba);
  }
  return fits;
}

/// Which version of the program has made the picture.
std::pair<std::string, std::string> version() {
  return {"abbe/version", program_version()};
}

} // namespace

FilmExrs::FilmExrs(const Film& film, const Plan& plan, const OutputOptions& options,
                   const DenoisedPictures* denoised)
    : film_(film), plan_(plan), options_(options), denoised_(denoised),
      metadata_(scene_linear_metadata(film, plan)), pixel_(options.exr_pixel) {
  metadata_.emplace_back(version());
  if (pixel_ == ExrPixel::half && !half_holds(film, plan, options.exr_space))
    pixel_ = ExrPixel::single;
}

PixelWindow FilmExrs::data() const {
  if (!options_.full_frame) return film_.window();
  return {0, 0, plan_.settings.width, plan_.settings.height};
}

ExrHead FilmExrs::head() const {
  return {{0, 0, plan_.settings.width, plan_.settings.height},
          data(),
          metadata_,
          options_.exr_space,
          plan_.camera,
          options_.exr_tag};
}

std::vector<std::string> FilmExrs::layers() const {
  PixelWindow none = film_.window();
  none.y1 = none.y0;
  std::vector<std::string> names =
      layer_names(develop_scene_linear(film_, plan_, options_.exr_space, FilmPart{none}));
  if (denoised_)
    std::erase_if(names, [&](const std::string& name) { return denoised_->leaves_out(name); });
  return names;
}

void FilmExrs::write(const fs::path& file, const ExrHead& head, ExrPixel pixel,
                     const LinearRows& develop) const {
  if (options_.full_frame)
    return write_exr_rows(file, head, pixel, framed(film_.window(), develop));
  write_exr_rows(file, head, pixel, develop);
}

std::string FilmExrs::write_picture(const fs::path& file) const {
  if (denoised_) {
    SceneLinearImage image = denoised_->scene_linear(options_.exr_space, options_.layer_files);
    image.metadata.emplace_back(version());
    return write_image(file, image, {}, options_);
  }
  write(file, head(), pixel_, [&](const PixelWindow& rows) {
    const FilmPart part{.window = rows, .colors_only = options_.layer_files};
    return develop_scene_linear(film_, plan_, options_.exr_space, part);
  });
  return pixel_ == options_.exr_pixel ? "" : note_of_floats(file);
}

std::string FilmExrs::write_layer(const fs::path& file, const std::string& layer) const {
  write(file, head(), ExrPixel::single, [&](const PixelWindow& rows) {
    return develop_scene_linear(film_, plan_, options_.exr_space, FilmPart{rows, layer});
  });
  return "";
}

std::string FilmExrs::write_band(const fs::path& file, int band) const {
  ExrHead of_band = head();
  of_band.metadata.emplace_back(
      "abbe/band", fmt::format("{} of {}, {:.6g} to {:.6g} nm", band + 1, plan_.grid.count(),
                               plan_.grid.lower_nm(band), plan_.grid.lower_nm(band + 1)));
  write(file, of_band, ExrPixel::single, [&](const PixelWindow& rows) {
    return develop_band(film_, plan_, band, options_.exr_space, rows);
  });
  return "";
}

std::string FilmExrs::write_bands(const fs::path& file) const {
  Metadata of_film = film_metadata(film_);
  of_film.emplace_back(version());
  const auto develop = [&](const PixelWindow& rows) {
    SpectralImage image =
        denoised_ ? denoised_->spectral(rows) : develop_spectral(film_, plan_, rows);
    image.metadata.insert(image.metadata.end(), of_film.begin(), of_film.end());
    return image;
  };
  if (options_.full_frame)
    write_spectral_exr(file, data(), framed(film_.window(), develop), options_.exr_tag);
  else
    write_spectral_exr(file, data(), develop, options_.exr_tag);
  return "";
}

std::string FilmExrs::write_unit(const fs::path& file, const std::string& group) const {
  write_spectral_exr(
      file, film_.window(),
      [&](const PixelWindow& rows) { return develop_unit(film_, plan_, group, rows); },
      options_.exr_tag);
  return "";
}

} // namespace abbe
