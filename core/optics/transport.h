#pragma once

#include <cstdint>

namespace abbe {

/// What a path carries, which matters where light changes medium. Camera paths carry radiance: a
/// boundary scales what it transmits by (n_before / n_after)^2, where `before` is the side of `wo`.
/// Light paths carry flux, without that factor [Veach97, 5.2].
enum class Transport : std::uint8_t { radiance, flux };

} // namespace abbe
