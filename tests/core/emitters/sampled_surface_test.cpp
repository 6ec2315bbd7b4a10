#include "core/emitters/sampled_surface.h"

#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/core/emitters/direction_sampling.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <string>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi;

Transform placed_at(const dvec3& centre, const dvec3& stretch) {
  return Transform::translation(centre)
      .after(Transform::rotation(35.0, {1.0, 2.0, -0.5}))
      .after(Transform::scaling(stretch));
}

/// Two triangles of a roof, which hide nothing of each other from above.
Mesh roof() {
  return {{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0.4}, {0, -1, 1}}, {{0, 3, 2}, {3, 1, 2}}};
}

Mesh tetrahedron() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

/// A shape alone in the world, and a place that looks at it.
struct Seen {
  PlacedShape placed;
  SampledSurface surface;
  World world;
  dvec3 place;

  Seen(Shape shape, const Transform& to_world, const dvec3& from, bool both_sides = false)
      : placed{std::move(shape), to_world, {0}, {}, 0},
        surface(*sampled_surface(placed, both_sides)), world({placed}, 10.0), place(from) {}

  [[nodiscard]] std::optional<SeenPoint> sample(const dvec2& u) const {
    return std::visit([&](const auto& s) { return s.sample(place, u); }, surface);
  }
  [[nodiscard]] std::optional<Hit> hit(const dvec3& direction) const {
    return world.closest(RayState{{place, direction}, {}, {}});
  }
  /// Of the first point of the surface in this direction; 0 where it shows its dark side.
  [[nodiscard]] double pdf(const dvec3& direction, bool both_sides) const {
    const auto met = hit(direction);
    if (!met || (!met->entering && !both_sides)) return 0.0;
    return std::visit([&](const auto& s) { return s.pdf(place, met->point, met->normal); },
                      surface);
  }
  [[nodiscard]] test::SamplingCheck check(bool both_sides = false, int fine = 96) const {
    const Bounds box = bounds(placed);
    const dvec3 way = 0.5 * (box.lower + box.upper) - place;
    const double d = glm::length(way), reach = 0.5 * glm::length(box.upper - box.lower);
    const Cone all{way / d,
                   reach < d ? Cone::of_sine(way / d, std::pow(reach / d, 2)).one_minus_cos : 2.0};
    const auto direction_of = [&](const dvec2& u) {
      const auto seen = sample(u);
      return seen ? std::optional(seen->direction) : std::nullopt;
    };
    const auto pdf_of = [&](const dvec3& v) { return pdf(v, both_sides); };
    return test::check_sampling(all, direction_of, pdf_of, 20000, fine);
  }
};

const dvec3 kStretch{0.5, 1.2, 0.8}, kMirror{0.5, -0.7, 0.9}, kEven{0.6, 0.6, 0.6};

} // namespace

TEST_CASE("directions to a light come with the pdf that is claimed, which is lost nowhere") {
  struct Case {
    const char* name;
    Shape shape;
    dvec3 stretch;
    bool complete; ///< each draw gives a direction, from outside
  };
  const Case cases[] = {
      {"square", Square{}, kStretch, true},      {"disc", Disc{}, kStretch, true},
      {"ball", Sphere{}, kEven, true},           {"mirrored ball", Sphere{}, -kEven, true},
      {"ellipsoid", Sphere{}, kStretch, false},  {"box", Box{}, kStretch, true},
      {"mirrored box", Box{}, kMirror, true},    {"tetrahedron", tetrahedron(), kMirror, false},
      {"prism", thesis_prism(), kStretch, true}, {"mirrored prism", thesis_prism(), kMirror, true}};
  // The flat ones are looked at from above: their normal is the rotated z axis.
  const dvec3 up = Transform::rotation(35.0, {1.0, 2.0, -0.5}).vector({0.0, 0.0, 1.0});
  for (const Case& c : cases)
    for (const dvec3 place :
         {3.0 * up, dvec3(0.3, 0.2, 0.1) + 1.6 * up, 1.5 * up + dvec3(2, 1, 0)}) {
      CAPTURE(c.name, place.x, place.y, place.z);
      const auto check = Seen(c.shape, placed_at(dvec3(0.0), c.stretch), place).check();
      CAPTURE(check.chi_square, check.limit, check.outside);
      CHECK(check.agrees());
      CHECK(check.integral == Approx(check.drawn).margin(0.015));
      if (c.complete) {
        CHECK(check.drawn == Approx(1.0).margin(1e-12));
      }
    }
}

TEST_CASE("a flat lamp is dark behind unless both of its sides shine") {
  for (const bool both : {false, true})
    for (const Shape& shape : {Shape(Square{}), Shape(Disc{}), Shape(roof())}) {
      const dvec3 up = Transform::rotation(35.0, {1.0, 2.0, -0.5}).vector({0.0, 0.0, 1.0});
      const Seen above(shape, placed_at(dvec3(0.0), kStretch), 3.0 * up, both);
      const Seen below(shape, placed_at(dvec3(0.0), kStretch), -3.0 * up, both);
      CHECK(above.check(both, 24).drawn == Approx(1.0));
      CHECK(above.check(both, 24).agrees());
      CHECK(below.check(both, 24).drawn == Approx(both ? 1.0 : 0.0));
      if (both) {
        CHECK(below.check(both, 24).agrees());
      }
    }
}

TEST_CASE("no solid lamp shines inside itself") {
  for (const Shape& shape :
       {Shape(Sphere{}), Shape(Box{}), Shape(tetrahedron()), Shape(thesis_prism())})
    for (const dvec3& stretch : {kEven, kStretch}) {
      const Seen inside(shape, placed_at(dvec3(0.0), stretch), {0.02, 0.03, 0.01}, true);
      for (const dvec2 u : {dvec2(0.1, 0.2), dvec2(0.9, 0.6), dvec2(0.5, 0.5), dvec2(0.3, 0.99)})
        CHECK_FALSE(inside.sample(u).has_value());
    }
}

// The solid angle of a ball is 2 pi (1 - cos), with sin = R / d. 1 - cos = sin^2 / (1 + cos) holds
// all digits where R / d is 1e-9 and 1 - cos would be 0.
TEST_CASE("the pdf of a ball is one over its solid angle, however small it is") {
  for (const double radius : {1.0, 1e-3, 1e-9}) {
    const Seen ball(Sphere{}, placed_at(dvec3(0.0), dvec3(radius)), {0.0, 0.0, 2.0});
    const double sine2 = radius * radius / 4.0;
    const double solid_angle = 2.0 * kPi * sine2 / (1.0 + std::sqrt(1.0 - sine2));
    for (const dvec2 u : {dvec2(0.0, 0.0), dvec2(0.3, 0.8), dvec2(0.999, 0.5)}) {
      const auto seen = ball.sample(u);
      REQUIRE(seen);
      CHECK(seen->pdf * solid_angle == Approx(1.0).epsilon(1e-12));
      CHECK(glm::length(seen->direction) == Approx(1.0).epsilon(1e-15));
      const dvec3 point = ball.place + seen->distance * seen->direction;
      CHECK(glm::length(point) == Approx(radius).margin(1e-11));
    }
  }
}

TEST_CASE("a shadow ray to a lamp ends before it") {
  for (const Shape& shape : {Shape(Square{}), Shape(Disc{}), Shape(Sphere{}), Shape(Box{}),
                             Shape(roof()), Shape(thesis_prism())})
    for (const dvec3& stretch : {kEven, kStretch}) {
      const Seen lamp(shape, placed_at({0.3, 0.1, 5.0}, stretch), {0.1, 0.7, 0.2}, true);
      int seen_points = 0;
      for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j)
          if (const auto seen = lamp.sample({(i + 0.5) / 64, (j + 0.5) / 64})) {
            ++seen_points;
            // The far sides of ellipsoids face away and are not chosen: all that is, is seen.
            CHECK_FALSE(lamp.world.occluded(RayState{{lamp.place, seen->direction}, {}, {}},
                                            seen->distance));
          }
      CHECK(seen_points > 1500);
    }
}

TEST_CASE("areas in the world") {
  const auto area = [](const Shape& shape, const dvec3& stretch) {
    const PlacedShape placed{shape, placed_at({1, 2, 3}, stretch), {}, {}, 0};
    return std::visit([](const auto& s) { return s.area(); }, *sampled_surface(placed, false));
  };
  CHECK(area(Square{}, {0.5, 1.2, 9.0}) == Approx(4.0 * 0.6));
  CHECK(area(Disc{}, {0.5, 1.2, 9.0}) == Approx(kPi * 0.6));
  CHECK(area(Sphere{}, kEven) == Approx(4.0 * kPi * 0.36));
  CHECK(area(Box{}, {1.0, 2.0, 3.0}) == Approx(8.0 * (2.0 + 3.0 + 6.0)));
  CHECK(area(tetrahedron(), kEven) == Approx(0.36 * std::sqrt(3.0) * 8.0)); // edges 2 sqrt(2)
  // Its triangle has sides of 2 sqrt(3) and a height of 3.
  const double root3 = std::sqrt(3.0);
  CHECK(area(thesis_prism(), kEven) == Approx(0.36 * (2.0 * 3.0 * root3 + 3.0 * 4.0 * root3)));
  // A spheroid with axes 1, 1, c > 1: 2 pi (1 + c / e asin e), e^2 = 1 - 1 / c^2.
  const double c = 2.0, e = std::sqrt(1.0 - 1.0 / (c * c));
  CHECK(area(Sphere{}, {1.0, 1.0, c}) ==
        Approx(2.0 * kPi * (1.0 + c / e * std::asin(e))).epsilon(1e-3));
}

// The mean of 1 / pdf is the area; over a closed surface the normals times area cancel, and
// over one with a centre the places do, if each part has its share. The face that is named holds
// the point.
TEST_CASE("points of a surface come with the pdf that is claimed, on the face that is named") {
  const Shape shapes[] = {Square{}, Disc{}, Sphere{}, Box{}, roof(), tetrahedron(), thesis_prism()};
  for (const Shape& shape : shapes)
    for (const dvec3& stretch : {kEven, kMirror}) {
      CAPTURE(shape.index(), stretch.y);
      const PlacedShape placed{shape, placed_at({1, 2, 3}, stretch), {}, {}, 0};
      const SampledSurface surface = *sampled_surface(placed, false);
      constexpr int kSide = 128;
      double area = 0.0;
      dvec3 normals(0.0), places(0.0);
      for (int i = 0; i < kSide * kSide; ++i) {
        const dvec2 u{(i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide};
        const SurfacePoint at = std::visit([&](const auto& s) { return s.at(u); }, surface);
        const double share = 1.0 / at.pdf / (kSide * kSide);
        const dvec3 local = placed.to_world.inverse_point(at.point);
        area += share;
        normals += share * at.normal;
        places += share * local;
        const dvec3 on_face =
            std::visit([&](const auto& s) { return snapped(s, local, at.face); }, shape);
        const dvec3 normal =
            std::visit([&](const auto& s) { return outward_normal(s, local, at.face); }, shape);
        REQUIRE(glm::distance(on_face, local) < 1e-12);
        REQUIRE(glm::distance(placed.to_world.normal(normal), at.normal) < 1e-12);
      }
      CHECK(area ==
            Approx(std::visit([](const auto& s) { return s.area(); }, surface)).epsilon(1e-3));
      if (is_solid(shape)) CHECK(glm::length(normals) < 0.03 * area);
      const bool has_centre =
          !std::holds_alternative<Mesh>(shape) && !std::holds_alternative<ConvexPolyhedron>(shape);
      if (has_centre) CHECK(glm::length(places) < 0.03 * area);
    }
}

TEST_CASE("other shapes cannot be sampled") {
  CHECK_FALSE(can_sample_surface(Plane{}));
  CHECK_FALSE(can_sample_surface(Shape(TaperedCylinder{})));
  CHECK_FALSE(sampled_surface({Plane{}, {}, {}, {}, 0}, true).has_value());
  CHECK(can_sample_surface(Shape(roof())));
}
