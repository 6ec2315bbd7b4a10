#include "core/bundles/lens_fan.h"
#include "core/planning/make_plan.h"

#include "core/sampling/sampler.h"
#include "tests/catch.h"
#include "tests/core/cameras/lens_file.h"

#include <algorithm>
#include <cmath>

using namespace abbe;
using test::lens_file;

namespace {

/// An empty scene under white light, seen by a lens 500 mm from what is sharp.
struct Setup {
  Scene scene;
  Plan plan;
  LensCamera camera;

  explicit Setup(const char* lens, const RenderSettings& settings = {}, double f_number = 4.0)
      : scene(scene_with(lens, f_number)), plan(make_plan(scene, settings)),
        camera(scene.camera, 1.0, settings.width, settings.height) {}

  static Scene scene_with(const char* lens, double f_number) {
    Scene scene;
    scene.background = Curve::constant(1.0);
    Camera& camera = scene.camera;
    camera.eye = {0.0, 0.0, 500.0};
    camera.lens = lens_file(lens);
    camera.aperture = LensSystem(*camera.lens).paraxial(587.5618).focal_length() / f_number;
    camera.film_height_mm = 12.0;
    return scene;
  }

  std::vector<CameraBundle> bundles;
  std::vector<RayState> states;
  void sample(const dvec2& position, const dvec2& u_lens, const dvec2& wavelength) {
    bundles.clear();
    states.clear();
    LensFan(plan, camera).sample(position, u_lens, wavelength, bundles, states);
  }
  [[nodiscard]] double direct_weight(const dvec2& position, const dvec2& u_lens, int band) const {
    const auto from = camera.film_ray(position, u_lens);
    if (!from) return 0.0;
    const auto n = camera.lens().indices(plan.wavelength_nm(band, 0.5));
    return camera.trace(*from, n) ? from->weight : 0.0;
  }
};

RenderSettings with(double tolerance, int max_fan) {
  RenderSettings settings;
  settings.width = settings.height = 100;
  settings.tolerance_pixels = tolerance;
  settings.max_fan = max_fan;
  return settings;
}

/// A place near the rim of the pupil.
const dvec2 kRim{0.97, 0.4};

} // namespace

TEST_CASE("lens fan: exact gives each band the ray of its wavelength") {
  RenderSettings settings = with(0.25, 8);
  settings.exact = true;
  Setup s("singlet_bk7_50", settings);
  s.sample({30.0, 60.0}, kRim, {0.5, 0.3});
  REQUIRE(s.bundles.size() == 81);
  const auto from = s.camera.film_ray({30.0, 60.0}, kRim).value();
  for (std::size_t b = 0; b < 81; ++b) {
    CHECK(s.bundles[b].bands.first == static_cast<int>(b));
    CHECK(s.bundles[b].bands.last == static_cast<int>(b) + 1);
    const auto n = s.camera.lens().indices(380.0 + 5.0 * static_cast<double>(b));
    const Ray direct = s.camera.to_world(s.camera.trace(from, n).value().ray);
    CHECK(glm::distance(s.states[b].ray.direction, direct.direction) < 1e-14);
    CHECK(s.bundles[b].weight == static_cast<float>(from.weight));
  }
  CHECK(glm::distance(s.states[0].ray.direction, s.states[80].ray.direction) > 1e-3);
}

TEST_CASE("lens fan: a generous tolerance leaves one bundle of all bands, a strict one parts all") {
  Setup whole("singlet_bk7_50", with(1e6, 8));
  whole.sample({30.0, 60.0}, kRim, {0.5, 0.3});
  REQUIRE(whole.bundles.size() == 1);
  CHECK(whole.bundles[0].bands.first == 0);
  CHECK(whole.bundles[0].bands.last == 81);
  CHECK(whole.bundles[0].divergence > 0.0);
  Setup parted("singlet_bk7_50", with(0.0, 405));
  parted.sample({30.0, 60.0}, kRim, {0.5, 0.3});
  CHECK(parted.bundles.size() == 81);
}

TEST_CASE("lens fan: bands that share a ray leave the lens close together") {
  for (const char* lens : {"singlet_bk7_50", "achromat_ac254_050_a"}) {
    Setup s(lens, with(0.25, 405));
    s.sample({30.0, 60.0}, kRim, {0.5, 0.3});
    const auto from = s.camera.film_ray({30.0, 60.0}, kRim).value();
    const double limit = 0.25 * s.camera.pixel_angle();
    int last = 0;
    bool shared = false;
    for (std::size_t i = 0; i < s.bundles.size(); ++i) {
      const CameraBundle& bundle = s.bundles[i];
      last = std::max(last, bundle.bands.last);
      shared = shared || bundle.bands.size() > 1;
      for (int b = bundle.bands.first; b < bundle.bands.last; ++b) {
        const auto n = s.camera.lens().indices(s.plan.wavelength_nm(b, 0.5));
        const Ray own = s.camera.to_world(s.camera.trace(from, n).value().ray);
        const Ray& ray = s.states[i].ray;
        CHECK(glm::distance(own.direction, ray.direction) <= 1.01 * limit);
        const auto in_focus = [](const Ray& r) { return r.at(-r.origin.z / r.direction.z); };
        CHECK(glm::distance(in_focus(own), in_focus(ray)) <= 1.01 * limit * 500.0);
      }
    }
    CHECK(last == 81);
    CHECK(shared);
  }
}

TEST_CASE("lens fan: the achromat needs fewer rays than the singlet") {
  Setup singlet("singlet_bk7_50", with(0.25, 405)),
      achromat("achromat_ac254_050_a", with(0.25, 405));
  singlet.sample({50.0, 50.0}, kRim, {0.5, 0.3});
  achromat.sample({50.0, 50.0}, kRim, {0.5, 0.3});
  CHECK(2 * achromat.bundles.size() < singlet.bundles.size());
}

TEST_CASE("lens fan: roulette follows few bands, and each as often as its weight says") {
  Setup s("singlet_bk7_50", with(0.0, 8));
  constexpr int kChoices = 1 << 14;
  std::vector<double> mean(81, 0.0);
  for (int i = 0; i < kChoices; ++i) {
    s.sample({30.0, 60.0}, kRim, {0.5, (i + 0.5) / kChoices});
    REQUIRE(s.bundles.size() == 8);
    for (const CameraBundle& bundle : s.bundles)
      for (int b = bundle.bands.first; b < bundle.bands.last; ++b)
        mean[static_cast<std::size_t>(b)] += static_cast<double>(bundle.weight) / kChoices;
  }
  const double weight = s.camera.film_ray({30.0, 60.0}, kRim)->weight;
  for (int b = 0; b < 81; ++b)
    CHECK(mean[static_cast<std::size_t>(b)] == Approx(weight).epsilon(0.02));
}

TEST_CASE("lens fan: bands that the lens stops are left out, alone or in a range") {
  // At the edge of the pupil, where some bands pass and others do not.
  Setup exact("singlet_bk7_50", with(0.25, 405), 2.0);
  int partly = 0;
  for (int i = 0; i < 4096; ++i) {
    const dvec2 position{20.0 + 0.01 * i, 50.0};
    const dvec2 u = Sampler(0, 0, static_cast<std::uint32_t>(i), 9).pair(kLens);
    std::vector<double> expected;
    int passing = 0;
    for (int b = 0; b < 81; ++b) {
      expected.push_back(exact.direct_weight(position, u, b));
      passing += expected.back() > 0.0;
    }
    if (passing == 0 || passing == 81) continue;
    ++partly;
    exact.sample(position, u, {0.5, 0.3});
    int wrong = 0;
    std::vector<double> found(81, 0.0);
    for (const CameraBundle& bundle : exact.bundles)
      for (int b = bundle.bands.first; b < bundle.bands.last; ++b)
        found[static_cast<std::size_t>(b)] = static_cast<double>(bundle.weight);
    for (std::size_t b = 0; b < 81; ++b)
      wrong += std::abs(found[b] - expected[b]) > 1e-6;
    CHECK(wrong == 0);
  }
  CHECK(partly > 3);
}

TEST_CASE("lens fan: a lens of one index never parts bands") {
  Scene scene = Setup::scene_with("singlet_bk7_50", 4.0);
  scene.camera.lens->surfaces[0].medium_after = ConstantIndex{1.5168};
  const RenderSettings settings = with(0.0, 405);
  const Plan plan = make_plan(scene, settings);
  const LensCamera camera(scene.camera, 1.0, 100, 100);
  std::vector<CameraBundle> bundles;
  std::vector<RayState> states;
  LensFan(plan, camera).sample({30.0, 60.0}, kRim, {0.5, 0.3}, bundles, states);
  REQUIRE(bundles.size() == 1);
  CHECK(bundles[0].bands.size() == 81);
}

TEST_CASE("lens fan: outside the image circle nothing starts") {
  Setup s("singlet_bk7_50", with(0.25, 8));
  s.sample({1e4, 1e4}, {0.5, 0.5}, {0.5, 0.5});
  CHECK(s.bundles.empty());
  CHECK(s.states.empty());
}
