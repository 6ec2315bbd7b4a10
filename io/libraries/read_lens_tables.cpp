// Lenses in the files of other programs.
//
//   UNIT MM X W X CM MR CPMM        Zemax, a statement a line; indented ones belong to the surface
//   SURF 1
//     TYPE EVENASPH
//     CURV 0.03
//     PARM 2 1.1e-5                 the coefficient of h^4
//     CONI -0.7
//     DISZ 9
//     GLAS N-BK7 0 0 1.5168 64.2
//     DIAM 12.7
//
//   29.475 3.76 1.67 25.2           pbrt: radius, thickness, index, diameter

#include "io/libraries/read_lens_tables.h"

#include "io/text/numbers.h"
#include "io/text/similar_names.h"
#include "io/text/utf16.h"
#include "spectral/data_table.h"
#include "spectral/glass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace abbe {
namespace {

/// The words of a file's lines.
class LensLines {
public:
  LensLines(std::string_view text, const std::filesystem::path& file)
      : text_(without_utf16(text)), where_{file.string(), 0, 1} {
    std::ranges::replace(text_, '\t', ' ');
    std::ranges::replace(text_, '\r', '\n');
    rest_ = text_;
  }
  LensLines(const LensLines&) = delete;
  LensLines& operator=(const LensLines&) = delete;

  /// Goes to the next line; false at the end.
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    words_ = split_words(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++where_.line;
    return true;
  }
  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
  [[nodiscard]] const SourcePosition& where() const { return where_; }

  [[nodiscard]] double number(std::size_t word) const {
    if (word >= words_.size())
      throw ReadError(where_, "a number is missing", fmt::format("it is word {}", word + 1),
                      "Save the lens again");
    if (const auto value = parse_finite(words_[word])) return *value;
    throw ReadError(where_, fmt::format("\"{}\" is not a number", words_[word]),
                    fmt::format("it is word {} of the line", word + 1), "Save the lens again");
  }

private:
  std::string text_;
  std::string_view rest_;
  std::vector<std::string_view> words_;
  SourcePosition where_;
};

class ZmxReader {
public:
  ZmxReader(std::string_view text, const std::filesystem::path& file) : lines_(text, file) {
    lens_.name = file.stem().string();
  }

  LensPrescription read() {
    bool surfaces = false;
    while (lines_.next()) {
      if (lines_.words().empty()) continue;
      const std::string_view keyword = lines_.words()[0];
      if (keyword == "SURF") {
        all_.emplace_back();
        surfaces = true;
      } else if (surfaces && !all_.empty()) {
        read_of_surface(keyword);
      } else if (keyword == "UNIT" && lines_.words().size() > 1) {
        read_unit(lines_.words()[1]);
      } else if (keyword == "FNUM") {
        lens_.f_number = lines_.number(1);
      }
    }
    take_surfaces();
    return std::move(lens_);
  }

private:
  /// A surface as the file has it; whether light passes it is known at the end.
  struct Read {
    PrescribedSurface surface;
    bool aspheric = false, stop = false;
  };

  void read_unit(std::string_view unit) {
    mm_per_unit_ = unit == "CM" ? 10.0 : unit == "IN" ? 25.4 : unit == "METER" ? 1000.0 : 1.0;
  }

  void read_of_surface(std::string_view keyword) {
    Read& now = all_.back();
    PrescribedSurface& surface = now.surface;
    if (keyword == "TYPE") {
      read_type(now);
    } else if (keyword == "CURV") {
      const double c = lines_.number(1);
      surface.radius_mm = c == 0.0 ? 0.0 : mm_per_unit_ / c;
    } else if (keyword == "CONI") {
      surface.conic = lines_.number(1);
    } else if (keyword == "PARM" && now.aspheric) {
      read_parameter(surface);
    } else if (keyword == "DISZ" && lines_.words().size() > 1) {
      if (lines_.words()[1] != "INFINITY") surface.thickness_mm = mm_per_unit_ * lines_.number(1);
    } else if (keyword == "GLAS") {
      surface.medium_after = read_glass_line();
    } else if (keyword == "DIAM") {
      if (const double semi = lines_.number(1); semi > 0.0)
        surface.semi_diameter_mm = mm_per_unit_ * semi;
    } else if (keyword == "STOP") {
      now.stop = true;
    }
  }

  void read_type(Read& now) {
    const std::string_view type = lines_.words().size() > 1 ? lines_.words()[1] : "";
    now.aspheric = type == "EVENASPH";
    if (!now.aspheric && type != "STANDARD")
      throw ReadError(lines_.where(), fmt::format("a surface of the type {} is not read", type),
                      "spheres, conics and even aspheres are (STANDARD and EVENASPH)",
                      "Replace it by one of these");
  }

  /// PARM i is the coefficient of h^2i.
  void read_parameter(PrescribedSurface& surface) {
    const double number = lines_.number(1), value = lines_.number(2);
    if (value == 0.0 || !(number >= 1.0 && number <= 8.0)) return;
    const auto place = static_cast<std::size_t>(number) - 1;
    if (surface.even_terms.size() <= place) surface.even_terms.resize(place + 1);
    surface.even_terms[place] = value * std::pow(mm_per_unit_, 1.0 - 2.0 * number);
  }

  [[nodiscard]] Dispersion read_glass_line() const {
    const std::vector<std::string_view>& words = lines_.words();
    const std::string_view name = words.size() > 1 ? words[1] : "";
    if (name == "MIRROR")
      throw ReadError(lines_.where(), "mirrors in a lens are not read",
                      "light passes its surfaces once, one after the other",
                      "Give a lens without mirrors");
    if (const Glass* glass = find_glass(name)) return glass->dispersion;
    // The name ___BLANK is that of a model; other glasses bring their n_d and V_d too.
    if (words.size() > 5 && lines_.number(4) >= 1.0 && lines_.number(5) > 1.0)
      return cauchy_of_abbe(lines_.number(4), lines_.number(5));
    std::vector<std::string> names;
    for (const Glass& glass : glass_catalogue())
      names.push_back(glass.name);
    throw ReadError(lines_.where(), fmt::format("unknown glass \"{}\"", name),
                    "it is not in the glass catalogue, and its n_d and V_d do not follow",
                    did_you_mean(name, names, "abbe list glasses shows them all"));
  }

  /// The first surface is the object and the last one the image; planes in air before and behind
  /// the glass do nothing, unless they are the stop.
  void take_surfaces() {
    const auto plain = [](const Read& read) {
      return !read.stop && read.surface.radius_mm == 0.0 && !read.aspheric &&
             read.surface.medium_after == Dispersion(ConstantIndex{1.0});
    };
    std::size_t first = 1, last = all_.empty() ? 0 : all_.size() - 1;
    while (first < last && plain(all_[first]))
      ++first;
    const Dispersion air = ConstantIndex{1.0};
    while (last > first + 1 && plain(all_[last - 1]) && all_[last - 2].surface.medium_after == air)
      --last;
    bool stop = false;
    for (std::size_t i = first; i < last; ++i) {
      if (all_[i].stop) lens_.stop = lens_.surfaces.size();
      stop = stop || all_[i].stop;
      lens_.surfaces.push_back(std::move(all_[i].surface));
    }
    if (lens_.surfaces.empty() || !stop)
      throw ReadError(
          lines_.where(), "the file holds no lens with a stop",
          fmt::format("{} surfaces lie between the object and the image", lens_.surfaces.size()),
          "Save a sequential lens, with its stop");
  }

  LensLines lines_;
  LensPrescription lens_;
  std::vector<Read> all_;
  double mm_per_unit_ = 1.0;
};

} // namespace

LensPrescription read_zmx_text(std::string_view text, const std::filesystem::path& file) {
  return ZmxReader(text, file).read();
}

LensPrescription read_dat_text(std::string_view text, const std::filesystem::path& file) {
  LensLines lines(text, file);
  LensPrescription lens;
  lens.name = file.stem().string();
  bool stop = false;
  while (lines.next()) {
    if (lines.words().empty() || lines.words()[0].starts_with('#')) continue;
    PrescribedSurface surface;
    surface.radius_mm = lines.number(0);
    surface.thickness_mm = lines.number(1);
    const double n = lines.number(2), diameter = lines.number(3);
    surface.medium_after = ConstantIndex{n == 0.0 ? 1.0 : n};
    if (diameter > 0.0) surface.semi_diameter_mm = 0.5 * diameter;
    if (surface.radius_mm == 0.0 && !stop) {
      lens.stop = lens.surfaces.size();
      stop = true;
    }
    lens.surfaces.push_back(std::move(surface));
  }
  if (!stop)
    throw ReadError(lines.where(), "the lens has no stop", "no surface has the radius 0",
                    "Add it: 0, thickness, 0 and its diameter");
  return lens;
}

} // namespace abbe
