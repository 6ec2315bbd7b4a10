#pragma once

#include "core/scene/material.h"

#include <cstddef>

namespace abbe {

// Numbers by which equal values are found among many. Equal values have the same; different ones
// mostly have not, though curves are looked at in a few places only.

[[nodiscard]] std::size_t fingerprint(const Material& material);
[[nodiscard]] std::size_t fingerprint(const Medium& medium);

} // namespace abbe
