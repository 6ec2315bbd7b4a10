// A rendering under light of equal energy whose lamps are changed afterwards is the rendering that
// these lamps would have given.

#include "core/film/part_layers.h"
#include "core/image/relight.h"
#include "core/planning/plan_relightable.h"
#include "core/scene/user_error.h"
#include "io/libraries/standard_lights.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <string>
#include <vector>

using namespace abbe;

namespace {

/// A prism before a wall, a ball of glass and a lamp with an extent, under two lights.
std::string scene_text(const std::string& key, const std::string& fill) {
  return "imageSize 12 12 samples 8 integrator path eye 0 0 9 lookAt 0 0 0 fieldOfView 40 "
         "falloff square intensity 30 lightGroup key light " +
         key + " 4 3 5 1 lightGroup fill intensity 0.5 light " + fill +
         " -4 1 5 1 "
         "defaultMaterials diffuse 0.7 0.6 0.5 ambient 0 0 0 "
         "push translate 0 0 -2 scale 6 6 1 square pop "
         "glass N-SF11 push translate 1 0 1 rotate 90 1 0 0 prism pop "
         "push translate -2 0 1 sphere pop ";
}

struct Relightable {
  Plan plan;
  Film film;
};

Relightable rendered(const std::string& text) {
  const Scene own = test::scene_from(text), lit = equal_energy_scene(own);
  Plan plan = plan_relightable(own, lit, own.settings);
  const World world(lit.shapes, farthest_coordinate(lit));
  Film film = std::move(render(lit, plan, world).film);
  return {std::move(plan), std::move(film)};
}

Curve light(const char* name) {
  return standard_light({TokenKind::word, name, {}}).value();
}

std::vector<float> unit_at(const Relightable& r, const std::string& group, int x, int y) {
  const SpectralImage image = develop_unit(r.film, r.plan, group, {x, y, x + 1, y + 1});
  return image.values;
}

} // namespace

TEST_CASE("lamps that are changed afterwards give what a rendering with them gives") {
  const Relightable cubes = rendered(scene_text("E", "E"));
  const Relightable wanted = rendered(scene_text("FL11", "D65"));
  REQUIRE(cubes.plan.light_groups == wanted.plan.light_groups);
  const Lamp key(cubes.plan.grid, light("FL11").scaled(30.0), cubes.plan.settings.observer);
  const Lamp fill(cubes.plan.grid, light("D65").scaled(0.5), cubes.plan.settings.observer);
  double mean = 0.0, worst = 0.0, caustic = 0.0;
  for_each_pixel(cubes.film.window(), [&](int x, int y) {
    const Xyz got =
        key.color(unit_at(cubes, "key", x, y)) + fill.color(unit_at(cubes, "fill", x, y));
    const Xyz want = wanted.film.color(x, y);
    worst = std::max(
        {worst, std::abs(got.x - want.x), std::abs(got.y - want.y), std::abs(got.z - want.z)});
    mean += want.y / (12 * 12);
    caustic += wanted.film.mean(wanted.film.find(kSplats).value(), x, y, 1);
  });
  CHECK(mean > 0.0);
  CHECK(caustic > 0.0);
  CHECK(worst <= 1e-6 * mean);
}

// The two renderings decide differently and have other random numbers. Errors are those of single
// samples, by the strata of both films.
TEST_CASE("relit pictures agree with ordinary ones within their noise") {
  const auto lit = [](const std::string& seed, const char* samples) {
    return "seed " + seed + " " + scene_text("FL11", "D65") + "samples " + samples;
  };
  double relit = 0.0, ordinary = 0.0, variance = 0.0;
  const int kRuns = 8;
  std::vector<double> a, b;
  for (int run = 0; run < kRuns; ++run) {
    const Relightable r = rendered(lit(std::to_string(run), "16"));
    Scene scene = test::scene_from(lit(std::to_string(100 + run), "16"));
    const Film plain = std::move(test::render_scene(scene, false).film);
    a.push_back(0.0);
    b.push_back(0.0);
    for_each_pixel(plain.window(), [&](int x, int y) {
      a.back() += r.film.color(x, y).y;
      b.back() += plain.color(x, y).y;
    });
    relit += a.back() / kRuns;
    ordinary += b.back() / kRuns;
  }
  for (int run = 0; run < kRuns; ++run)
    variance += (std::pow(a[static_cast<std::size_t>(run)] - relit, 2) +
                 std::pow(b[static_cast<std::size_t>(run)] - ordinary, 2)) /
                (kRuns * (kRuns - 1.0));
  CHECK(std::abs(relit - ordinary) < 4.0 * std::sqrt(variance));
  CHECK(std::sqrt(variance) < 0.02 * ordinary);
}

TEST_CASE("a relightable rendering refuses that the picture decides on samples") {
  Scene scene = test::scene_from(scene_text("E", "E"));
  for (const auto& set :
       {+[](RenderSettings& s) { s.adaptive = AdaptiveSampling::on; },
        +[](RenderSettings& s) { s.noise = 0.1; }, +[](RenderSettings& s) { s.seconds = 1.0; }}) {
    RenderSettings settings = scene.settings;
    set(settings);
    CHECK_THROWS_AS(plan_relightable(scene, equal_energy_scene(scene), settings), UserError);
  }
}
