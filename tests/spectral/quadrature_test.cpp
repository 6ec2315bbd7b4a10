// How many bands a colour needs: 81 against the integral by 1 nm, coarser groups against 81.

#include "spectral/color_difference.h"
#include "spectral/color_space.h"
#include "spectral/gamut.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/spectral/expected.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace abbe;

namespace {

std::vector<Curve> patches() {
  const test::Expected table("colorchecker_ohta.csv");
  std::vector<Curve> list;
  for (int patch = 1; patch <= 24; ++patch)
    list.push_back(
        Curve::samples81(table.numbers((patch < 10 ? "p0" : "p") + std::to_string(patch))));
  return list;
}

/// The integral over 360-830 nm by 1 nm; the light from its own table, linear between its points,
/// 0 beyond. The reflectance is that of 380 and 780 nm beyond these. Scaled so that a perfect white
/// has Y = 1.
class FineIntegral {
public:
  explicit FineIntegral(const std::string& illuminant)
      : observer_(embedded_table("cie1931_2deg_1nm.csv")), nm_(observer_.numbers("nm")),
        x_(observer_.numbers("xbar")), y_(observer_.numbers("ybar")),
        z_(observer_.numbers("zbar")) {
    const DataTable table{embedded_table("illuminants/" + illuminant + ".csv")};
    light_ = Curve::table(table.numbers("nm"), table.numbers("spd"), Outside::zero);
    white_ = of(Curve::constant(1.0));
    light_ = light_.scaled(1.0 / white_.y);
    white_ = white_ * (1.0 / white_.y);
  }
  [[nodiscard]] Xyz of(const Curve& reflectance) const {
    Xyz sum;
    for (std::size_t i = 0; i < nm_.size(); ++i)
      sum += Xyz{x_[i], y_[i], z_[i]} * (light_.at(nm_[i]) * reflectance.at(nm_[i]));
    return sum;
  }
  [[nodiscard]] const Xyz& white() const { return white_; }

private:
  DataTable observer_;
  std::vector<double> nm_, x_, y_, z_;
  Curve light_;
  Xyz white_;
};

struct Spread {
  double mean = 0.0, max = 0.0;
};

/// A row of golden_quadrature.csv, each quadrature against its own white.
Spread expected_spread(const std::string& illuminant, const std::string& scheme, int groups) {
  static const test::Expected table("golden_quadrature.csv");
  for (int row = 0; row < table.row_count(); ++row)
    if (table.text(row, "chart") == "ohta" && table.text(row, "illuminant") == illuminant &&
        table.text(row, "scheme") == scheme && table.number(row, "groups") == groups)
      return {table.number(row, "dE_own_mean"), table.number(row, "dE_own_max")};
  throw std::runtime_error("no such row");
}

/// Differences over the chart of two ways to compute a colour.
template <class Seen, class Exact>
Spread spread(const Seen& seen, const Xyz& seen_white, const Exact& exact, const Xyz& exact_white) {
  Spread result;
  for (const Curve& patch : patches()) {
    const double difference =
        delta_e_2000(to_lab(seen(patch), seen_white), to_lab(exact(patch), exact_white));
    result.mean += difference / 24.0;
    result.max = std::max(result.max, difference);
  }
  return result;
}

/// What the renderer computes: light x observer folded exactly, reflectance at the band's centre.
Xyz at_centers(int bands, const Curve& light, const Curve& reflectance) {
  const BandGrid grid(bands);
  const auto weights = band_weights(grid, light);
  Xyz sum;
  for (int b = 0; b < bands; ++b)
    sum += weights[b] * reflectance.at(grid.center_nm(b));
  return sum;
}

Xyz of_means(int bands, const Curve& light, const Curve& reflectance) {
  const BandGrid grid(bands);
  const auto weights = band_weights(grid, light);
  const auto means = band_means(grid, reflectance);
  Xyz sum;
  for (int b = 0; b < bands; ++b)
    sum += weights[b] * means[b];
  return sum;
}

constexpr std::array kThesisLevels{1, 3, 9, 27, 81};

} // namespace

TEST_CASE("81 bands are the integral to dE2000 0.1 for every patch of the ColorChecker") {
  for (const std::string name : {"D65", "A", "FL2"}) {
    const FineIntegral fine(name);
    const Curve light = *find_illuminant(name);
    const Spread s =
        spread([&](const Curve& patch) { return to_xyz(light.times(patch)); }, to_xyz(light),
               [&](const Curve& patch) { return fine.of(patch); }, fine.white());
    INFO(name);
    CHECK(s.max < 0.1);
    const Spread expected = expected_spread(name, "5nm_vs_1nm_linear", 81);
    CHECK(s.mean == Approx(expected.mean).epsilon(0.1));
    CHECK(s.max == Approx(expected.max).epsilon(0.1));
  }
}

TEST_CASE("Coarser groups err as computed independently") {
  for (const std::string name : {"D65", "A", "FL2"})
    for (const int bands : {27, 9, 3, 1}) {
      const Curve light = *find_illuminant(name);
      const Xyz white = to_xyz(light);
      const auto exact = [&](const Curve& patch) { return to_xyz(light.times(patch)); };
      const auto check = [&](const Spread& s, const std::string& scheme) {
        INFO(name << ' ' << scheme << ' ' << bands);
        const Spread expected = expected_spread(name, scheme, bands);
        CHECK(s.mean == Approx(expected.mean).epsilon(0.1));
        CHECK(s.max == Approx(expected.max).epsilon(0.1));
      };
      check(spread([&](const Curve& patch) { return at_centers(bands, light, patch); }, white,
                   exact, white),
            "refl_centre_light_exact");
      check(spread([&](const Curve& patch) { return of_means(bands, light, patch); }, white, exact,
                   white),
            "refl_mean_light_exact");
    }
}

TEST_CASE("Figure 7: the total colour does not darken with the number of rays") {
  // A white is the same at 1, 3, 9, 27 and 81 bands. For other colours the sums differ by
  // quadrature alone, to both sides: 81 bands are never darker than fewer by more than it is wrong,
  // 0.2 % of the whole chart and 1 % of the figure's patch 14 (the thesis lost 42 % of its green).
  for (const std::string name : {"E", "D65", "A", "FL2"}) {
    const Curve light = *find_illuminant(name);
    const std::vector<Curve> chart = patches();
    const auto total = [&](int bands) {
      double sum = 0.0;
      for (const Curve& patch : chart)
        sum += at_centers(bands, light, patch).y;
      return sum;
    };
    for (const int bands : kThesisLevels) {
      INFO(name << ' ' << bands);
      CHECK(at_centers(bands, light, Curve::constant(1.0)).y ==
            Approx(to_xyz(light).y).epsilon(1e-13));
      CHECK(total(81) > 0.998 * total(bands));
      CHECK(at_centers(81, light, chart[13]).y > 0.99 * at_centers(bands, light, chart[13]).y);
    }
    for (const Curve& patch : chart) {
      const double exact = at_centers(81, light, patch).y;
      CHECK(at_centers(27, light, patch).y == Approx(exact).epsilon(0.01));
      CHECK(at_centers(9, light, patch).y == Approx(exact).epsilon(0.10));
    }
  }
}

TEST_CASE("Figure 7: what darkened the thesis's green was the scaling of each ray by itself") {
  // Patch 14 in equal-energy light on an NTSC monitor. Each group's colour has X + Y + Z = 1, is
  // brought into gamut by itself and counts by its share. Expected: the row "ohta, E, NTSC, B, xyz"
  // of an independent reproduction; the thesis printed green 1.0000,
  // 0.7786, 0.6376, 0.5850, 0.5825.
  const std::array<LinearRgb, 5> expected{{{0.4429, 1.0000, 0.1902},
                                           {0.3920, 0.8487, 0.2431},
                                           {0.4476, 0.7131, 0.2274},
                                           {0.4212, 0.6439, 0.2350},
                                           {0.4269, 0.6421, 0.2349}}};
  const ColorSpace ntsc = find_color_space("ntsc").value();
  const Xyz white = to_xyz(ntsc.white, ntsc.white.y); // X + Y + Z = 1
  const Matrix3 to_xyz_of_rgb = multiply(rgb_to_xyz_matrix(ntsc.primaries, ntsc.white),
                                         diagonal({white.y, white.y, white.y}));
  const Matrix3 to_rgb = inverse(to_xyz_of_rgb);
  const auto weights = band_weights(BandGrid(81), patches()[13]);
  double unscaled_green = 0.0;
  for (std::size_t level = 0; level < kThesisLevels.size(); ++level) {
    const int groups = kThesisLevels[level];
    Vector3 scaled{}, linear{};
    double total = 0.0;
    for (int g = 0; g < groups; ++g) {
      Xyz group;
      for (int b = g * 81 / groups; b < (g + 1) * 81 / groups; ++b)
        group += weights[b];
      const double sum = group.x + group.y + group.z;
      const Vector3 rgb = multiply(to_rgb, Vector3{group.x / sum, group.y / sum, group.z / sum});
      const LinearRgb mapped =
          map_to_gamut({rgb[0], rgb[1], rgb[2]}, GamutMapping::scale, to_xyz_of_rgb[1]);
      scaled = {scaled[0] + sum * mapped.r, scaled[1] + sum * mapped.g, scaled[2] + sum * mapped.b};
      linear[1] += sum * rgb[1];
      total += sum;
    }
    INFO(groups);
    CHECK(scaled[0] / total == Approx(expected[level].r).margin(2e-4));
    CHECK(scaled[1] / total == Approx(expected[level].g).margin(2e-4));
    CHECK(scaled[2] / total == Approx(expected[level].b).margin(2e-4));
    if (level == 0) unscaled_green = linear[1] / total;
    CHECK(linear[1] / total == Approx(unscaled_green).epsilon(1e-12)); // ours: scaled after the sum
  }
}
