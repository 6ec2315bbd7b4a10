#pragma once

namespace abbe {

/// Exit codes: a mistake of the user's is 2, any other failure 1, an interruption 130.
inline constexpr int kExitFailure = 1, kExitUsage = 2, kExitInterrupted = 130;

} // namespace abbe
