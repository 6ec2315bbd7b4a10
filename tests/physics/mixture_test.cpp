// A mixture sends each sample to one of its parts, so with parts of known light the share of
// samples is known: it is binomial, or better where the samples are stratified.

#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>

using namespace abbe;

namespace {

constexpr int kSide = 8, kSamples = 64, kCount = kSide * kSide * kSamples;

/// The mean over an image filled by a square whose parts are seen as 0.8 and 0, or others.
double mean(const std::string& integrator, const std::string& materials) {
  const std::string light =
      integrator == "path" ? "background E 1 " : "shadows none light E 0 0 1 0 ";
  const Rendering r = test::render_scene(
      test::scene_from("integrator " + integrator + " eye 0 0 4 lookAt 0 0 0 fieldOfView 5 " +
                       "imageSize 8 8 samples 64 filter box bands 3 " + light + materials +
                       " square"),
      false);
  double sum = 0.0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      sum += r.film.color(x, y).y;
  return sum / (kSide * kSide);
}

const std::string kParts = "ambient 0 0 0 diffuse 0.8 0.8 0.8 defMaterial white "
                           "diffuse 0 0 0 defMaterial black ";

} // namespace

TEST_CASE("a mixture of white and black reflects the white's share") {
  for (const char* integrator : {"path", "whitted"}) {
    double chi2 = 0.0;
    for (const double share : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0}) {
      INFO(integrator << " " << share);
      const double part =
          mean(integrator, kParts + "mix white black " + std::to_string(share)) / 0.8;
      const double variance = share * (1.0 - share) / kCount;
      if (variance == 0.0) {
        CHECK(part == Approx(share).epsilon(1e-5));
        continue;
      }
      const double z = (part - share) / std::sqrt(variance);
      CHECK(std::abs(z) < 5.0);
      chi2 += z * z;
    }
    CHECK(chi2 < 24.0); // four degrees of freedom: exceeded once in 10^4
  }
}

TEST_CASE("mixtures may be mixed") {
  // 0.5 (0.25 white + 0.75 black) + 0.5 white
  for (const char* integrator : {"path", "whitted"}) {
    const double part = mean(integrator, kParts + "mix white black 0.25 defMaterial grey "
                                                  "mix grey white 0.5") /
                        0.8;
    CHECK(std::abs(part - 0.625) < 5.0 * std::sqrt(0.625 * 0.375 / kCount));
  }
}

TEST_CASE("all bands go to the same part") {
  const Rendering r = test::render_scene(
      test::scene_from("integrator path background E 1 eye 0 0 4 lookAt 0 0 0 fieldOfView 5 "
                       "imageSize 16 16 samples 1 filter box bands 9 " +
                       kParts + "mix white black 0.5 square"),
      true);
  int white = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const double first = r.film.radiance(x, y, 0);
      CHECK((first == 0.0 || first == Approx(0.8)));
      for (int b = 1; b < 9; ++b)
        CHECK(r.film.radiance(x, y, b) == Approx(first));
      white += first > 0.0;
    }
  CHECK(std::abs(white - 128) < 5 * 8); // 256 throws of a coin
}

// Each of the pane's two faces lets through 0.5 of half its light and all of the other half, and
// nothing of that is left to chance. Without Fresnel and at index 1, straight shadow rays are
// exact.
TEST_CASE("a straight shadow ray is weakened by a mixture's mean") {
  const Rendering r = test::render_scene(
      test::scene_from("eye 3 0 4 lookAt 0 0 0 fieldOfView 0.0001 imageSize 1 1 samples 1 bands 1 "
                       "light E 0 0 9 0 "
                       "ambient 0 0 0 diffuse 0.8 0.8 0.8 square "
                       "diffuse 0 0 0 fresnel off transparency 1 defMaterial clear "
                       "transparency 0.5 defMaterial dim mix clear dim 0.5 "
                       "translate 0 0 1 scale 0.5 0.5 0.1 cube"),
      false);
  CHECK(r.film.color(0, 0).y == Approx(0.8 * 0.75 * 0.75).epsilon(1e-5));
}

TEST_CASE("dust on glass stops its share of the light") {
  // Two faces; glass of index 1 is not seen. Black dust covers a quarter of each.
  const Rendering r = test::render_scene(
      test::scene_from("integrator path background E 1 eye 0 0 4 lookAt 0 0 0 fieldOfView 5 "
                       "imageSize 8 8 samples 64 filter box bands 1 diffuse 0 0 0 ambient 0 0 0 "
                       "defMaterial dust fresnel off transparency 1 defMaterial clear "
                       "mix clear dust 0.75 scale 1 1 0.1 cube"),
      false);
  double sum = 0.0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      sum += r.film.color(x, y).y / (kSide * kSide);
  const double through = 0.75 * 0.75;
  CHECK(std::abs(sum - through) < 5.0 * std::sqrt(through * (1.0 - through) / kCount));
}

// Light comes to the floor through a slab of glass, and so does the sight: photons are looked up.
// Parts are chosen by the camera's paths alone; were they by light paths too, half would count as a
// quarter.
TEST_CASE("caustics on a mixture are as bright as on the mean of its parts") {
  const auto brightness = [](const std::string& floor) {
    const Rendering r = test::render_scene(
        test::scene_from("integrator path light E 0.3 0 1 0 eye 0 0 6 lookAt 0 0 0 fieldOfView 4 "
                         "imageSize 8 8 samples 64 bands 3 filter box " +
                         kParts + floor + " plane glass N-BK7 translate 0 0 1 scale 2 2 0.1 cube"),
        false);
    double sum = 0.0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        sum += r.film.color(x, y).y;
    return sum / (kSide * kSide);
  };
  const double mixed = brightness("mix white black 0.5"), mean = brightness("diffuse 0.4 0.4 0.4");
  CHECK(mean > 0.2); // 0.4 times the cosine and two boundaries' transmittance, twice
  // The photons are the same; of the camera's samples a half, by chance, sees them.
  CHECK(std::abs(mixed / mean - 1.0) < 5.0 / std::sqrt(kCount));
}
