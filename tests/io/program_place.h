#pragma once

#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <sys/wait.h>

#include <cstdlib>
#include <string>

namespace abbe::test {

struct Outcome {
  int exit_code = 0;
  std::string out, error;
};

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
struct Place {
  Folder folder;

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
  /// Runs the shell's command, in which $abbe is the program.
  [[nodiscard]] Outcome shell(const std::string& command) const {
    const std::string all = "cd '" + folder.path.string() + "' && abbe='" ABBE_EXECUTABLE "'; { " +
                            command + "; } >out 2>error";
    const int status = std::system(all.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes("out"), bytes("error")};
  }
  [[nodiscard]] Outcome abbe(const std::string& arguments) const {
    return shell("$abbe " + arguments);
  }
  /// Runs the program, which must succeed, and returns what it says on standard output.
  std::string run(const std::string& arguments) const {
    const Outcome outcome = abbe(arguments);
    INFO(arguments << "\n" << outcome.error);
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
  }
  void refuses(const std::string& arguments, const std::string& reason) const {
    const Outcome outcome = abbe(arguments);
    INFO(arguments << "\n" << outcome.error);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.error.find(reason) != std::string::npos);
  }
};

} // namespace abbe::test
