#include "io/selftest/furnace_rows.h"

#include "io/selftest/small_picture.h"

#include <cmath>
#include <string>

namespace abbe {
namespace {

constexpr int kSize = 8;

Rendering in_furnace(const std::string& solid, int samples) {
  return rendered("background E 1 eye 1.7 1.1 5 lookAt 0 0 0 fieldOfView 24 imageSize " +
                  std::to_string(kSize) + " " + std::to_string(kSize) + " samples " +
                  std::to_string(samples) +
                  " maxRecursionDepth 100000 minThroughput 1e-9 bands 9 " + solid);
}

/// The value of all bands and pixels that is farthest from 1.
double farthest_from_one(const std::string& solid) {
  const Rendering r = in_furnace("exact on " + solid, 1);
  double farthest = 1.0;
  for_each_pixel(r.film.window(), [&](int x, int y) {
    for (int b = 0; b < r.film.bands(); ++b)
      if (const double v = r.film.radiance(x, y, b);
          !(std::abs(v - 1.0) <= std::abs(farthest - 1.0)))
        farthest = v;
  });
  return farthest;
}

/// The mean of all bands and pixels, for light that is scattered at random.
double mean_of_all(const std::string& solid) {
  const Rendering r = in_furnace("integrator path " + solid, 64);
  double sum = 0.0;
  for_each_pixel(r.film.window(), [&](int x, int y) {
    for (int b = 0; b < r.film.bands(); ++b)
      sum += r.film.radiance(x, y, b) / (kSize * kSize * r.film.bands());
  });
  return sum;
}

} // namespace

SelftestRows furnace_rows() {
  SelftestRows rows;
  const auto add = [&](const std::string& what, double got, double tolerance) {
    rows.push_back({"furnace", what, "R + T = 1 everywhere", 1.0, got, tolerance});
  };
  add("ball of SF11, worst band", farthest_from_one("glass SF11 sphere"), 1e-5);
  add("cube of N-BK7, worst band", farthest_from_one("glass N-BK7 cube"), 1e-5);
  add("prism of SF11, worst band", farthest_from_one("glass SF11 rotate 25 0 1 0 prism"), 1e-5);
  add("lens of F2, worst band",
      farthest_from_one("glass F2 lens push translate 0 0 0.6 sphere pop "
                        "push translate 0 0 -0.6 sphere pop"),
      1e-5);
  add("soap bubble, worst band",
      farthest_from_one("thinFilm 400 1.33 speedOfLight 1 transparency 1 reflectivity 1 sphere"),
      1e-5);
  add("ball of SF11, paths, mean", mean_of_all("glass SF11 sphere"), 0.005);
  add("rough ball of N-BK7, paths, mean", mean_of_all("glass N-BK7 roughness 0.5 sphere"), 0.01);
  add("white matt ball, paths, mean", mean_of_all("diffuse 1 1 1 sphere"), 0.005);
  return rows;
}

} // namespace abbe
