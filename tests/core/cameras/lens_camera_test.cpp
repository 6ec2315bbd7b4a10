#include "core/cameras/lens_camera.h"

#include "core/sampling/sampler.h"
#include "spectral/fraunhofer.h"
#include "tests/catch.h"
#include "tests/core/cameras/lens_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace abbe;
using test::lens_file;

namespace {

constexpr double kFocus = 2000.0; ///< mm
constexpr int kSize = 100;        ///< pixels per side

const ImageScale kImage{kSize, kSize, 1.0};

RealLens lens_with(const char* name, double f_number) {
  RealLens lens{lens_file(name)};
  lens.aperture = LensSystem(lens.prescription).paraxial(kLineD_nm).focal_length() / f_number;
  lens.film_height_mm = 30.0;
  return lens;
}

Camera from_the_focus() {
  Camera camera;
  camera.eye = {0.0, 0.0, kFocus};
  return camera;
}

LensCamera camera_with(const RealLens& lens) {
  return {lens, from_the_focus(), kImage};
}

dvec2 numbers(int i, std::uint32_t purpose) {
  return Sampler(3, 4, static_cast<std::uint32_t>(i), 5).pair(purpose);
}

/// Where rays of one place meet the plane z in the world.
template <class Use>
void for_rays(const LensCamera& camera, const dvec2& position, double nm, double z,
              const Use& use) {
  const auto n = camera.lens().indices(nm);
  for (int i = 0; i < 2048; ++i) {
    const auto from = camera.film_ray(position, numbers(i, kLens));
    if (!from) continue;
    const auto out = camera.trace(*from, n);
    if (!out) continue;
    const Ray ray = camera.to_world(out->ray);
    use(ray.at((z - ray.origin.z) / ray.direction.z));
  }
}

/// The diameter about the middle of the picture.
double spot(const LensCamera& camera, double nm, double z) {
  double radius = 0.0;
  for_rays(camera, {50.0, 50.0}, nm, z,
           [&](const dvec3& p) { radius = std::max(radius, std::hypot(p.x, p.y)); });
  return 2.0 * radius;
}

/// The mean of what arrives at a place of the film for a radiance of 1.
double brightness(const LensCamera& camera, const dvec2& position, double nm) {
  constexpr int kSamples = 4096;
  const auto n = camera.lens().indices(nm);
  double sum = 0.0;
  for (int i = 0; i < kSamples; ++i)
    if (const auto from = camera.film_ray(position, numbers(i, kLens)))
      if (const auto out = camera.trace(*from, n)) sum += from->weight * out->transmittance;
  return sum / kSamples;
}

} // namespace

TEST_CASE("lens camera: a point in focus is small, and one out of focus as large as the beam") {
  const double f_number = 16.0;
  const LensCamera camera = camera_with(lens_with("double_gauss_f2", f_number));
  const double pupil = camera.lens().entrance_pupil_diameter();
  const double sharp = spot(camera, kLineD_nm, 0.0);
  // The beam that fills the entrance pupil shrinks to the plane of focus and grows behind it. The
  // pupil of this lens lies 57.9 mm behind the first vertex, by the paraxial image of its stop.
  CHECK(sharp < 0.01 * pupil);
  for (const double z : {800.0, -800.0, -2000.0})
    CHECK(spot(camera, kLineD_nm, z) ==
          Approx(pupil * std::abs(z) / (kFocus + 57.9)).epsilon(0.02));
}

TEST_CASE("lens camera: what is below and to the right comes from there") {
  const LensCamera camera = camera_with(lens_with("cooke_triplet", 8.0));
  const double pixel = kFocus * camera.pixel_angle();
  // Close to the axis the picture is that of a pinhole; farther out this lens hardly distorts.
  for (const dvec2 offset : {dvec2(5, 0), dvec2(0, 7), dvec2(-20, 10)}) {
    dvec3 sum{0.0};
    int count = 0;
    for_rays(camera, dvec2(50, 50) + offset, kLineD_nm, 0.0, [&](const dvec3& p) {
      sum += p;
      ++count;
    });
    REQUIRE(count > 0);
    CHECK(sum.x / count == Approx(offset.x * pixel).epsilon(0.01).margin(0.01 * pixel));
    CHECK(sum.y / count == Approx(-offset.y * pixel).epsilon(0.01).margin(0.01 * pixel));
  }
}

TEST_CASE("lens camera: the scene's unit scales the lens, not the picture") {
  RealLens in_metres = lens_with("double_gauss_f2", 4.0);
  Camera nearer = from_the_focus();
  nearer.eye /= 1000.0;
  in_metres.aperture /= 1000.0;
  const LensCamera a = camera_with(lens_with("double_gauss_f2", 4.0));
  const LensCamera b(in_metres, nearer, {kSize, kSize, 1000.0});
  const auto n = a.lens().indices(500.0);
  const dvec2 u{0.3, 0.6};
  const Ray p = a.to_world(a.trace(a.film_ray({20, 30}, u).value(), n).value().ray);
  const Ray q = b.to_world(b.trace(b.film_ray({20, 30}, u).value(), n).value().ray);
  CHECK(glm::distance(p.direction, q.direction) < 1e-12);
  CHECK(glm::distance(p.origin, 1000.0 * q.origin) < 1e-9);
}

TEST_CASE("lens camera: a uniform radiance is seen as it is in the middle, at any aperture") {
  for (const char* name : {"double_gauss_f2", "singlet_bk7_50", "zeiss_biotar_1927"})
    for (const double f_number : {2.2, 5.6, 16.0}) {
      INFO(name << " f/" << f_number);
      const LensCamera camera = camera_with(lens_with(name, f_number));
      CHECK(brightness(camera, {50.0, 50.0}, kLineD_nm) == Approx(1.0).epsilon(2e-3));
    }
}

// A thin lens with its stop at the glass: the film sees a disc at the same distance from every
// place, dE = L cos^4 dA / d^2.
TEST_CASE("lens camera: off the axis, light falls with cos^4") {
  const LensCamera camera = camera_with(lens_with("singlet_bk7_50", 32.0));
  const FocusedLens lens = focused_lens(lens_with("singlet_bk7_50", 32.0), from_the_focus(), 1.0);
  // The exit pupil is the image of the stop, the first surface, in the second: close to it.
  const double distance = lens.film_distance + 3.4;
  for (const double pixels : {10.0, 30.0, 45.0}) {
    const double cos2 = 1.0 / (1.0 + std::pow(pixels * 0.3 / distance, 2));
    CHECK(brightness(camera, {50.0 + pixels, 50.0}, kLineD_nm) ==
          Approx(cos2 * cos2).epsilon(0.01));
  }
}

// The same integral over all of the last surface, without the exit pupil.
TEST_CASE("lens camera: vignetting is that of all rays that pass") {
  const RealLens description = lens_with("double_gauss_f2", 2.0);
  const LensCamera camera = camera_with(description);
  const FocusedLens lens = focused_lens(description, from_the_focus(), 1.0);
  const auto n = lens.lens.indices(450.0);
  const double last = lens.lens.last_vertex(), d = lens.film_distance;
  const auto irradiance = [&](double film_radius, double reach) {
    constexpr int kSamples = 1 << 15;
    double sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const dvec2 q = reach * (2.0 * numbers(i, 1) - 1.0);
      const dvec3 from{-film_radius, 0.0, last + d}, way = dvec3(q.x, q.y, last) - from;
      const double cos2 = d * d / glm::dot(way, way);
      if (lens.lens.trace_from_film({from, glm::normalize(way)}, n)) sum += cos2 * cos2;
    }
    return sum / kSamples * 4.0 * reach * reach / (d * d);
  };
  const double middle = irradiance(0.0, 30.0);
  for (const double pixels : {20.0, 40.0, 70.0})
    CHECK(brightness(camera, {50.0 + pixels, 50.0}, 450.0) /
              brightness(camera, {50.0, 50.0}, 450.0) ==
          Approx(irradiance(pixels * 0.3, 40.0) / middle).epsilon(0.02));
}

TEST_CASE("lens camera: beyond the image circle it is dark") {
  RealLens description = lens_with("double_gauss_f2", 2.0);
  description.film_height_mm = 300.0;
  const LensCamera camera = camera_with(description);
  CHECK(brightness(camera, {50.0, 50.0}, kLineD_nm) == Approx(1.0).epsilon(2e-3));
  CHECK(brightness(camera, {99.0, 50.0}, kLineD_nm) == 0.0);
  CHECK_FALSE(camera.film_ray({99.0, 99.0}, {0.5, 0.5}));
}

TEST_CASE("lens camera: colours are sharp at other distances") {
  // The distance at which the blue spot is smallest is that of the paraxial image in blue.
  const LensCamera camera = camera_with(lens_with("singlet_bk7_50", 16.0));
  const FocusedLens lens = focused_lens(lens_with("singlet_bk7_50", 16.0), from_the_focus(), 1.0);
  const double sharp = lens.lens.paraxial(kLineF_nm).object_distance(lens.film_distance);
  REQUIRE(sharp > 0.0);
  CHECK(std::abs(sharp - kFocus) > 100.0);
  const double at_focus = spot(camera, kLineF_nm, 0.0);
  const double at_sharp = spot(camera, kLineF_nm, kFocus - sharp);
  CHECK(at_sharp < 0.35 * at_focus);
  CHECK(spot(camera, kLineD_nm, 0.0) < 0.35 * at_focus);
}

TEST_CASE("lens camera: without coating each surface takes its share") {
  RealLens description = lens_with("singlet_bk7_50", 16.0);
  description.coating = false;
  const LensCamera camera = camera_with(description);
  const double n = camera.lens().indices(kLineD_nm)[1];
  const double passed = 1.0 - std::pow((n - 1.0) / (n + 1.0), 2); // close to normal incidence
  CHECK(brightness(camera, {50.0, 50.0}, kLineD_nm) == Approx(passed * passed).epsilon(2e-3));
}
