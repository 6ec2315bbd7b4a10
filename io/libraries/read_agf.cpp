// Zemax's glass catalogues, a statement a line:
//
//   NM N-BK7 2 517642.251 1.516800 64.167336 0 1     name, formula, code, n_d, V_d ...
//   CD 1.03961212 0.00600069867 ...                  coefficients
//   LD 0.3 2.5                                       range, in um
//   IT 0.4 0.997 10                                  um, internal transmittance, mm
//
// Other statements say nothing of how a glass looks.

#include "io/libraries/glass_formulas.h"
#include "io/libraries/read_glass_files.h"
#include "io/text/numbers.h"
#include "io/text/utf16.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace abbe {
namespace {

/// Less than a millionth counts as a millionth, as for internalTransmittance.
constexpr double kLeastTransmittance = 1e-6;

/// A glass as far as it is read.
struct Entry {
  SourcePosition where;
  Glass glass;
  int formula = 0;
  std::vector<double> coefficients, nm, per_mm;
};

class AgfReader {
public:
  AgfReader(std::string_view text, const std::filesystem::path& file, const Warn& warn)
      : text_(without_utf16(text)), where_{file.string(), 0, 1}, warn_(warn) {}

  std::vector<FileGlass> read() {
    std::string_view rest = text_;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      std::string_view line = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (line.ends_with('\r')) line.remove_suffix(1);
      ++where_.line;
      read_line(line);
    }
    finish();
    if (found_.empty())
      throw ReadError(SourcePosition{where_.file, 1, 1}, "the catalogue holds no glass",
                      "no line begins with NM", "Give a glass catalogue in Zemax's format");
    return std::move(found_);
  }

private:
  void read_line(std::string_view line) {
    if (line.size() < 3 || line[2] != ' ') return;
    const std::string_view keyword = line.substr(0, 2);
    std::string blanks(line.substr(3));
    std::ranges::replace(blanks, '\t', ' ');
    const std::vector<std::string_view> words = split_words(blanks);
    if (keyword == "NM") return begin(words);
    if (entry_.formula == 0) return; // what stands before the first glass is about the catalogue
    if (keyword == "CD")
      for (const std::string_view word : words)
        entry_.coefficients.push_back(number(word));
    else if (keyword == "LD" && words.size() >= 2)
      std::tie(entry_.glass.lower_nm, entry_.glass.upper_nm) =
          std::pair(1e3 * number(words[0]), 1e3 * number(words[1]));
    else if (keyword == "IT" && words.size() >= 3)
      add_transmittance(number(words[0]), number(words[1]), number(words[2]));
  }

  void begin(const std::vector<std::string_view>& words) {
    finish();
    entry_ = {where_, {}, 0, {}, {}, {}};
    if (words.size() < 5)
      throw ReadError(where_, "NM has too few words",
                      "it takes a name, a formula, a code, n_d and V_d", "Add them");
    entry_.glass.name = std::string(words[0]);
    const double formula = number(words[1]);
    entry_.formula = static_cast<int>(std::clamp(formula, 0.0, 99.0));
    if (entry_.formula < 1 || entry_.formula > 13)
      throw ReadError(where_, fmt::format("{} names no formula", words[1]),
                      "formulas have the numbers 1 to 13", "Check the line");
    entry_.glass.n_d = number(words[3]);
    entry_.glass.v_d = number(words[4]);
    entry_.glass.source = where_.file;
  }

  void add_transmittance(double um, double share, double mm) {
    if (!(mm > 0.0) || !(um > 0.0)) return; // Zemax writes 0 for what was not measured
    if (!entry_.nm.empty() && 1e3 * um <= entry_.nm.back()) return;
    entry_.nm.push_back(1e3 * um);
    entry_.per_mm.push_back(-std::log(std::clamp(share, kLeastTransmittance, 1.0)) / mm);
  }

  void finish() {
    if (entry_.formula == 0) return;
    FileGlass found{std::move(entry_.glass), Curve::constant(0.0)};
    try {
      found.glass.dispersion = agf_law(std::exchange(entry_.formula, 0), entry_.coefficients);
    } catch (const std::invalid_argument& fault) {
      if (warn_)
        warn_(fmt::format("{}: glass {} is left out: {}", to_string(entry_.where), found.glass.name,
                          fault.what()));
      return;
    }
    if (!entry_.nm.empty())
      found.absorption_per_mm = Curve::table(std::move(entry_.nm), std::move(entry_.per_mm));
    found_.push_back(std::move(found));
  }

  [[nodiscard]] double number(std::string_view word) const {
    if (const auto value = parse_finite(word)) return *value;
    throw ReadError(where_, fmt::format("\"{}\" is not a number", word), "one should stand here",
                    "Check the line");
  }

  std::string text_;
  SourcePosition where_;
  const Warn& warn_;
  Entry entry_;
  std::vector<FileGlass> found_;
};

} // namespace

std::vector<FileGlass> read_agf_text(std::string_view text, const std::filesystem::path& file,
                                     const Warn& warn) {
  return AgfReader(text, file, warn).read();
}

} // namespace abbe
