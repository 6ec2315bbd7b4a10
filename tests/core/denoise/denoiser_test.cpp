#include "core/denoise/denoiser.h"

#include "tests/catch.h"

#include <cmath>
#include <numeric>
#include <random>

using namespace abbe;

namespace {

using Plane = DenoiseGuide::Plane;

constexpr int kWidth = 40, kHeight = 30;
constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;

Plane plane(const auto& value_at) {
  Plane result;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      result.push_back(static_cast<float>(value_at(x, y)));
  return result;
}

Plane random_plane(unsigned seed, double mean, double deviation) {
  std::mt19937 numbers(seed); // its numbers are the same everywhere, those of distributions are not
  return plane([&](int, int) {
    double sum = -6.0; // of twelve numbers: its variance is 1
    for (int i = 0; i < 12; ++i)
      sum += static_cast<double>(numbers()) * 0x1p-32;
    return mean + deviation * sum;
  });
}

/// Two halves with independent noise on top of what the picture is.
DenoiseGuide noisy(const Plane& truth, double deviation) {
  DenoiseGuide guide{kWidth, kHeight, {}, {}, {}};
  for (unsigned c = 0; c < 3; ++c) {
    const Plane a = random_plane(2 * c, 0.0, deviation),
                b = random_plane(2 * c + 1, 0.0, deviation);
    for (std::size_t i = 0; i < kPixels; ++i) {
      guide.color[c].push_back(truth[i] + (a[i] + b[i]) / 2.0f);
      guide.noise[c].push_back((a[i] - b[i]) / 2.0f);
    }
  }
  return guide;
}

double sum(const Plane& plane) {
  return std::accumulate(plane.begin(), plane.end(), 0.0);
}

double squared_error(const Plane& plane, const Plane& truth) {
  double error = 0.0;
  for (std::size_t i = 0; i < plane.size(); ++i)
    error += std::pow(static_cast<double>(plane[i]) - static_cast<double>(truth[i]), 2);
  return error;
}

} // namespace

// Columns of the weights add up to 1 as rows do. Sums are rounded to 2^-24 of about 1 per pixel.
TEST_CASE("no channel loses or wins light when noise is taken out") {
  const Denoiser denoiser(noisy(plane([](int x, int) { return x < 20 ? 1.0 : 3.0; }), 0.5));
  const std::vector<Plane> channels{
      random_plane(7, 2.0, 1.0), random_plane(8, 0.0, 100.0),
      plane([](int x, int y) { return x == 9 && y == 9 ? 1e4 : 0.; })};
  const std::vector<Plane> filtered = denoiser.filtered(channels);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    double all = 0.0;
    for (const float value : channels[i])
      all += std::abs(static_cast<double>(value));
    CHECK(std::abs(sum(filtered[i]) - sum(channels[i])) < 1e-6 * all);
  }
  CHECK(filtered[2][9 * kWidth + 9] < 0.2f * channels[2][9 * kWidth + 9]);
}

TEST_CASE("bands that add up to a colour still do when noise is taken out") {
  const Denoiser denoiser(noisy(plane([](int, int) { return 1.0; }), 0.3));
  const Plane a = random_plane(11, 1.0, 0.5), b = random_plane(12, 2.0, 0.5);
  Plane both;
  for (std::size_t i = 0; i < kPixels; ++i)
    both.push_back(0.25f * a[i] + 2.0f * b[i]);
  const std::vector<Plane> filtered = denoiser.filtered({a, b, both});
  for (std::size_t i = 0; i < kPixels; ++i)
    REQUIRE(filtered[2][i] == Approx(0.25f * filtered[0][i] + 2.0f * filtered[1][i]).epsilon(1e-5));
}

// A mean over n independent values has an n-th of their variance. Of the 121 pixels in reach most
// are mixed; 10 is far below that, and far above what a filter that does nothing gives.
TEST_CASE("noise on an even surface is taken out") {
  const Plane truth = plane([](int, int) { return 1.0; });
  const DenoiseGuide guide = noisy(truth, 0.3);
  const Plane filtered = Denoiser(guide).filtered({guide.color.begin(), guide.color.end()}).front();
  CHECK(squared_error(filtered, truth) < 0.1 * squared_error(guide.color[0], truth));
}

TEST_CASE("a picture without noise stays as it is") {
  DenoiseGuide guide{kWidth, kHeight, {}, {}, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    guide.color[c] = random_plane(static_cast<unsigned>(c), 100.0, 10.0);
    guide.noise[c].assign(kPixels, 0.0f);
  }
  const std::vector<Plane> filtered =
      Denoiser(guide).filtered({guide.color.begin(), guide.color.end()});
  for (std::size_t i = 0; i < kPixels; ++i)
    REQUIRE(filtered[1][i] == Approx(guide.color[1][i]).epsilon(1e-3));
}

// The step is a third of the noise, so that colours alone would not keep it.
TEST_CASE("light does not go over an edge that a layer shows") {
  DenoiseGuide guide = noisy(plane([](int x, int) { return x < 17 ? 1.0 : 1.1; }), 0.3);
  guide.features.push_back(plane([](int x, int) { return x < 17 ? 0.0 : 10.0; }));
  const auto left = [](const Plane& of) {
    double light = 0.0;
    for (std::size_t i = 0; i < kPixels; ++i)
      light += i % kWidth < 17 ? static_cast<double>(of[i]) : 0.0;
    return light;
  };
  const Plane with = Denoiser(guide).filtered({guide.color[0]}).front();
  CHECK(left(with) == Approx(left(guide.color[0])).epsilon(1e-6));
  const Plane before = guide.color[0];
  guide.features.clear();
  const Plane without = Denoiser(guide).filtered({before}).front();
  CHECK(std::abs(left(without) - left(before)) > 1e-4 * left(before));
}

TEST_CASE("rows that are filtered alone are those of the whole picture") {
  const DenoiseGuide guide = noisy(plane([](int x, int y) { return x + y; }), 5.0);
  const Denoiser denoiser(guide);
  const Plane whole = denoiser.filtered({guide.color[2]}).front();
  const DenoiseWeights weights = denoiser.weights({21, 24});
  CHECK(weights.sources().first == 21 - Denoiser::kReach);
  Plane rows(3 * kWidth);
  weights.apply(guide.color[2].data() + weights.sources().first * kWidth, rows.data());
  for (std::size_t i = 0; i < rows.size(); ++i)
    REQUIRE(rows[i] == whole[21 * kWidth + i]);
}
