#pragma once

namespace abbe {

/// How many threads can be alive at once besides this one, at most `wanted`. It makes them to find
/// out, and ends them.
[[nodiscard]] int threads_that_can_be_made(int wanted);

/// How many threads shall work and how many the system allows, this one included.
struct Workers {
  int wanted = 1, allowed = 1;
};

/// From now on no more threads work than can be made now, so that the libraries that make threads
/// do not fail: they end the program where the system refuses one. `wanted` is the number of
/// threads that shall work; 0: one per processor.
Workers limit_workers(int wanted);

} // namespace abbe
