#include "core/film/part_layers.h"

#include "core/film/radiance_sums.h"
#include "core/planning/make_plan.h"
#include "core/scene/user_error.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace abbe;

namespace {

const std::string kScene = "imageSize 1 1 bands 3 background E 1 lightGroup key falloff square "
                           "light E 0 0 5 1 light D65 1 0 5 1 lightGroup none light E 0 5 0 1 ";

Plan plan_of(const std::string& layers) {
  Scene scene = test::scene_from(kScene);
  REQUIRE(add_layers(layers, scene.settings.layers));
  return make_plan(scene, scene.settings);
}

/// A film of the beauty and its parts, with splats.
Film film_of(const Plan& plan) {
  std::vector<LayerForm> forms = beauty_layers({.quantum = plan.quantum, .splats = true});
  for (const LayerForm& form : part_layers(plan, true))
    forms.push_back(form);
  return Film({0, 0, 1, 1}, std::move(forms));
}

std::int64_t sum_of(const Film& film, const std::vector<std::string>& layers, std::size_t value) {
  std::int64_t sum = 0;
  for (const std::string& layer : layers)
    sum += film.layer(film.find(layer).value()).sum(0, value);
  return sum;
}

} // namespace

TEST_CASE("lights of one group are one part, and others go by their name") {
  const Plan plan = plan_of("light:*");
  CHECK(plan.light_groups == std::vector<std::string>{"background", "key", "E"});
  CHECK(plan.sources[static_cast<std::size_t>(plan.light_source(0))].group == 1);
  CHECK(plan.sources[static_cast<std::size_t>(plan.light_source(1))].group == 1);
  CHECK(plan.sources[static_cast<std::size_t>(plan.light_source(2))].group == 2);
  CHECK(plan.sources[Plan::kAmbient].group < 0);
  CHECK_THROWS_AS(plan_of("light:fill"), UserError);
}

// The numbers are such that each part alone is rounded, and that the parts are of very different
// size.
TEST_CASE("parts add up to the beauty in whole quanta, sample by sample") {
  const Plan plan = plan_of("light:*,class:*,direct,indirect,caustic");
  Film film = film_of(plan);
  PartLayers layers(plan, film);
  REQUIRE_FALSE(layers.empty());
  RadianceSums sums(plan);
  RadianceParts parts(plan);
  sums.divide(&parts);
  std::vector<float> throughput(plan.stride, 1.0f);
  const BandTable ones(1.0f, 3);
  const std::vector<std::string> groups{"light:background", "light:key", "light:E"},
      views{"class:direct", "class:reflection", "class:refraction"},
      arrivals{"direct", "indirect", "caustic"};
  for (std::uint32_t s = 0; s < 50; ++s) {
    sums.clear();
    parts.clear();
    for (int i = 0; i < 9; ++i) {
      sums.classify(static_cast<View>(i % 3), static_cast<Arrival>(i / 3));
      const int source = i % 4 == 0 ? Plan::kBackground : plan.light_source(i % 3u);
      const auto factor = static_cast<float>(std::exp2(-5.0 * i) * (1.0 + 0.37 * s));
      sums.add(source, {throughput.data(), {0, 3}}, ones, factor);
    }
    layers.add(film.add({0, 0, s, true}, sums.color(), {}), sums.color(), parts);
    for (std::size_t value = 0; value < 3; ++value) {
      const std::int64_t beauty = film.layer(film.find(kBeauty).value()).sum(0, value);
      REQUIRE(beauty > 0);
      REQUIRE(sum_of(film, groups, value) == beauty);
      REQUIRE(sum_of(film, views, value) == beauty);
      REQUIRE(sum_of(film, arrivals, value) == beauty);
    }
  }
  for (const auto& names : {groups, views, arrivals})
    for (const std::string& name : names) {
      CAPTURE(name);
      CHECK(film.layer(film.find(name).value()).sum(0, 1) > 0);
    }
}

TEST_CASE("a part does not depend on which others are asked for") {
  const auto key_of = [](const std::string& asked) {
    const Plan plan = plan_of(asked);
    Film film = film_of(plan);
    PartLayers layers(plan, film);
    RadianceSums sums(plan);
    RadianceParts parts(plan);
    sums.divide(&parts);
    std::vector<float> throughput(plan.stride, 0.3f);
    sums.add(Plan::kBackground, {throughput.data(), {0, 3}}, BandTable(1.0f, 3), 0.7f);
    sums.add(plan.light_source(0), {throughput.data(), {0, 3}}, BandTable(1.0f, 3), 1.3f);
    layers.add(film.add({0, 0, 0, true}, sums.color(), {}), sums.color(), parts);
    return film.layer(film.find("light:key").value()).sum(0, 1);
  };
  CHECK(key_of("light:key") == key_of("light:*,direct"));
}

TEST_CASE("a sample that the beauty refuses is refused in all parts") {
  const Plan plan = plan_of("light:*");
  Film film = film_of(plan);
  PartLayers layers(plan, film);
  RadianceSums sums(plan);
  RadianceParts parts(plan);
  sums.divide(&parts);
  std::vector<float> throughput(plan.stride, 1.0f);
  sums.add(plan.light_source(0), {throughput.data(), {0, 3}}, BandTable(1.0f, 3), 1.0f);
  const Xyz broken{1.0, std::nan(""), 1.0};
  layers.add(film.add({0, 0, 0, true}, broken, {}), broken, parts);
  for (std::size_t value = 0; value < 3; ++value)
    CHECK(film.layer(film.find("light:key").value()).sum(0, value) == 0);
}

TEST_CASE("a splat is rounded by one number in the beauty and in its part of each kind") {
  const Plan plan = plan_of("light:*,class:*,direct,indirect,caustic");
  Film film = film_of(plan);
  PartLayers layers(plan, film);
  for (int i = 0; i < 100; ++i) {
    const double u = std::fmod(0.618 * i, 1.0);
    const Xyz color = Xyz{0.3, 0.2, 0.7} * (plan.quantum * (1.0 + 0.01 * i));
    const SplatPart part{1 + i % 2, View::direct,
                         i % 3 == 0 ? Arrival::indirect : Arrival::caustic};
    film.add_splat(0, 0, color, {}, u);
    layers.splat(0, 0, color, {}, part, u);
  }
  for (std::size_t value = 0; value < 3; ++value) {
    const std::int64_t beauty = film.layer(film.find(kSplats).value()).sum(0, value);
    CHECK(beauty > 0);
    CHECK(sum_of(film, {"light:key.splats", "light:E.splats", "light:background.splats"}, value) ==
          beauty);
    CHECK(sum_of(film, {"class:direct.splats"}, value) == beauty);
    CHECK(sum_of(film, {"indirect.splats", "caustic.splats"}, value) == beauty);
  }
}
