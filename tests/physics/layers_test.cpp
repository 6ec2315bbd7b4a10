// What layers beside the picture hold, by closed forms, and that the picture does not depend on
// them.

#include "core/film/part_layers.h"
#include "core/image/develop.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

using namespace abbe;

namespace {

struct Layered {
  Plan plan;
  Film film;

  [[nodiscard]] double at(const std::string& layer, int x = 0, int y = 0) const {
    return film.mean(film.find(layer).value(), x, y);
  }
};

Layered layered(Scene scene, const std::string& layers) {
  scene.settings.layers = {};
  REQUIRE(add_layers(layers, scene.settings.layers));
  return {make_plan(scene, scene.settings), std::move(test::render_scene(scene, false).film)};
}

/// A view so narrow that all its rays are the same, straight along -z from z = 50.
Layered narrow(const std::string& text, const std::string& layers) {
  return layered(test::scene_from("filter box imageSize 1 1 fieldOfView 0.0001 samples 4 "
                                  "eye 0 0 50 lookAt 0 0 0 light E 0 0 50 1 " +
                                  text),
                 layers);
}

std::int64_t sum_of(const Film& film, const std::string& layer, std::size_t pixel,
                    std::size_t value) {
  const auto id = film.find(layer);
  return id ? film.layer(*id).sum(pixel, value) : 0;
}

const std::string kGlass = "glass N-BK7 ";
const std::string kAll =
    "depth,depth.nearest,distance,position,normal,normal.geometric,normal.through,albedo,uv,object,"
    "material,samples,direct,indirect,caustic,class:*,light:*,deviation,surfaces,glassPath,"
    "totalReflections,leastDeviation";

} // namespace

TEST_CASE("first-hit layers of a sphere that is seen along its axis") {
  const Layered l =
      narrow("diffuse 0.5 0.5 0.5 sphere", "depth,depth.nearest,distance,position,normal,albedo");
  for (const char* depth : {"depth.Z", "depth_nearest.Z", "distance.Z"})
    CHECK(l.at(depth) == Approx(49.0).epsilon(1e-7));
  CHECK(l.at("position.Z") == Approx(1.0).epsilon(1e-7));
  CHECK(l.at("position.X") == Approx(0.0).margin(1e-4));
  CHECK(l.at("normal.Z") == Approx(1.0).epsilon(1e-7));
  const Xyz white = to_xyz(kSrgbWhite, 1.0);
  const LayerId albedo = l.film.find("albedo").value();
  CHECK(l.film.mean(albedo, 0, 0, 0) == Approx(0.5 * white.x).epsilon(1e-3));
  CHECK(l.film.mean(albedo, 0, 0, 1) == Approx(0.5).epsilon(1e-3));
}

// A square before the camera at the distance 2 along its axis: at the angle t from the axis it is
// 2 / cos t away.
TEST_CASE("depth is along the axis of the camera, and distance along the ray") {
  const Layered l = layered(test::scene_from("filter box imageSize 5 1 fieldOfView 10 samples 16 "
                                             "eye 0 0 2 lookAt 0 0 0 light E 0 0 2 1 "
                                             "scale 9 9 1 square"),
                            "depth,distance,depth.nearest");
  for (int x = 0; x < 5; ++x) {
    CAPTURE(x);
    CHECK(l.at("depth.Z", x) == Approx(2.0).epsilon(1e-9));
    const double across = (x - 2) * 2.0 * std::tan(5.0 * std::numbers::pi / 180.0);
    CHECK(l.at("distance.Z", x) == Approx(2.0 / std::cos(std::atan(across))).epsilon(0.02));
    CHECK(l.at("depth_nearest.Z", x) <= l.at("depth.Z", x) + 1e-8);
  }
  CHECK(l.at("distance.Z", 0) > 1.03 * l.at("distance.Z", 2));
}

TEST_CASE("layers of one ray through a slab of glass") {
  const Layered l = narrow("push " + kGlass +
                               "translate 0 0 5 scale 3 3 0.75 cube pop "
                               "defaultMaterials push translate 0 0 -2 scale 5 5 1 square pop",
                           "normal.through,deviation,surfaces,glassPath,depth");
  CHECK(l.at("surfaces.V") == 2.0);
  CHECK(l.at("deviation.V") == Approx(0.0).margin(1e-4));
  CHECK(l.at("glassPath.V") == Approx(1.5).epsilon(1e-7));
  CHECK(l.at("normal_through.Z") == Approx(1.0).epsilon(1e-7));
  CHECK(l.at("depth.Z") == Approx(50.0 - 5.75).epsilon(1e-7));
}

// A mirror that is turned by 30 degrees sends the ray off by 180 - 2 * 30.
TEST_CASE("a mirror turns a ray by what the law of reflection says") {
  const Layered l = narrow("defaultMaterials diffuse 0 0 0 ambient 0 0 0 reflectivity 1 "
                           "push rotate 30 0 1 0 square pop",
                           "deviation,surfaces,glassPath");
  CHECK(l.at("surfaces.V") == 1.0);
  CHECK(l.at("deviation.V") == Approx(120.0).epsilon(1e-7));
  CHECK(l.at("glassPath.V") == 0.0);
}

// Straight into one face of a prism of glass and out of the other, which is inclined by the angle
// A: sin of the way out is n sin A, and the ray is turned by that angle less A. n_d of N-BK7 is
// Schott's 1.516800.
TEST_CASE("a wedge turns the d line by what Snell's law says") {
  const double wedge = 20.0 * std::numbers::pi / 180.0;
  const std::string back =
      std::to_string(std::sin(wedge)) + " 0 " + std::to_string(-std::cos(wedge));
  const Layered l = narrow(kGlass + "polyhedron planes 6 0 0 1 1 " + back +
                               " 1 1 0 0 2 -1 0 0 2 0 1 0 2 0 -1 0 2",
                           "deviation,surfaces");
  CHECK(l.at("surfaces.V") == 2.0);
  const double expected = std::asin(1.516800 * std::sin(wedge)) - wedge;
  CHECK(l.at("deviation.V") == Approx(expected * 180.0 / std::numbers::pi).epsilon(1e-5));
}

// Straight into one face of a prism of a right angle, to its back at 45 degrees, beyond the
// critical angle of 41.25 degrees, and straight out of the other face.
TEST_CASE("total reflections are counted") {
  const std::string back = "-0.70710678118 0 -0.70710678118 0";
  const Layered l =
      narrow(kGlass + "polyhedron planes 5 0 0 1 1 1 0 0 1 " + back + " 0 1 0 2 0 -1 0 2",
             "deviation,surfaces,totalReflections");
  CHECK(l.at("totalReflections.V") == 1.0);
  CHECK(l.at("surfaces.V") == 3.0);
  CHECK(l.at("deviation.V") == Approx(90.0).epsilon(1e-6));
}

// A prism of 60 degrees turns light of 550 nm least where the sine of its angle is n / 2: it goes
// through as symmetrically as it can. n by Schott's formula of N-BK7.
TEST_CASE("the wavelength of least deviation is the one that passes a prism symmetrically") {
  const double l2 = 0.55 * 0.55;
  const double n =
      std::sqrt(1.0 + 1.03961212 * l2 / (l2 - 0.00600069867) +
                0.231792344 * l2 / (l2 - 0.0200179144) + 1.01046945 * l2 / (l2 - 103.560653));
  const double in = std::asin(n / 2.0), third = std::numbers::pi / 3.0;
  const auto plane = [](double angle, double side) {
    return std::to_string(side * std::sin(angle)) + " 0 " + std::to_string(side * std::cos(angle)) +
           " 1 ";
  };
  const std::string prism = kGlass + "polyhedron planes 5 " + plane(in, 1.0) +
                            plane(in - third, -1.0) + plane(in + third, -1.0) + "0 1 0 2 0 -1 0 2";
  CHECK(narrow(prism, "leastDeviation").at("leastDeviation.V") == Approx(550.0).margin(0.5));
  // Far from it at any wavelength, and where nothing is refracted.
  const Layered slab = narrow(kGlass + "cube", "leastDeviation");
  CHECK(slab.at("leastDeviation.V") == 0.0);
}

// What a band adds to a sky of equal energy is its part of the observer's curves.
TEST_CASE("a band's image is the colour of its light") {
  Scene scene = test::scene_from("imageSize 1 1 samples 4 bands 27 background E 1");
  scene.settings.band_images = true;
  const Plan plan = make_plan(scene, scene.settings);
  const Film film = std::move(test::render_scene(scene, false).film);
  const std::vector<Xyz> weights =
      band_weights(plan.grid, Curve::constant(1.0), plan.settings.observer);
  for (int b = 0; b < 27; ++b) {
    const LayerId layer = film.find(band_layer(b)).value();
    const Xyz& expected = weights[static_cast<std::size_t>(b)];
    CAPTURE(b);
    CHECK(film.mean(layer, 0, 0, 0) == Approx(expected.x).epsilon(1e-6).margin(1e-9));
    CHECK(film.mean(layer, 0, 0, 1) == Approx(expected.y).epsilon(1e-6).margin(1e-9));
    CHECK(film.mean(layer, 0, 0, 2) == Approx(expected.z).epsilon(1e-6).margin(1e-9));
  }
}

// Samples of bands add up in the film's integers; a splat is rounded in each band for itself.
TEST_CASE("the images of all bands add up to the beauty, which does not depend on them") {
  for (const std::string name : {"cornell_glass", "gem_caustic", "prism_view"}) {
    CAPTURE(name);
    Scene scene = test::project_scene(name, 12);
    scene.settings.samples_per_pixel = 2;
    scene.settings.bands = 9;
    const Film plain = std::move(test::render_scene(scene, false).film);
    scene.settings.band_images = true;
    const Plan plan = make_plan(scene, scene.settings);
    const Film film = std::move(test::render_scene(scene, false).film);
    bool same = true, exact = true;
    std::int64_t total = 0;
    for (std::size_t pixel = 0; pixel < 12 * 12; ++pixel)
      for (std::size_t value = 0; value < 3; ++value) {
        std::int64_t bands = 0;
        for (int b = 0; b < 9; ++b)
          bands += sum_of(film, band_layer(b), pixel, value);
        exact = exact && bands == sum_of(film, "beauty", pixel, value);
        for (const std::string layer : {"beauty", "beauty.splats"})
          same = same && sum_of(film, layer, pixel, value) == sum_of(plain, layer, pixel, value);
        total += bands;
      }
    CHECK(total > 0);
    CHECK(same);
    CHECK(exact);
    std::vector<double> sum(4 * 12 * 12);
    for (int b = 0; b < 9; ++b) {
      const auto image = develop_band(film, plan, b, SceneLinearSpace::rec709, film.window());
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += static_cast<double>(image.rgba[i]);
    }
    const SceneLinearImage beauty = develop_scene_linear(film, plan);
    double worst = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (i % 4 == 3) continue; // alpha
      worst = std::max(worst, std::abs(sum[i] - static_cast<double>(beauty.rgba[i])));
      mean += static_cast<double>(std::abs(beauty.rgba[i])) / (3 * 12 * 12);
    }
    CHECK(worst < 3e-6 * std::max(mean, 1e-3));
  }
}

TEST_CASE("no byte of the beauty depends on layers, and its parts add up to it exactly") {
  for (const std::string name :
       {"cornell_glass", "gem_caustic", "rough_glass", "prism_view", "sphere", "rainbow"}) {
    CAPTURE(name);
    Scene scene = test::project_scene(name, 16);
    scene.settings.samples_per_pixel = 2;
    const Layered plain = layered(scene, "none"), all = layered(scene, kAll);
    bool same = true, whole = true;
    std::int64_t total = 0;
    for (std::size_t pixel = 0; pixel < 16 * 16; ++pixel)
      for (std::size_t value = 0; value < 3; ++value)
        for (const std::string splats : {"", ".splats"}) {
          const std::int64_t beauty = sum_of(all.film, "beauty" + splats, pixel, value);
          same = same && beauty == sum_of(plain.film, "beauty" + splats, pixel, value);
          std::int64_t lights = 0, views = 0, arrivals = 0;
          for (const std::string& group : all.plan.light_groups)
            lights += sum_of(all.film, light_layer(group) + splats, pixel, value);
          for (int i = 0; i < 3; ++i) {
            views += sum_of(all.film, view_layer(static_cast<View>(i)) + splats, pixel, value);
            arrivals +=
                sum_of(all.film, arrival_layer(static_cast<Arrival>(i)) + splats, pixel, value);
          }
          whole = whole && lights == beauty && views == beauty && arrivals == beauty;
          total += beauty;
        }
    CHECK(total > 0);
    CHECK(same);
    CHECK(whole);
  }
}

// A ball that mirrors shows a floor, a ball of glass stands beside it, and the floor is seen too.
TEST_CASE("light is told by how it is seen and by how it has come") {
  const auto share = [](const Layered& l, const char* layer) {
    double part = 0.0, whole = 0.0;
    for_each_pixel(l.film.window(), [&](int x, int y) {
      part += l.film.mean(l.film.find(layer).value(), x, y, 1);
      whole += l.film.color(x, y).y;
    });
    return part / whole;
  };
  const std::string lamp = "light E 0 0 50 1 ";
  const Layered floor = narrow("integrator path square", "class:*,direct,indirect,caustic");
  CHECK(share(floor, "class:direct") == 1.0);
  CHECK(share(floor, "direct") == 1.0);
  const Layered mirrored = narrow("integrator path push translate 0 0 60 square pop "
                                  "defaultMaterials diffuse 0 0 0 ambient 0 0 0 reflectivity 1 "
                                  "square",
                                  "class:*,direct,indirect,caustic");
  CHECK(share(mirrored, "class:reflection") == 1.0);
  const Layered behind = narrow("integrator path push translate 0 0 -3 square pop background E 1 " +
                                    kGlass + "scale 1 1 0.1 cube",
                                "class:*");
  CHECK(share(behind, "class:refraction") > 0.8);
  CHECK(share(behind, "class:reflection") > 0.01);
  CHECK(share(behind, "class:direct") == Approx(0.0).margin(1e-9));
}

TEST_CASE("pictures have the layers under names that other programs show") {
  Scene scene = test::scene_from("imageSize 4 4 samples 8 light E 0 0 50 1 objectName ball sphere");
  REQUIRE(add_layers("depth,normal,object,light:*,variance,samples,uv", scene.settings.layers));
  const Plan plan = make_plan(scene, scene.settings);
  const Rendering rendering = test::render_scene(scene, false);
  const SceneLinearImage image =
      develop_scene_linear(rendering.film, plan, SceneLinearSpace::rec709);
  std::map<std::string, std::size_t> channels;
  for (const ImageChannel& channel : image.channels)
    channels[channel.name] = channel.values.size();
  for (const char* name :
       {"depth.Z", "normal.X", "normal.Y", "normal.Z", "CryptoObject00.R", "CryptoObject02.A",
        "light_E.R", "light_E.G", "light_E.B", "variance.R", "samples.V", "uv.U", "uv.V"}) {
    CAPTURE(name);
    REQUIRE(channels.contains(name));
    CHECK(channels[name] == 16);
  }
  const bool manifest = std::ranges::any_of(image.metadata, [](const auto& entry) {
    return entry.first.ends_with("/manifest") && entry.second.find("\"ball\"") != std::string::npos;
  });
  CHECK(manifest);
}
