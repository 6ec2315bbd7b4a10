#include "core/film/merge_films.h"
#include "tests/catch.h"

#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace abbe;

namespace {

constexpr PixelWindow kWindow{3, 5, 6, 7};
constexpr std::uint32_t kSamples = 24;

std::vector<LayerForm> forms() {
  std::vector<LayerForm> layers =
      beauty_layers({.quantum = 0x1p-40, .bands = 2, .errors = true, .splats = true});
  layers.push_back({.name = "height", .kind = LayerKind::value, .quantum = 0x1p-20});
  layers.push_back({.name = "object", .kind = LayerKind::ids});
  return layers;
}

/// A film with those of some random samples that `takes` says yes to.
Film film_of(const std::function<bool(std::uint32_t index)>& takes) {
  Film film(kWindow, forms());
  std::mt19937 random(3);
  std::uniform_real_distribution<float> value(0.0f, 1.0f);
  for_each_pixel(kWindow, [&](int x, int y) {
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      const std::vector<float> radiance{value(random), value(random)};
      const Xyz color{value(random), value(random), i == 7 ? -1.0 : value(random)}; // one refused
      const double height = value(random) - 0.5;
      const auto object = static_cast<std::uint32_t>(3.0f * value(random));
      if (!takes(i)) continue;
      const Film::Place place = film.count({x, y, i, i % 3 == 0});
      if (film.add(*film.find("beauty"), place, color))
        film.add(*film.find("bands"), place, radiance);
      film.add(*film.find("height"), place, height);
      film.add_id(*film.find("object"), place, object);
      film.add_splat(x, y, color, radiance, 0.5);
    }
  });
  for (std::uint32_t i = 0; i < kSamples; ++i)
    if (takes(i)) film.add_light_passes(1.0 / 8.0);
  return film;
}

void check_same(const Film& a, const Film& b) {
  CHECK(a.light_passes() == b.light_passes());
  CHECK(a.refused().not_finite == b.refused().not_finite);
  CHECK(a.refused().negative == b.refused().negative);
  CHECK(a.refused().overflow == b.refused().overflow);
  for_each_pixel(kWindow, [&](int x, int y) {
    REQUIRE(a.samples(x, y) == b.samples(x, y));
    REQUIRE(a.covered_samples(x, y) == b.covered_samples(x, y));
    REQUIRE(a.strata(x, y) == b.strata(x, y));
    REQUIRE(a.color(x, y) == b.color(x, y));
    REQUIRE(a.radiance(x, y, 1) == b.radiance(x, y, 1));
    REQUIRE(a.signed_error(x, y) == b.signed_error(x, y));
    const std::size_t pixel = kWindow.index(x, y);
    REQUIRE(a.layer(*a.find("height")).sum(pixel) == b.layer(*b.find("height")).sum(pixel));
    REQUIRE(a.layer(*a.find("object")).ids().of(pixel) ==
            b.layer(*b.find("object")).ids().of(pixel));
  });
}

std::string refusal(Film a, const Film& b) {
  try {
    merge(a, b);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("films of parts of the samples merge into the film of all, in any order") {
  const Film whole = film_of([](std::uint32_t) { return true; });
  CHECK(whole.samples(3, 5) == kSamples);
  CHECK(whole.strata(3, 5) == PixelStrata{16, 16});
  // Where a part ends, before a power of two, at one and behind it, and parts that interlock.
  for (const std::uint32_t cut : {0u, 1u, 5u, 8u, 12u, 16u, 17u, 20u, 23u}) {
    INFO(cut);
    const auto early = [&](std::uint32_t i) { return i < cut; };
    const auto late = [&](std::uint32_t i) { return i >= cut; };
    Film forwards = film_of(early), backwards = film_of(late);
    merge(forwards, film_of(late));
    merge(backwards, film_of(early));
    check_same(forwards, whole);
    check_same(backwards, whole);
  }
  Film thirds = film_of([](std::uint32_t i) { return i % 3 == 2; });
  merge(thirds, film_of([](std::uint32_t i) { return i % 3 == 0; }));
  merge(thirds, film_of([](std::uint32_t i) { return i % 3 == 1; }));
  check_same(thirds, whole);
}

TEST_CASE("films that do not fit are not merged, and it is said why") {
  const auto film = [](const std::function<void(std::vector<LayerForm>&)>& change) {
    std::vector<LayerForm> layers = forms();
    change(layers);
    return Film(kWindow, layers);
  };
  const auto same = [&] { return film([](auto&) {}); };
  const std::string begin = "these films cannot be merged: ";
  CHECK(refusal(same(), same()).empty());
  CHECK(refusal(same(), Film({3, 5, 6, 8}, forms())) ==
        begin + "one shows the pixels 3 5 6 7, the other 3 5 6 8");
  CHECK(refusal(same(), film([](auto& l) { l.pop_back(); })) ==
        begin + "one has 6 layers, the other 5");
  CHECK(refusal(same(), film([](auto& l) { l[4].name = "depth"; })) ==
        begin + "one has a layer height where the other has depth");
  CHECK(refusal(same(), film([](auto& l) { l[4].quantum = 0.5; })) ==
        begin + "their layers height count in steps of 9.5367431640625e-07 and 0.5");
  CHECK(refusal(same(), film([](auto& l) { l[1].bands = 3; })) ==
        begin + "their layers bands are not of one form");
  CHECK(refusal(same(), film([](auto& l) { l[0].strata = false; })) ==
        begin + "their layers beauty are not of one form");
}

// 2^62 and 2^62 quanta are one more than fit.
TEST_CASE("sums that would overflow by merging stay as they are, and it is counted") {
  Film a({0, 0, 1, 1}, 1.0, 0), b({0, 0, 1, 1}, 1.0, 0);
  a.add({0, 0, 0, true}, {0x1p62, 1.0, 0.0}, {});
  b.add({0, 0, 1, true}, {0x1p62, 3.0, 0.0}, {});
  merge(a, b);
  CHECK(a.refused().overflow == 1);
  CHECK(a.color(0, 0).x == 0x1p61);
  CHECK(a.color(0, 0).y == 2.0);
}
