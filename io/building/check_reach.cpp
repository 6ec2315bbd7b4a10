#include "io/building/check_reach.h"

#include <fmt/format.h>

namespace abbe {

void check_reach(const SourcePosition& where, const std::string& what, double reach) {
  if (reach <= kFarthestCoordinate) return; // what is no number is too far, too
  throw ReadError(where, what + " is too far off",
                  fmt::format("it reaches {:.3g} units from the origin, and rays can be followed "
                              "to {:.0e}",
                              reach, kFarthestCoordinate),
                  "Bring it nearer, or measure in larger units");
}

} // namespace abbe
