#include "core/adaptive/noise.h"
#include "tests/catch.h"

#include <cmath>
#include <limits>

using namespace abbe;

namespace {

Film film_of_two(int width) {
  return {{4, 6, 4 + width, 7}, 0x1p-40, 0, true};
}

} // namespace

// Pixel 0: means 1 and errors 0.5. Pixel 1: X alone, 3 +- 1. The mean of all six values is 1.
TEST_CASE("the relative error is that of its formula") {
  Film film = film_of_two(2);
  film.add({4, 6, 0, true}, {0.5, 0.5, 0.5}, {});
  film.add({4, 6, 1, true}, {1.5, 1.5, 1.5}, {});
  film.add({5, 6, 0, true}, {2.0, 0.0, 0.0}, {});
  film.add({5, 6, 1, true}, {4.0, 0.0, 0.0}, {});
  CHECK(relative_error(film, film.window()) ==
        Approx(std::sqrt((3.0 * 0.25 / 1.01 + 1.0 / 9.01) / 6.0)).epsilon(1e-9));
  CHECK(relative_error(film, {4, 6, 5, 7}) == Approx(std::sqrt(0.25 / 1.01)).epsilon(1e-9));
  // One pixel of 3 values whose mean is 1.
  CHECK(relative_error(film, {5, 6, 6, 7}) == Approx(std::sqrt(1.0 / 9.01 / 3.0)).epsilon(1e-9));
}

TEST_CASE("black has no error, a sample alone an unknown one") {
  Film film = film_of_two(2);
  film.add({4, 6, 0, true}, {0.0, 0.0, 0.0}, {});
  film.add({4, 6, 1, true}, {0.0, 0.0, 0.0}, {});
  CHECK(relative_error(film, {4, 6, 5, 7}) == 0.0);
  film.add({5, 6, 0, true}, {1.0, 1.0, 1.0}, {});
  CHECK(relative_error(film, film.window()) == std::numeric_limits<double>::infinity());
  film.add({5, 6, 1, true}, {1.0, 1.0, 1.0}, {});
  CHECK(relative_error(film, film.window()) == 0.0);
}

TEST_CASE("samples are counted over the window") {
  Film film = film_of_two(3);
  for (std::uint32_t i = 0; i < 4; ++i)
    film.add({5, 6, i, true}, {1.0, 1.0, 1.0}, {});
  for (std::uint32_t i = 0; i < 5; ++i)
    film.add({6, 6, i, true}, {1.0, 1.0, 1.0}, {});
  const SampleCounts counts = sample_counts(film);
  CHECK(counts.least == 0);
  CHECK(counts.most == 5);
  CHECK(counts.mean == Approx(3.0));
}
