// Materials of a scene, by the keywords that make them.

#include "core/scene/quantity_limits.h"
#include "core/scene/user_error.h"
#include "io/converting/scene_writer.h"
#include "spectral/band_grid.h"
#include "spectral/fraunhofer.h"
#include "spectral/glass.h"
#include "spectral/metal.h"

#include <fmt/format.h>

#include <algorithm>

namespace abbe {
namespace {

/// The glass of the catalogue that has this index; null: none.
const Glass* glass_with(const Dispersion& index) {
  for (const Glass& glass : glass_catalogue())
    if (glass.dispersion == index) return &glass;
  return nullptr;
}

/// The index of a film, a coat or a pane as a word: a number or the name of a glass.
std::optional<std::string> index_word(const Dispersion& index) {
  if (const Glass* glass = glass_with(index)) return glass->name;
  if (!is_achromatic(index)) return std::nullopt;
  return fmt::format("{}", refractive_index(index, kLineD_nm));
}

} // namespace

void SceneWriter::write_absorption(const Curve& absorption) {
  if (const auto value = absorption.constant_value()) {
    if (*value != 0.0) line(fmt::format("absorption {}", *value));
    return;
  }
  std::string table = fmt::format("absorptionTable {}", kSampleCount);
  for (int k = 0; k < kSampleCount; ++k)
    table += fmt::format(" {} {}", sample_nm(k), std::max(absorption.at(sample_nm(k)), 0.0));
  line(table);
}

/// The index of a body, by a keyword that begins a new material.
SceneWriter::Base SceneWriter::write_index(const Medium& medium, const Material& finish) {
  constexpr Base kClear{0.0, 0.0, 1.0, 1.0};
  if (finish.pane) {
    auto word = index_word(medium.index);
    if (!word) {
      warn_once(fmt::format("{}: the pane {} gets one index at all wavelengths", file_.string(),
                            finish.name));
      word = fmt::format("{}", refractive_index(medium.index, kLineD_nm));
    }
    line(fmt::format("thinGlass {} {}", finish.pane->thickness_mm, *word));
    return kClear;
  }
  if (const Glass* glass = glass_with(medium.index)) {
    line("glass " + glass->name);
  } else if (const auto* law = std::get_if<Cauchy>(&medium.index)) {
    line(fmt::format("cauchy {} {} {}", law->a, law->b_um2, law->c_um4));
  } else if (is_achromatic(medium.index)) {
    line(
        fmt::format("defaultMaterials speedOfLight {}", refractive_index(medium.index, kLineD_nm)));
    return {0.1, 0.8, 0.0, 0.0};
  } else {
    std::string table = "indexTable 82";
    for (int k = 0; k < 82; ++k) {
      const double nm = kLowerNm + (kUpperNm - kLowerNm) * k / 81.0;
      table += fmt::format(" {} {}", nm, refractive_index(medium.index, nm));
    }
    line(table);
  }
  return kClear;
}

void SceneWriter::write_color(std::string_view keyword, const Curve& color, double base) {
  const auto value = color.constant_value();
  if (value == base) return;
  line(value ? fmt::format("{} {} {} {}", keyword, *value, *value, *value)
             : fmt::format("{} \"{}\"", keyword, color_file(color)));
}

void SceneWriter::write_share(std::string_view keyword, const Curve& share, double base) {
  const auto value = share.constant_value();
  if (value == base) return;
  line(value ? fmt::format("{} {}", keyword, *value)
             : fmt::format("{} \"{}\"", keyword, color_file(share)));
}

SceneWriter::Base SceneWriter::write_body(const Material& finish, const Medium& medium) {
  if (finish.metal) {
    for (const Metal& metal : metal_catalogue())
      if (ConductorIndex{metal.n, metal.k} == *finish.metal) {
        line("metal " + metal.name);
        return {0.0, 0.0, 1.0, 0.0};
      }
    const auto known = std::ranges::find(known_metals_, *finish.metal);
    const auto number = static_cast<std::size_t>(known - known_metals_.begin()) + 1;
    const std::string name = name_of_file("metal", number, "yml");
    line(fmt::format("metal \"{}\"", name));
    if (known != known_metals_.end()) return {0.0, 0.0, 1.0, 0.0};
    known_metals_.push_back(*finish.metal);
    std::string rows = "DATA:\n  - type: tabulated nk\n    data: |\n";
    for (int k = 0; k < kSampleCount; ++k)
      rows += fmt::format("        {} {} {}\n", sample_nm(k) / 1000.0,
                          finish.metal->n.at(sample_nm(k)), finish.metal->k.at(sample_nm(k)));
    write_text(beside(name), rows);
    return {0.0, 0.0, 1.0, 0.0};
  }
  if (finish.transparency.zero() && !finish.pane) {
    line("defaultMaterials");
    return {0.1, 0.8, 0.0, 0.0};
  }
  const Medium body = finish.pane
                          ? Medium{finish.name, finish.pane->index, finish.pane->absorption_per_mm}
                          : medium;
  const Base base = write_index(body, finish);
  write_absorption(body.absorption_per_mm);
  return base;
}

void SceneWriter::define_field(const Curve& reflectance) {
  for (const auto& [known, name] : fields_)
    if (known == reflectance) return;
  const std::string name = fmt::format("field{}", fields_.size() + 1);
  fields_.emplace_back(reflectance, name);
  line("defaultMaterials");
  write_color("diffuse", reflectance, 0.8);
  line("defMaterial " + name);
}

const std::string& SceneWriter::field_name(const Curve& reflectance) const {
  return std::ranges::find(fields_, reflectance, &std::pair<Curve, std::string>::first)->second;
}

void SceneWriter::define_fields(const Texture& texture) {
  if (const auto* checker = std::get_if<CheckerTexture>(&texture)) {
    define_field(checker->first);
    define_field(checker->second);
  } else if (const auto* grid = std::get_if<GridTexture>(&texture)) {
    define_field(grid->lines);
    define_field(grid->fields);
  }
}

void SceneWriter::write_texture(const Texture& texture) {
  if (const auto* checker = std::get_if<CheckerTexture>(&texture))
    return line(fmt::format("checker {} {} {} {}", checker->across, checker->up,
                            field_name(checker->first), field_name(checker->second)));
  if (const auto* grid = std::get_if<GridTexture>(&texture))
    return line(fmt::format("grid {} {} {} {} {}", grid->across, grid->up, grid->width,
                            field_name(grid->lines), field_name(grid->fields)));
  line(fmt::format("imageTexture \"{}\"", image_file(std::get<ImageTexture>(texture).image)));
}

const std::string& SceneWriter::image_file(std::size_t image) {
  std::string& file = images_[image];
  const ReflectanceImage& picture = scene_.images[image];
  if (file.empty()) file = picture_file(picture.width, picture.height, picture.rgb);
  return file;
}

void SceneWriter::write_surface(const Material& finish, const Base& base) {
  write_color("ambient", finish.ambient, base.ambient);
  write_color("diffuse", finish.diffuse, base.diffuse);
  if (!finish.specular.zero()) {
    write_color("specular", finish.specular, 0.0);
    line(fmt::format("specularExponent {}", finish.specular_exponent));
  }
  write_share("reflectivity", finish.reflectivity, base.reflectivity);
  write_share("transparency", finish.transparency, base.transparency);
  if (!finish.fresnel) line("fresnel off");
  if (finish.roughness > 0.0) line(fmt::format("roughness {}", finish.roughness));
  if (!finish.compensation) line("compensation off");
  if (finish.film) {
    const auto word = index_word(finish.film->index);
    if (!word) throw UserError("the index of a film cannot be written");
    line(fmt::format("thinFilm {} {}", finish.film->thickness_nm, *word));
  }
  if (finish.coat) {
    const auto word = index_word(*finish.coat);
    if (!word) throw UserError("the index of a coat cannot be written, since it has a colour");
    line("coat " + *word);
  }
  if (!finish.emission.zero()) {
    line("emissive " + spectrum(finish.emission));
    line(finish.emits_behind ? "emissiveSides both" : "emissiveSides front");
  }
  if (finish.texture) write_texture(*finish.texture);
}

std::string SceneWriter::defined_material(MaterialId material, MediumId medium) {
  const std::pair key(material.value, medium.value);
  const auto known = defined_.find(key);
  if (known != defined_.end()) return known->second;
  write_material(material, medium); // which may define others
  const std::string name = fmt::format("material{}", defined_.size() + 1);
  line("defMaterial " + name);
  return defined_.emplace(key, name).first->second;
}

void SceneWriter::write_material(MaterialId material, MediumId medium) {
  const Material& finish = scene_.materials[material.index()];
  if (finish.mixture) {
    const std::string first = defined_material(finish.mixture->first, medium);
    const std::string second = defined_material(finish.mixture->second, medium);
    return line(fmt::format("mix {} {} {}", first, second, finish.mixture->share));
  }
  const Medium nothing{"", ConstantIndex{1.0}, Curve::constant(0.0)};
  const Medium& filling = medium.valid() ? scene_.media[medium.index()] : nothing;
  if (filling.drops) throw UserError("drops cannot be written");
  if (finish.texture) define_fields(*finish.texture); // before, since that changes the material
  const Base base = write_body(finish, filling);
  write_surface(finish, base);
}

} // namespace abbe
