#include "core/develop.h"

#include <fmt/format.h>

#include <cmath>

namespace abbe {
namespace {

PixelWindow full_window(const Plan& plan) {
  return {0, 0, plan.settings.width, plan.settings.height};
}

template <class Use>
void for_each_pixel(const PixelWindow& window, const Use& use) {
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      use(x, y);
}

std::vector<float> linear_rgba(const Film& film) {
  std::vector<float> rgba;
  rgba.reserve(4 * film.window().pixel_count());
  for_each_pixel(film.window(), [&](int x, int y) {
    const LinearRgb c = to_linear_srgb(film.color(x, y));
    for (const double v : {c.r, c.g, c.b, film.alpha(x, y)})
      rgba.push_back(static_cast<float>(v));
  });
  return rgba;
}

const char* name(PixelFilter filter) {
  switch (filter) {
  case PixelFilter::box:
    return "box";
  case PixelFilter::tent:
    return "tent";
  case PixelFilter::gaussian:
    return "gaussian";
  }
  return "";
}

const char* name(ShadowRule rule) {
  switch (rule) {
  case ShadowRule::none:
    return "none";
  case ShadowRule::opaque:
    return "opaque";
  case ShadowRule::attenuated:
    return "attenuated";
  }
  return "";
}

} // namespace

Metadata render_metadata(const Plan& plan) {
  const RenderSettings& s = plan.settings;
  Metadata data{{"abbe/integrator", "whitted"},
                {"abbe/bands", fmt::format("{}", s.bands)},
                {"abbe/samples", fmt::format("{}", s.samples_per_pixel)},
                {"abbe/seed", fmt::format("{}", s.seed)},
                {"abbe/filter", name(s.filter)},
                {"abbe/shadows", name(s.shadows)},
                {"abbe/depth", fmt::format("{}", s.max_depth)},
                {"abbe/minThroughput", fmt::format("{}", s.min_throughput)},
                {"abbe/minReflectivity", fmt::format("{}", s.min_reflectivity)},
                {"abbe/minTransparency", fmt::format("{}", s.min_transparency)},
                {"abbe/jitter", s.jitter ? "on" : "off"},
                {"abbe/exact", s.exact ? "on" : "off"}};
  if (!s.exact) {
    data.push_back({"abbe/tolerance", fmt::format("{}", s.tolerance_pixels)});
    data.push_back({"abbe/maxFan", fmt::format("{}", s.max_fan)});
  }
  return data;
}

SceneLinearImage develop_scene_linear(const Film& film, const Plan& plan) {
  return {full_window(plan), film.window(), linear_rgba(film), render_metadata(plan)};
}

DisplayImage develop_display(const Film& film, const Plan& plan, const DisplaySettings& settings) {
  DisplayImage image{full_window(plan), film.window(), {}, {}, render_metadata(plan)};
  const double gain = std::exp2(settings.exposure_ev);
  for_each_pixel(film.window(), [&](int x, int y) {
    const LinearRgb c = map_to_gamut(to_linear_srgb(film.color(x, y) * gain), settings.gamut);
    const DisplayRgb e = encode_srgb(c);
    for (const double v : {c.r, c.g, c.b})
      image.linear.push_back(static_cast<float>(v));
    for (const double v : {e.r, e.g, e.b})
      image.encoded.push_back(static_cast<float>(v));
  });
  return image;
}

SpectralImage develop_spectral(const Film& film, const Plan& plan) {
  SpectralImage image{full_window(plan), film.window(),        {}, {},
                      linear_rgba(film), render_metadata(plan)};
  image.values.reserve(film.window().pixel_count() * static_cast<std::size_t>(film.bands()));
  for (int b = 0; b < film.bands(); ++b) {
    image.wavelengths_nm.push_back(plan.grid.center_nm(b));
    for_each_pixel(film.window(), [&](int x, int y) {
      image.values.push_back(static_cast<float>(film.radiance(x, y, b)));
    });
  }
  return image;
}

} // namespace abbe
