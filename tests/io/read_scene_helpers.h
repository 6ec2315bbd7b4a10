#pragma once

#include "io/read_scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A scene in memory that lies beside the libraries of scenes/.
inline Scene scene_of(std::string_view text, std::vector<std::string>* warnings = nullptr) {
  return read_scene_text(text, std::filesystem::path(ABBE_SOURCE_DIR) / "scenes/test.sdl",
                         [&](const std::string& message) {
                           if (warnings) warnings->push_back(message);
                         });
}

/// The message of the error that a scene without libraries ends with; "no error" when it is read.
inline std::string scene_error(std::string_view text) {
  try {
    (void)read_scene_text(text, "s.sdl", {});
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace abbe
