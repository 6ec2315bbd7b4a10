#pragma once

#include "bench/reports/sections.h"

namespace abbe::bench {

/// The sections as a page that needs no other file.
[[nodiscard]] std::string to_html(const std::vector<Section>& sections);

} // namespace abbe::bench
