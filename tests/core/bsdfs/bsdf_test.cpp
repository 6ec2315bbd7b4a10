// Tests that hold for every type of the set.

#include "tests/catch.h"
#include "tests/core/bsdfs/bsdf_surface.h"

#include <cmath>

using namespace abbe;

using test::kOneOfEach;
using test::Surface;

TEST_CASE("there is a scene for each BSDF of the set") {
  CHECK(kOneOfEach.size() == std::variant_size_v<Bsdf>);
  std::size_t index = 0;
  for (const std::string& text : kOneOfEach)
    CHECK(Surface(text).bsdf().index() == index++);
}

TEST_CASE("no BSDF sends more light along single rays than it gets") {
  for (const std::string& text : kOneOfEach)
    for (const double cosine : {1.0, 0.6, 0.2, 0.01}) {
      CAPTURE(text, cosine);
      Surface s(text);
      s.in.wo = {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
      specular_factors(s.bsdf(), s.in, {s.reflected.data(), s.transmitted.data()});
      for (const float light : s.reflected)
        CHECK(light >= 0.0f);
      for (std::size_t b = 0; b < 5; ++b)
        CHECK(s.reflected[b] + s.transmitted[b] <= 1.0f + 1e-6f);
    }
}

TEST_CASE("straight rays pass only BSDFs that transmit light or let it pass") {
  for (const std::string& text : kOneOfEach) {
    CAPTURE(text);
    Surface s(text);
    std::vector<float> light(s.plan.stride, 1.0f);
    pass_straight(s.bsdf(), s.in, light.data());
    const BsdfFacts facts = facts_of(s.bsdf());
    for (std::size_t b = 0; b < 5; ++b)
      CHECK((light[b] > 0.0f) == (facts.transmits || facts.passes));
  }
}

TEST_CASE("a specular BSDF evaluates to 0 and samples nothing") {
  for (const std::string& text : kOneOfEach) {
    CAPTURE(text);
    Surface s(text);
    s.in.wo = {0.6, 0.0, 0.8};
    std::fill(s.f_cos.begin(), s.f_cos.end(), 7.0f);
    const double pdf = evaluate(s.bsdf(), s.in, {-0.6, 0.0, 0.8}, s.f_cos.data());
    const BsdfFacts facts = facts_of(s.bsdf());
    const bool scatters = facts.rough || facts.coats || !facts.goes_on();
    CHECK((pdf > 0.0) == scatters);
    CHECK(sample(s.bsdf(), s.in, {0.3, 0.4}, {0.2, 0.5}).has_value() == scatters);
    for (std::size_t b = 0; b < 5; ++b)
      CHECK((s.f_cos[b] > 0.0f) == scatters);
  }
}
