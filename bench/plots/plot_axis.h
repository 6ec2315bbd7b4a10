#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace abbe::bench {

struct Tick {
  double value = 0.0;
  std::string label; ///< empty: a small one
};

/// How values are laid out along an axis; `whole`: evenly, with ticks at whole numbers alone.
enum class Scale : std::uint8_t { even, whole, logarithmic };

/// Takes values to places along an edge of a plot.
class PlotAxis {
public:
  /// An axis that shows all the values; with `from_zero` also 0. A logarithmic one leaves out what
  /// is not positive. Without values it shows 0 to 1, or 1 to 10. It ends at ticks.
  PlotAxis(const std::vector<double>& values, Scale scale, bool from_zero);

  [[nodiscard]] bool shows(double value) const {
    return scale_ != Scale::logarithmic || value > 0.0;
  }
  /// 0 at the lower end, 1 at the upper one.
  [[nodiscard]] double place(double value) const;
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }
  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }

private:
  void set_even(double least, double most);
  void set_logarithmic(double least, double most);

  Scale scale_;
  double lower_ = 0.0, upper_ = 1.0;
  std::vector<Tick> ticks_;
};

} // namespace abbe::bench
