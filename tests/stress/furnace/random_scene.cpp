#include "tests/stress/furnace/random_scene.h"

#include "tests/stress/furnace/random_numbers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe::stress {
namespace {

Placing translate(double x, double y, double z) {
  return {Placing::Kind::translate, {x, y, z, 0.0}};
}

Placing scale(double x, double y, double z) {
  return {Placing::Kind::scale, {x, y, z, 0.0}};
}

/// Draws the parts of one scene.
class Draw {
public:
  Draw(std::uint64_t seed, Losses losses, std::string folder)
      : random_(seed * 2 + (losses == Losses::lossy)), losses_(losses), folder_(std::move(folder)) {
    // Rough surfaces and diffuse ones need the path tracer, which is the slower one.
    by_path_ = losses_ == Losses::lossless && random_.chance(0.5);
    rough_ = losses_ == Losses::lossless && random_.chance(0.15);
    // Shares that stand by themselves lose what total reflection keeps from passing.
    one_index_ = losses_ == Losses::lossless && random_.chance(0.1);
  }

  RandomScene scene() {
    RandomScene scene;
    const int count = 1 + random_.below(5);
    for (int i = 0; i < count; ++i)
      scene.items.push_back(item(scene.items));
    keep_out_what_is_no_furnace(scene.items);
    settings(scene);
    return scene;
  }

private:
  /// In a medium of index n the field is n^2. What gives off 1 less its reflectance is in balance
  /// in air alone, so nothing gives off light where a solid of another index could stand around it.
  /// A pane on a solid's face gives way to it, with what it would absorb: where light is lost,
  /// panes stand a little beside.
  void keep_out_what_is_no_furnace(std::vector<Item>& items) {
    const bool dense = std::ranges::any_of(items, [](const Item& item) {
      const Substance& s = item.substance;
      return !item.solid.names.empty() ||
             (s.lets_light_in() && (!s.glass.empty() || s.index != 1.0));
    });
    for (Item& item : items) {
      Substance& substance = item.substance;
      if (dense && substance.emission > 0.0) {
        substance.emission = 0.0;
        substance.reflectivity = 1.0;
      }
      if (losses_ == Losses::lossy && item.solid.flat())
        item.solid.placing.push_back(translate(0.0, 0.0, 0.0371));
    }
  }

  Placing turn() {
    return {Placing::Kind::rotate,
            {random_.between(0.0, 360.0), random_.between(-1.0, 1.0), random_.between(-1.0, 1.0),
             random_.between(0.1, 1.0)}};
  }

  Placing stretch() {
    if (random_.chance(0.5)) {
      const double size = random_.log_between(0.4, 1.5);
      return scale(size, size, size);
    }
    return scale(random_.log_between(0.3, 1.5), random_.log_between(0.3, 1.5),
                 random_.log_between(0.3, 1.5));
  }

  /// Half-spaces about the origin: those of a cube, and some that cut its corners.
  Solid polyhedron() {
    Solid solid{Solid::Kind::planes};
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0})
        for (int i = 0; i < 4; ++i)
          solid.numbers.push_back(i == 3 ? random_.between(0.6, 1.1) : i == axis ? sign : 0.0);
    for (int cuts = random_.below(5); cuts > 0; --cuts) {
      for (int i = 0; i < 3; ++i)
        solid.numbers.push_back(random_.one_of({-1.0, 1.0}) * random_.between(0.2, 1.0));
      solid.numbers.push_back(random_.between(0.6, 1.2));
    }
    return solid;
  }

  Solid lens_element() {
    const double diameter = random_.between(1.0, 2.5);
    const auto radius = [&] {
      return random_.chance(0.2)
                 ? 0.0
                 : random_.one_of({-1.0, 1.0}) * diameter * random_.log_between(0.75, 8.0);
    };
    return {Solid::Kind::lens_element,
            {radius(), radius(), diameter * random_.between(0.3, 0.6), diameter}};
  }

  Solid cemented() {
    const double diameter = random_.between(1.5, 2.5);
    const double bend = diameter * random_.log_between(1.0, 4.0);
    return {Solid::Kind::cemented,
            {diameter, bend, 0.4 * diameter, -bend * random_.between(0.8, 1.5), 0.3 * diameter,
             random_.chance(0.3) ? 0.0 : -2.0 * bend},
            {},
            {},
            {"N-BK7", "SF10"}};
  }

  Solid simple() {
    using enum Solid::Kind;
    switch (random_.below(8)) {
    case 0:
    case 1:
      return {sphere};
    case 2:
      return {cube};
    case 3:
      return {prism};
    case 4:
      return {cylinder};
    case 5:
      return {cone};
    case 6:
      return {tapered_cylinder, {random_.between(0.2, 2.0)}};
    default:
      return polyhedron();
    }
  }

  Solid boolean(int depth) {
    using enum Solid::Kind;
    Solid solid{random_.one_of({set_union, intersection, difference, difference})};
    for (int i = 0; i < 2; ++i) {
      Solid operand = depth > 1 && random_.chance(0.4) ? boolean(depth - 1) : simple();
      operand.placing.clear();
      if (i == 1) operand.placing.push_back(translate(shift(), shift(), shift()));
      if (random_.chance(0.5)) operand.placing.push_back(turn());
      if (random_.chance(0.5)) operand.placing.push_back(stretch());
      solid.operands.push_back(operand);
    }
    return solid;
  }

  /// Small, and now and then exactly 0: faces then coincide.
  double shift() { return random_.chance(0.3) ? 0.0 : random_.between(-0.7, 0.7); }

  Solid any() {
    const double kind = random_.uniform();
    if (kind < 0.55) return simple();
    if (kind < 0.78) return boolean(3);
    if (kind < 0.9) return lens_element();
    return {Solid::Kind::mesh,
            {},
            {},
            {},
            {folder_ + "/" +
             random_.one_of<const char*>({"ball.obj", "ring.obj", "star.obj", "wedge.obj"})}};
  }

  /// Where a solid stands: anywhere near the middle, or in a chosen relation to an earlier one.
  void place(Solid& solid, const std::vector<Item>& before) {
    if (before.empty() || random_.chance(0.35)) {
      solid.placing = {translate(random_.between(-1.3, 1.3), random_.between(-1.3, 1.3),
                                 random_.between(-1.3, 1.3)),
                       turn(), stretch()};
      return;
    }
    const Item& other =
        before[static_cast<std::size_t>(random_.below(static_cast<int>(before.size())))];
    solid.placing = other.solid.placing;
    switch (random_.below(4)) {
    case 0: { // inside, or around
      const double size = random_.chance(0.7) ? random_.between(0.3, 0.9) : 1.0 / 0.8;
      solid.placing.push_back(scale(size, size, size));
      return;
    }
    case 1: { // side by side: solids that reach from -1 to 1 touch
      std::array<double, 3> to{};
      to[static_cast<std::size_t>(random_.below(3))] = random_.one_of({-2.0, 2.0, -1.0, 1.0});
      solid.placing.push_back(translate(to[0], to[1], to[2]));
      return;
    }
    case 2: // at the same place: if it is the same solid, all faces coincide
      if (random_.chance(0.5) && !other.solid.flat()) {
        const std::vector<Placing> placing = solid.placing;
        solid = other.solid;
        solid.placing = placing;
      }
      return;
    default: // across
      solid.placing.push_back(translate(random_.between(-1.0, 1.0), random_.between(-1.0, 1.0),
                                        random_.between(-1.0, 1.0)));
    }
  }

  void index(Substance& substance) {
    if (one_index_) {
      substance.index = 1.0;
      return;
    }
    if (random_.chance(0.4)) {
      substance.glass = random_.one_of<const char*>({"N-BK7", "SF11", "F2", "N-SF6", "CAF2"});
      if (losses_ == Losses::lossless && random_.chance(0.2)) substance.dispersion_scale = 3.0;
      return;
    }
    substance.index = random_.one_of({1.0, 1.0001, 1.33, 1.5, 1.5, 1.76, 2.4, 0.8});
  }

  Substance clear() {
    Substance substance;
    index(substance);
    if (losses_ == Losses::lossy) {
      if (random_.chance(0.8)) substance.absorption = random_.log_between(0.02, 1.0);
      if (random_.chance(0.2)) substance.transparency = random_.between(0.5, 1.0);
      if (random_.chance(0.2)) substance.reflectivity = random_.between(0.0, 1.0);
    }
    if (rough_ && random_.chance(0.5))
      substance.roughness = random_.between(0.1, 1.0);
    else if (random_.chance(0.25))
      substance.layer = {random_.log_between(20.0, 3000.0), random_.one_of({1.33, 1.38, 1.9, 2.3})};
    return substance;
  }

  Substance shares() {
    Substance substance{Substance::Kind::shares};
    index(substance);
    substance.transparency = random_.below(5) / 4.0;
    substance.reflectivity = 1.0 - substance.transparency;
    if (losses_ == Losses::lossy) substance.transparency *= random_.between(0.5, 1.0);
    return substance;
  }

  Substance opaque() {
    Substance substance{Substance::Kind::mirror};
    const bool loses = losses_ == Losses::lossy;
    if (loses) substance.reflectivity = random_.between(0.0, 1.0);
    if (!by_path_ || random_.chance(0.4)) {
      if (rough_) substance.roughness = random_.between(0.1, 1.0);
      return substance;
    }
    substance.kind = Substance::Kind::diffuse;
    if (random_.chance(0.3)) {
      substance.kind = Substance::Kind::coated;
      substance.layer = {1.0, random_.between(1.2, 2.0)};
      if (rough_) substance.roughness = random_.between(0.1, 1.0);
    } else if (random_.chance(0.6)) {
      substance.reflectivity = random_.between(0.1, 0.9);
      substance.emission = 1.0 - substance.reflectivity;
    }
    return substance;
  }

  Substance pane() {
    Substance substance{Substance::Kind::pane};
    substance.layer = {random_.between(0.1, 5.0), random_.one_of({1.33, 1.5, 2.0})};
    if (losses_ == Losses::lossy) substance.absorption = random_.log_between(0.01, 0.3);
    return substance;
  }

  Substance material() {
    const double kind = random_.uniform();
    if (kind < (one_index_ ? 0.3 : 0.7)) return clear();
    if (one_index_ ? kind < 0.8 : losses_ == Losses::lossy && kind < 0.8) return shares();
    if (kind < 0.87 && losses_ == Losses::lossless) {
      Substance substance = clear();
      substance.kind = Substance::Kind::speckled;
      substance.share = random_.between(0.1, 0.9);
      return substance;
    }
    return opaque();
  }

  Item item(const std::vector<Item>& before) {
    Item item;
    item.priority = random_.below(3);
    if (random_.chance(0.1)) {
      item.solid.kind = random_.one_of({Solid::Kind::square, Solid::Kind::disc});
      item.substance = pane();
    } else if (losses_ == Losses::lossless && !one_index_ && random_.chance(0.08)) {
      item.solid = cemented(); // brings its own glasses
    } else {
      item.solid = any();
      item.substance = material();
    }
    place(item.solid, before);
    if (item.solid.flat() != (item.substance.kind == Substance::Kind::pane))
      item.substance = item.solid.flat() ? pane() : clear();
    return item;
  }

  void settings(RandomScene& scene) {
    const double polar = std::acos(random_.between(-1.0, 1.0));
    const double around = random_.between(0.0, 2.0 * std::numbers::pi);
    const double far = random_.between(8.0, 12.0);
    scene.eye = {far * std::sin(polar) * std::cos(around), far * std::sin(polar) * std::sin(around),
                 far * std::cos(polar)};
    for (double& x : scene.look_at)
      x = random_.between(-0.7, 0.7);
    scene.field_of_view = random_.between(12.0, 30.0);
    scene.bands = losses_ == Losses::lossy ? 3 : random_.one_of({1, 3, 3, 7});
    scene.exact = losses_ == Losses::lossy || random_.chance(0.3);
    scene.jitter = losses_ == Losses::lossless;
    if (losses_ == Losses::lossless && random_.chance(0.4))
      scene.surroundings = Surroundings::glowing_walls;
    if (losses_ == Losses::lossless)
      scene.more_settings =
          random_.one_of<const char*>({"", "", "", "maxFan 1", "tolerance 0", "tolerance 10",
                                       "filter box", "minThroughput 0.05"});
  }

  RandomNumbers random_;
  Losses losses_;
  std::string folder_;
  bool by_path_ = false, rough_ = false, one_index_ = false;
};

} // namespace

bool RandomScene::needs_path() const {
  return std::any_of(items.begin(), items.end(),
                     [](const Item& item) { return item.substance.needs_path(); });
}

bool RandomScene::has_rough() const {
  return std::any_of(items.begin(), items.end(),
                     [](const Item& item) { return item.substance.roughness > 0.0; });
}

RandomScene random_scene(std::uint64_t seed, Losses losses, const std::string& folder) {
  RandomScene scene = Draw(seed, losses, folder).scene();
  scene.seed = seed;
  return scene;
}

} // namespace abbe::stress
