#include "bench/reports/figures.h"

#include <fmt/format.h>

namespace abbe::bench {

std::string size_text(const RenderSettings& s) {
  std::string text = fmt::format("{}x{}", s.width, s.height);
  if (s.crop)
    text += fmt::format(" crop {},{},{},{}", s.crop->x0, s.crop->y0, s.crop->x1, s.crop->y1);
  return text;
}

std::string seconds_text(double seconds) {
  return fmt::format("{:.3f}", seconds);
}

std::string range_text(const Summary& s) {
  const double percent = s.median > 0.0 ? 50.0 * (s.highest - s.lowest) / s.median : 0.0;
  return fmt::format("{:.0f}", percent);
}

std::string speed_text(std::size_t rays, double seconds) {
  return fmt::format("{:.3f}", seconds > 0.0 ? static_cast<double>(rays) / seconds * 1e-6 : 0.0);
}

std::string or_dash(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "-";
}

} // namespace abbe::bench
