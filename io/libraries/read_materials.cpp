// A material library, conventionally *.mtl:
//
//   def StrongOrangeYellow
//   {
//     reflectivity 0.5                          ! amounts: they scale the colour below
//     transparency 0.1
//     diffuseAmount 0.3
//     specularExponent 12.8
//     speedOfLight 1.33                         ! used as refractive index
//     Vnum 1                                    ! a factor on dispersion
//     freqBreakdown 81 0.0538 0.0552 ... 0.0000 ! 380, 385 ... 780 nm
//   }
//   endmaterial

#include "io/libraries/read_materials.h"

#include "core/scene/quantity_limits.h"
#include "io/libraries/read_absorption.h"
#include "io/libraries/read_dispersion.h"
#include "io/libraries/read_glass.h"
#include "io/libraries/read_library.h"
#include "spectral/band_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace abbe {
namespace {

constexpr LibraryWords kMaterialWords{"def", "endmaterial"};

constexpr Range kFraction{"a fraction of the light", 0.0, 1.0};
constexpr Range kAmount{"a factor on the colour", 0.0, kMostLight};

/// A key that sets one number of the entry.
template <double LibraryMaterial::* member>
void set_amount(LibraryMaterial& entry, Arguments& arguments, const Warn&) {
  entry.*member = arguments.number(kAmount);
}

template <double LibraryMaterial::* member>
void set_fraction(LibraryMaterial& entry, Arguments& arguments, const Warn&) {
  entry.*member = arguments.number(kFraction);
}

/// An entry has one index that takes the place of speedOfLight and Vnum.
void refuse_second_index(const LibraryMaterial& entry, const Arguments& arguments) {
  if (!entry.glass && !entry.law) return;
  throw ReadError(arguments.keyword().where,
                  fmt::format("{} is a second index of this entry", arguments.name()),
                  "one law gives n at every wavelength", "Remove one of them");
}

template <WrittenIndex (*read_law)(Arguments&, const Warn&)>
void set_law(LibraryMaterial& entry, Arguments& arguments, const Warn& warn) {
  refuse_second_index(entry, arguments);
  entry.law = read_law(arguments, warn).law;
}

constexpr std::array<LibraryKey<LibraryMaterial>, 23> kMaterialKeys{{
    {"reflectivity x", set_fraction<&LibraryMaterial::reflectivity>},
    {"specularExponent e",
     [](LibraryMaterial& entry, Arguments& arguments, const Warn&) {
       entry.specular_exponent = arguments.number({"the exponent of the highlight", 0.0, 1e9});
     }},
    {"transparency x", set_fraction<&LibraryMaterial::transparency>},
    {"diffuseAmount x", set_amount<&LibraryMaterial::diffuse>},
    {"emissiveAmount x", set_amount<&LibraryMaterial::emissive>},
    {"specularAmount x", set_amount<&LibraryMaterial::specular>},
    {"ambience x", set_amount<&LibraryMaterial::ambient>},
    {"speedOfLight n", [](LibraryMaterial& entry, Arguments& arguments,
                          const Warn&) { entry.speed_of_light = arguments.number(kIndexRange); }},
    {"Vnum v", [](LibraryMaterial& entry, Arguments& arguments,
                  const Warn&) { entry.v_number = arguments.number(kVNumberRange); }},
    {"freqBreakdown 41|81|201|401 v380 ... v780",
     [](LibraryMaterial& entry, Arguments& arguments, const Warn& warn) {
       entry.colour = read_samples(arguments, warn).sampled81();
     }},
    {"glass NAME",
     [](LibraryMaterial& entry, Arguments& arguments, const Warn&) {
       refuse_second_index(entry, arguments);
       if (auto code = read_glass_code(arguments)) {
         entry.law = std::move(code->law);
         return;
       }
       entry.glass = &read_glass(arguments);
     }},
    {kCauchyUsage, set_law<read_cauchy>},
    {kAbbeUsage, set_law<read_abbe>},
    {kIndexTableUsage, set_law<read_index_table>},
    {kIndexFitUsage, set_law<read_index_fit>},
    {kQuartzUsage, set_law<read_quartz>},
    {kDispersionScaleUsage,
     [](LibraryMaterial& entry, Arguments& arguments, const Warn&) {
       entry.dispersion_scale = arguments.number(kDispersionScaleRange);
     }},
    {"absorption x",
     [](LibraryMaterial& entry, Arguments& arguments, const Warn&) {
       entry.absorption_per_mm = Curve::constant(arguments.number(kAbsorptionRange));
     }},
    {kAbsorptionTableUsage,
     [](LibraryMaterial& entry, Arguments& arguments, const Warn&) {
       entry.absorption_per_mm = read_absorption_table(arguments);
     }},
    {kInternalTransmittanceUsage,
     [](LibraryMaterial& entry, Arguments& arguments, const Warn&) {
       entry.absorption_per_mm = read_internal_transmittance(arguments);
     }},
    {"metal NAME", [](LibraryMaterial& entry, Arguments& arguments,
                      const Warn&) { entry.metal = &read_metal(arguments); }},
    {"alsoCalled NAME",
     [](LibraryMaterial& entry, Arguments& arguments, const Warn&) {
       entry.other_name = arguments.name_token("a second name");
     }},
    {"fresnel on|off", [](LibraryMaterial& entry, Arguments& arguments,
                          const Warn&) { entry.fresnel = arguments.on_off(); }},
}};

/// Adds the entries that have a second name under it too, after the others.
void add_other_names(std::vector<LibraryMaterial>& entries) {
  NameIndex names;
  for (const LibraryMaterial& entry : entries)
    names.add(entry.name, 0);
  for (std::size_t i = 0, count = entries.size(); i < count; ++i) {
    if (!entries[i].other_name) continue;
    LibraryMaterial same = entries[i];
    same.name = same.other_name->text;
    if (!names.add(same.name, 0)) throw duplicate_entry(*same.other_name);
    entries.push_back(std::move(same));
  }
}

/// The part of a surface with this amount; an amount of 0 is the constant that means "absent".
Curve part(const LibraryMaterial& entry, double amount) {
  return amount == 0.0 ? Curve::constant(0.0) : entry.colour.scaled(amount);
}

/// The colour where it is largest.
double largest(const Curve& colour) {
  if (const auto constant = colour.constant_value()) return *constant;
  double most = 0.0;
  for (int i = 0; i < kSampleCount; ++i)
    most = std::max(most, colour.at(sample_nm(i)));
  return most;
}

/// The same for a part that gives back light, which counts as 1 where it is more.
Curve limited_part(const LibraryMaterial& entry, double amount) {
  Curve whole = part(entry, amount);
  if (!(largest(whole) > 1.0)) return whole;
  if (whole.constant_value()) return Curve::constant(1.0);
  std::vector<double> values;
  for (int i = 0; i < kSampleCount; ++i)
    values.push_back(std::min(1.0, whole.at(sample_nm(i))));
  return Curve::samples81(std::move(values));
}

/// Notes parts that are above 1.
void remark_on_limits(LibraryMaterial& entry, const Warn& warn) {
  const double colour = largest(entry.colour);
  for (const auto& [name, amount] : {std::pair("ambience", entry.ambient),
                                     {"diffuseAmount", entry.diffuse},
                                     {"specularAmount", entry.specular},
                                     {"reflectivity", entry.reflectivity},
                                     {"transparency", entry.transparency}}) {
    if (!(colour * amount > 1.0)) continue;
    entry.remarks.push_back(
        fmt::format("{}: {} times the colour of {} reaches {:.4g}; above 1 it counts as 1 (nothing "
                    "reflects more than it gets)",
                    to_string(entry.where), name, entry.name, colour * amount));
    if (warn) warn(entry.remarks.back());
  }
}

} // namespace

Material finish(const LibraryMaterial& entry) {
  Material material;
  material.name = entry.name;
  material.ambient = limited_part(entry, entry.ambient);
  material.diffuse = limited_part(entry, entry.diffuse);
  material.specular = limited_part(entry, entry.specular);
  material.emission = part(entry, entry.emissive);
  material.specular_exponent = entry.specular_exponent;
  material.reflectivity = limited_part(entry, entry.reflectivity);
  material.transparency = limited_part(entry, entry.transparency);
  material.fresnel = entry.fresnel;
  if (entry.metal) { // which lets no light in
    material.metal = ConductorIndex{entry.metal->n, entry.metal->k};
    material.transparency = Curve::constant(0.0);
  }
  return material;
}

Medium filling(const LibraryMaterial& entry) {
  Medium medium;
  medium.name = entry.glass ? entry.glass->name : entry.name;
  if (entry.law)
    medium.index = *entry.law;
  else if (entry.glass)
    medium.index = entry.glass->dispersion;
  else
    medium.index = ThesisScaled{entry.speed_of_light, entry.v_number};
  if (entry.dispersion_scale != 1.0)
    medium.index = exaggerated(medium.index, entry.dispersion_scale);
  medium.absorption_per_mm = entry.absorption_per_mm;
  return medium;
}

std::vector<LibraryMaterial> read_materials(const std::filesystem::path& file, const Warn& warn) {
  return read_materials_text(read_text_file(file), file.string(), warn);
}

std::vector<LibraryMaterial> read_materials_text(std::string_view text, const std::string& file,
                                                 const Warn& warn) {
  auto entries = read_library(text, file, kMaterialWords,
                              std::span<const LibraryKey<LibraryMaterial>>(kMaterialKeys), warn);
  for (LibraryMaterial& entry : entries)
    remark_on_limits(entry, warn);
  add_other_names(entries);
  return entries;
}

} // namespace abbe
