#pragma once

#include <atomic>

namespace abbe {

/// Becomes true when the user presses Ctrl-C, the terminal is closed, or the program is asked to
/// end by any of the signals by which schedulers ask (SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU). Signals
/// within a second of the first are the same request, which may reach a process in several ways at
/// once; a later one ends the program at once. Calling it installs the handler.
[[nodiscard]] const std::atomic<bool>& interrupted();

} // namespace abbe
