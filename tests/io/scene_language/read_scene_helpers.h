#pragma once

#include "io/scene_language/read_scene.h"

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
/// The scene is called s.sdl and lies in a folder that does not exist, so that none is found.
inline std::string scene_error(std::string_view text) {
  constexpr std::string_view kFolder = "no_such_folder/";
  try {
    (void)read_scene_text(text, std::string(kFolder) + "s.sdl", {});
  } catch (const ReadError& error) {
    return std::string(error.what()).substr(kFolder.size());
  }
  return "no error";
}

} // namespace abbe
