#include "bench/measurements/image_error.h"
#include "tests/catch.h"

#include <cmath>

using namespace abbe;
using namespace abbe::bench;

namespace {

double square_of(double v) {
  return v * v;
}

} // namespace

TEST_CASE("relMSE by hand") {
  // Reference mean (1+1+1 + 3+3+3) / 6 = 2, so the floor is 0.04. One value of six is off by 0.1:
  // 0.01 / (1 + 0.04) / 6.
  const std::vector<LinearRgb> reference{{1, 1, 1}, {3, 3, 3}};
  const std::vector<LinearRgb> picture{{1.1, 1, 1}, {3, 3, 3}};
  CHECK(relative_mse(picture, reference) == Approx(0.01 / 1.04 / 6.0));
}

TEST_CASE("relMSE does not depend on the exposure") {
  const std::vector<LinearRgb> reference{{0.2, 0.5, 0.1}, {0.0, 0.3, 0.9}};
  const std::vector<LinearRgb> picture{{0.25, 0.4, 0.1}, {0.1, 0.3, 0.7}};
  std::vector<LinearRgb> brighter_reference = reference, brighter = picture;
  for (auto* image : {&brighter_reference, &brighter})
    for (LinearRgb& c : *image)
      c = {8 * c.r, 8 * c.g, 8 * c.b};
  CHECK(relative_mse(brighter, brighter_reference) == Approx(relative_mse(picture, reference)));
}

TEST_CASE("an image equal to its reference has no error") {
  const std::vector<Xyz> reference{{0.2, 0.3, 0.1}, {0.9, 1.0, 1.1}};
  const ImageError error = image_error(reference, reference);
  CHECK(error.rel_mse == 0.0);
  CHECK(error.rmse_xyz == 0.0);
  CHECK(error.mean_delta_e == 0.0);
  CHECK(error.delta_e_95 == 0.0);
}

TEST_CASE("RMSE in XYZ by hand") {
  // One of two pixels is off by (0.3, 0, 0.4): sqrt(0.25 / 6).
  const std::vector<Xyz> reference{{0.2, 0.3, 0.1}, {0.5, 0.5, 0.5}};
  const std::vector<Xyz> picture{{0.5, 0.3, 0.5}, {0.5, 0.5, 0.5}};
  CHECK(image_error(picture, reference).rmse_xyz == Approx(std::sqrt(0.25 / 6.0)));
}

TEST_CASE("the colour difference of greys is that of their lightness") {
  // Both neutral under D65: dE = dL / S_L, S_L = 1 + 0.015 (L - 50)^2 / sqrt(20 + (L - 50)^2) with
  // L the mean of the two lightnesses [SWD05].
  const auto grey = [](double y) { return to_xyz(kSrgbWhite, y); };
  const auto lightness = [](double y) { return 116.0 * std::cbrt(y) - 16.0; };
  const double a = lightness(0.3), b = lightness(0.4);
  const double off = square_of(0.5 * (a + b) - 50.0);
  const double expected = (b - a) / (1.0 + 0.015 * off / std::sqrt(20.0 + off));
  const ImageError error = image_error({grey(0.3), grey(0.2)}, {grey(0.4), grey(0.2)});
  CHECK(error.mean_delta_e == Approx(expected / 2.0).epsilon(1e-6));
  CHECK(error.delta_e_95 == Approx(0.95 * expected).epsilon(1e-6));
}

TEST_CASE("quantiles lie between the sorted values") {
  CHECK(quantile({3.0, 1.0, 2.0}, 0.0) == 1.0);
  CHECK(quantile({3.0, 1.0, 2.0}, 0.5) == 2.0);
  CHECK(quantile({3.0, 1.0, 2.0}, 0.75) == 2.5);
  CHECK(quantile({3.0, 1.0, 2.0}, 1.0) == 3.0);
  CHECK(quantile({7.0}, 0.95) == 7.0);
}

TEST_CASE("the noise of bands by hand") {
  // Band 0: differences 0.1 and 0 over 1 and 2: 0.01 / 5. Band 1: 0.5 over 1: 0.25. Band 2 is
  // black.
  const auto film = [](const std::vector<std::vector<float>>& pixels) {
    Film result({0, 0, 2, 1}, 0x1p-40, 3);
    for (int x = 0; x < 2; ++x)
      result.add({x, 0, 0, true}, {1.0, 1.0, 1.0}, pixels[static_cast<std::size_t>(x)]);
    return result;
  };
  const Film reference = film({{1.0f, 1.0f, 0.0f}, {2.0f, 0.0f, 0.0f}});
  const Film picture = film({{1.1f, 1.5f, 0.0f}, {2.0f, 0.0f, 0.5f}});
  CHECK(band_noise(picture, reference) == Approx((0.01 / 5.0 + 0.25) / 2.0).epsilon(1e-6));
}

TEST_CASE("a pixel has changed with its colour, its coverage or one band") {
  const auto film = [](double y, bool covered, float band) {
    Film result({0, 0, 2, 1}, 0x1p-40, 2);
    result.add({0, 0, 0, true}, {0.1, 0.2, 0.3}, std::vector{1.0f, 2.0f});
    result.add({1, 0, 0, covered}, {0.1, y, 0.3}, std::vector{1.0f, band});
    return result;
  };
  const Film usual = film(0.5, true, 2.0f);
  CHECK(changed_pixels(usual, film(0.5, true, 2.0f)) == 0);
  CHECK(changed_pixels(usual, film(0.5 + 0x1p-40, true, 2.0f)) == 1);
  CHECK(changed_pixels(usual, film(0.5, false, 2.0f)) == 1);
  CHECK(changed_pixels(usual, film(0.5, true, 2.0f + 0x1p-22f)) == 1);
}
