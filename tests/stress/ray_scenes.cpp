#include "tests/stress/ray_scenes.h"

#include "geometry/booleans/lens.h"
#include "tests/geometry/mesh_reference.h"

#include <cmath>
#include <utility>

namespace abbe::stress {
namespace {

using Shapes = std::vector<PlacedShape>;

Transform moved(const dvec3& offset) {
  return Transform::translation(offset);
}
Transform sized(const dvec3& factors, const dvec3& offset = dvec3(0.0)) {
  return moved(offset).after(Transform::scaling(factors));
}
Transform brick(const dvec3& lower, const dvec3& upper) {
  return sized(0.5 * (upper - lower), 0.5 * (lower + upper));
}

/// Glass of its own kind, unless it is flat or, sometimes, opaque.
void add(Shapes& shapes, Shape shape, const Transform& at, int medium, int priority = 0) {
  const bool has_inside = is_solid(shape);
  const auto number = static_cast<std::int32_t>(shapes.size());
  shapes.push_back({std::move(shape), at, {number}, {has_inside ? medium : -1}, priority});
}

double log_uniform(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

Convex convex(Random& random) {
  switch (random.below(5)) {
  case 0:
    return Sphere{};
  case 1:
    return Box{};
  case 2:
    return thesis_prism();
  case 3:
    return ConvexPolyhedron(random.planes(6 + random.below(8)));
  default:
    break;
  }
  constexpr double kTops[] = {0.0, 1e-6, 0.3, 1.0 - 1e-9, 1.0, 1.0 + 1e-12, 1.7, 20.0};
  return TaperedCylinder{kTops[random.below(8)]};
}

Shape as_shape(const Convex& solid) {
  return std::visit([](const auto& s) -> Shape { return s; }, solid);
}

Shapes lone_convex(Random& random) {
  Shapes shapes;
  add(shapes, as_shape(convex(random)), Transform(random.linear(), random.in_cube(1.0)),
      random.chance(0.5) ? 1 : -1);
  return shapes;
}

/// Needles and sheets.
Shapes stretched(Random& random) {
  Shapes shapes;
  const dvec3 factors(log_uniform(random, 1e-3, 1.0), log_uniform(random, 1e-3, 1.0), 1.0);
  add(shapes, as_shape(convex(random)),
      Transform(random.rotation(), random.in_cube(0.5)).after(Transform::scaling(factors)), 1);
  return shapes;
}

/// A lens by its edge: the glass is `edge` of the diameter thick at the rim.
LensElement lens_with_edge(double front, double back, double edge, double vertex) {
  LensElement lens{front, back, 0.0, 2.0, vertex};
  lens.thickness = sag(front, 1.0) - sag(back, 1.0) + 2.0 * edge;
  return lens;
}

Shapes sharp_lens(Random& random) {
  Shapes shapes;
  const double edge = random.chance(0.5) ? 1e-6 : log_uniform(random, 1e-9, 1e-2);
  const double front = log_uniform(random, 1.0 + 1e-6, 30.0);
  const double back = random.chance(0.3) ? 0.0 : -log_uniform(random, 1.0 + 1e-6, 30.0);
  add(shapes, lens_element(lens_with_edge(front, back, edge, -0.5)), Transform(), 1);
  return shapes;
}

/// Radii up to 1e6 of the diameter, or next to half of it.
Shapes extreme_lens(Random& random) {
  Shapes shapes;
  const auto radius = [&] {
    const double r =
        random.chance(0.5) ? log_uniform(random, 1e2, 1e6) : 1.0 + log_uniform(random, 1e-14, 1e-3);
    return random.chance(0.5) ? r : -r;
  };
  LensElement lens{radius(), radius(), 0.0, 2.0, 0.1};
  const double least = sag(lens.front_radius, 1.0) - sag(lens.back_radius, 1.0);
  lens.thickness = std::max(least, 0.0) + log_uniform(random, 1e-6, 0.3);
  try {
    add(shapes, lens_element(lens), Transform(), 1);
  } catch (const std::invalid_argument&) { // thicker than one of its balls
    add(shapes, lens_element({1.0, -1.0, 2.0, 2.0, -1.0}), Transform(), 1); // a full ball
  }
  return shapes;
}

/// A group of elements whose surfaces are shared.
Shapes cemented(Random& random) {
  Shapes shapes;
  double vertex = -0.5, front = log_uniform(random, 1.5, 20.0);
  for (int i = 0; i < 2 + random.below(2); ++i) {
    const double back =
        random.chance(0.2) ? 0.0 : (i % 2 ? 1.0 : -1.0) * log_uniform(random, 1.5, 20.0);
    const LensElement lens = lens_with_edge(front, back, log_uniform(random, 1e-3, 0.2), vertex);
    if (lens.thickness < 1e-3) break;
    try {
      add(shapes, lens_element(lens), Transform(), i + 1);
    } catch (const std::invalid_argument&) {
      break;
    }
    vertex = lens.back_vertex();
    front = back;
  }
  if (shapes.empty()) return sharp_lens(random);
  return shapes;
}

/// Operands minus operands minus operands, nested on either side.
Shapes deep_difference(Random& random) {
  Shapes shapes;
  const auto leaf = [&](double size) {
    return CsgTree(convex(random),
                   moved(random.in_cube(0.6)).after(Transform(random.linear() * size, dvec3(0.0))));
  };
  CsgTree tree = leaf(1.0);
  for (int depth = 0; depth < 6; ++depth)
    tree = random.chance(0.5) ? CsgTree(CsgOperation::subtract, tree, leaf(0.5))
                              : CsgTree(CsgOperation::subtract, leaf(1.0), tree);
  add(shapes, tree, Transform(random.rotation(), random.in_cube(0.5)), random.chance(0.7) ? 1 : -1);
  return shapes;
}

Shapes mixed_tree(Random& random) {
  Shapes shapes;
  const auto leaf = [&] {
    return CsgTree(convex(random), Transform(random.linear(), random.in_cube(0.7)));
  };
  const auto operation = [&] { return static_cast<CsgOperation>(random.below(3)); };
  const auto pair = [&] { return CsgTree(operation(), leaf(), leaf()); };
  add(shapes, CsgTree(operation(), CsgTree(operation(), pair(), pair()), pair()), Transform(), 1);
  return shapes;
}

/// Operands with faces in common: cuts flush with faces, halves put together again.
Shapes flush_tree(Random& random) {
  Shapes shapes;
  const auto block = [](const dvec3& lower, const dvec3& upper) {
    return CsgTree(Box{}, brick(lower, upper));
  };
  const double h = random.uniform(-0.5, 0.5);
  CsgTree whole = block({-1, -1, -1}, {1, 1, 1});
  switch (random.below(4)) {
  case 0: // a corner cut out, flush with three faces
    whole = CsgTree(CsgOperation::subtract, whole, block({h, h, h}, {1, 1, 1}));
    break;
  case 1: // two halves that share a face
    whole =
        CsgTree(CsgOperation::unite, block({-1, -1, -1}, {1, 1, h}), block({-1, -1, h}, {1, 1, 1}));
    break;
  case 2: // a bore from face to face
    whole = CsgTree(CsgOperation::subtract, whole,
                    CsgTree(TaperedCylinder{1.0}, sized({0.5, 0.5, 2.0}, {h, 0, -1})));
    break;
  default: // a ball that touches six faces, taken away
    whole = CsgTree(CsgOperation::subtract, whole, CsgTree(Sphere{}, Transform()));
    break;
  }
  add(shapes, whole, Transform(), 1);
  return shapes;
}

Shapes touching(Random& random) {
  Shapes shapes;
  const double h = random.uniform(-0.5, 0.5);
  switch (random.below(4)) {
  case 0: // four blocks in a square, a fifth on top
    add(shapes, Box{}, brick({-1, -1, -1}, {h, h, 0}), 1);
    add(shapes, Box{}, brick({h, -1, -1}, {1, h, 0}), 2);
    add(shapes, Box{}, brick({-1, h, -1}, {h, 1, 0}), 3);
    add(shapes, Box{}, brick({h, h, -1}, {1, 1, 0}), -1);
    add(shapes, Box{}, brick({-1, -1, 0}, {1, 1, 1}), 4);
    break;
  case 1: // balls that touch each other and a block
    add(shapes, Sphere{}, sized(dvec3(0.5), {-0.5, 0, 0.5}), 1);
    add(shapes, Sphere{}, sized(dvec3(0.5), {0.5, 0, 0.5}), 2);
    add(shapes, Box{}, brick({-1, -1, -0.5}, {1, 1, 0}), 3);
    break;
  case 2: // a cylinder between a cone and a wider one
    add(shapes, TaperedCylinder{1.0}, sized(dvec3(0.5)), 1);
    add(shapes, TaperedCylinder{0.0}, sized(dvec3(0.5), {0, 0, 0.5}), 2);
    add(shapes, TaperedCylinder{2.0}, Transform(glm::dmat3(-0.5), dvec3(0.0)), 3);
    break;
  default: // a shell, the ball that fills it, and a lens through both
    add(shapes,
        CsgTree(CsgOperation::subtract, CsgTree(Sphere{}, Transform()),
                CsgTree(Sphere{}, sized(dvec3(0.6), {0.1, h / 4, 0}))),
        Transform(), 1);
    add(shapes, Sphere{}, sized(dvec3(0.6), {0.1, h / 4, 0}), 2);
    break;
  }
  return shapes;
}

Shapes overlapping(Random& random) {
  Shapes shapes;
  for (int i = 0; i < 3; ++i)
    add(shapes, as_shape(convex(random)), Transform(random.linear() * 0.7, random.in_cube(0.6)),
        random.chance(0.9) ? 1 + random.below(3) : -1, random.below(3));
  return shapes;
}

Shapes nested(Random& random) {
  Shapes shapes;
  double radius = 1.0;
  for (int i = 0; i < 10; ++i) { // more than a short list of solids holds
    add(shapes, i % 2 ? Shape(Box{}) : Shape(Sphere{}),
        Transform(random.rotation() * radius, dvec3(0.0)), i + 1, i);
    radius *= 0.55;
  }
  return shapes;
}

Shapes flat_ones(Random& random) {
  Shapes shapes;
  add(shapes, Box{}, Transform(), 1);
  add(shapes, Square{}, sized(dvec3(0.8), {0, 0, 1}), -1);
  add(shapes, Disc{}, Transform(random.rotation(), random.in_cube(1.0)), -1);
  add(shapes, Plane{}, moved({0, 0, -1}), -1);
  add(shapes, Sphere{}, sized(dvec3(0.4), {1.4, 0, -0.6}), 2); // on the plane and beside the box
  return shapes;
}

Shapes sliver_mesh(Random& random) {
  Shapes shapes;
  const double thin = log_uniform(random, 1e-6, 1e-2);
  const auto form = [&]() -> Mesh {
    switch (random.below(4)) {
    case 0:
      return reference::torus(24, 3);
    case 1:
      return reference::torus(3, 24);
    case 2:
      return reference::torus(8, 4, 1.0, thin);
    default:
      return reference::torus(8, 4, thin, 1.0);
    }
  };
  add(shapes, form(), Transform(random.linear(), random.in_cube(0.3)), random.chance(0.7) ? 1 : -1);
  return shapes;
}

Shapes jagged_mesh(Random& random) {
  Shapes shapes;
  const Mesh ball = reference::icosphere(random.below(2));
  std::vector<dvec3> vertices = ball.vertices();
  for (dvec3& v : vertices)
    v *= random.uniform(0.4, 1.0);
  add(shapes, Mesh(vertices, ball.triangles()), Transform(random.linear(), random.in_cube(0.3)), 1);
  return shapes;
}

/// Meshes that share faces with each other and with a box.
Shapes touching_meshes(Random& random) {
  Shapes shapes;
  const double h = random.uniform(-0.5, 0.5);
  const auto block = [&](double low, double high) {
    std::vector<dvec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.emplace_back(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? high : low);
    return Mesh(corners, {{0, 2, 1},
                          {1, 2, 3},
                          {4, 5, 6},
                          {5, 7, 6},
                          {0, 1, 4},
                          {1, 5, 4},
                          {2, 6, 3},
                          {3, 6, 7},
                          {0, 4, 2},
                          {2, 4, 6},
                          {1, 3, 5},
                          {3, 7, 5}});
  };
  add(shapes, block(-1.0, h), Transform(), 1);
  add(shapes, block(h, 1.0), Transform(), 2);
  add(shapes, Box{}, brick({1, -1, -1}, {2, 1, 1}), 3);
  return shapes;
}

using Kind = std::pair<const char*, Shapes (*)(Random&)>;
constexpr Kind kKinds[kKindsOfScenes] = {
    {"convex", lone_convex},
    {"stretched", stretched},
    {"sharp_lens", sharp_lens},
    {"extreme_lens", extreme_lens},
    {"cemented", cemented},
    {"deep_difference", deep_difference},
    {"mixed_tree", mixed_tree},
    {"flush_tree", flush_tree},
    {"touching", touching},
    {"overlapping", overlapping},
    {"nested", nested},
    {"flat", flat_ones},
    {"sliver_mesh", sliver_mesh},
    {"jagged_mesh", jagged_mesh},
    {"touching_meshes", touching_meshes},
    {"lens_and_flat", nullptr},
};

} // namespace

RayScene ray_scene(int kind, Random& random) {
  RayScene scene;
  if (kKinds[kind].second) {
    scene.name = kKinds[kind].first;
    scene.shapes = kKinds[kind].second(random);
  } else { // a card in a lens, one on it
    scene.name = kKinds[kind].first;
    scene.shapes = sharp_lens(random);
    add(scene.shapes, Square{}, sized(dvec3(0.3), {0.1, 0.2, -0.4}), -1);
    add(scene.shapes, Plane{}, Transform(random.rotation(), random.in_cube(1.0)), -1);
  }
  constexpr double kSizes[] = {1.0, 1.0, 1.0, 1e-4, 1e4, 0.37};
  scene.size = kSizes[random.below(6)];
  if (random.chance(0.4)) scene.middle = random.direction() * scene.size;
  if (random.chance(0.2)) scene.middle *= log_uniform(random, 1.0, 1e6);
  const glm::dmat3 turn = random.chance(0.4) ? glm::dmat3(1.0) : random.rotation();
  const Transform frame(turn * scene.size, scene.middle);
  for (PlacedShape& shape : scene.shapes)
    shape.to_world = frame.after(shape.to_world);
  return scene;
}

} // namespace abbe::stress
