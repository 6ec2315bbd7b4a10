#include "io/libraries/read_display.h"

#include "io/text/read_arguments.h"
#include "spectral/adaptation.h"
#include "spectral/data_table.h"
#include "spectral/illuminant.h"

#include <stdexcept>

namespace abbe {

bool can_be_white(const Chromaticity& c) {
  if (!(c.x > 0.0 && c.y > 0.0 && c.x + c.y < 1.0)) return false;
  try {
    (void)bradford_adaptation(to_xyz(c, 1.0), to_xyz(kSrgbWhite, 1.0));
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::optional<std::optional<WhitePoint>> parse_white_point(std::string_view text) {
  using Found = std::optional<WhitePoint>;
  if (same_name(text, "none")) return Found{};
  if (const auto illuminant = find_illuminant(text))
    return Found{WhitePoint::of_light(*illuminant)};
  const std::size_t comma = text.find(',');
  if (comma == text.npos) return std::nullopt;
  const auto x = parse_finite(text.substr(0, comma)), y = parse_finite(text.substr(comma + 1));
  if (!x || !y || !can_be_white({*x, *y})) return std::nullopt;
  return Found{WhitePoint::at({*x, *y})};
}

} // namespace abbe
