#include "geometry/booleans/lens.h"
#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

#include <functional>
#include <optional>
#include <stdexcept>

using namespace abbe;
using reference::Random;

namespace {

using Real = long double;

/// A surface's z at a height, in 80-bit arithmetic and by the sphere's equation itself.
Real surface(double vertex, double radius, Real height) {
  if (radius == 0.0) return vertex;
  const Real depth = std::sqrt(Real(radius) * radius - height * height);
  return vertex + radius - (radius > 0.0 ? depth : -depth);
}

/// Above 0 inside; near a surface, its distance to first order at most.
Real depth_inside(const LensElement& lens, const dvec3& p) {
  const Real height = std::hypot(Real(p.x), Real(p.y)), rim = 0.5L * lens.diameter;
  if (height >= rim) return rim - height;
  return std::min({rim - height, p.z - surface(lens.front_vertex, lens.front_radius, height),
                   surface(lens.back_vertex(), lens.back_radius, height) - p.z});
}

struct Prescription {
  double diameter;
  std::vector<double> radii, thicknesses;

  [[nodiscard]] std::vector<LensElement> elements() const {
    std::vector<LensElement> found;
    double vertex = 0.0;
    for (std::size_t i = 0; i < thicknesses.size(); ++i) {
      found.push_back({radii[i], radii[i + 1], thicknesses[i], diameter, vertex});
      vertex = found.back().back_vertex();
    }
    return found;
  }
};

// Singlets of every form, and cemented groups, all within 10 units or so.
const std::vector<Prescription> kPrescriptions{
    {6, {10, -20}, {2}},                  // biconvex
    {6, {0, -8}, {2}},                    // plano-convex
    {6, {-10, 12}, {1}},                  // biconcave
    {6, {5, 9}, {1.5}},                   // meniscus
    {6, {-9, -5}, {1.5}},                 // meniscus, the other way
    {6, {0, 0}, {1}},                     // a window
    {6, {3, -3}, {6}},                    // a ball
    {6, {6.13, -4.35, -22.28}, {2, 0.7}}, // an achromat
    {6, {8, 0, -9}, {1.5, 1}},            // cemented in a plane
    {6, {7, -6, 6, -7}, {2, 0.5, 2}},     // a triplet
};

/// Rays that turn back or go through at random, and what they are said to be in.
struct Walk {
  int segments = 0, interfaces = 0, wrong = 0, gaps = 0;
};

Walk walk(const Prescription& prescription, Random& random, int rays, double scale, double far) {
  const auto elements = prescription.elements();
  const Transform at(random.linear() * scale, random.in_cube(2.0 * scale + far));
  std::vector<PlacedShape> shapes;
  for (std::size_t i = 0; i < elements.size(); ++i)
    shapes.push_back({lens_element(elements[i]), at, {0}, {static_cast<int>(i)}, 0});
  const World world(shapes, 60.0 * scale + far);
  const Real blur = 1e-11L + 1e-14L * Real(far / scale); // in the lens's own frame
  const auto truth = [&](const dvec3& local) -> std::optional<int> {
    int found = -1;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Real depth = depth_inside(elements[i], local);
      if (std::abs(depth) < blur) return std::nullopt;
      if (depth > 0.0) found = static_cast<int>(i);
    }
    return found;
  };
  const auto shared = [&](const dvec3& p) {
    const double height = std::hypot(p.x, p.y);
    for (std::size_t i = 1; i < elements.size(); ++i)
      if (height < 0.5 * prescription.diameter - 100 * blur &&
          std::abs(p.z - surface(elements[i].front_vertex, elements[i].front_radius, height)) <
              1e-10L)
        return true;
    return false;
  };
  Walk count;
  for (int k = 0; k < rays; ++k) {
    const dvec3 middle(0, 0, 0.5 * elements.back().back_vertex());
    const dvec3 o = at.point(middle + random.in_cube(random.chance(0.5) ? 3.0 : 12.0));
    const dvec3 to = at.point(middle + random.in_cube(3.0));
    RayState state{{o, glm::normalize(to - o)}, {}, world.nesting_at(o)};
    for (int step = 0; step < 20; ++step) {
      const auto hit = world.closest(state);
      ++count.segments;
      const double length = hit ? hit->t : 30.0 * scale;
      for (const double part : {0.1, 0.4142, 0.9}) {
        const auto in = truth(at.inverse_point(state.ray.at(part * length)));
        const Nesting& nesting = hit ? hit->nesting_before : state.nesting;
        if (in && *in != world.medium_of(nesting).value) ++count.wrong;
      }
      if (!hit) break;
      if (shared(at.inverse_point(hit->point))) {
        ++count.interfaces;
        if (!hit->medium_before.valid() || !hit->medium_after.valid()) ++count.gaps;
      }
      const bool back = random.chance(0.3);
      dvec3 d = state.ray.direction;
      if (back) d -= 2.0 * glm::dot(d, hit->normal) * hit->normal;
      const dvec3 bent = glm::normalize(d + random.in_cube(0.3));
      if (glm::dot(bent, hit->normal) * glm::dot(d, hit->normal) > 0.0) d = bent;
      state = hit->going_on(glm::normalize(d), !back);
    }
  }
  return count;
}

} // namespace

TEST_CASE("lens: sag is the sphere's") {
  CHECK(sag(5, 3) == Approx(1.0)); // 3, 4, 5
  CHECK(sag(-5, 3) == Approx(-1.0));
  CHECK(sag(0, 3) == 0.0);
  CHECK(sag(1e9, 1) == Approx(0.5e-9).epsilon(1e-12));
  CHECK(sag(2, 2) == 2.0);
}

// Rays from everywhere, reflected and bent at random, under maps with mirrors and unequal scales,
// large, small and far away: at three places of each segment, what the ray is in is compared with
// the surfaces' equations. No ray finds air between elements that share a surface.
TEST_CASE("lens: on 1e5 rays each place is in the element that the surfaces say") {
  Random random(100);
  for (const Prescription& prescription : kPrescriptions) {
    Walk sum;
    for (int k = 0; k < 20; ++k) {
      const double scale = k % 4 == 1 ? 1e-4 : k % 4 == 2 ? 1e4 : 1.0;
      const Walk count = walk(prescription, random, 1000, scale, k % 4 == 3 ? 1e5 : 0.0);
      sum.segments += count.segments;
      sum.interfaces += count.interfaces;
      sum.wrong += count.wrong;
      sum.gaps += count.gaps;
    }
    INFO("radii from " << prescription.radii.front() << ", " << prescription.radii.size()
                       << " surfaces, " << sum.segments << " segments");
    CHECK(sum.segments > 40000);
    CHECK(sum.wrong == 0);
    CHECK(sum.gaps == 0);
    if (prescription.thicknesses.size() > 1) CHECK(sum.interfaces > 2000);
  }
}

TEST_CASE("lens: bounds hold the glass closely enough") {
  for (const Prescription& prescription : kPrescriptions)
    for (const LensElement& lens : prescription.elements()) {
      const Bounds box = bounds(lens_element(lens), Transform());
      CHECK(box.upper.x <= 3.0);
      CHECK(box.lower.z >= lens.front_vertex - 4.0);
      CHECK(box.upper.z <= lens.back_vertex() + 4.0);
    }
}

TEST_CASE("lens: data that describe no lens are refused") {
  for (const LensElement& lens :
       {LensElement{2, 0, 5, 6}, LensElement{0, -2, 5, 6}, LensElement{10, -10, 0.5, 6},
        LensElement{4, 5, 0.1, 6}, LensElement{3, 0, 4, 6}, LensElement{0, -3, 4, 6},
        LensElement{4, -100, 9, 2}})
    CHECK_THROWS_AS(lens_element(lens), std::invalid_argument);
}
