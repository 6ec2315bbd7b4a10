#pragma once

#include "bench/measurements/timing.h"
#include "core/scene/settings.h"

#include <optional>
#include <string>

namespace abbe::bench {

// Figures as tables show them.

/// "256x256", with the crop where there is one.
[[nodiscard]] std::string size_text(const RenderSettings& settings);
[[nodiscard]] std::string seconds_text(double seconds);
/// Half the range over the median, in percent.
[[nodiscard]] std::string range_text(const Summary& summary);
/// Mray/s.
[[nodiscard]] std::string speed_text(std::size_t rays, double seconds);
/// Three digits, or a dash where there is nothing.
[[nodiscard]] std::string or_dash(const std::optional<double>& value);

} // namespace abbe::bench
