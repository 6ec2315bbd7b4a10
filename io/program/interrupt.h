#pragma once

#include <atomic>

namespace abbe {

/// Becomes true when the user presses Ctrl-C or the program is asked to terminate. A second signal
/// ends the program at once. Calling it installs the handler.
[[nodiscard]] const std::atomic<bool>& interrupted();

} // namespace abbe
