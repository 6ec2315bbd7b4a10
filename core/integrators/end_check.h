#pragma once

#include <cstdint>
#include <functional>

namespace abbe {

/// Tells whether a rendering is to end, to whoever is in the middle of a long path.
using IsOver = std::function<bool()>;

/// Asks that now and then, since asking takes longer than a ray.
class EndCheck {
public:
  /// Until this is called nothing ends early. Keeps a reference.
  void end_with(const IsOver& is_over) { is_over_ = &is_over; }
  /// To be called for each ray; true where the path is to be given up.
  [[nodiscard]] bool gives_up() { return (++rays_ & 0xffu) == 0 && is_over_ && (*is_over_)(); }

private:
  const IsOver* is_over_ = nullptr;
  std::uint32_t rays_ = 0;
};

} // namespace abbe
