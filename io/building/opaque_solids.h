#pragma once

#include "core/scene/scene.h"
#include "io/text/read_error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace abbe {

/// The opaque solids of a scene and their places in its files. A room may be such a solid, with
/// camera and lamps in it, but light never crosses its surface.
class OpaqueSolids {
public:
  /// Notes that a shape of the scene, by its number, is opaque and has an inside.
  void add(std::size_t shape, const SourcePosition& where);

  /// Warns of each solid that has the camera inside and a point or spot light outside, or the other
  /// way round: nothing is seen of that light. Where the scene has no light at all but the sky's, a
  /// solid around the camera is warned of too.
  void warn_of_parted(const Scene& scene, const Warn& warn) const;

private:
  struct Noted {
    std::size_t shape;
    std::uint32_t file; ///< its number
    int line, column;
  };
  [[nodiscard]] std::string place_of(const Noted& solid) const;

  std::vector<std::string> files_;
  std::vector<Noted> solids_;
};

} // namespace abbe
