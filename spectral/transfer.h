#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A transfer function between linear light L and code value V, both 1 at full scale:
///   L = (scale V + offset)^exponent for V >= knee, L = slope V below.
/// All that displays use is of this form, which is also ICC's parametric curve of type 3 [ICC2010].
struct TransferFunction {
  std::string name;      ///< a name of transfer_names, or the exponent
  double exponent = 1.0; ///< gamma
  double scale = 1.0;
  double offset = 0.0;
  double slope = 0.0;
  double knee = 0.0;
  friend bool operator==(const TransferFunction&, const TransferFunction&) = default;
};

/// sRGB [IEC99].
[[nodiscard]] const TransferFunction& srgb_transfer();
/// V = L.
[[nodiscard]] const TransferFunction& linear_transfer();
/// The thesis's V = L^(1/gamma) [War05]. Throws std::invalid_argument unless 0.1 <= gamma <= 10.
[[nodiscard]] TransferFunction power_transfer(double gamma);

/// The function of this name, in upper or lower case, or with this number as its gamma. Empty for
/// an unknown name and a gamma outside of 0.1 ... 10.
[[nodiscard]] std::optional<TransferFunction> find_transfer(std::string_view name);
[[nodiscard]] std::vector<std::string> transfer_names();

/// Both are odd functions, so that negative values survive the round trip; values above 1
/// follow the power law.
[[nodiscard]] double encode(const TransferFunction& transfer, double linear);
[[nodiscard]] double decode(const TransferFunction& transfer, double code);

} // namespace abbe
