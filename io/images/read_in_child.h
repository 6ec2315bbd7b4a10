#pragma once

#include "io/images/read_exr.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace abbe {

/// What the reading of one image may take.
struct ReadingLimits {
  std::uint64_t memory = std::uint64_t{6} << 30; ///< in bytes, beyond what the program has
  int processor_seconds = 60;
  int seconds = 600; ///< where it waits for a slow disk
};

/// What a child sends.
struct ChildMessage {
  std::string text;
  std::vector<float> values;
};

/// Calls `read` in a child process and returns what it returns, so that nothing that a file makes a
/// library do can end or stop the program. Throws std::runtime_error with the text of the exception
/// that `read` threw, or with how the child ended.
[[nodiscard]] ChildMessage message_of_child(const std::function<ChildMessage()>& read,
                                            const ReadingLimits& limits = {});

/// The same for an image.
[[nodiscard]] ExrImage read_in_child(const std::function<ExrImage()>& read,
                                     const ReadingLimits& limits = {});

} // namespace abbe
