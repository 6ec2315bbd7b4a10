#include "core/image/develop.h"

#include "core/film/part_layers.h"
#include "core/image/develop_layers.h"
#include "core/image/metadata.h"
#include "core/image/scene_linear_space.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace abbe {
namespace {

PixelWindow full_window(const Plan& plan) {
  return {0, 0, plan.settings.width, plan.settings.height};
}

std::vector<float> linear_rgba(const Film& film, const PixelWindow& part, SceneLinearSpace space) {
  const Matrix3 to_rgb = matrix_to(space);
  std::vector<float> rgba;
  rgba.reserve(4 * part.pixel_count());
  for_each_pixel(part, [&](int x, int y) {
    // A pixel that was not reached has no picture, though light paths may have come to it.
    const Xyz xyz = film.samples(x, y) > 0 ? film.color(x, y) : Xyz{0.0, 0.0, 0.0};
    const Vector3 c = multiply(to_rgb, Vector3{xyz.x, xyz.y, xyz.z});
    for (const double v : {c[0], c[1], c[2], film.alpha(x, y)})
      rgba.push_back(as_float(v));
  });
  return rgba;
}

/// The layer of what passes through the scene, as channels in the picture's space.
std::vector<ImageChannel> transmittance_channels(const Film& film, LayerId layer,
                                                 const PixelWindow& part, SceneLinearSpace space) {
  const Matrix3 to_rgb = matrix_to(space);
  std::vector<ImageChannel> channels;
  for (const char* name : {"R", "G", "B"})
    channels.push_back({fmt::format("{}.{}", kTransmittance, name), {}});
  for_each_pixel(part, [&](int x, int y) {
    const Vector3 c = multiply(to_rgb, Vector3{film.mean(layer, x, y, 0), film.mean(layer, x, y, 1),
                                               film.mean(layer, x, y, 2)});
    for (std::size_t i = 0; i < channels.size(); ++i)
      channels[i].values.push_back(as_float(c[i]));
  });
  return channels;
}

ImageChannel samples_channel(const Film& film, const PixelWindow& part) {
  ImageChannel channel{"samples", {}};
  for_each_pixel(part, [&](int x, int y) {
    channel.values.push_back(static_cast<float>(film.samples(x, y)));
  });
  return channel;
}

ImageChannel error_channel(const Film& film, const PixelWindow& part) {
  ImageChannel channel{"error.Y", {}};
  for_each_pixel(part, [&](int x, int y) {
    const double e = film.error(x, y).y; // infinite where it is unknown
    channel.values.push_back(std::isfinite(e) ? as_float(e) : 0.0f);
  });
  return channel;
}

} // namespace

SceneLinearImage develop_scene_linear(const Film& film, const Plan& plan, SceneLinearSpace space) {
  SceneLinearImage image = develop_scene_linear(film, plan, space, FilmPart{film.window()});
  image.metadata = scene_linear_metadata(film, plan);
  return image;
}

Metadata scene_linear_metadata(const Film& film, const Plan& plan) {
  Metadata all = render_metadata(plan);
  for (const Metadata& more : {film_metadata(film), layer_metadata(plan)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

SceneLinearImage develop_scene_linear(const Film& film, const Plan& plan, SceneLinearSpace space,
                                      const FilmPart& part) {
  SceneLinearImage image{full_window(plan), part.window, {}, {}, space, {}, plan.camera};
  const auto wants = [&](std::string_view name) {
    return part.layer.empty() || part.layer == name;
  };
  if (part.layer.empty()) image.rgba = linear_rgba(film, part.window, space);
  if (part.colors_only) return image;
  const auto layer = film.find(kTransmittance);
  if (layer && wants(kTransmittance))
    image.channels = transmittance_channels(film, *layer, part.window, space);
  develop_layers(film, plan, matrix_to(space), part.layer, image);
  if (plan.settings.reports_errors()) {
    if (wants("samples")) image.channels.push_back(samples_channel(film, part.window));
    if (wants("error")) image.channels.push_back(error_channel(film, part.window));
  }
  film.touched(part.window.pixel_count());
  return image;
}

SceneLinearImage develop_band(const Film& film, const Plan& plan, int band, SceneLinearSpace space,
                              const PixelWindow& part) {
  SceneLinearImage image{full_window(plan), part, {}, {}, space, {}, plan.camera};
  const LayerId samples = film.find(band_layer(band)).value();
  const std::optional<LayerId> splats = film.find(splats_of(band_layer(band)));
  const Matrix3 to_rgb = matrix_to(space);
  image.rgba.reserve(4 * part.pixel_count());
  for_each_pixel(part, [&](int x, int y) {
    Vector3 xyz{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < xyz.size() && film.samples(x, y) > 0; ++i)
      xyz[i] = film.mean(samples, x, y, i) + (splats ? film.mean(*splats, x, y, i) : 0.0);
    const Vector3 c = multiply(to_rgb, xyz);
    for (const double v : {c[0], c[1], c[2], film.alpha(x, y)})
      image.rgba.push_back(as_float(v));
  });
  film.touched(part.pixel_count());
  return image;
}

DisplayImage develop_display(const Film& film, const Plan& plan, const DisplaySettings& settings) {
  DisplayImage image{full_window(plan),     film.window(),        {}, {},
                     render_metadata(plan), encoding_of(settings)};
  for (auto& entry : display_metadata(settings, plan.settings.observer))
    image.metadata.push_back(std::move(entry));
  const DisplayTransform transform(settings, plan.settings.observer);
  image.linear.reserve(3 * film.window().pixel_count());
  image.encoded.reserve(3 * film.window().pixel_count());
  for_each_pixel(film.window(), [&](int x, int y) {
    const LinearRgb c = transform.unclipped(film.color(x, y));
    const DisplayRgb e = transform.encoded(transform.linear(film.color(x, y)));
    for (const double v : {c.r, c.g, c.b})
      image.linear.push_back(as_float(v));
    for (const double v : {e.r, e.g, e.b})
      image.encoded.push_back(static_cast<float>(v));
  });
  return image;
}

SpectralImage develop_spectral(const Film& film, const Plan& plan, const PixelWindow& part) {
  SpectralImage image{
      full_window(plan),     part,       {}, {}, linear_rgba(film, part, SceneLinearSpace::rec709),
      render_metadata(plan), plan.camera};
  const std::size_t pixels = part.pixel_count();
  image.values.resize(pixels * static_cast<std::size_t>(film.bands()));
  for (int b = 0; b < film.bands(); ++b)
    image.wavelengths_nm.push_back(plan.grid.center_nm(b));
  std::size_t pixel = 0; // outside, as the film's bands of a pixel lie side by side
  for_each_pixel(part, [&](int x, int y) {
    for (int b = 0; b < film.bands(); ++b)
      image.values[static_cast<std::size_t>(b) * pixels + pixel] = as_float(film.radiance(x, y, b));
    ++pixel;
  });
  film.touched(pixels);
  return image;
}

} // namespace abbe
