#include "core/film/film.h"
#include "core/film/merge_films.h"
#include "tests/catch.h"

#include <array>
#include <limits>
#include <vector>

using namespace abbe;

namespace {

LayerForm value_layer(const char* name, double quantum, LayerMean mean = LayerMean::samples) {
  return {.name = name, .kind = LayerKind::value, .quantum = quantum, .mean = mean};
}

} // namespace

TEST_CASE("a film holds the layers that were asked for, by name") {
  const Film film({0, 0, 2, 2}, {value_layer("depth", 0x1p-20),
                                 {.name = "object", .kind = LayerKind::ids},
                                 {.name = "light", .kind = LayerKind::bands, .bands = 5}});
  CHECK(film.layer_count() == 3);
  REQUIRE(film.find("object"));
  CHECK(film.layer(*film.find("object")).form().kind == LayerKind::ids);
  REQUIRE(film.find("light"));
  CHECK(film.layer(*film.find("light")).form().values() == 5);
  CHECK_FALSE(film.find("normal"));
  CHECK_FALSE(film.keeps_errors());
}

TEST_CASE("the beauty is made of layers, splats and bands where they are asked for") {
  const auto names = [](const BeautyForm& form) {
    std::vector<std::string> result;
    for (const LayerForm& layer : beauty_layers(form))
      result.push_back(layer.name);
    return result;
  };
  using Names = std::vector<std::string>;
  CHECK(names({}) == Names{"beauty"});
  CHECK(names({.bands = 3}) == Names{"beauty", "bands"});
  CHECK(names({.bands = 3, .splats = true}) ==
        Names{"beauty", "bands", "beauty.splats", "bands.splats"});
  CHECK_FALSE(beauty_layers({})[0].strata);
  CHECK(beauty_layers({.errors = true})[0].strata);
}

// 0.3 is 1.2 quarters and 4.8 sixteenths.
TEST_CASE("each layer rounds to its own quantum, and values may be negative") {
  Film film({0, 0, 1, 1}, {value_layer("coarse", 0.25), value_layer("fine", 0.0625)});
  const LayerId coarse = *film.find("coarse"), fine = *film.find("fine");
  const Film::Place place = film.count({0, 0, 0, true});
  for (const LayerId id : {coarse, fine}) {
    CHECK(film.add(id, place, 0.3));
    CHECK(film.add(id, place, -0.3));
    CHECK(film.add(id, place, -0.3));
  }
  CHECK(film.layer(coarse).sum(0) == -1);
  CHECK(film.layer(fine).sum(0) == -5);
  CHECK(film.mean(coarse, 0, 0) == -0.25);
  CHECK(film.mean(fine, 0, 0) == -0.3125);
  CHECK(film.refused().negative == 0);
  CHECK_FALSE(film.add(coarse, place, std::numeric_limits<double>::quiet_NaN()));
  CHECK_FALSE(film.add(coarse, place, -1e30));
  CHECK(film.refused().not_finite == 1);
  CHECK(film.refused().overflow == 1);
  CHECK(film.mean(coarse, 0, 0) == -0.25);
}

TEST_CASE("a layer's mean is over all samples, those that are covered, or light passes") {
  Film film({0, 0, 1, 1},
            {value_layer("all", 1.0), value_layer("met", 1.0, LayerMean::covered_samples),
             value_layer("light", 1.0, LayerMean::light_passes)});
  for (const char* name : {"all", "met", "light"})
    CHECK(film.mean(*film.find(name), 0, 0) == 0.0); // of nothing
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Film::Place place = film.count({0, 0, i, i == 0});
    for (const char* name : {"all", "met", "light"})
      film.add(*film.find(name), place, 2.0);
  }
  film.add_light_passes(0.25);
  film.add_light_passes(0.25);
  CHECK(film.mean(*film.find("all"), 0, 0) == 2.0);
  CHECK(film.mean(*film.find("met"), 0, 0) == 8.0);
  CHECK(film.mean(*film.find("light"), 0, 0) == 16.0);
  CHECK(film.samples(0, 0) == 4);
  CHECK(film.covered_samples(0, 0) == 1);
}

TEST_CASE("a layer of colours keeps its first stratum, each its own") {
  LayerForm diffuse{.name = "diffuse", .quantum = 1.0, .strata = true};
  LayerForm direct{.name = "direct", .quantum = 1.0};
  Film film({0, 0, 1, 1}, {diffuse, direct});
  for (std::uint32_t i = 0; i < 6; ++i) { // 4 and 2 of them
    const Film::Place place = film.count({0, 0, i, true});
    CHECK(place.stratum == Stratum::second); // each is the last so far
    const double v = i + 1.0;
    film.add(*film.find("diffuse"), place, Xyz{v, 0.0, 2.0 * v});
    film.add(*film.find("direct"), place, Xyz{v, v, v});
  }
  const Layer& layer = film.layer(*film.find("diffuse"));
  CHECK(layer.first_sum(0, 0) == 10);
  CHECK(layer.first_sum(0, 1) == 0);
  CHECK(layer.first_sum(0, 2) == 20);
  CHECK(layer.sum(0, 0) == 21);
  CHECK(film.layer(*film.find("direct")).sum(0, 1) == 21);
  CHECK(film.count({0, 0, 3, true}).stratum == Stratum::first);
}

TEST_CASE("splats are rounded up in proportion to what is above a whole quantum") {
  Film film({0, 0, 1, 1}, beauty_layers({.quantum = 1.0, .splats = true}));
  constexpr int kSplatCount = 1000;
  for (int i = 0; i < kSplatCount; ++i)
    film.add_splat(0, 0, {0.25, 1.0, 2.5}, {}, (i + 0.5) / kSplatCount);
  film.add_light_passes(kSplatCount);
  CHECK(film.color(0, 0).x == 0.25);
  CHECK(film.color(0, 0).y == 1.0);
  CHECK(film.color(0, 0).z == Approx(2.5).margin(2.0 / kSplatCount));
}

TEST_CASE("the nearest of samples' values stays, whatever their order and the film they came by") {
  const LayerForm form{
      .name = "depth", .kind = LayerKind::nearest, .quantum = 0.25, .mean = LayerMean::samples};
  const auto film_of = [&](const std::vector<double>& values) {
    Film film({0, 0, 1, 1}, {form});
    for (const double value : values)
      film.add(*film.find("depth"), film.count({0, 0, 0, true}), value);
    return film;
  };
  const LayerId id = *film_of({}).find("depth");
  CHECK_FALSE(film_of({}).layer(id).nearest(0));
  CHECK(film_of({3.0, 1.5, 7.0}).mean(id, 0, 0) == 1.5);
  CHECK(film_of({7.0, 0.0}).layer(id).nearest(0) == 0.0);
  Film merged = film_of({3.0});
  merge(merged, film_of({}));
  CHECK(merged.mean(id, 0, 0) == 3.0);
  merge(merged, film_of({2.25, 9.0}));
  CHECK(merged.mean(id, 0, 0) == 2.25);
  Film refuses = film_of({-1.0, std::numeric_limits<double>::quiet_NaN()});
  CHECK_FALSE(refuses.layer(id).nearest(0));
  CHECK(refuses.refused().not_finite == 1);
}

// A million pixels: colours take 24 million bytes, nine bands 72 million, and values 8.
TEST_CASE("large layers beside the picture go to files together, and bands one by one") {
  const std::size_t pixels = 1'000'000;
  std::vector<LayerForm> layers = beauty_layers({.bands = 9, .errors = true});
  layers.push_back({.name = "light:a"});
  layers.push_back({.name = "light:b"});
  layers.push_back({.name = "object", .kind = LayerKind::ids});
  layers.push_back(transparency_layer());
  using Flags = std::vector<bool>;
  const auto places = [&](std::size_t largest, const char* folder = "/tmp") {
    return layer_places(layers, pixels, {folder, largest});
  };
  CHECK(places(80'000'000).in_file == Flags{false, false, false, false, false, false});
  CHECK(places(70'000'000).in_file == Flags{false, true, false, false, false, false});
  CHECK(places(47'000'000).in_file == Flags{false, true, true, true, false, false});
  CHECK(places(1, "").in_file == Flags{false, false, false, false, false, false});
  CHECK(places(1).resident == FileBackedSums::kResidentBytes / 3);
}
