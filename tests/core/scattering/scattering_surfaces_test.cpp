// Scattering with rough, coated and mixed materials: what is sampled has the pdf that is told,
// and lossless surfaces keep all light.

#include "core/planning/make_plan.h"
#include "core/scattering/scattering.h"
#include "tests/catch.h"
#include "tests/core/scattering/directions.h"
#include "tests/render_text.h"

#include <numeric>

using namespace abbe;

namespace {

constexpr int kBands = 9;

Plan planned(const std::string& text) {
  const Scene scene = test::scene_from("integrator path background E 1 bands 9 " + text);
  return make_plan(scene, scene.settings);
}

/// A surface of a plan's first material, met from above at an angle. Of the bands every one, or
/// each `stride`-th, is alive.
class Surface {
public:
  Surface(const Plan& plan, double cos_o, Transport transport, int stride = 1)
      : plan_(plan), wavelengths_(plan_), scattering_(plan_, transport), throughput_(plan_.stride),
        f_(plan_.stride) {
    for (int b = 0; b < kBands; b += stride)
      throughput_[static_cast<std::size_t>(b)] = 1.0f;
    wavelengths_.begin_path(0.5);
    hit_.point = dvec3(0.0);
    hit_.normal = hit_.shading_normal = {0.0, 0.0, 1.0};
    hit_.entering = true;
    if (!plan_.media.empty()) hit_.medium_after = MediumId{0};
    scattering_.prepare(plan_.materials[0], plan_.materials[0].diffuse, hit_,
                        -test::direction(cos_o, 0.4), {throughput_.data(), {0, kBands}},
                        wavelengths_);
  }
  [[nodiscard]] Scattering& scattering() { return scattering_; }
  double evaluate(const dvec3& wi) { return scattering_.evaluate(wi, f_.data()); }
  [[nodiscard]] double f(int b) const {
    return static_cast<double>(f_[static_cast<std::size_t>(b)]);
  }
  [[nodiscard]] std::optional<dvec3> sample(const dvec2& u, const dvec2& lobe) {
    const auto sample = scattering_.sample(u, lobe, f_.data());
    if (!sample) return std::nullopt;
    return sample->direction;
  }

private:
  const Plan& plan_;
  PathWavelengths wavelengths_;
  Scattering scattering_;
  Hit hit_;
  std::vector<float> throughput_, f_;
};

/// Reflected and refracted rays as they are, nonspecular light by sampling: the part of the light
/// of one band that goes on.
double goes_on(const Plan& plan, double cos_o, int band) {
  Surface surface(plan, cos_o, Transport::flux);
  double sum = 0.0;
  const Scattering& s = surface.scattering();
  for (const double u : {0.0, 1.0 - 1e-9}) { // the first and the last part
    const auto choice = s.choose(u);
    if (choice.kind == ScatterKind::reflect) sum += static_cast<double>(s.reflected()[band]);
    if (choice.kind == ScatterKind::refract) sum += static_cast<double>(s.transmitted()[band]);
    if (s.certain()) break;
  }
  if (!s.has_nonspecular()) return sum;
  const double chance = s.choose(0.0).chance; // of the nonspecular part
  constexpr int kCount = 8000;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double scattered = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const dvec3 u = test::lattice_point(i);
    if (const auto wi = surface.sample({u.x, u.y}, {u.z, uniform(random)})) {
      const double pdf = surface.evaluate(*wi);
      scattered += surface.f(band) / pdf * chance;
    }
  }
  return sum + scattered / kCount;
}

} // namespace

TEST_CASE("lossless rough, filmed and coated surfaces pass all light on") {
  for (const std::string text :
       {"glass N-BK7 roughness 0.3 cube", "glass SF11 roughness 0.8 cube",
        "diffuse 0 0 0 ambient 0 0 0 reflectivity 1 roughness 0.7 cube",
        "metal Al fresnel off roughness 1 cube", "glass SF11 thinFilm 150 1.38 cube",
        "diffuse 1 1 1 coat 1.5 cube", "diffuse 1 1 1 coat SF11 roughness 0.4 cube"}) {
    const Plan plan = planned(text);
    for (const double cos_o : {0.95, 0.5, 0.15})
      for (const int band : {0, 8}) {
        INFO(text << ' ' << cos_o << ' ' << band);
        CHECK(goes_on(plan, cos_o, band) == Approx(1.0).margin(0.006));
      }
  }
}

TEST_CASE("without compensation rough surfaces lose light") {
  CHECK(goes_on(planned("metal Al fresnel off roughness 1 compensation off cube"), 0.8, 0) < 0.8);
  CHECK(goes_on(planned("glass N-BK7 roughness 1 compensation off cube"), 0.5, 0) < 0.8);
}

TEST_CASE("mixed materials are sampled with the pdf they tell, by live bands") {
  for (const std::string text :
       {"glass SF11 dispersionScale 8 roughness 0.6 cube",
        "glass SF11 roughness 0.6 diffuse 0.3 0.2 0.1 specular 0.2 0.2 0.2 specularExponent 9 cube",
        "metal Au roughness 0.7 diffuse 0.4 0.4 0.4 cube", "diffuse 0.5 0.1 0.1 coat 1.5 cube",
        "diffuse 0.5 0.1 0.1 coat 1.6 roughness 0.6 cube",
        "diffuse 0.5 0.5 0.5 reflectivity 0.5 roughness 0.6 cube"}) {
    const Plan plan = planned(text);
    for (const double cos_o : {0.9, 0.35})
      for (const int stride : {1, 3}) {
        INFO(text << ' ' << cos_o << ' ' << stride);
        Surface surface(plan, cos_o, Transport::radiance, stride);
        REQUIRE(surface.scattering().has_nonspecular());
        const double chance = surface.scattering().choose(0.0).chance;
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        CHECK(test::deviation_from_density(
                  [&](const dvec2& u, double choice) {
                    return surface.sample(u, {choice, uniform(random)});
                  },
                  [&](const dvec3& wi) { return surface.evaluate(wi) / chance; }, 40000) < 4.0);
      }
  }
}

TEST_CASE("a rough boundary between like media is none") {
  const Plan plan =
      planned("speedOfLight 1 transparency 1 reflectivity 1 diffuse 0 0 0 roughness 0.5 cube");
  Surface surface(plan, 0.7, Transport::radiance);
  const Scattering& scattering = surface.scattering();
  CHECK_FALSE(scattering.has_nonspecular());
  CHECK(scattering.choose(0.5).kind == ScatterKind::refract);
}

TEST_CASE("only glass scatters light through") {
  const auto through = [](const std::string& text) {
    const Plan plan = planned(text);
    return Surface(plan, 0.7, Transport::radiance).scattering().transmits_nonspecular();
  };
  CHECK(through("glass N-BK7 roughness 0.5 cube"));
  CHECK_FALSE(through("glass N-BK7 diffuse 1 1 1 cube"));
  CHECK_FALSE(through("metal Al roughness 0.5 cube"));
}

// Over all numbers each part is followed as often as the chance says by which it is weighed.
TEST_CASE("branches are followed with the chances that are told") {
  for (const char* text : {"glass SF11 cube", "diffuse 0.5 0.5 0.5 ambient 0 0 0 coat 1.5 cube"}) {
    const Plan plan = planned(text);
    Surface surface(plan, 0.4, Transport::radiance);
    const Scattering& s = surface.scattering();
    const Scattering::Choice last = s.choose(1.0 - 1e-9), first = s.choose(0.0);
    const double reflect = (first.kind == ScatterKind::reflect ? first : last).chance;
    for (const double eagerness : {0.0, 1.0, 2.0, 1.01 / reflect, 1000.0}) {
      CAPTURE(text, eagerness);
      constexpr int kNumbers = 10000;
      double reflected = 0.0, on = 0.0;
      int none = 0;
      for (int i = 0; i < kNumbers; ++i) {
        const auto branches = s.branch((i + 0.5) / kNumbers, eagerness);
        const bool goes_on = branches.on.kind != ScatterKind::none;
        if (branches.reflect_chance > 0.0) reflected += 1.0 / branches.reflect_chance / kNumbers;
        if (goes_on) on += 1.0 / branches.on.chance / kNumbers;
        none += branches.reflect_chance == 0.0 && !goes_on;
        if (eagerness * reflect > 1.0) CHECK(branches.reflect_chance == 1.0);
        if (eagerness <= 1.0) CHECK((branches.reflect_chance > 0.0) != goes_on);
      }
      CHECK(reflected == Approx(1.0).epsilon(2e-3));
      CHECK(on == Approx(1.0).epsilon(2e-3));
      CHECK(none == 0);
    }
  }
}
