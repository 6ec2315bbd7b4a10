// Every type of the set at the limits of its parameters, of angles and of random numbers: nothing
// is infinite or no number, no light is made, and where nothing is absorbed none is lost.

#include "tests/catch.h"
#include "tests/core/bsdfs/bsdf_surface.h"
#include "tests/core/scattering/directions.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

using namespace abbe;
using test::direction;
using test::Surface;

namespace {

std::string glass(double index, const std::string& more = "") {
  return fmt::format("defaultMaterials diffuse 0 0 0 reflectivity 1 transparency 1 speedOfLight "
                     "{:.17g} {} cube",
                     index, more);
}

/// Indices equal to that of the air, nearly so, below it and far above.
const std::vector<double> kIndices = {1.0,        1.0 + 1e-15, 1.0 - 1e-15, 1.0 + 1e-12,
                                      1.0 + 1e-9, 1.0 - 1e-9,  1.0 + 1e-6,  1.0 + 1e-3,
                                      1.0 - 1e-3, 0.5,         1.5,         4.0};

/// Materials that neither make nor take light.
std::vector<std::string> clear_materials() {
  std::vector<std::string> all;
  for (const double n : kIndices) {
    all.push_back(glass(n));
    for (const double thickness : {1e-9, 0.1, 300.0, 1e6})
      all.push_back(glass(n, fmt::format("thinFilm {} 1.38", thickness)));
    if (n > 1.0) all.push_back(fmt::format("thinGlass 3 {:.17g} square", n));
  }
  return all;
}

/// The others: rough ones, metals, coats and panes that absorb.
std::vector<std::string> other_materials() {
  std::vector<std::string> all = test::kOneOfEach;
  for (const double roughness : {0.01, std::nextafter(0.01, 0.0), std::nextafter(0.01, 1.0),
                                 std::nextafter(1.0, 0.0), 1.0}) {
    const std::string rough = fmt::format("roughness {:.17g}", roughness);
    for (const double n : {1.0 + 1e-15, 1.0 - 1e-15, 1.0 + 1e-9, 1.001, 0.5, 1.5, 4.0})
      all.push_back(glass(n, rough));
    all.push_back("metal Au " + rough + " cube");
    all.push_back("reflectivity 1 " + rough + " cube");
    all.push_back("diffuse 1 1 1 coat 1.5 " + rough + " cube");
  }
  for (const double coat : {1.0, 1.0 + 1e-15, 1.0 + 1e-9, 4.0})
    all.push_back(fmt::format("diffuse 1 1 1 coat {:.17g} cube", coat));
  all.push_back("thinGlass 3 1.5 absorption 0 square");
  all.push_back("thinGlass 3 1.5 absorption 1e9 square");
  all.push_back("thinGlass 1000 1.5 absorption 1e9 square");
  return all;
}

const std::vector<double> kCosines = {1.0, std::nextafter(1.0, 0.0), 0.5, 1e-3, 1e-8, 1e-20, 1e-170,
                                      0.0};

/// Both factors of all bands for light of flux; those that a type does not fill are 0.
void find_factors(Surface& s, double cosine) {
  s.in.wo = {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
  std::fill(s.reflected.begin(), s.reflected.end(), 0.0f);
  std::fill(s.transmitted.begin(), s.transmitted.end(), 0.0f);
  specular_factors(s.bsdf(), s.in, {s.reflected.data(), s.transmitted.data()});
}

} // namespace

TEST_CASE("clear boundaries lose no light at any limit: R + T = 1") {
  for (const std::string& text : clear_materials()) {
    Surface s(text);
    for (const bool from_inside : {false, true}) {
      if (from_inside) std::swap(s.in.n_before, s.in.n_after);
      for (const double cosine : kCosines) {
        CAPTURE(text, from_inside, cosine);
        find_factors(s, cosine);
        for (std::size_t b = 0; b < 5; ++b) {
          REQUIRE(s.reflected[b] >= 0.0f);
          REQUIRE(s.transmitted[b] >= 0.0f);
          REQUIRE(std::abs(s.reflected[b] + s.transmitted[b] - 1.0f) < 1e-6f);
        }
      }
    }
  }
}

TEST_CASE("no surface makes light, or numbers that are none, at any limit") {
  for (const std::string& text : other_materials()) {
    Surface s(text);
    for (const double cosine : kCosines) {
      CAPTURE(text, cosine);
      find_factors(s, cosine);
      for (std::size_t b = 0; b < 5; ++b) {
        REQUIRE(s.reflected[b] >= 0.0f);
        REQUIRE(s.transmitted[b] >= 0.0f);
        REQUIRE(s.reflected[b] + s.transmitted[b] < 1.0f + 1e-6f);
      }
      std::vector<float> light(s.plan.stride, 1.0f);
      pass_straight(s.bsdf(), s.in, light.data());
      for (std::size_t b = 0; b < 5; ++b) {
        REQUIRE(light[b] >= 0.0f);
        REQUIRE(light[b] < 1.0f + 1e-6f);
      }
    }
  }
}

TEST_CASE("what surfaces evaluate and sample is finite, at any limit of angles and numbers") {
  const double one = std::nextafter(1.0, 0.0);
  for (const std::string& text : other_materials()) {
    Surface s(text);
    for (const double cosine : {1.0, 0.5, 1e-3, 1e-8, 1e-20}) {
      CAPTURE(text, cosine);
      s.in.wo = {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
      const auto check = [&](const dvec3& wi) {
        const double pdf = evaluate(s.bsdf(), s.in, wi, s.f_cos.data());
        REQUIRE(std::isfinite(pdf));
        REQUIRE(pdf >= 0.0);
        for (std::size_t b = 0; b < 5; ++b) {
          REQUIRE(std::isfinite(s.f_cos[b]));
          REQUIRE(s.f_cos[b] >= 0.0f);
        }
        return pdf;
      };
      // Diffuse and coated surfaces are asked for directions above them alone.
      const BsdfFacts facts = facts_of(s.bsdf());
      for (const double to : {1.0, 0.5, 1e-3, 1e-8, 1e-20, -1e-20, -1e-8, -0.5, -1.0})
        for (const double phi : {0.0, 1.0, std::numbers::pi})
          if (to > 0.0 || facts.transmits) check(direction(to, phi));
      if (facts.transmits) check(-s.in.wo);
      for (const dvec2 u : {dvec2(0.0, 0.0), dvec2(0.0, one), dvec2(0.5, 0.5), dvec2(one, one)})
        for (const double lobe : {0.0, 0.3, 0.999, one})
          if (const auto wi = sample(s.bsdf(), s.in, u, {lobe, 0.5})) {
            CAPTURE(u.x, u.y, lobe);
            REQUIRE(std::abs(glm::length(*wi) - 1.0) < 1e-12);
            if (wi->z > 0.0 || facts.transmits) check(*wi);
          }
    }
  }
}

// Throughput is in single precision, where R and T add up to 1 but for half a last place, 3e-8. A
// thousand reflections at one angle repeat the same rounding; total reflection has none.
TEST_CASE("a thousand reflections inside glass keep all light") {
  Surface s(glass(1.5));
  std::swap(s.in.n_before, s.in.n_after);
  const double critical = std::sqrt(1.0 - 1.0 / (1.5 * 1.5));
  for (const double cosine : {1.0, 0.9, critical + 1e-3, critical + 1e-6, critical + 1e-9,
                              std::nextafter(critical, 1.0), critical, 0.5, 1e-6}) {
    CAPTURE(cosine);
    find_factors(s, cosine);
    float kept = 1.0f;
    double left = 0.0;
    for (int i = 0; i < 1000; ++i) {
      left += static_cast<double>(kept * s.transmitted[0]);
      kept *= s.reflected[0];
    }
    if (cosine < critical) CHECK(kept == 1.0f);
    CHECK(std::abs(left + static_cast<double>(kept) - 1.0) < 3e-5);
  }
}
