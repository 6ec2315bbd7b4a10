#include "io/building/scene_builder.h"

#include "io/building/check_reach.h"
#include "io/building/fingerprint.h"
#include "io/building/material_energy.h"
#include "spectral/band_grid.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <utility>

namespace abbe {

template <class Value, class Check>
std::int32_t SceneBuilder::number_of(KnownValues& known, std::vector<Value>& values,
                                     const Value& value, const Check& check) {
  if (known.last >= 0 && values[static_cast<std::size_t>(known.last)] == value) return known.last;
  const std::size_t print = fingerprint(value);
  const auto [begin, end] = known.numbers.equal_range(print);
  for (auto candidate = begin; candidate != end; ++candidate)
    if (values[static_cast<std::size_t>(candidate->second)] == value)
      return known.last = candidate->second;
  check();
  known.last = static_cast<std::int32_t>(values.size());
  known.numbers.emplace(print, known.last);
  values.push_back(value);
  return known.last;
}

MaterialId SceneBuilder::add_material(const SourcePosition& where, const ShapeMaterial& material) {
  return add_finish(where, shape_finish(where, material));
}

MaterialId SceneBuilder::add_finish(const SourcePosition& where, Material finish) {
  const double shares = limit_shares(finish);
  const auto note = [&] { note_energy(where, finish, shares); };
  return {number_of(materials_, scene_.materials, finish, note)};
}

/// Sums a little above 1, as of colours that are told as three numbers, are not warned of.
void SceneBuilder::note_energy(const SourcePosition& where, const Material& finish, double shares) {
  constexpr double kNoticeable = 1.05;
  const std::string name = finish.name.empty() ? "the material" : finish.name;
  if (shares > 1.0 + 1e-9)
    energy_warnings_.push_back(
        fmt::format("{}: reflectivity and transparency of {} add up to {:.4g} with fresnel off; "
                    "they are lowered so that they add up to 1",
                    to_string(where), name, shares));
  const MaterialEnergy energy = most_given_back(finish, scene_.images);
  if (energy.most > kNoticeable)
    energy_warnings_.push_back(fmt::format(
        "{}: {} gives back up to {:.3g} times the light that it gets, at {:g} nm (diffuse {:.3g}, "
        "highlight {:.3g}, mirrored or let through {:.3g})",
        to_string(where), name, energy.most, energy.at_nm, energy.diffuse, energy.highlight,
        energy.specular));
}

void SceneBuilder::warn_of_the_whole(const Warn& warn) const {
  keywords_.warn_of_rest(warn);
  for (const std::string& warning : energy_warnings_)
    warn(warning);
  opaque_solids_.warn_of_parted(scene_, warn);
}

MediumId SceneBuilder::add_medium(const SourcePosition& where, const Medium& medium) {
  return {number_of(media_, scene_.media, medium, [&] { check_medium(where, medium); })};
}

void SceneBuilder::add_shape(const SourcePosition& where, PlacedShape shape,
                             const ShapeMaterial& material) {
  check_reach(where, "the shape", reach_of(shape));
  check_surface(where, material.finish);
  if (is_solid(shape.shape))
    check_solid(scene_, where, material.finish);
  else
    check_sheet(scene_, where, material);
  keywords_.meet_shape(material, is_solid(shape.shape));
  shape.material = add_material(where, material);
  shape.gives_way = !is_solid(shape.shape) && is_transparent(material.finish);
  if (is_solid(shape.shape) && is_transparent(material.finish))
    shape.medium = add_medium(where, material.medium);
  else if (is_solid(shape.shape))
    opaque_solids_.add(scene_.shapes.size(), where);
  scene_.shapes.push_back(std::move(shape));
}

void SceneBuilder::add_light(Light light, const LightKeywords& given) {
  keywords_.meet_light(given, light.kind);
  scene_.lights.push_back(std::move(light));
}

std::size_t SceneBuilder::add_image(const std::filesystem::path& file,
                                    const std::function<ReflectanceImage()>& read) {
  const auto known = images_.find(file);
  if (known != images_.end()) return known->second;
  scene_.images.push_back(read());
  return images_.emplace(file, scene_.images.size() - 1).first->second;
}

ShapeMaterial SceneBuilder::mix(const SourcePosition& where, const ShapeMaterial& first,
                                const ShapeMaterial& second, double share) {
  const bool lets_in = is_transparent(first.finish), other = is_transparent(second.finish);
  const bool pane = first.finish.pane.has_value(), other_pane = second.finish.pane.has_value();
  if (lets_in && other && pane != other_pane)
    throw ReadError(where, "thinGlass does not mix with glass",
                    "the one bends no light and the other does",
                    "Mix it with another thinGlass, or with a material that lets no light in");
  if (lets_in && other && !pane && first.medium != second.medium)
    throw ReadError(where, "the two materials would fill a solid differently",
                    "both let light in, and a solid has one filling",
                    "Mix materials of the same glass, or one that lets no light in");
  for (const ShapeMaterial* part : {&first, &second})
    keywords_.meet_shape(*part, true);
  ShapeMaterial mixed{{}, lets_in ? first.medium : second.medium};
  if (!lets_in && !other) mixed.medium = ShapeMaterial{}.medium;
  mixed.finish.name = fmt::format("{} and {}", first.finish.name, second.finish.name);
  mixed.finish.transparency = Curve::constant(lets_in || other ? 1.0 : 0.0);
  Mixture mixture;
  mixture.first = add_material(where, first);
  mixture.second = add_material(where, second);
  mixture.share = share;
  mixed.finish.mixture = mixture;
  return mixed;
}

void SceneBuilder::warn_of_extrapolation(const SourcePosition& where, const Glass& glass,
                                         const Warn& warn) {
  if (glass.lower_nm <= kLowerNm && glass.upper_nm >= kUpperNm) return;
  if (!warned_glasses_.insert(&glass).second || !warn) return;
  warn(fmt::format("{}: glass {} is extrapolated beyond {:g}-{:g} nm (pictures need {}-{} nm)",
                   to_string(where), glass.name, glass.lower_nm, glass.upper_nm, kLowerNm,
                   kUpperNm));
}

void check_view(const SourcePosition& where, const Camera& camera) {
  const dvec3 view = camera.look_at - camera.eye;
  if (!(glm::length(view) > 0.0))
    throw ReadError(where, "eye and lookAt are the same point", "the camera has no direction",
                    "Move one of them");
  constexpr double kFarthest = 1e30;
  if (!(glm::length(view) <= kFarthest))
    throw ReadError(where, "eye and lookAt are too far apart",
                    fmt::format("at most {:g} units can be between them", kFarthest),
                    "Move one of them");
  const double sine = glm::length(glm::cross(glm::normalize(view), camera.up));
  if (!(sine > 1e-9 * glm::length(camera.up)))
    throw ReadError(where, "up has no part across the direction of view",
                    "it is 0 0 0, or points along the view",
                    "Give an up such as 0 1 0, or 0 0 1 when looking along y");
}

void check_crop(const SourcePosition& where, const RenderSettings& settings) {
  if (!settings.crop ||
      (settings.crop->x1 <= settings.width && settings.crop->y1 <= settings.height))
    return;
  throw ReadError(where, "the crop reaches beyond the picture",
                  fmt::format("the picture has {} x {} pixels", settings.width, settings.height),
                  "Give a smaller crop, or a larger imageSize");
}

} // namespace abbe
