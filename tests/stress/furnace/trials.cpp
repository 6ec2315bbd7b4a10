#include "tests/stress/furnace/trials.h"

#include "io/text/read_error.h"
#include "tests/stress/furnace/meshes.h"
#include "tests/stress/furnace/shrink.h"

#include <fmt/format.h>

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>

namespace abbe::stress {
namespace {

constexpr int kMostShrunk = 5;
constexpr std::chrono::seconds kShrinkingTime(60);

const char* name_of(Asked asked) {
  switch (asked) {
  case Asked::furnace:
    return "furnace";
  case Asked::energy:
    return "energy";
  case Asked::bytes:
    break;
  }
  return "bytes";
}

/// A folder with the meshes, for scenes that fail too.
const std::string& folder() {
  static const std::string made = [] {
    const std::string path =
        (std::filesystem::temp_directory_path() / fmt::format("abbe_furnace.{}", ::getuid()))
            .string();
    std::filesystem::create_directories(path);
    write_meshes(path);
    return path;
  }();
  return made;
}

std::string report(const RandomScene& scene, const Question& question) {
  const auto answer = [&](const RandomScene& candidate) -> std::optional<std::string> {
    try {
      return wrong(candidate, question);
    } catch (const ReadError&) {
      return {};
    }
  };
  // Where much is broken, each failing scene need not be as small as can be.
  static std::atomic<int> failures = 0;
  const auto end = std::chrono::steady_clock::now() + kShrinkingTime;
  const RandomScene small =
      ++failures > kMostShrunk ? scene : shrunk(scene, [&](const RandomScene& candidate) {
        return std::chrono::steady_clock::now() < end && answer(candidate).has_value();
      });
  const std::string what = answer(small).value_or("it no longer fails");
  const std::string file =
      fmt::format("{}/{}_{}.sdl", folder(), name_of(question.asked), scene.seed);
  std::ofstream(file) << fmt::format("! seed {}, {}: {}\n", scene.seed, name_of(question.asked),
                                     what)
                      << scene_text(small, question.settings);
  return fmt::format("round {} ({}): {}; the smallest such scene is {}", scene.seed,
                     question.settings, what, file);
}

} // namespace

void try_scene(std::uint64_t seed, Asked asked, Tally& tally) {
  const std::string name = name_of(asked);
  const RandomScene scene =
      random_scene(seed, asked == Asked::energy ? Losses::lossy : Losses::lossless, folder());
  for (const Question& question : questions(scene, asked)) {
    try {
      if (wrong(scene, question)) tally.fail(name, report(scene, question));
      tally.count(name + "_renderings_judged");
    } catch (const ReadError&) {
      return tally.count(name + "_scenes_refused"); // a lens whose surfaces cross, say
    }
  }
  tally.count(name + "_scenes");
}

} // namespace abbe::stress
