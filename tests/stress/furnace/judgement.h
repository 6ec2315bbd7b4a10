#pragma once

#include "core/scene/scene.h"
#include "tests/stress/furnace/random_scene.h"

#include <optional>
#include <string>

namespace abbe::stress {

/// What a scene is asked.
enum class Asked : std::uint8_t {
  furnace, ///< a lossless scene shows radiance 1 in every band, with every integrator
  energy,  ///< what a lossy scene shows and what it takes, by an independent account, are all light
  bytes    ///< threads, skips and packets change no bit
};

/// Which part, and under which settings of the renderer. It is what a failing scene is asked again
/// while it shrinks.
struct Question {
  Asked asked;
  std::string settings; ///< statements of the scene language
};

/// The questions that a scene is asked.
[[nodiscard]] std::vector<Question> questions(const RandomScene& scene, Asked asked);

/// What is wrong, with the numbers; nothing when all is right. Errors: ReadError for a scene that
/// describes nothing, such as a lens whose surfaces cross.
[[nodiscard]] std::optional<std::string> wrong(const RandomScene& scene, const Question& question);

} // namespace abbe::stress
