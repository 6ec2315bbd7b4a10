#include "core/optics/fresnel.h"
#include "tests/catch.h"
#include "tests/core/bundles/fan_scene.h"

#include <algorithm>
#include <cmath>

using namespace abbe;
using test::FanScene;

namespace {

/// A ball of dense flint before a wall; the ray through `kAside` meets it well off its middle.
const std::string kBall = "imageSize 512 512 background E 1 maxFan 405\n"
                          "push translate 0 0 -4 scale 9 9 9 square pop glass SF11 sphere\n";
const glm::dvec2 kAside{380.0, 260.0};

/// From inside a block of flint through a slanting face onto a wall, where every path ends.
const std::string kOutwards =
    "imageSize 512 512 eye 0 0 0 lookAt 0 0 -1 background E 1 maxFan 405\n"
    "push translate 0 0 -6 scale 60 60 1 square pop\n"
    "glass SF11 rotate 25 0 1 0 cube\n";
const glm::dvec2 kMiddle{256.0, 256.0};

bool partition(std::vector<FanCell> cells, int first, int last) {
  std::sort(cells.begin(), cells.end(),
            [](const FanCell& a, const FanCell& b) { return a.bands.first < b.bands.first; });
  for (const FanCell& cell : cells) {
    if (cell.bands.first != first || cell.bands.last <= first) return false;
    first = cell.bands.last;
  }
  return first == last;
}

/// The ray of one band behind the surface, by Snell's law, and what it meets.
Hit own_hit(FanScene& s, int band) {
  const Hit& hit = s.bundle.hit;
  const double eta = s.wavelengths.indices(hit.medium_after)[band] /
                     s.wavelengths.indices(hit.medium_before)[band];
  const dvec3& d = s.bundle.state.ray.direction;
  const dvec3 normal = hit.entering ? hit.normal : -hit.normal;
  const double cos_i = -glm::dot(d, normal);
  RayState state;
  state.ray = {hit.point, refracted(d, normal, cos_i, *refracted_cosine(cos_i, eta), eta)};
  hit.go_on(true, state.contacts, state.nesting);
  return *s.world.closest(state);
}

} // namespace

TEST_CASE("--exact gives every band its own ray, by Snell's law") {
  FanScene s(kBall + "exact on", kAside);
  const auto& cells = s.refract();
  CHECK(s.rays.refracted == 81);
  REQUIRE(cells.size() == 81);
  CHECK(partition(cells, 0, 81));
  for (const FanCell& cell : cells) {
    CHECK(cell.weight == 1.0f);
    CHECK_FALSE(cell.shared);
    REQUIRE(cell.hit->met());
    CHECK(glm::distance(cell.hit->point, own_hit(s, cell.bands.first).point) < 1e-12);
    Bundle next;
    go_on_as(cell, s.bundle, next);
    CHECK(next.depth == 1);
    CHECK(next.path_length == s.bundle.hit.t);
    CHECK(next.traced); // by the fan
    CHECK(next.hit.point == cell.hit->point);
    CHECK(cell.separation == 0.0);
    CHECK(cell.divergence == 0.0);
  }
  // blue is bent more than red, so it leaves farther from the straight line
  const dvec3 straight = s.bundle.state.ray.direction;
  CHECK(glm::dot(cells.front().state->ray.direction, straight) <
        glm::dot(cells.back().state->ray.direction, straight));
}

TEST_CASE("a refracted bundle is given all that the path has met") {
  FanScene s(kBall + "exact on", kAside);
  s.bundle.depth = 3;
  s.bundle.panes = 2;
  Bundle next; // as waiting bundles are: it still holds what another path has left there
  next.depth = 11;
  next.panes = 7;
  go_on_as(s.refract().front(), s.bundle, next);
  CHECK(next.depth == 4);
  CHECK(next.panes == 2);
  CHECK(next.surfaces() == 6);
}

TEST_CASE("only the bands that are asked for are refracted") {
  FanScene s(kBall + "exact on", kAside);
  const auto& cells = s.fan.refract(s.bundle, {20, 33}, {1.0, 0.5}, s.wavelengths, s.rays);
  CHECK(partition(cells, 20, 33));
  CHECK(s.rays.refracted == 13);
}

TEST_CASE("between media without dispersion the bundle stays whole") {
  for (const char* mode : {"exact on", "exact off tolerance 0"}) {
    FanScene s(std::string("background E 1 imageSize 512 512 defaultMaterials transparency 1 "
                           "speedOfLight 1.5 sphere ") +
                   mode,
               kAside);
    const auto& cells = s.refract();
    REQUIRE(cells.size() == 1);
    CHECK(partition(cells, 0, 81));
    CHECK(cells[0].weight == 1.0f);
    CHECK(cells[0].hit == nullptr); // no hit is needed to know that
    CHECK(s.rays.refracted == 0);
    Bundle next;
    go_on_as(cells[0], s.bundle, next);
    extend(next, s.world, s.rays);
    CHECK(s.rays.refracted == 1);
    CHECK(glm::distance(next.hit.point, own_hit(s, 40).point) < 1e-12);
  }
}

TEST_CASE("bands share a ray while the outermost two land together") {
  for (const bool outwards : {false, true}) {
    std::size_t last = 82;
    for (const double tolerance : {0.0, 0.1, 0.25, 1.0, 4.0, 1000.0}) {
      FanScene s((outwards ? kOutwards : kBall) + "tolerance " + std::to_string(tolerance),
                 outwards ? kMiddle : kAside);
      const std::vector<FanCell> cells = s.refract();
      CAPTURE(outwards, tolerance);
      CHECK(partition(cells, 0, 81));
      CHECK(cells.size() <= last); // fewer with more tolerance
      last = cells.size();
      for (const FanCell& cell : cells) {
        CHECK(cell.weight == 1.0f);
        REQUIRE(cell.hit->met());
        const Hit a = own_hit(s, cell.bands.first), b = own_hit(s, cell.bands.last - 1);
        const double way = s.bundle.hit.t + std::max(a.t, b.t);
        const double pixel = s.camera.pixel_angle() * way;
        CHECK(glm::distance(a.point, b.point) <= tolerance * pixel);
        // the shared ray lands between them
        CHECK(glm::distance(cell.hit->point, a.point) <=
              glm::distance(a.point, b.point) + (cell.bands.size() == 1 ? 1e-12 : 0.0));
        CHECK(cell.shared == (cell.bands.size() > 1));
      }
      if (tolerance == 0.0) CHECK(cells.size() == 81);
      if (tolerance == 1000.0) CHECK(cells.size() == 1);
    }
  }
}

// On the wall nothing goes on, so the landing points alone decide: a range is halved no further
// than its outermost bands need.
TEST_CASE("bands part no further than tolerance demands") {
  FanScene s(kOutwards + "tolerance 4", kMiddle);
  const auto& cells = s.refract();
  const auto separation = [&](int first, int last) {
    const Hit a = own_hit(s, first), b = own_hit(s, last - 1);
    return glm::distance(a.point, b.point) /
           (s.camera.pixel_angle() * (s.bundle.hit.t + std::max(a.t, b.t)));
  };
  CHECK(cells.size() > 4);
  for (const FanCell& cell : cells) {
    int first = 0, last = 81; // the path by halves to this cell
    while (first != cell.bands.first || last != cell.bands.last) {
      REQUIRE(last - first > cell.bands.size());
      CHECK(separation(first, last) > 4.0);
      const int middle = s.plan.shares.middle({first, last});
      (cell.bands.first < middle ? last : first) = middle;
    }
  }
}

TEST_CASE("the footprint of a shared ray is that of its outermost bands") {
  FanScene s(kBall + "tolerance 100", kAside);
  const auto& cells = s.refract();
  REQUIRE(cells.size() == 1);
  const dvec3 from = s.bundle.hit.point;
  const auto direction = [&](int band) { return glm::normalize(own_hit(s, band).point - from); };
  CHECK(cells[0].divergence == Approx(glm::distance(direction(0), direction(80))).epsilon(1e-9));
  CHECK(cells[0].separation == 0.0);
}

// The bundle comes with the footprint that earlier surfaces left: its position's part is handed on,
// its direction's part grows with the distance and is scaled by Snell's law.
TEST_CASE("the footprint that earlier surfaces left uses tolerance up") {
  FanScene s(kBall + "tolerance 2", kAside);
  const std::size_t fresh = s.refract().size();
  REQUIRE(fresh < 40);
  const double pixel = s.camera.pixel_angle() * s.bundle.hit.t;
  const auto with_spread = [&](double position, double direction) {
    s.bundle.separation = position;
    s.bundle.divergence = direction;
    return s.refract().size();
  };
  CHECK(with_spread(1.9 * pixel, 0.0) >= fresh);
  CHECK(with_spread(100.0 * pixel, 0.0) == 81);
  CHECK(with_spread(0.0, 1.9 * s.camera.pixel_angle()) > fresh);
  CHECK(with_spread(0.0, 100.0 * s.camera.pixel_angle()) == 81);
}

TEST_CASE("bands whose rays meet different faces or shapes do not share, whatever the tolerance") {
  FanScene open(kOutwards, kMiddle);
  const std::string there = "push translate " + std::to_string(own_hit(open, 40).point.x) + " 0 0 ";
  // A box whose edge faces the fan, and two walls, one of which ends within it.
  for (const char* obstacle : {"push translate 0 0 -7.3 rotate 45 0 1 0 cube pop pop\n",
                               "push translate 30 0 -5.9 scale 30 30 1 square pop pop\n"}) {
    int parted = 0;
    for (double x = 200.0; x < 312.0; x += 4.0) {
      FanScene s(there + obstacle + kOutwards + "tolerance 1e6", {x, 256.0});
      const auto& cells = s.refract();
      CHECK(partition(cells, 0, 81));
      for (const FanCell& cell : cells) {
        const Hit a = own_hit(s, cell.bands.first), b = own_hit(s, cell.bands.last - 1);
        CHECK(a.shape == b.shape);
        CHECK(a.face == b.face);
      }
      const Hit first = own_hit(s, 0), last = own_hit(s, 80);
      const bool same = first.shape == last.shape && first.face == last.face;
      CHECK((cells.size() == 1) == same);
      parted += same ? 0 : 1;
    }
    CHECK(parted > 0);
  }
}

TEST_CASE("packets and single rays make the same fan") {
  FanScene s(kBall, kAside), packets(kBall, kAside);
  s.plan.settings.tracing = Tracing::single;
  const auto &a = s.refract(), &b = packets.refract();
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].bands.first == b[i].bands.first);
    CHECK(a[i].hit->point == b[i].hit->point);
  }
}
