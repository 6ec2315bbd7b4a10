#include "tests/stress/furnace/shrink.h"

#include <cmath>

namespace abbe::stress {
namespace {

using Candidates = std::vector<RandomScene>;

/// The solids that are simpler than this one.
std::vector<Solid> simpler(const Solid& solid) {
  std::vector<Solid> all;
  const auto offer = [&](auto&& change) {
    Solid changed = solid;
    change(changed);
    all.push_back(changed);
  };
  for (const Solid& operand : solid.operands)
    offer([&](Solid& changed) {
      changed = operand;
      changed.placing.insert(changed.placing.begin(), solid.placing.begin(), solid.placing.end());
    });
  if (solid.operands.empty() && solid.kind != Solid::Kind::sphere && !solid.flat())
    offer([](Solid& changed) { changed = {Solid::Kind::sphere, {}, changed.placing, {}, {}}; });
  for (std::size_t i = 0; i < solid.placing.size(); ++i)
    offer([&](Solid& changed) {
      changed.placing.erase(changed.placing.begin() + static_cast<std::ptrdiff_t>(i));
    });
  for (std::size_t i = 0; i < solid.operands.size(); ++i)
    for (const Solid& operand : simpler(solid.operands[i]))
      offer([&](Solid& changed) { changed.operands[i] = operand; });
  if (solid.kind == Solid::Kind::planes && solid.numbers.size() > 24)
    offer([](Solid& changed) { changed.numbers.resize(changed.numbers.size() - 4); });
  return all;
}

/// The substances that differ in one thing, which is as plain as can be.
std::vector<Substance> simpler(const Substance& substance) {
  std::vector<Substance> all;
  const auto offer = [&](auto member, auto plain) {
    if (substance.*member == plain) return;
    Substance changed = substance;
    changed.*member = plain;
    all.push_back(changed);
  };
  if (substance.kind == Substance::Kind::speckled) offer(&Substance::kind, Substance::Kind::clear);
  if (substance.lets_light_in()) {
    offer(&Substance::glass, std::string());
    if (substance.glass.empty()) offer(&Substance::index, 1.5);
    if (substance.layer.thickness > 0.0) {
      all.push_back(substance);
      all.back().layer = {};
    }
    if (substance.kind == Substance::Kind::clear) {
      offer(&Substance::reflectivity, 1.0);
      offer(&Substance::transparency, 1.0);
    }
  }
  offer(&Substance::absorption, 0.0);
  offer(&Substance::roughness, 0.0);
  offer(&Substance::dispersion_scale, 1.0);
  return all;
}

/// All scenes that are one step simpler.
Candidates candidates(const RandomScene& scene) {
  Candidates all;
  const auto offer = [&](auto&& change) {
    RandomScene changed = scene;
    change(changed);
    all.push_back(changed);
  };
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    offer([&](RandomScene& s) { s.items.erase(s.items.begin() + static_cast<std::ptrdiff_t>(i)); });
  if (scene.surroundings != Surroundings::background)
    offer([](RandomScene& s) { s.surroundings = Surroundings::background; });
  if (!scene.more_settings.empty()) offer([](RandomScene& s) { s.more_settings.clear(); });
  if (scene.bands > 1) offer([](RandomScene& s) { s.bands = 1; });
  if (scene.exact) offer([](RandomScene& s) { s.exact = false; });
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    for (const Solid& solid : simpler(scene.items[i].solid))
      offer([&](RandomScene& s) { s.items[i].solid = solid; });
    if (scene.items[i].solid.kind != Solid::Kind::cemented)
      for (const Substance& substance : simpler(scene.items[i].substance))
        offer([&](RandomScene& s) { s.items[i].substance = substance; });
    if (scene.items[i].priority != 0) offer([&](RandomScene& s) { s.items[i].priority = 0; });
  }
  return all;
}

} // namespace

RandomScene shrunk(RandomScene scene, const std::function<bool(const RandomScene&)>& fails) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const RandomScene& candidate : candidates(scene))
      if (fails(candidate)) {
        scene = candidate;
        smaller = true;
        break;
      }
  }
  return scene;
}

} // namespace abbe::stress
