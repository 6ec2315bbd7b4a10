// A camera lens is a list of its surfaces, from the object to the film; light travels along +z, and
// a radius above 0 has its centre on the film's side:
//
//   ! Thorlabs AC254-050-A
//   unit mm
//   stop                                     ! the surface that follows is the aperture stop
//   surface  33.34   9     N-BAF10      12.7 ! radius, thickness, medium behind, semi-diameter
//   surface -22.28   2.5   1.72825 28.41 12.7 ! or n_d and V_d
//   surface -291.07  43.4  air          12.7 conic -0.7 even 4 1.1e-5    ! an asphere

#include "io/libraries/read_lens_prescription.h"

#include "core/cameras/lens_system.h"
#include "io/libraries/read_dispersion.h"
#include "io/libraries/read_glass.h"
#include "io/libraries/read_lens_tables.h"
#include "io/text/similar_names.h"
#include "spectral/band_grid.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

namespace abbe {
namespace {

/// The lens as far as it is read.
struct LensFile {
  LensPrescription lens;
  std::vector<SourcePosition> surfaces_at; ///< of the keywords
  double mm_per_unit = 1.0;
  std::optional<SourcePosition> stop_at; ///< of the keyword
  const Warn& warn;
  std::set<const Glass*> warned_glasses;
};

void read_unit(LensFile& file, Arguments& arguments) {
  if (!file.lens.surfaces.empty())
    throw ReadError(arguments.keyword().where, "unit stands too late",
                    "surfaces before it have been read", "Move it before the first surface");
  file.mm_per_unit =
      arguments.choice<double>({{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}});
}

void read_stop(LensFile& file, Arguments& arguments) {
  const SourcePosition& where = arguments.keyword().where;
  if (file.stop_at)
    throw ReadError(where, "stop is given twice", "the first is at " + to_string(*file.stop_at),
                    "Remove one of them");
  file.stop_at = where;
  file.lens.stop = file.lens.surfaces.size();
}

/// The medium behind a surface: air, a glass of the catalogue or by its code, or n_d and V_d.
Dispersion read_medium(LensFile& file, Arguments& arguments) {
  if (auto code = read_glass_code(arguments)) return std::move(code->law);
  if (arguments.number_follows()) return read_abbe_numbers(arguments);
  const Token name = arguments.reader().peek();
  if (is_word(name, "air")) {
    arguments.reader().next();
    return ConstantIndex{1.0};
  }
  const Glass& glass = read_glass(arguments);
  const bool extrapolated = glass.lower_nm > kLowerNm || glass.upper_nm < kUpperNm;
  if (file.warn && extrapolated && file.warned_glasses.insert(&glass).second)
    file.warn(fmt::format("{}: glass {} is extrapolated beyond {:g}-{:g} nm (pictures need {}-{} "
                          "nm)",
                          to_string(name.where), glass.name, glass.lower_nm, glass.upper_nm,
                          kLowerNm, kUpperNm));
  return glass.dispersion;
}

/// `conic k` and `even 4 a4 6 a6 ...`, in any order, as far as they follow. Coefficients are those
/// of powers of the height in the unit of the file.
void read_asphere(const LensFile& file, Arguments& arguments, PrescribedSurface& surface) {
  TokenReader& reader = arguments.reader();
  for (;;) {
    const Token token = reader.peek();
    if (is_word(token, "conic")) {
      reader.next();
      surface.conic = arguments.number({"a conic constant", -1e6, 1e6});
    } else if (is_word(token, "even")) {
      reader.next();
      do {
        const SourcePosition at = reader.peek().where;
        const auto power = arguments.whole_number({"a power of the height", 2.0, 20.0});
        if (power % 2 != 0)
          throw ReadError(at, fmt::format("{} is an odd power", power),
                          "an even asphere has the powers 2, 4, 6 ... 20", "Give an even power");
        const auto place = static_cast<std::size_t>(power / 2 - 1);
        if (surface.even_terms.size() <= place) surface.even_terms.resize(place + 1);
        surface.even_terms[place] =
            arguments.number() * std::pow(file.mm_per_unit, 1.0 - static_cast<double>(power));
      } while (arguments.number_follows());
    } else {
      break;
    }
  }
  if ((surface.conic != 0.0 || !surface.even_terms.empty()) && !surface.semi_diameter_mm)
    throw ReadError(arguments.keyword().where, "an aspheric surface has no semi-diameter",
                    "its polynomial means something inside of one only", "Add the semi-diameter");
}

void read_surface(LensFile& file, Arguments& arguments) {
  PrescribedSurface surface;
  if (is_word(arguments.reader().peek(), "inf"))
    arguments.reader().next(); // flat, as 0 is
  else
    surface.radius_mm = file.mm_per_unit * arguments.number();
  surface.thickness_mm = file.mm_per_unit * arguments.number({"the way to the next surface"});
  surface.medium_after = read_medium(file, arguments);
  if (arguments.number_follows())
    surface.semi_diameter_mm =
        file.mm_per_unit * arguments.number({.meaning = "half of a diameter", .open = true});
  read_asphere(file, arguments, surface);
  if (const auto& height = surface.semi_diameter_mm; height && surface.conic == 0.0 &&
                                                     surface.radius_mm != 0.0 &&
                                                     *height > std::abs(surface.radius_mm))
    throw ReadError(arguments.keyword().where, "the semi-diameter is larger than the radius",
                    "a ball has no surface so far from the axis", "Check both numbers");
  file.lens.surfaces.push_back(std::move(surface));
  file.surfaces_at.push_back(arguments.keyword().where);
}

struct LensKeyword {
  std::string_view usage;
  void (*read)(LensFile&, Arguments&);
};

constexpr std::array kKeywords{
    LensKeyword{"unit mm|cm|m|in", read_unit},
    LensKeyword{"fNumber N",
                [](LensFile& file, Arguments& arguments) {
                  file.lens.f_number =
                      arguments.number({.meaning = "focal length by aperture", .open = true});
                }},
    LensKeyword{"halfField angle",
                [](LensFile& file, Arguments& arguments) {
                  file.lens.half_field_deg =
                      arguments.number({"half of the angle of view, in degrees", 0.0, 80.0});
                }},
    LensKeyword{"stop", read_stop},
    LensKeyword{"surface radius thickness MEDIUM [semiDiameter] [conic k] [even power a ...]",
                read_surface},
};

std::string_view name_of(const LensKeyword& keyword) {
  return keyword.usage.substr(0, keyword.usage.find(' '));
}

const LensKeyword& find_keyword(const Token& token) {
  std::vector<std::string> names;
  for (const LensKeyword& keyword : kKeywords) {
    if (is_word(token, name_of(keyword))) return keyword;
    names.emplace_back(name_of(keyword));
  }
  throw ReadError(token.where, "unknown keyword " + shown(token), "no such word in a lens file",
                  did_you_mean(token.text, names,
                               "The keywords are unit, fNumber, halfField, stop and surface"));
}

/// A plane that only limits the beam: nobody has to grind it.
bool is_diaphragm(const LensFile& file, std::size_t i) {
  const auto& surfaces = file.lens.surfaces;
  const Dispersion air = ConstantIndex{1.0};
  const Dispersion& before = i == 0 ? air : surfaces[i - 1].medium_after;
  return before == surfaces[i].medium_after;
}

LensProfile profile(const PrescribedSurface& surface) {
  return {surface.radius_mm == 0.0 ? 0.0 : 1.0 / surface.radius_mm, surface.conic,
          surface.even_terms};
}

/// Neighbours must not meet where both of them are.
void check_crossings(const LensFile& file) {
  const auto& surfaces = file.lens.surfaces;
  for (std::size_t i = 0; i + 1 < surfaces.size(); ++i) {
    const PrescribedSurface &front = surfaces[i], &back = surfaces[i + 1];
    if (!front.semi_diameter_mm || !back.semi_diameter_mm) continue;
    if (is_diaphragm(file, i) || is_diaphragm(file, i + 1)) continue;
    const double height = std::min(*front.semi_diameter_mm, *back.semi_diameter_mm);
    const double gap = front.thickness_mm + profile(back).sag(height) - profile(front).sag(height);
    if (gap >= 0.0) continue;
    const std::string what = "this surface crosses the one before it";
    const std::string why =
        fmt::format("at {:g} mm from the axis it lies {:.3g} mm before it", height, -gap);
    // Published aspheres bend back beyond the beam that they were made for.
    if (profile(front).spherical() && profile(back).spherical())
      throw ReadError(file.surfaces_at[i + 1], what, why,
                      "Check the signs of the radii, the thickness and the semi-diameters");
    if (file.warn)
      file.warn(fmt::format("{}: {} ({}). Rays that meet them there are stopped",
                            to_string(file.surfaces_at[i + 1]), what, why));
  }
}

void require_lens(const LensPrescription& lens, const std::filesystem::path& path) {
  try {
    (void)LensSystem(lens);
  } catch (const std::invalid_argument& error) {
    throw ReadError(path, "these data describe no camera lens", error.what(),
                    "Check the signs of the radii, the media, the stop and the f-number");
  }
}

/// Mistakes that no single line makes.
void check(const LensFile& file, const std::filesystem::path& path) {
  if (file.lens.surfaces.empty())
    throw ReadError(path, "the lens has no surface", "a lens needs glass", "Add its surfaces");
  if (!file.stop_at)
    throw ReadError(path, "the lens has no stop", "none of its surfaces limits the aperture",
                    "Write stop before the surface that is the aperture stop");
  if (file.lens.stop == file.lens.surfaces.size())
    throw ReadError(*file.stop_at, "no surface follows stop", "it marks the surface behind it",
                    "Write stop before the surface that is the aperture stop");
  check_crossings(file);
  require_lens(file.lens, path);
}

} // namespace

std::vector<std::string_view> lens_file_keywords() {
  std::vector<std::string_view> usages;
  for (const LensKeyword& keyword : kKeywords)
    usages.push_back(keyword.usage);
  return usages;
}

LensPrescription read_lens_prescription_text(std::string_view text,
                                             const std::filesystem::path& path, const Warn& warn) {
  LensFile file{{}, {}, 1.0, {}, warn, {}};
  file.lens.name = path.stem().string();
  TokenReader reader(text, path.string());
  while (!reader.at_end()) {
    const Token token = reader.next();
    const LensKeyword& keyword = find_keyword(token);
    Arguments arguments(reader, token, keyword.usage);
    keyword.read(file, arguments);
  }
  check(file, path);
  return std::move(file.lens);
}

LensPrescription read_lens_prescription(const std::filesystem::path& file, const Warn& warn) {
  const std::string text = read_text_file(file), extension = file.extension().string();
  const bool zemax = same_name(extension, ".zmx");
  if (!zemax && !same_name(extension, ".dat")) return read_lens_prescription_text(text, file, warn);
  LensPrescription lens = zemax ? read_zmx_text(text, file) : read_dat_text(text, file);
  require_lens(lens, file);
  return lens;
}

} // namespace abbe
