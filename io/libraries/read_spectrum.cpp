// Spectra as instruments and tables give them:
//
//   wavelength,power          a table: commas, semicolons, tabs or blanks between two columns
//   380,0.0123
//
//   SPECTRAL_BANDS "36"       CGATS, as Argyll writes it, with SPECTRAL_START_NM and _END_NM
//   BEGIN_DATA
//   0.1 0.2 ...
//
//   <SpectralData wavelength="380">0.0123</SpectralData>         IES TM-27

#include "io/libraries/read_spectrum.h"

#include "io/text/numbers.h"
#include "spectral/band_grid.h"
#include "spectral/data_table.h"
#include "spectral/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// The lines of a text, with whatever ends them taken off.
class Lines {
public:
  Lines(std::string_view text, const fs::path& file) : rest_(text), file_(file) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  }
  /// Goes to the next line; false at the end.
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end);
    if (rest_.starts_with("\r\n"))
      rest_.remove_prefix(2);
    else if (!rest_.empty())
      rest_.remove_prefix(1);
    ++number_;
    return true;
  }
  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] SourcePosition position() const {
    return {file_.string(), static_cast<int>(number_), 1};
  }
  [[nodiscard]] ReadError error(const std::string& what, const std::string& why,
                                const std::string& right) const {
    return {position(), what, why, right};
  }

private:
  std::string_view rest_, line_;
  std::size_t number_ = 0;
  const fs::path& file_;
};

/// The parts of a line between any of these characters. Empty ones are left out, and so are quotes
/// around one.
std::vector<std::string> parts(std::string_view line, std::string_view separators) {
  std::vector<std::string> found;
  std::string part;
  bool quoted = false;
  const auto take = [&] {
    if (!part.empty()) found.push_back(std::exchange(part, {}));
  };
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (!quoted && separators.find(c) != std::string_view::npos)
      take();
    else
      part += c;
  }
  take();
  return found;
}

MeasuredSpectrum read_table(Lines& lines, const Warn& warn) {
  MeasuredSpectrum spectrum;
  bool warned = false;
  while (lines.next()) {
    const std::string_view line = lines.line();
    // Where semicolons or tabs separate, a comma is a decimal point.
    const bool comma = line.find_first_of(";\t") == std::string_view::npos;
    std::vector<std::string> fields = parts(line, comma ? ", \t" : "; \t");
    if (fields.empty() || fields[0][0] == '#' || fields[0][0] == '%' || fields[0][0] == '!')
      continue;
    if (!comma)
      for (std::string& field : fields)
        std::ranges::replace(field, ',', '.');
    const auto nm = parse_finite(fields[0]);
    const auto value = fields.size() > 1 ? parse_finite(fields[1]) : std::nullopt;
    if (!nm && spectrum.nm.empty()) continue; // a title
    if (!nm || !value)
      throw lines.error("a wavelength and a value should stand here",
                        fmt::format("\"{}\" is not two numbers", line.substr(0, 60)),
                        "Give a line with two columns for each wavelength, in nm");
    if (fields.size() > 2 && !std::exchange(warned, true) && warn)
      warn(fmt::format("{}: of {} columns the second is taken", to_string(lines.position()),
                       fields.size()));
    spectrum.nm.push_back(*nm);
    spectrum.values.push_back(*value);
    spectrum.lines.push_back(lines.number());
  }
  return spectrum;
}

/// A CGATS file: the words with their values, the names of its fields, and its first set of data.
struct Cgats {
  std::map<std::string, std::string> words;
  std::vector<std::string> fields, values;
  std::size_t line = 0; ///< of the data
  std::size_t sets = 0;
};

Cgats read_cgats_words(Lines& lines) {
  Cgats file;
  std::vector<std::string>* list = nullptr;
  while (lines.next()) {
    const std::string_view all = lines.line();
    std::vector<std::string> words = parts(all.substr(0, all.find('#')), " \t");
    if (words.empty()) continue;
    if (words[0] == "BEGIN_DATA_FORMAT") {
      list = &file.fields;
    } else if (words[0] == "BEGIN_DATA") {
      list = &file.values;
      file.line = lines.number() + 1;
    } else if (words[0].starts_with("END_DATA")) {
      list = nullptr;
    } else if (list) {
      list->insert(list->end(), words.begin(), words.end());
    } else if (words.size() > 1) {
      file.words[words[0]] = words[1];
    }
  }
  return file;
}

/// The digits at the end of SPEC_380, SPECTRAL_NM380 or nm380.
std::optional<double> wavelength_of_field(const std::string& field) {
  const bool spectral = field.starts_with("SPEC") || field.starts_with("nm");
  const std::size_t digits = field.find_first_of("0123456789");
  if (!spectral || digits == std::string::npos) return std::nullopt;
  return parse_finite(field.substr(digits));
}

MeasuredSpectrum read_cgats(Lines& lines, const Warn& warn) {
  const Cgats file = read_cgats_words(lines);
  const auto number = [&](const char* word) -> std::optional<double> {
    const auto found = file.words.find(word);
    return found == file.words.end() ? std::nullopt : parse_finite(found->second);
  };
  MeasuredSpectrum spectrum;
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < file.fields.size(); ++i)
    if (const auto nm = wavelength_of_field(file.fields[i])) {
      columns.push_back(i);
      spectrum.nm.push_back(*nm);
    }
  if (columns.empty())
    throw lines.error("the file has no spectral fields", "such as SPEC_380 after BEGIN_DATA_FORMAT",
                      "Give a file that was measured with spectra");
  // Names are rounded to whole nm; these are not.
  const auto first = number("SPECTRAL_START_NM"), last = number("SPECTRAL_END_NM");
  if (first && last && columns.size() > 1)
    for (std::size_t i = 0; i < columns.size(); ++i)
      spectrum.nm[i] = *first + (*last - *first) * static_cast<double>(i) /
                                    static_cast<double>(columns.size() - 1);
  if (file.values.size() < file.fields.size())
    throw lines.error("the file has no set of data",
                      fmt::format("{} fields are announced, {} values follow", file.fields.size(),
                                  file.values.size()),
                      "Give a file with at least one set of data");
  if (file.values.size() >= 2 * file.fields.size() && warn)
    warn(fmt::format("{}: of {} spectra the first is taken", to_string(lines.position()),
                     file.values.size() / file.fields.size()));
  const double norm = number("SPECTRAL_NORM").value_or(1.0);
  for (const std::size_t column : columns) {
    const auto value = parse_finite(file.values[column]);
    if (!value || !(norm > 0.0))
      throw lines.error(fmt::format("{} is no number", file.values[column]),
                        "it is a value of " + file.fields[column], "Give a number");
    spectrum.values.push_back(*value / norm);
    spectrum.lines.push_back(file.line);
  }
  return spectrum;
}

/// What stands between two marks, of which the text up to the second is taken off; empty where one
/// of them is missing.
std::string_view take_between(std::string_view& text, std::string_view begin,
                              std::string_view end) {
  const std::size_t from = text.find(begin);
  if (from == std::string_view::npos) return {};
  const std::string_view rest = text.substr(from + begin.size());
  const std::size_t to = rest.find(end);
  if (to == std::string_view::npos) return {};
  text = rest.substr(to);
  return rest.substr(0, to);
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

/// Each point is an element `SpectralData` with the attribute `wavelength`, on one line; all else
/// of the file is about the measurement.
MeasuredSpectrum read_tm27(Lines& lines) {
  MeasuredSpectrum spectrum;
  while (lines.next()) {
    std::string_view line = lines.line();
    for (std::size_t at; (at = line.find("SpectralData ")) != std::string_view::npos;) {
      line.remove_prefix(at + 1);
      const std::size_t quote = line.find_first_of("\"'");
      const std::string_view mark = quote == std::string_view::npos ? "\"" : line.substr(quote, 1);
      const auto nm = parse_finite(without_blanks(take_between(line, mark, mark)));
      const auto value = parse_finite(without_blanks(take_between(line, ">", "<")));
      if (!nm || !value)
        throw lines.error("this SpectralData holds no point",
                          "a point is <SpectralData wavelength=\"NM\">VALUE</SpectralData>, on one "
                          "line",
                          "Write it so");
      spectrum.nm.push_back(*nm);
      spectrum.values.push_back(*value);
      spectrum.lines.push_back(lines.number());
    }
  }
  return spectrum;
}

enum class SpectrumFormat : std::uint8_t { table, cgats, tm27 };

constexpr std::array<std::pair<std::string_view, SpectrumFormat>, 6> kFormats{{
    {".csv", SpectrumFormat::table},
    {".tsv", SpectrumFormat::table},
    {".txt", SpectrumFormat::table},
    {".sp", SpectrumFormat::cgats},
    {".cgats", SpectrumFormat::cgats},
    {".spdx", SpectrumFormat::tm27},
}};

std::optional<SpectrumFormat> spectrum_format(const fs::path& name) {
  const std::string extension = name.extension().string();
  for (const auto& [known, format] : kFormats)
    if (same_name(extension, known)) return format;
  return std::nullopt;
}

void check_wavelengths(const MeasuredSpectrum& spectrum, const fs::path& file) {
  const auto at = [&](std::size_t i) {
    return SourcePosition{file.string(), static_cast<int>(spectrum.lines[i]), 1};
  };
  if (spectrum.nm.size() < 2)
    throw ReadError(file, "the file holds no spectrum",
                    fmt::format("it has {} wavelengths", spectrum.nm.size()),
                    "Give at least two wavelengths in nm, each with its value");
  for (std::size_t i = 1; i < spectrum.nm.size(); ++i)
    if (!(spectrum.nm[i] > spectrum.nm[i - 1]))
      throw ReadError(at(i), "the wavelengths do not ascend",
                      fmt::format("{:g} follows {:g}", spectrum.nm[i], spectrum.nm[i - 1]),
                      "Sort the lines, each wavelength once");
  if (spectrum.nm.back() < kLowerNm || spectrum.nm.front() > kUpperNm)
    throw ReadError(
        at(0), "no wavelength of the file is visible",
        fmt::format("they run from {:g} to {:g}", spectrum.nm.front(), spectrum.nm.back()),
        "Give wavelengths in nm");
}

/// A table of a file's points, after each value has been looked at.
template <class Look>
Curve curve_of(const Token& name, const Warn& warn, const Look& look) {
  const fs::path file = fs::path(name.where.file).parent_path() / name.text;
  std::error_code error;
  if (!fs::exists(file, error))
    throw ReadError(name.where, fmt::format("there is no file \"{}\"", file.string()),
                    "spectra are found relative to the file that names them",
                    "Check the name, or write the whole path");
  MeasuredSpectrum spectrum = read_spectrum_text(read_text_file(file), file, warn);
  for (std::size_t i = 0; i < spectrum.values.size(); ++i)
    spectrum.values[i] = look(spectrum, i, file);
  return Curve::table(std::move(spectrum.nm), std::move(spectrum.values));
}

} // namespace

bool is_spectrum_file(std::string_view name) {
  return spectrum_format(fs::path(name)).has_value();
}

MeasuredSpectrum read_spectrum_text(std::string_view text, const fs::path& file, const Warn& warn) {
  Lines lines(text, file);
  const auto read = [&] {
    switch (spectrum_format(file).value_or(SpectrumFormat::table)) {
    case SpectrumFormat::cgats:
      return read_cgats(lines, warn);
    case SpectrumFormat::tm27:
      return read_tm27(lines);
    case SpectrumFormat::table:
      break;
    }
    return read_table(lines, warn);
  };
  MeasuredSpectrum spectrum = read();
  check_wavelengths(spectrum, file);
  return spectrum;
}

Curve read_lamp(const Token& name, const Warn& warn) {
  std::size_t negative = 0;
  const Curve lamp =
      curve_of(name, warn, [&](const MeasuredSpectrum& spectrum, std::size_t i, const fs::path&) {
        negative += spectrum.values[i] < 0.0;
        return std::max(0.0, spectrum.values[i]);
      });
  if (negative > 0 && warn)
    warn(fmt::format("{}: {} values of {} are below 0 and count as 0", to_string(name.where),
                     negative, name.text));
  const double y = to_xyz(lamp).y;
  if (!(y > 0.0 && std::isfinite(1.0 / y)))
    throw ReadError(name.where, fmt::format("{} gives no light", shown(name)),
                    "none of its values in the visible range is above 0", "Give another file");
  return lamp.scaled(1.0 / y);
}

Curve read_reflectance(const Token& name, const Warn& warn) {
  constexpr double kMostAbove = 1.05; // what an instrument's white may be off
  std::size_t above = 0;
  const Curve found = curve_of(
      name, warn, [&](const MeasuredSpectrum& spectrum, std::size_t i, const fs::path& file) {
        const double value = spectrum.values[i];
        const SourcePosition at{file.string(), static_cast<int>(spectrum.lines[i]), 1};
        if (value > kMostAbove || value < 1.0 - kMostAbove)
          throw ReadError(at, fmt::format("{:g} is no reflectance", value),
                          fmt::format("it stands at {:g} nm; they lie from 0 to 1", spectrum.nm[i]),
                          "Divide percents by 100");
        above += value > 1.0 || value < 0.0;
        return std::clamp(value, 0.0, 1.0);
      });
  if (above > 0 && warn)
    warn(fmt::format("{}: {} values of {} lie outside 0 to 1 and count as 0 or 1",
                     to_string(name.where), above, name.text));
  return found.sampled81();
}

} // namespace abbe
