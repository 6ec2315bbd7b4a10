// n as a function of wavelength, in a scene or in a material library:
//
//   cauchy 1.5046 0.0042 0           ! A, B (um^2), C (um^4)
//   abbe 1.5168 64.17                ! n_d, V_d
//   indexTable 3  486.1 1.5224  587.6 1.5168  656.3 1.5143
//   indexFit 3  486.1 1.5224  587.6 1.5168  656.3 1.5143
//   quartz linear                    ! the thesis's

#include "io/libraries/read_dispersion.h"

#include "io/libraries/read_glass.h"
#include "spectral/band_grid.h"
#include "spectral/fit_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace abbe {
namespace {

constexpr double kResidualWorthAWarning = 1e-4;

constexpr int kLeastCode = 200; ///< no glass has an index below 1.2

/// Six digits, and a point and three more where the density stands in the code.
bool is_glass_code(std::string_view text) {
  const auto digits = [](std::string_view part) {
    return std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
  };
  if (text.size() == 6) return digits(text);
  return text.size() == 10 && text[6] == '.' && digits(text.substr(0, 6)) && digits(text.substr(7));
}

void warn_at_keyword(const Arguments& arguments, const Warn& warn, const std::string& message) {
  if (warn) warn(to_string(arguments.keyword().where) + ": " + message);
}

} // namespace

WrittenIndex read_cauchy(Arguments& arguments, const Warn&) {
  constexpr double kMost = 1e3;
  const double a = arguments.number(kIndexRange);
  const double b = arguments.number({"a coefficient in um^2", -kMost, kMost});
  return {Cauchy{a, b, arguments.number({"a coefficient in um^4", -kMost, kMost})}, "cauchy"};
}

WrittenIndex read_abbe(Arguments& arguments, const Warn&) {
  return {read_abbe_numbers(arguments), "abbe"};
}

Dispersion read_abbe_numbers(Arguments& arguments) {
  const Token at = arguments.reader().peek();
  const double n_d = arguments.number(kIndexRange);
  if (n_d < 1.0)
    throw ReadError(at.where, fmt::format("{} with an Abbe number is no medium", at.text),
                    "below an index of 1 an Abbe number above 0 would mean that n rises with the "
                    "wavelength",
                    "Give an n_d of 1 or more, or speedOfLight, cauchy or indexTable");
  return cauchy_of_abbe(n_d, arguments.number(kAbbeRange));
}

std::optional<WrittenIndex> read_glass_code(Arguments& arguments) {
  const Token& token = arguments.reader().peek();
  if (token.kind != TokenKind::word || !is_glass_code(token.text)) return std::nullopt;
  const Token code = arguments.reader().next();
  const int digits = std::stoi(code.text.substr(0, 6));
  const int index = digits / 1000, abbe = digits % 1000;
  const double v_d = 0.1 * abbe;
  if (!kAbbeRange.holds(v_d))
    throw ReadError(code.where, fmt::format("{} is the code of no glass", code.text),
                    fmt::format("its last three digits give an Abbe number of {:.1f}", v_d),
                    "Give a code such as 517642, for n_d 1.517 and V_d 64.2");
  const double n_d = (index < kLeastCode ? 2.0 : 1.0) + 0.001 * index;
  return WrittenIndex{cauchy_of_abbe(n_d, v_d), code.text};
}

Points read_points(Arguments& arguments, const Range& value) {
  const auto count = arguments.whole_number({"the number of points", 1.0, 10000.0});
  Points points;
  for (std::int64_t i = 0; i < count; ++i) {
    const Token at = arguments.reader().peek();
    const double nm = arguments.number({.meaning = "a wavelength in nm", .open = true});
    if (!points.nm.empty() && nm <= points.nm.back())
      throw ReadError(at.where,
                      fmt::format("the wavelengths of {} do not ascend", arguments.name()),
                      fmt::format("{} follows {:g}", at.text, points.nm.back()),
                      "Sort the points, each wavelength once");
    points.nm.push_back(nm);
    points.values.push_back(arguments.number(value));
  }
  return points;
}

WrittenIndex read_index_table(Arguments& arguments, const Warn& warn) {
  Points points = read_points(arguments, kIndexRange);
  const double first = points.nm.front(), last = points.nm.back();
  if (points.nm.size() > 1 && (first > kLowerNm || last < kUpperNm))
    warn_at_keyword(arguments, warn,
                    fmt::format("indexTable has no dispersion beyond {:g}-{:g} nm (pictures need "
                                "{}-{} nm; indexFit would go on)",
                                first, last, kLowerNm, kUpperNm));
  return {tabulated_index(std::move(points.nm), std::move(points.values)), "indexTable"};
}

WrittenIndex read_index_fit(Arguments& arguments, const Warn& warn) {
  const Points points = read_points(arguments, kIndexRange);
  IndexFit fit = fit_index(points.nm, points.values);
  const std::string miss =
      fmt::format("its points by up to {:.1e}, at {:g} nm", fit.largest_residual, fit.worst_nm);
  if (fit.largest_residual > kResidualWorthAWarning)
    warn_at_keyword(arguments, warn, "indexFit misses " + miss);
  return {std::move(fit.law), "indexFit, which misses " + miss};
}

WrittenIndex read_quartz(Arguments& arguments, const Warn&) {
  const bool linear = arguments.choice<bool>({{"linear", true}, {"polynomial", false}});
  return {linear ? Dispersion(ThesisLinear{}) : Dispersion(ThesisPolynomial{}), "quartz"};
}

} // namespace abbe
