#include "io/building/keyword_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <variant>

namespace abbe {
namespace {

bool is_specular(const Material& finish) {
  return !finish.reflectivity.zero() || is_transparent(finish);
}
bool never(const ShapeMaterial&) {
  return false;
}

/// What fills a solid, or a pane's glass, is seen.
bool has_filling(const ShapeMaterial& m, bool is_solid) {
  return m.finish.pane || (is_solid && is_transparent(m.finish));
}
constexpr std::string_view kNoFilling = "nothing of this material is filled: it lets no light in, "
                                        "or the shape has no inside";

constexpr auto kMaterialEffects = std::to_array<MaterialEffect>({
    {"roughness", MaterialSlot::roughness,
     [](const ShapeMaterial& m) { return m.finish.roughness == 0.0; },
     [](const ShapeMaterial& m, bool) { return is_specular(m.finish) || m.finish.coat; },
     "the surface neither mirrors nor refracts, and has no coat"},
    {"compensation", MaterialSlot::compensation,
     [](const ShapeMaterial& m) { return m.finish.compensation; },
     [](const ShapeMaterial& m, bool) {
       return m.finish.roughness > 0.0 && !m.finish.coat && is_specular(m.finish);
     },
     "the surface has no rough mirror or glass"},
    {"thinFilm", MaterialSlot::film, [](const ShapeMaterial& m) { return !m.finish.film; },
     [](const ShapeMaterial& m, bool) { return m.finish.fresnel && is_specular(m.finish); },
     "with fresnel off, or without any reflectivity and transparency, no film is seen"},
    {"reflectivity", MaterialSlot::reflectivity,
     [](const ShapeMaterial& m) { return m.finish.reflectivity.zero(); },
     [](const ShapeMaterial& m, bool) { return !m.finish.coat; },
     "a coat reflects by its own index"},
    {"specularExponent", MaterialSlot::specular_exponent,
     [](const ShapeMaterial& m) { return m.finish.specular_exponent == 1.0; },
     [](const ShapeMaterial& m, bool) { return !m.finish.specular.zero(); },
     "there is no highlight: specular is 0"},
    {"emissiveSides", MaterialSlot::emissive_sides,
     [](const ShapeMaterial& m) { return m.finish.emits_behind; },
     [](const ShapeMaterial& m, bool is_solid) { return !is_solid && !m.finish.emission.zero(); },
     "the surface gives off no light, or is a solid's, which gives it off outwards"},
    {"fresnel", MaterialSlot::fresnel, [](const ShapeMaterial& m) { return m.finish.fresnel; },
     [](const ShapeMaterial& m, bool) {
       return is_transparent(m.finish) || (m.finish.metal && !m.finish.reflectivity.zero());
     },
     "the surface is neither glass nor metal"},
    {"speedOfLight", MaterialSlot::index, never, has_filling, kNoFilling},
    {"vnum", MaterialSlot::vnum, never, has_filling, kNoFilling},
    {"dispersionScale", MaterialSlot::dispersion_scale, never, has_filling, kNoFilling},
    {"absorption", MaterialSlot::absorption, never, has_filling, kNoFilling},
    {"absorptionTable", MaterialSlot::absorption, never, has_filling, kNoFilling},
    {"internalTransmittance", MaterialSlot::absorption, never, has_filling, kNoFilling},
    {"drops", MaterialSlot::drops, never, has_filling, kNoFilling},
});

template <class... Kinds>
bool is_one_of(const LightKind& kind) {
  return (std::holds_alternative<Kinds>(kind) || ...);
}

constexpr auto kLightEffects = std::to_array<LightEffect>({
    {"falloff", LightSlot::falloff, is_one_of<PointLight, SpotLight>,
     "only points and spotlights fall off"},
    {"intensity", LightSlot::intensity, [](const LightKind&) { return true; }, ""},
    {"softEdge", LightSlot::soft_edge, is_one_of<SpotLight>, "only spotlights have an edge"},
    {"sunRadius", LightSlot::sun_radius, is_one_of<SunLight>, "only suns have a disc"},
});

template <class Row>
const Row* row_of(std::span<const Row> table, std::string_view keyword) {
  const auto row = std::ranges::find(table, keyword, &Row::keyword);
  return row == table.end() ? nullptr : &*row;
}

} // namespace

const MaterialEffect* material_effect(std::string_view keyword) {
  return row_of<MaterialEffect>(kMaterialEffects, keyword);
}

const LightEffect* light_effect(std::string_view keyword) {
  return row_of<LightEffect>(kLightEffects, keyword);
}

std::size_t KeywordLedger::Hash::operator()(const Place& place) const {
  std::uint64_t h = static_cast<std::uint32_t>(place.file);
  for (const std::int32_t part : {place.line, place.column}) // the factor is near 2^64 / phi
    h = (h ^ static_cast<std::uint32_t>(part)) * 0x9e3779b97f4a7c15u;
  return h ^ (h >> 32);
}

void KeywordLedger::note(NotedKeyword& slot, std::string_view keyword,
                         const SourcePosition& where) {
  keep(slot);
  const auto file = std::ranges::find(files_, where.file) - files_.begin();
  if (file == std::ssize(files_)) files_.push_back(where.file);
  const Place place{static_cast<std::int32_t>(file), where.line, where.column};
  const auto [number, is_new] =
      numbers_.emplace(place, static_cast<std::int32_t>(statements_.size()));
  if (is_new) statements_.push_back({place, keyword, "", false, false});
  slot.number = number->second;
}

void KeywordLedger::meet(NotedKeyword slot, bool acts, std::string_view why_not) {
  if (slot.number < 0) return;
  Statement& statement = statements_[static_cast<std::size_t>(slot.number)];
  statement.met = true;
  statement.acted = statement.acted || acts;
  if (!acts && statement.why_not.empty()) statement.why_not = why_not;
}

void KeywordLedger::keep(NotedKeyword slot) {
  if (slot.number < 0) return;
  Statement& statement = statements_[static_cast<std::size_t>(slot.number)];
  if (!statement.met) statement.acted = true;
}

void KeywordLedger::meet_shape(const ShapeMaterial& material, bool is_solid) {
  for (const MaterialEffect& effect : kMaterialEffects) {
    const NotedKeyword slot = material.given[effect.slot];
    if (slot.number < 0) continue;
    if (statements_[static_cast<std::size_t>(slot.number)].keyword != effect.keyword) continue;
    meet(slot, effect.acts(material, is_solid), effect.why_not);
  }
}

void KeywordLedger::meet_light(const LightKeywords& given, const LightKind& kind) {
  for (const LightEffect& effect : kLightEffects)
    meet(given[effect.slot], effect.acts(kind), effect.why_not);
}

void KeywordLedger::warn_of_rest(const Warn& warn) const {
  for (const Statement& s : statements_) {
    if (s.acted) continue;
    const SourcePosition where{files_[static_cast<std::size_t>(s.place.file)], s.place.line,
                               s.place.column};
    warn(fmt::format("{}: {} has no effect ({})", to_string(where), s.keyword,
                     s.met ? s.why_not : "nothing follows that it applies to"));
  }
}

} // namespace abbe
