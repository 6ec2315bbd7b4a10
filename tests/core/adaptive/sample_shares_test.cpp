#include "core/adaptive/pixel_quarter.h"
#include "core/adaptive/sample_shares.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace abbe;

namespace {

constexpr int kWidth = 60, kHeight = 40;
constexpr PixelWindow kWindow{7, 3, 7 + kWidth, 3 + kHeight};

using Value = std::function<double(int, int)>;

/// Two samples in each pixel, `color` of -d and of d: the estimated error is what d makes.
Film film_of(const std::function<LinearRgb(int, int, double)>& color, const Value& d) {
  Film film(kWindow, 0x1p-40, 0, true);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (const std::uint32_t i : {0u, 1u})
        film.add({kWindow.x0 + x, kWindow.y0 + y, i, true},
                 to_xyz(color(x, y, i == 0 ? -d(x, y) : d(x, y))), {});
  return film;
}

/// The same of greys: the white of sRGB has R = G = B.
Film greys(const Value& grey, const Value& d) {
  return film_of(
      [&](int x, int y, double v) {
        const double c = grey(x, y) * (1.0 + v);
        return LinearRgb{c, c, c};
      },
      d);
}

double one(int, int) {
  return 1.0;
}

bool left(int x) {
  return x < kWidth / 2;
}

/// 3 for each of two samples: they cost 4.
std::vector<std::uint32_t> equal_rays() {
  return std::vector<std::uint32_t>(kWindow.pixel_count(), 6);
}

/// The mean share over columns [first, last) without what is added to each. (Shares are dithered by
/// numbers whose mean is 1.)
double share_of(const std::vector<float>& shares, int first, int last) {
  double sum = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = first; x < last; ++x)
      sum += shares[static_cast<std::size_t>(y * kWidth + x)];
  return sum / ((last - first) * kHeight) - kSmallestShare;
}

/// How many times the share of the left half that of the right one is, away from their border.
double right_over_left(const std::vector<float>& shares) {
  return share_of(shares, 32, kWidth) / share_of(shares, 0, 28);
}

} // namespace

TEST_CASE("each pixel is in a quarter, and none of its neighbours is in the same") {
  for (int y = 4; y < 8; ++y)
    for (int x = 4; x < 8; ++x) {
      REQUIRE(quarter_of(x, y) < kQuarters);
      for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i)
          CHECK((quarter_of(i, j) == quarter_of(x, y)) == (i == x && j == y));
    }
  std::vector<int> visits(kWindow.pixel_count());
  for (std::size_t quarter = 0; quarter < kQuarters; ++quarter)
    for (int y = kWindow.y0; y < kWindow.y1; ++y)
      for_each_in_row(kWindow, quarter, y, [&](int x) {
        REQUIRE(x >= kWindow.x0);
        REQUIRE(x < kWindow.x1);
        REQUIRE(quarter_of(x, y) == quarter);
        ++visits[kWindow.index(x, y)];
      });
  CHECK(std::ranges::all_of(visits, [](int n) { return n == 1; }));
}

TEST_CASE("shares are in proportion to the error") {
  const Film film = greys(one, [](int x, int) { return left(x) ? 0.05 : 0.2; });
  CHECK(right_over_left(find_shares(film, equal_rays())) == Approx(4.0).epsilon(0.02));
}

// The same error of a grey 100. The mean is 50.5, 0.01 m^2 = 25.5: variances in proportion to
// 1 / 26.5 and 1 / 10025.5. (Without the second term as 1 to 0.01.)
TEST_CASE("errors count in relation to the pixel and to the picture's mean") {
  const auto grey = [](int x, int) { return left(x) ? 1.0 : 100.0; };
  const Film film = greys(grey, [&](int x, int y) { return 0.2 / grey(x, y); });
  CHECK(right_over_left(find_shares(film, equal_rays())) ==
        Approx(std::sqrt(26.5 / 10025.5)).epsilon(0.05));
}

TEST_CASE("what costs four times as much gets half the share") {
  const Film film = greys(one, [](int x, int y) { return (x / 4 + y / 4) % 2 == 0 ? 0.02 : 0.2; });
  std::vector<std::uint32_t> rays(kWindow.pixel_count());
  for (std::size_t i = 0; i < rays.size(); ++i)
    rays[i] = left(static_cast<int>(i) % kWidth) ? 2 : 14; // and one more each: 2 and 8
  CHECK(right_over_left(find_shares(film, rays)) == Approx(0.5).epsilon(0.05));
}

// A red that is 0.2 in green and blue, where errors are large in relation. The mean is 1.4 / 3,
// 0.01 m^2 = 0.00218: sqrt(1.00218 / 0.04218) = 4.87 times the share.
TEST_CASE("errors are those of linear red, green and blue") {
  const Film film = film_of(
      [](int x, int, double v) {
        return left(x) ? LinearRgb{1.0 + v, 0.2, 0.2} : LinearRgb{1.0, 0.2 + v, 0.2};
      },
      [](int, int) { return 0.04; });
  CHECK(right_over_left(find_shares(film, equal_rays())) == Approx(4.87).epsilon(0.02));
}

// On the left red and green err in opposite ways, on the right in the same: the squares are equal.
// Quiet stripes let shares be of use.
TEST_CASE("errors keep their signs on the way from XYZ to red, green and blue") {
  const Film film = film_of(
      [](int x, int, double v) { return LinearRgb{0.5 + v, 0.5 + (left(x) ? -v : v), 0.5}; },
      [](int, int y) { return y / 4 % 2 == 0 ? 0.004 : 0.04; });
  CHECK(right_over_left(find_shares(film, equal_rays())) == Approx(1.0).epsilon(0.03));
}

// Checks of eight pixels, 1 and 3, without noise: next to a border a pixel's neighbours have a
// variance of samples though none of their own. Within them the share is the least there is.
TEST_CASE("neighbours that differ show an edge") {
  const Film film =
      greys([](int x, int y) { return (x / 8 + y / 8) % 2 == 0 ? 1.0 : 3.0; },
            [](int x, int y) { return (x % 8 % 7 == 0 || y % 8 % 7 == 0) ? 0.1 : 0.0; });
  const auto shares = find_shares(film, equal_rays());
  const auto at = [&](int x, int y) { return shares[static_cast<std::size_t>(y * kWidth + x)]; };
  CHECK(at(16, 20) > 2.0 * kSmallestShare); // at a border between columns 15 and 16
  CHECK(at(16, 20) > at(19, 20));
}

// Six by six pixels. Those beside them have seen some of it, those far from it nothing.
TEST_CASE("noise draws samples to its surroundings alone, and not all") {
  const auto in = [](int x, int y) { return x >= 24 && x < 30 && y >= 18 && y < 24; };
  const Film film = greys([&](int x, int y) { return in(x, y) ? 1e4 : 1.0; },
                          [&](int x, int y) { return in(x, y) ? 0.99 : 0.01; });
  const auto shares = find_shares(film, equal_rays());
  const auto at = [&](int x, int y) { return shares[static_cast<std::size_t>(y * kWidth + x)]; };
  CHECK(at(26, 20) >= 0.9 * (kLargestShare + kSmallestShare));
  CHECK(*std::ranges::max_element(shares) <= 1.1 * (kLargestShare + kSmallestShare));
  CHECK(at(5, 5) <= 1.2 * kSmallestShare);
  CHECK(at(5, 5) >= 0.9 * kSmallestShare);
}

// Its neighbours are quiet. Samples in proportion to what neighbours show would be wrong for it, so
// all get the same; and what it has shown itself may not count.
TEST_CASE("one bright sample by chance decides nothing") {
  const auto in = [](int x, int y) { return x == 30 && y == 20; };
  const Film film = greys([&](int x, int y) { return in(x, y) ? 1e4 : 1.0; },
                          [&](int x, int y) { return in(x, y) ? 0.99 : 0.01; });
  const auto shares = find_shares(film, equal_rays());
  CHECK(shares[20 * kWidth + 30] <= 1.1f * (1.0f + static_cast<float>(kSmallestShare)));
  CHECK(shares[20 * kWidth + 31] == 0.0f);
}

// With errors a and b of two halves, of mean 1, samples in proportion to a + 0.35 and b + 0.35
// leave 1.35 (a^2 / (a + 0.35) + b^2 / (b + 0.35)) / (a^2 + b^2) of the squared error of equal
// numbers: 0.92 for 0.7 and 1.3, and 0.87 for 0.6 and 1.4.
TEST_CASE("shares that promise less than a tenth of the error are not worth their noise") {
  const auto shares = [](double a, double b) {
    const Film film = greys(one, [&](int x, int) { return 0.1 * (left(x) ? a : b); });
    return find_shares(film, equal_rays());
  };
  for (const float share : shares(0.7, 1.3))
    REQUIRE(share == 0.0f);
  for (const float share : shares(0.6, 1.4))
    REQUIRE(share > 0.0f);
}

TEST_CASE("where there is no noise at all there are no shares") {
  const Film still = greys(one, [](int, int) { return 0.0; });
  const Film black = greys([](int, int) { return 0.0; }, [](int, int) { return 0.0; });
  for (const Film* film : {&still, &black})
    for (const float share : find_shares(*film, equal_rays()))
      REQUIRE(share == 0.0f);
}

TEST_CASE("a single pixel has no neighbours, and no share") {
  Film film({4, 9, 5, 10}, 0x1p-40, 0, true);
  for (const std::uint32_t i : {0u, 1u})
    film.add({4, 9, i, true}, {i + 0.0, i + 0.0, i + 0.0}, {});
  CHECK(find_shares(film, std::vector<std::uint32_t>{2}) == std::vector<float>{0.0f});
}

// What decides is the layer without the light of photon maps, where there is one.
TEST_CASE("the evidence decides, not the beauty") {
  Film film(kWindow, beauty_layers({.quantum = 0x1p-40, .errors = true, .evidence = true}));
  for_each_pixel(kWindow, [&](int x, int y) {
    for (const std::uint32_t i : {0u, 1u}) {
      const auto value = [&](double d) {
        const double c = 1.0 + (i == 0 ? -d : d);
        return to_xyz(LinearRgb{c, c, c});
      };
      const bool on_left = left(x - kWindow.x0);
      const Film::Place place = film.add({x, y, i, true}, value(on_left ? 0.5 : 0.01), {});
      film.add(*film.find(kEvidence), place, value(on_left ? 0.05 : 0.2));
    }
  });
  CHECK(right_over_left(find_shares(film, equal_rays())) == Approx(4.0).epsilon(0.02));
}
