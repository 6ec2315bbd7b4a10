#include "spectral/curve.h"

#include "spectral/band_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace abbe {
namespace {

void require_finite(const std::vector<double>& values, const char* message) {
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    throw std::invalid_argument(message);
}

// Exact at both ends: a node keeps the number that was given for it.
double mix(double a, double b, double t) {
  return (1.0 - t) * a + t * b;
}

} // namespace

Curve Curve::constant(double value) {
  return Curve(Constant{value});
}

Curve Curve::samples81(std::vector<double> values) {
  if (values.size() != kSampleCount)
    throw std::invalid_argument("a sampled curve has 81 values, 380 to 780 nm in steps of 5");
  require_finite(values, "a sampled curve has a value that is not finite");
  return Curve(Samples{std::move(values)});
}

Curve Curve::table(std::vector<double> wavelengths_nm, std::vector<double> values,
                   Outside outside) {
  if (wavelengths_nm.size() != values.size())
    throw std::invalid_argument("a tabulated curve needs one value per wavelength");
  if (values.empty()) throw std::invalid_argument("a tabulated curve needs at least one point");
  require_finite(wavelengths_nm, "a tabulated curve has a wavelength that is not finite");
  require_finite(values, "a tabulated curve has a value that is not finite");
  if (std::adjacent_find(wavelengths_nm.begin(), wavelengths_nm.end(), std::greater_equal<>()) !=
      wavelengths_nm.end())
    throw std::invalid_argument("the wavelengths of a tabulated curve must ascend");
  return Curve(Table{std::move(wavelengths_nm), std::move(values), outside});
}

Curve Curve::lines(std::vector<SpectralLine> lines) {
  if (lines.empty()) throw std::invalid_argument("a curve of lines needs at least one");
  if (!std::all_of(lines.begin(), lines.end(), [](const SpectralLine& line) {
        return std::isfinite(line.nm) && std::isfinite(line.power);
      }))
    throw std::invalid_argument("a line has a number that is not finite");
  return Curve(Lines{std::move(lines)});
}

std::span<const SpectralLine> Curve::spectral_lines() const {
  if (const auto* form = std::get_if<Lines>(&form_)) return form->lines;
  return {};
}

double Curve::at(double lambda_nm) const {
  return std::visit([&](const auto& form) { return value_at(form, lambda_nm); }, form_);
}

double Curve::mean(double lower_nm, double upper_nm) const {
  if (const auto* form = std::get_if<Table>(&form_))
    return integral(*form, lower_nm, upper_nm) / (upper_nm - lower_nm);
  return at(0.5 * (lower_nm + upper_nm));
}

Curve Curve::sampled81() const {
  std::vector<double> values;
  for (int k = 0; k < kSampleCount; ++k)
    values.push_back(mean(sample_nm(k) - 0.5 * kSampleStepNm, sample_nm(k) + 0.5 * kSampleStepNm));
  return samples81(std::move(values));
}

std::optional<double> Curve::constant_value() const {
  if (const auto* form = std::get_if<Constant>(&form_)) return form->value;
  return std::nullopt;
}

Curve Curve::scaled(double factor) const {
  if (const auto* form = std::get_if<Constant>(&form_)) return constant(form->value * factor);
  if (const auto* form = std::get_if<Lines>(&form_)) {
    Lines scaled = *form;
    for (SpectralLine& line : scaled.lines)
      line.power *= factor;
    return Curve(std::move(scaled));
  }
  Form form = form_;
  std::vector<double>& values = std::holds_alternative<Samples>(form)
                                    ? std::get<Samples>(form).values
                                    : std::get<Table>(form).values;
  for (double& value : values)
    value *= factor;
  return Curve(std::move(form));
}

Curve Curve::times(const Curve& other) const {
  if (const auto factor = constant_value()) return other.scaled(*factor);
  if (const auto factor = other.constant_value()) return scaled(*factor);
  if (const auto* form = std::get_if<Lines>(&form_)) {
    Lines product = *form;
    for (SpectralLine& line : product.lines)
      line.power *= other.at(line.nm);
    return Curve(std::move(product));
  }
  if (!other.spectral_lines().empty()) return other.times(*this);
  const auto* a = std::get_if<Samples>(&form_);
  const auto* b = std::get_if<Samples>(&other.form_);
  if (a && b) {
    std::vector<double> values(kSampleCount);
    std::transform(a->values.begin(), a->values.end(), b->values.begin(), values.begin(),
                   std::multiplies<>());
    return Curve(Samples{std::move(values)});
  }
  const Table first = a ? as_table(*a) : std::get<Table>(form_);
  const Table second = b ? as_table(*b) : std::get<Table>(other.form_);
  return product(first, second);
}

double Curve::value_at(const Constant& form, double) {
  return form.value;
}

double Curve::value_at(const Samples& form, double lambda_nm) {
  const double position =
      std::clamp((lambda_nm - kFirstSampleNm) / kSampleStepNm, 0.0, kSampleCount - 1.0);
  const int index = std::min(static_cast<int>(position), kSampleCount - 2);
  return mix(form.values[index], form.values[index + 1], position - index);
}

double Curve::value_at(const Table& form, double lambda_nm) {
  const std::vector<double>& x = form.wavelengths_nm;
  const bool outside = lambda_nm < x.front() || lambda_nm > x.back();
  if (outside && form.outside == Outside::zero) return 0.0;
  if (lambda_nm <= x.front()) return form.values.front();
  if (lambda_nm >= x.back()) return form.values.back();
  const auto upper = std::upper_bound(x.begin(), x.end(), lambda_nm);
  const auto i = upper - x.begin();
  return mix(form.values[i - 1], form.values[i], (lambda_nm - x[i - 1]) / (x[i] - x[i - 1]));
}

/// By trapezoids from point to point, which are exact for what is linear between them.
double Curve::integral(const Table& form, double lower_nm, double upper_nm) {
  const std::vector<double>& x = form.wavelengths_nm;
  if (form.outside == Outside::zero) {
    lower_nm = std::max(lower_nm, x.front());
    upper_nm = std::min(upper_nm, x.back());
  }
  double sum = 0.0, from = lower_nm;
  auto next = std::upper_bound(x.begin(), x.end(), lower_nm);
  while (from < upper_nm) {
    const double to = next == x.end() ? upper_nm : std::min(*next++, upper_nm);
    sum += 0.5 * (value_at(form, from) + value_at(form, to)) * (to - from);
    from = to;
  }
  return sum;
}

double Curve::value_at(const Lines& form, double lambda_nm) {
  double sum = 0.0;
  for (const SpectralLine& line : form.lines)
    if (std::abs(lambda_nm - line.nm) <= 0.5) sum += line.power;
  return sum;
}

Curve::Table Curve::as_table(const Samples& form) {
  Table table{std::vector<double>(kSampleCount), form.values, Outside::hold_ends};
  for (int k = 0; k < kSampleCount; ++k)
    table.wavelengths_nm[k] = sample_nm(k);
  return table;
}

Curve Curve::product(const Table& a, const Table& b) {
  std::vector<double> wavelengths_nm;
  std::set_union(a.wavelengths_nm.begin(), a.wavelengths_nm.end(), b.wavelengths_nm.begin(),
                 b.wavelengths_nm.end(), std::back_inserter(wavelengths_nm));
  // Where either factor is zero outside its table, the product is too.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = -lower;
  for (const Table* factor : {&a, &b})
    if (factor->outside == Outside::zero) {
      lower = std::max(lower, factor->wavelengths_nm.front());
      upper = std::min(upper, factor->wavelengths_nm.back());
    }
  std::erase_if(wavelengths_nm, [&](double x) { return x < lower || x > upper; });
  if (wavelengths_nm.empty()) return constant(0.0);

  std::vector<double> values;
  values.reserve(wavelengths_nm.size());
  for (const double x : wavelengths_nm)
    values.push_back(value_at(a, x) * value_at(b, x));
  const bool zero = a.outside == Outside::zero || b.outside == Outside::zero;
  return table(std::move(wavelengths_nm), std::move(values),
               zero ? Outside::zero : Outside::hold_ends);
}

} // namespace abbe
