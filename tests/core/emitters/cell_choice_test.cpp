#include "core/emitters/cell_choice.h"

#include "tests/catch.h"

#include <cmath>

using namespace abbe;

// Over an even grid of numbers each cell comes as often as its part of the weights says, but for
// the grid's cells at its edges.
TEST_CASE("cells are chosen in proportion to their weights") {
  const std::vector<double> weights{1.0, 0.0, 2.0, 0.5, 0.0, 0.0, 0.0, 0.0, 4.0, 0.25, 0.25, 0.0};
  const CellChoice choice(weights, 4);
  CHECK(choice.total() == 8.0);
  constexpr int kSteps = 512;
  std::vector<double> counts(weights.size());
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const auto c = choice.choose({(i + 0.5) / kSteps, (j + 0.5) / kSteps});
      REQUIRE((c.row < 3 && c.column < 4));
      REQUIRE((c.inside.x >= 0.0 && c.inside.x < 1.0 && c.inside.y >= 0.0 && c.inside.y < 1.0));
      counts[c.row * 4 + c.column] += 1.0 / (kSteps * kSteps);
    }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    CHECK(counts[i] == Approx(weights[i] / 8.0).margin(2.0 / kSteps));
    if (weights[i] == 0.0) {
      CHECK(counts[i] == 0.0);
    }
  }
}

TEST_CASE("the ends of the numbers give cells that have a weight") {
  const CellChoice choice({0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 3);
  for (const double u : {0.0, 0.5, 1.0 - 0x1p-53})
    for (const double v : {0.0, 1.0 - 0x1p-53}) {
      const auto c = choice.choose({u, v});
      CHECK((c.row == 0 && c.column == 1));
      CHECK(c.inside.x == Approx(u).margin(1e-12));
      CHECK(c.inside.y == Approx(v).margin(1e-12));
    }
}
