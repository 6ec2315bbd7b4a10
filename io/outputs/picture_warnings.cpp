#include "io/outputs/picture_warnings.h"

#include "core/planning/plan_bands.h"

#include <algorithm>
#include <variant>

namespace abbe {
namespace {

/// True when the condition holds for every pixel of the film.
template <class Condition>
bool everywhere(const Film& film, const Condition& holds) {
  bool all = true;
  for_each_pixel(film.window(), [&](int x, int y) { all = all && holds(x, y); });
  return all;
}

bool is_black(const Film& film) {
  return everywhere(film, [&](int x, int y) { return film.color(x, y) == Xyz{0.0, 0.0, 0.0}; });
}

} // namespace

std::string warning_of_darkness(const Scene& scene, const Plan& plan, const Rendering& rendering) {
  const Film& film = rendering.film;
  if (!is_black(film)) return "";
  if (nothing_gives_light(plan)) return "the picture is black: nothing in the scene gives light";
  if (std::holds_alternative<RealLens>(scene.camera.kind) && rendering.rays.camera == 0)
    return "the picture is black: no ray gets through the camera's lens";
  const bool clear = !everywhere(film, [&](int x, int y) { return film.alpha(x, y) == 1.0; });
  if (plan.sky.transparent && clear) return ""; // the plate shows
  if (everywhere(film, [&](int x, int y) { return film.covered_samples(x, y) == 0; }))
    return "the picture is black: no ray of the camera meets a shape. Is the scene behind it, or "
           "out of its view?";
  return "the picture is black: no light reaches what the camera sees. Is the camera, or are all "
         "lights, inside of something opaque?";
}

std::string warning_of_exposure(const Film& film, const DisplayImage& image) {
  if (is_black(film)) return "";
  // What 8 bits take for black, and light beyond the last of their codes by one more code.
  constexpr float black = 0.5f / 255.0f, beyond_white = 256.0f / 255.0f;
  if (std::ranges::all_of(image.encoded, [](float value) { return value < black; }))
    return "the picture for screens is black everywhere, though the film is not: the exposure is "
           "too low";
  if (std::ranges::all_of(image.linear, [](float value) { return value > beyond_white; }))
    return "the picture for screens is white everywhere: the exposure is too high";
  return "";
}

} // namespace abbe
