#include "tests/stress/furnace/random_scene.h"

#include <fmt/format.h>

namespace abbe::stress {
namespace {

std::string text(const Placing& placing) {
  const auto& v = placing.values;
  switch (placing.kind) {
  case Placing::Kind::translate:
    return fmt::format("translate {} {} {} ", v[0], v[1], v[2]);
  case Placing::Kind::rotate:
    return fmt::format("rotate {} {} {} {} ", v[0], v[1], v[2], v[3]);
  case Placing::Kind::scale:
    break;
  }
  return fmt::format("scale {} {} {} ", v[0], v[1], v[2]);
}

const char* keyword(Solid::Kind kind) {
  using enum Solid::Kind;
  switch (kind) {
  case sphere:
    return "sphere";
  case cube:
    return "cube";
  case prism:
    return "prism";
  case cylinder:
    return "cylinder";
  case cone:
    return "cone";
  case tapered_cylinder:
    return "taperedCylinder";
  case planes:
    return "polyhedron planes";
  case lens_element:
    return "lensElement";
  case cemented:
    return "cemented";
  case mesh:
    return "mesh";
  case set_union:
    return "union";
  case intersection:
    return "intersection";
  case difference:
    return "difference";
  case square:
    return "square";
  case disc:
    break;
  }
  return "disc";
}

std::string arguments(const Solid& solid) {
  using enum Solid::Kind;
  const std::vector<double>& n = solid.numbers;
  if (solid.kind == mesh) return fmt::format("\"{}\"", solid.names[0]);
  if (solid.kind == cemented)
    return fmt::format("2 {} {} {} {} {} {} {} {}", n[0], n[1], solid.names[0], n[2], n[3],
                       solid.names[1], n[4], n[5]);
  std::string words;
  if (solid.kind == planes) words = fmt::format("{} ", n.size() / 4);
  return words + fmt::format("{}", fmt::join(n, " "));
}

std::string text(const Solid& solid) {
  std::string words = "push ";
  for (const Placing& placing : solid.placing)
    words += text(placing);
  words += keyword(solid.kind);
  words += " " + arguments(solid) + " ";
  for (const Solid& operand : solid.operands)
    words += text(operand);
  return words + "pop ";
}

/// The statements that set a medium's index.
std::string index(const Substance& substance) {
  if (substance.glass.empty()) return fmt::format("speedOfLight {} ", substance.index);
  std::string words = "glass " + substance.glass + " ";
  if (substance.dispersion_scale != 1.0)
    words += fmt::format("dispersionScale {} ", substance.dispersion_scale);
  return words;
}

std::string text(const Substance& substance) {
  using enum Substance::Kind;
  const Substance& s = substance;
  const std::string black = "defaultMaterials ambient 0 0 0 diffuse 0 0 0 ";
  const std::string rough = s.roughness > 0.0 ? fmt::format("roughness {} ", s.roughness) : "";
  const std::string absorbs = s.absorption > 0.0 ? fmt::format("absorption {} ", s.absorption) : "";
  switch (s.kind) {
  case clear:
  case shares: {
    std::string words = black + index(s);
    words += fmt::format("reflectivity {} transparency {} ", s.reflectivity, s.transparency);
    if (s.kind == shares) return words + "fresnel off " + absorbs + rough;
    if (s.layer.thickness > 0.0)
      words += fmt::format("thinFilm {} {} ", s.layer.thickness, s.layer.index);
    return words + absorbs + rough;
  }
  case mirror:
    return black + fmt::format("fresnel off reflectivity {} ", s.reflectivity) + rough;
  case diffuse:
    return black + fmt::format("diffuse {0} {0} {0} emissive E {1} ", s.reflectivity, s.emission);
  case coated:
    return black + fmt::format("diffuse 1 1 1 coat {} ", s.layer.index) + rough;
  case pane:
    return black + fmt::format("thinGlass {} {} ", s.layer.thickness, s.layer.index) + absorbs;
  case speckled:
    break;
  }
  Substance whole = s;
  whole.kind = clear;
  Substance spot;
  spot.kind = mirror;
  return text(whole) + "defMaterial whole " + text(spot) + "defMaterial spot " +
         fmt::format("defaultMaterials mix spot whole {} ", s.share);
}

/// Six squares that shine inwards and outwards.
std::string glowing_walls() {
  std::string words = "defaultMaterials ambient 0 0 0 diffuse 0 0 0 emissive E 1\n";
  for (const char* turn :
       {"0 1 0 0", "180 1 0 0", "90 1 0 0", "-90 1 0 0", "90 0 1 0", "-90 0 1 0"})
    words += fmt::format("push rotate {} translate 0 0 20 scale 20 20 1 square pop\n", turn);
  return words;
}

} // namespace

std::string scene_text(const RandomScene& scene, const std::string& settings) {
  std::string words = fmt::format(
      "eye {} lookAt {} fieldOfView {}\nbands {} exact {} jitter {} {}\n",
      fmt::join(scene.eye, " "), fmt::join(scene.look_at, " "), scene.field_of_view, scene.bands,
      scene.exact ? "on" : "off", scene.jitter ? "on" : "off", scene.more_settings);
  words += settings + "\n";
  words += scene.surroundings == Surroundings::background ? "background E 1\n" : glowing_walls();
  for (const Item& item : scene.items)
    words += text(item.substance) + fmt::format("priority {}\n  ", item.priority) +
             text(item.solid) + "\n";
  return words;
}

} // namespace abbe::stress
