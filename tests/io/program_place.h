#pragma once

#include "tests/io/run_program.h"

#include <string>

namespace abbe::test {

/// A glass ball on a floor under a lamp with an area, where adaptive sampling gives pixels unlike
/// numbers of samples.
inline const std::string kSoftShadows =
    "imageSize 40 24 bands 5 integrator path eye 0 1.2 5 fieldOfView 40\n"
    "defaultMaterials emissive D65 8 emissiveSides front diffuse 0 0 0\n"
    "push translate 0 3 0 rotate 90 1 0 0 scale 0.4 0.4 1 square pop\n"
    "defaultMaterials diffuse 0.7 0.7 0.7\n"
    "push rotate -90 1 0 0 scale 4 4 1 square pop\n"
    "glass N-SF11 push translate 0 0.8 0 scale 0.7 0.7 0.7 sphere pop\n";

/// A glass ball on a floor under a lamp, and the folder in which the program runs.
struct Place : Desk {
  Place() {
    write("scene.sdl", "imageSize 40 24 bands 5 integrator path eye 0 1.2 5 fieldOfView 40\n"
                       "background 0.1 0.1 0.2\n"
                       "falloff square intensity 4 light E 1 3 2 1\n"
                       "defaultMaterials diffuse 0.7 0.7 0.7\n"
                       "push rotate -90 1 0 0 scale 4 4 1 square pop\n"
                       "glass N-SF11 push translate 0 0.8 0 scale 0.7 0.7 0.7 sphere pop\n");
  }
  void write(const std::string& name, const std::string& text) const {
    put(folder.path / name, text);
  }
  [[nodiscard]] std::string bytes(const std::string& name) const {
    return content(folder.path / name);
  }
};

} // namespace abbe::test
