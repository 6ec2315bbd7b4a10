#pragma once

#include <glm/vec2.hpp>

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace abbe {

/// What the user wants to see, beside what the scene says.
struct PreviewWishes {
  std::map<std::string, std::string> settings; ///< texts of options by their names: "--size"
  std::string layer;                           ///< the layer that is shown; empty: the picture
  glm::dvec2 orbit{0.0}; ///< angles about the point looked at, in radians: to the right and up
  double distance = 1.0; ///< from that point, in multiples of the scene's
  std::optional<glm::dvec2> focus;      ///< the point of the image that is to be sharp
  std::optional<double> focus_distance; ///< what was found there
  bool forget_focus = false;            ///< the focus is to be the scene's again
  std::optional<double> aperture;       ///< of the lens, in scene units; empty: the scene's
  bool read_again = true;               ///< the scene has been saved
  bool over = false;                    ///< the preview is to end
  std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();
};

} // namespace abbe
