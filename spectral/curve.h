#pragma once

#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace abbe {

/// The values of a tabulated curve beyond its first and last wavelength.
enum class Outside { hold_ends, zero };

/// Light of a single wavelength; its power has the unit of a curve's value times nm.
struct SpectralLine {
  double nm = 0.0;
  double power = 0.0;
  friend bool operator==(const SpectralLine&, const SpectralLine&) = default;
};

/// A function of wavelength: a reflectance, a transmittance, the spectrum of a light, n or k of a
/// metal. A plain value; copying a constant copies one number. Units are those of what it
/// describes.
class Curve {
public:
  /// The constant 0.
  Curve() : form_(Constant{0.0}) {}

  /// The same value at every wavelength.
  [[nodiscard]] static Curve constant(double value);

  /// The thesis's convention [War05]: 81 values at 380, 385 ... 780 nm, each the mean of its 5 nm
  /// cell. Linear between the samples, held at the ends.
  /// Throws std::invalid_argument unless there are exactly 81 finite values.
  [[nodiscard]] static Curve samples81(std::vector<double> values);

  /// Values at ascending wavelengths (nm), linear between; `outside` says what lies beyond them.
  /// Throws std::invalid_argument when the lengths differ, when there is no point, when the
  /// wavelengths do not strictly ascend, or when a number is not finite.
  [[nodiscard]] static Curve table(std::vector<double> wavelengths_nm, std::vector<double> values,
                                   Outside outside = Outside::hold_ends);

  /// Single lines, with nothing between them. Throws std::invalid_argument when there is none, or a
  /// number is not finite.
  [[nodiscard]] static Curve lines(std::vector<SpectralLine> lines);

  /// The lines of a curve that was made of lines; empty for others.
  [[nodiscard]] std::span<const SpectralLine> spectral_lines() const;

  /// The value at `lambda_nm`; at a sample or a tabulated wavelength exactly the number given. A
  /// line has no value at a wavelength: `at` shows it as if it were 1 nm wide. Whoever sums light
  /// over bands takes the lines themselves.
  [[nodiscard]] double at(double lambda_nm) const;

  /// The mean over a range of wavelengths. Of a table it is the exact integral over the width. A
  /// sample stands for its cell already, so that of samples it is the value in the middle.
  [[nodiscard]] double mean(double lower_nm, double upper_nm) const;

  /// Samples of the thesis's convention: the means over 5 nm around 380, 385 ... 780 nm.
  [[nodiscard]] Curve sampled81() const;

  /// The value, when the curve was made as a constant.
  [[nodiscard]] std::optional<double> constant_value() const;

  /// True for a curve that was made as the constant 0.
  [[nodiscard]] bool zero() const { return constant_value() == 0.0; }

  /// This curve times a number.
  [[nodiscard]] Curve scaled(double factor) const;

  /// The pointwise product. A constant scales the other curve; lines keep their wavelengths;
  /// samples with samples give samples; any other pair gives a table on the points of both, exact
  /// at these points and linear between.
  [[nodiscard]] Curve times(const Curve& other) const;

  friend bool operator==(const Curve&, const Curve&) = default;

private:
  struct Constant {
    double value;
    friend bool operator==(const Constant&, const Constant&) = default;
  };
  struct Samples {
    std::vector<double> values;
    friend bool operator==(const Samples&, const Samples&) = default;
  };
  struct Table {
    std::vector<double> wavelengths_nm;
    std::vector<double> values;
    Outside outside = Outside::hold_ends;
    friend bool operator==(const Table&, const Table&) = default;
  };
  struct Lines {
    std::vector<SpectralLine> lines;
    friend bool operator==(const Lines&, const Lines&) = default;
  };
  using Form = std::variant<Constant, Samples, Table, Lines>;

  explicit Curve(Form form) : form_(std::move(form)) {}

  [[nodiscard]] static double value_at(const Constant& form, double lambda_nm);
  [[nodiscard]] static double value_at(const Samples& form, double lambda_nm);
  [[nodiscard]] static double value_at(const Table& form, double lambda_nm);
  [[nodiscard]] static double value_at(const Lines& form, double lambda_nm);
  [[nodiscard]] static double integral(const Table& form, double lower_nm, double upper_nm);
  [[nodiscard]] static Table as_table(const Samples& form);
  [[nodiscard]] static Curve product(const Table& a, const Table& b);

  Form form_;
};

} // namespace abbe
