#include "geometry/meshes/close_mesh.h"

#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/mesh_reference.h"
#include "tests/geometry/random.h"

#include <algorithm>
#include <functional>

using namespace abbe;
using namespace abbe::reference;

namespace {

/// Vertices and triangles that are being put together.
struct Parts {
  std::vector<dvec3> vertices;
  std::vector<Triangle> triangles;

  /// Adds a box, its faces cut along the one diagonal or the other.
  void add_box(const dvec3& lower, const dvec3& upper, bool other_diagonals = false) {
    const auto first = static_cast<std::int32_t>(vertices.size());
    for (int i = 0; i < 8; ++i)
      vertices.emplace_back((i & 1 ? upper : lower).x, (i & 2 ? upper : lower).y,
                            (i & 4 ? upper : lower).z);
    for (const auto& [a, b, c, d] : std::vector<std::array<std::int32_t, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      const std::int32_t e = first + a, f = first + b, g = first + c, h = first + d;
      if (other_diagonals)
        triangles.insert(triangles.end(), {{f, g, h}, {f, h, e}});
      else
        triangles.insert(triangles.end(), {{e, f, g}, {e, g, h}});
    }
  }
  void turn(std::size_t t) { std::swap(triangles[t][1], triangles[t][2]); }
  [[nodiscard]] Mesh mesh() const { return {vertices, triangles}; }
};

Parts cube() {
  Parts parts;
  parts.add_box(dvec3(-1), dvec3(1));
  return parts;
}

PlacedShape placed(const Mesh& mesh) {
  return {mesh, {}, {0}, {0}, 0};
}

/// Which of the points that are drawn in a cube the mesh holds, and a set does not, or not so.
int differing(const Mesh& mesh, double half, const std::function<bool(const dvec3&)>& inside) {
  Random random(120);
  int count = 0;
  for (int i = 0; i < 2000; ++i) {
    const dvec3 p = random.in_cube(half);
    count += contains(placed(mesh), p) != inside(p) ? 1 : 0;
  }
  return count;
}

bool in_box(const dvec3& p, const dvec3& lower, const dvec3& upper) {
  return p.x > lower.x && p.y > lower.y && p.z > lower.z && p.x < upper.x && p.y < upper.y &&
         p.z < upper.z;
}
bool in_cube(const dvec3& p) {
  return in_box(p, dvec3(-1), dvec3(1));
}

/// How often straight rays through a mesh of glass and through other solids, which look the same,
/// meet different boundaries.
int differing_walks(const Mesh& mesh, const std::vector<PlacedShape>& solids, double half) {
  const World one({placed(mesh)}, 100.0), other(solids, 100.0);
  Random random(121);
  int count = 0;
  for (int i = 0; i < 5000; ++i) {
    RayState a;
    a.ray.origin = random.in_cube(half) + dvec3(0, 0, 10);
    a.ray.direction = glm::normalize(random.in_cube(half) - a.ray.origin);
    RayState b = a;
    for (int step = 0; step < 20; ++step) {
      const auto first = one.closest(a), second = other.closest(b);
      if (!first && !second) break;
      const bool same = first && second && glm::length(first->point - second->point) < 1e-5 &&
                        first->entering == second->entering &&
                        std::abs(glm::dot(first->normal, second->normal)) > 1.0 - 1e-5;
      if (!same) {
        ++count;
        break;
      }
      a = first->going_on(a.ray.direction, true);
      b = second->going_on(b.ray.direction, true);
    }
  }
  return count;
}

const std::vector<PlacedShape> kBox{{Box{}, {}, {0}, {0}, 0}};

PlacedShape box_at(const dvec3& middle, double half = 1.0) {
  return {
      Box{}, Transform::translation(middle).after(Transform::scaling(dvec3(half))), {0}, {0}, 0};
}

} // namespace

TEST_CASE("closing a mesh: what is closed stays the very same mesh") {
  Parts two_parts = cube(), hollow = cube(), touching = cube();
  two_parts.add_box(dvec3(2), dvec3(3));
  touching.add_box({1, -1, -1}, {3, 1, 1});
  const std::size_t outer = hollow.triangles.size();
  hollow.add_box(dvec3(-0.5), dvec3(0.5));
  for (std::size_t t = outer; t < hollow.triangles.size(); ++t)
    hollow.turn(t);
  for (const Mesh& mesh : {cube().mesh(), torus(24, 12), icosphere(3), two_parts.mesh(),
                           hollow.mesh(), touching.mesh()}) {
    REQUIRE(mesh.is_closed());
    const MendedMesh mended = close_mesh(mesh);
    CHECK(mended.mesh.triangles().data() == mesh.triangles().data());
    CHECK(mended.turned + mended.welded + mended.split + mended.repeated == 0);
  }
  CHECK(differing(close_mesh(hollow.mesh()).mesh, 1.5, [](const dvec3& p) {
          return in_cube(p) && !in_box(p, dvec3(-0.5), dvec3(0.5));
        }) == 0);
}

TEST_CASE("closing a mesh: turned triangles are turned back, whichever they are") {
  Random random(122);
  for (int k = 0; k < 50; ++k) {
    Parts parts = cube();
    std::size_t turned = 0;
    for (std::size_t t = 0; t < parts.triangles.size(); ++t)
      if (random.chance(k == 0 ? 0.0 : 0.1 * (k % 10))) {
        parts.turn(t);
        ++turned;
      }
    const MendedMesh mended = close_mesh(parts.mesh());
    REQUIRE(mended.mesh.is_closed());
    CHECK(mended.turned == (turned == 12 ? 0 : turned)); // Mesh turns one that is inside out
    CHECK(differing(mended.mesh, 1.5, in_cube) == 0);
    CHECK(differing_walks(mended.mesh, kBox, 1.5) == 0);
  }
}

TEST_CASE("closing a mesh: one of two bodies is inside out, and so is a hollow") {
  Parts two = cube(), hollow = cube(), nested = cube();
  const std::size_t outer = two.triangles.size();
  two.add_box({2, -1, -1}, {4, 1, 1});
  for (std::size_t t = outer; t < two.triangles.size(); ++t)
    two.turn(t);
  const MendedMesh apart = close_mesh(two.mesh());
  CHECK(apart.turned == 12);
  CHECK(differing(apart.mesh, 4.5, [](const dvec3& p) {
          return in_cube(p) || in_box(p, {2, -1, -1}, {4, 1, 1});
        }) == 0);

  hollow.add_box(dvec3(-0.5), dvec3(0.5)); // outwards, as if it were a body
  CHECK(differing(close_mesh(hollow.mesh()).mesh, 1.5, [](const dvec3& p) {
          return in_cube(p) && !in_box(p, dvec3(-0.5), dvec3(0.5));
        }) == 0);

  nested.add_box(dvec3(-0.75), dvec3(0.75)); // and a body in the hollow
  nested.add_box(dvec3(-0.5), dvec3(0.5));
  const Mesh body = close_mesh(nested.mesh()).mesh;
  REQUIRE(body.is_closed());
  CHECK(differing(body, 1.5, [](const dvec3& p) {
          return in_cube(p) &&
                 (!in_box(p, dvec3(-0.75), dvec3(0.75)) || in_box(p, dvec3(-0.5), dvec3(0.5)));
        }) == 0);
}

TEST_CASE("closing a mesh: T-junctions, on one side of an edge, on both and with turned faces") {
  for (const int turned : {-1, 0, 7}) {
    Parts parts = cube(); // its face at z = 1 is given anew, cut into strips
    parts.triangles.erase(parts.triangles.begin() + 2, parts.triangles.begin() + 4);
    const auto first = static_cast<std::int32_t>(parts.vertices.size());
    const std::vector<double> cuts{-1, -0.7, 0.1, 0.3, 1};
    for (const double x : cuts) {
      parts.vertices.emplace_back(x, -1, 1);
      parts.vertices.emplace_back(x, 1, 1);
    }
    for (std::int32_t i = first; i < first + 8; i += 2)
      parts.triangles.insert(parts.triangles.end(), {{i, i + 2, i + 3}, {i, i + 3, i + 1}});
    // The face at y = -1 too, in such a way that either has a vertex on an edge of the other.
    parts.triangles.erase(parts.triangles.begin() + 2, parts.triangles.begin() + 4);
    const auto last = static_cast<std::int32_t>(parts.vertices.size());
    parts.vertices.emplace_back(-0.3, -1, 1); // between the cuts
    parts.triangles.insert(parts.triangles.end(), {{0, 1, last}, {0, last, 4}, {1, 5, last}});
    if (turned >= 0) parts.turn(static_cast<std::size_t>(turned));
    const Mesh given = parts.mesh();
    CHECK_FALSE(given.is_closed());
    const MendedMesh mended = close_mesh(given);
    REQUIRE(mended.mesh.is_closed());
    CHECK(mended.split == 4);
    CHECK(mended.turned == (turned >= 0 ? 1 : 0));
    CHECK(mended.mesh.area() == Approx(24.0));
    CHECK(differing(mended.mesh, 1.5, in_cube) == 0);
    CHECK(differing_walks(mended.mesh, kBox, 1.5) == 0);
  }
}

TEST_CASE("closing a mesh: small seams are welded, wider ones are not") {
  for (const double scale : {1e-3, 1.0, 1e4})
    for (const double seam : {1e-7, 1e-4}) {
      Random random(123);
      Parts parts;
      for (const Triangle& t : cube().triangles) {
        const auto n = static_cast<std::int32_t>(parts.vertices.size());
        for (const std::int32_t i : t)
          parts.vertices.push_back(
              scale * (cube().vertices[static_cast<std::size_t>(i)] + random.in_cube(seam)));
        parts.triangles.push_back({n, n + 1, n + 2});
      }
      const MendedMesh mended = close_mesh(parts.mesh());
      CHECK(mended.mesh.is_closed() == (seam < 1e-5));
      if (seam > 1e-5) {
        CHECK(mended.open.edges == 36);
        continue;
      }
      CHECK(mended.welded == 28); // of 36 corners, 8 are left
      CHECK(mended.tolerance < 1e-5 * scale);
      CHECK(mended.mesh.area() == Approx(24.0 * scale * scale));
      CHECK(differing(mended.mesh, 1.5 * scale,
                      [&](const dvec3& p) { return in_cube(p / scale); }) == 0);
    }
}

TEST_CASE("closing a mesh: bodies that touch at a vertex, an edge or a face") {
  for (const bool other_diagonals : {false, true})
    for (const dvec3& middle : {dvec3(2, 2, 2), dvec3(2, 2, 0), dvec3(2, 0, 0)})
      for (const std::size_t turned : {0, 1, 2}) {
        Parts parts = cube();
        parts.add_box(middle - dvec3(1), middle + dvec3(1), other_diagonals);
        for (std::size_t t = 0; t < turned; ++t)
          parts.turn(11 - t); // of the side that may touch
        const MendedMesh mended = close_mesh(parts.mesh());
        INFO("at " << middle.x << " " << middle.y << " " << middle.z);
        REQUIRE(mended.mesh.is_closed());
        CHECK(mended.turned == turned);
        CHECK(differing(mended.mesh, 3.5,
                        [&](const dvec3& p) { return in_cube(p) || in_cube(p - middle); }) == 0);
        // Two cubes of one glass that touch have no boundary between them.
        CHECK(differing_walks(mended.mesh, {box_at(dvec3(0)), box_at(middle)}, 3.5) == 0);
      }
  Parts beside = cube(); // a smaller one, which shares no vertex with the face it stands on
  beside.add_box({1, -0.5, -0.5}, {2, 0.5, 0.5});
  CHECK(differing_walks(close_mesh(beside.mesh()).mesh,
                        {box_at(dvec3(0)), box_at({1.5, 0, 0}, 0.5)}, 3.0) == 0);
}

TEST_CASE("closing a mesh: triangles that come twice") {
  Parts parts = cube();
  parts.triangles.push_back(parts.triangles[3]);
  parts.triangles.push_back(parts.triangles[7]);
  const MendedMesh one = close_mesh(parts.mesh());
  CHECK(one.repeated == 2);
  CHECK(one.mesh.triangles().size() == 12);
  Parts opposite = cube(); // the copy of a triangle has the other sense
  opposite.triangles.push_back(opposite.triangles[3]);
  opposite.turn(12);
  CHECK(close_mesh(opposite.mesh()).repeated == 1);
  CHECK(differing(close_mesh(opposite.mesh()).mesh, 1.5, in_cube) == 0);

  Parts twice = cube();
  for (const Triangle& t : cube().triangles)
    twice.triangles.push_back(t);
  CHECK_FALSE(twice.mesh().is_closed());
  const MendedMesh all = close_mesh(twice.mesh());
  CHECK(all.mesh.is_closed());
  CHECK(differing_walks(all.mesh, kBox, 1.5) == 0);
}

TEST_CASE("closing a mesh: what is open stays as it is, and says where") {
  Parts lid = cube(), band, wall = cube();
  lid.triangles.erase(lid.triangles.begin() + 2, lid.triangles.begin() + 4);
  lid.turn(0);
  const Mesh given = lid.mesh();
  const MendedMesh open = close_mesh(given);
  CHECK_FALSE(open.mesh.is_closed());
  CHECK(open.mesh.triangles().data() == given.triangles().data());
  CHECK(open.open.edges == 4); // the turned triangle is none of them
  CHECK(open.open.from.z == 1.0);
  CHECK(open.open.to.z == 1.0);
  CHECK(glm::length(open.open.to - open.open.from) == 2.0);

  for (int i = 0; i < 9; ++i) {
    const double u = 2 * std::numbers::pi * i / 9;
    for (const double v : {-0.3, 0.3})
      band.vertices.emplace_back((1 + v * std::cos(u / 2)) * std::cos(u),
                                 (1 + v * std::cos(u / 2)) * std::sin(u), v * std::sin(u / 2));
    const std::int32_t a = 2 * i, b = a + 1, c = i < 8 ? a + 2 : 1, d = i < 8 ? a + 3 : 0;
    band.triangles.insert(band.triangles.end(), {{a, c, b}, {b, c, d}});
  }
  const MendedMesh moebius = close_mesh(band.mesh());
  CHECK_FALSE(moebius.mesh.is_closed());
  CHECK(moebius.open.one_sided);

  wall.vertices.insert(wall.vertices.end(), {{0, -1, -1}, {0, 1, -1}, {0, 0, 1}});
  wall.triangles.push_back({0, 3, 6}); // a membrane along a diagonal
  CHECK_FALSE(close_mesh(wall.mesh()).mesh.is_closed());
  CHECK(close_mesh(wall.mesh()).open.edges == 3);
}

TEST_CASE("closing a mesh: curved meshes with random harm look as before") {
  Random random(124);
  const Mesh ring = torus(24, 12);
  const std::vector<PlacedShape> truth{placed(ring)};
  for (int k = 0; k < 10; ++k) {
    Parts parts;
    for (std::size_t t = 0; t < ring.triangles().size(); ++t) { // each with vertices of its own
      const auto n = static_cast<std::int32_t>(parts.vertices.size());
      for (const dvec3& p : ring.corners(static_cast<int>(t)))
        parts.vertices.push_back(p + random.in_cube(1e-8));
      parts.triangles.push_back({n, n + 1, n + 2});
      const double kind = random.uniform(0.0, 1.0);
      if (kind < 0.2) parts.turn(parts.triangles.size() - 1);
      if (kind > 0.9) parts.triangles.push_back(parts.triangles.back());
      if (kind > 0.4 && kind < 0.6) { // halved at one side: a T-junction
        parts.vertices.push_back(0.5 * (parts.vertices[static_cast<std::size_t>(n)] +
                                        parts.vertices[static_cast<std::size_t>(n) + 1]));
        parts.triangles.back() = {n, n + 3, n + 2};
        parts.triangles.push_back({n + 3, n + 1, n + 2});
      }
    }
    const MendedMesh mended = close_mesh(parts.mesh());
    REQUIRE(mended.mesh.is_closed());
    CHECK(mended.mesh.area() == Approx(ring.area()).epsilon(1e-6));
    CHECK(differing_walks(mended.mesh, truth, 1.6) < 5); // lines within 1e-8 of an edge
  }
}
