// Sums of very many samples against exact ones, at the film's interface.

#include "core/film/film.h"
#include "tests/catch.h"

#include <cmath>
#include <functional>
#include <random>

using namespace abbe;

namespace {

/// That of a scene whose brightest light is 1.
constexpr double kQuantum = 0x1p-36;
constexpr std::uint32_t kSamples = 1'000'000;

Film film_of(const std::function<double(std::uint32_t)>& value) {
  Film film({0, 0, 1, 1}, kQuantum, 0);
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const double v = value(i);
    film.add({0, 0, i, true}, {v, v, v}, {});
  }
  return film;
}

} // namespace

// A sample is rounded to a whole number of quanta, so its error, and that of any mean, is at most
// half a quantum: 7e-12 of the brightest light. For values that differ errors are independent, and
// their mean is sqrt(1 / 12 / n) of a quantum.
TEST_CASE(
    "the mean of a million samples is right to half a quantum, or far less where they differ") {
  for (const double constant :
       {1.0, 1.0 / 3.0, 1e-6, 1e-10, 0.4999 * kQuantum, 0.5001 * kQuantum}) {
    const Film film = film_of([&](std::uint32_t) { return constant; });
    CAPTURE(constant);
    CHECK(std::abs(film.color(0, 0).y - constant) <= 0.5 * kQuantum);
  }
  std::mt19937_64 random(5);
  for (const double scale : {100.0, 1.0, 1e-5, 1e-9}) { // the last: 69 quanta
    std::uniform_real_distribution<double> values(0.0, scale);
    long double exact = 0.0L;
    const Film film = film_of([&](std::uint32_t) {
      const double v = values(random);
      exact += v;
      return v;
    });
    CAPTURE(scale);
    const double error = film.color(0, 0).y - static_cast<double>(exact / kSamples);
    // Five standard deviations; above that the last place of a double.
    CHECK(std::abs(error) < 5.0 * kQuantum * std::sqrt(1.0 / 12.0 / kSamples) + 4e-16 * scale);
  }
}

// 2^63 quanta are 2^27 times the brightest light.
TEST_CASE("a sum has room for a million samples of a hundred times the brightest light") {
  const Film film = film_of([](std::uint32_t) { return 100.0; });
  CHECK(film.refused().overflow == 0);
  CHECK(film.color(0, 0).y == 100.0);
  // More is refused, and counted; the sum stays what it was.
  const Film full = film_of([](std::uint32_t) { return 200.0; });
  CHECK(full.refused().overflow > 0);
  CHECK(full.color(0, 0).y < 200.0);
  CHECK(full.color(0, 0).y > 134.0);
}

// Four million light paths, of which each brings so little that it is a part of a quantum. It is
// rounded up with the chance of that part, so the sum is right in the mean, and its standard
// deviation is the square root of the number of quanta in it.
TEST_CASE("light paths that bring a thousandth of a quantum each lose nothing") {
  constexpr int kPaths = 4'000'000;
  for (const double part : {0.5, 1e-3, 1e-6}) {
    Film film({0, 0, 1, 1}, beauty_layers({.quantum = kQuantum, .splats = true}));
    film.add_light_passes(1.0);
    std::mt19937_64 random(11);
    const double value = part * kQuantum;
    for (int i = 0; i < kPaths; ++i)
      film.add_splat(0, 0, {value, value, value}, {},
                     static_cast<double>(random() >> 11) * 0x1p-53);
    const double expected = part * kPaths; // in quanta
    CAPTURE(part);
    CHECK(std::abs(film.color(0, 0).y / kQuantum - expected) <
          5.0 * std::sqrt(expected * (1.0 - part)));
  }
}

// 2^-36 of the brightest light is a picture's range within one sample: 22 stops below a display's
// darkest step. What is darker than half of that is black, however many samples there are.
TEST_CASE(
    "light of 1e+30 leaves no room for light of 1e-30 in one picture, but for that of 1e+20") {
  Film film({0, 0, 4, 1}, std::ldexp(1.0, std::ilogb(1e30) - 36), 0);
  const double values[] = {1e30, 1e20, 1e18, 1e-30};
  for (int x = 0; x < 4; ++x)
    film.add({x, 0, 0, true}, {values[x], values[x], values[x]}, {});
  CHECK(film.color(0, 0).y == Approx(1e30).epsilon(1e-10));
  CHECK(film.color(1, 0).y == Approx(1e20).epsilon(0.05));
  CHECK(film.color(2, 0).y == 0.0);
  CHECK(film.color(3, 0).y == 0.0);
}
