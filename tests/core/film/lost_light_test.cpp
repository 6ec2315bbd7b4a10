#include "core/film/lost_light.h"
#include "tests/catch.h"

#include <cmath>

using namespace abbe;

namespace {

Film film_with_losses(int width, bool splats) {
  std::vector<LayerForm> layers = beauty_layers({.quantum = 0x1p-30, .splats = splats});
  for (LayerForm& layer : lost_light_layers(0x1p-30, splats))
    layers.push_back(std::move(layer));
  return {{0, 0, width, 1}, std::move(layers)};
}

void add(Film& film, int x, std::uint32_t index, double y, double lost) {
  const Film::Place place = film.add({x, 0, index, true}, {y, y, y}, {});
  film.add(*film.find(kLost), place, lost_light(lost, 0x1p-30));
}

} // namespace

// Pixel 0 has a mean of 3 and lost 8 in one of 4 samples, pixel 1 a mean of 5 and lost 2 in one of
// two: means of 2 and 1, with errors of 8 / 4 and 2 / 2.
TEST_CASE("the share of light that a limit has taken, with its error, is known from its samples") {
  Film film = film_with_losses(2, false);
  for (std::uint32_t i = 0; i < 4; ++i)
    add(film, 0, i, 3.0, i == 2 ? 8.0 : 0.0);
  for (std::uint32_t i = 0; i < 2; ++i)
    add(film, 1, i, 5.0, i == 0 ? 2.0 : 0.0);
  const auto lost = lost_share(film);
  REQUIRE(lost);
  CHECK(lost->share == Approx(3.0 / 11.0));
  CHECK(lost->error == Approx(std::sqrt(4.0 + 1.0) * 8.0 / (11.0 * 11.0)));
  CHECK(film.color(0, 0).y == 3.0); // the image has none of it
}

TEST_CASE("lost splats count by light passes") {
  Film film = film_with_losses(1, true);
  add(film, 0, 0, 3.0, 0.0);
  film.add_light_passes(2.0);
  film.splat(*film.find(kLostSplats), 0, 0, lost_light(4.0, 0x1p-30), 0.5);
  const auto lost = lost_share(film);
  REQUIRE(lost);
  CHECK(lost->share == Approx(2.0 / 5.0));
  CHECK(lost->error == Approx(2.0 * 3.0 / 25.0));
}

TEST_CASE("without a limit, and without light, no share is told") {
  CHECK_FALSE(lost_share(Film({0, 0, 1, 1}, 1.0, 0)));
  CHECK_FALSE(lost_share(film_with_losses(1, false)));
}
