#include "io/program/command_line.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

using namespace abbe;
using test::content;
using test::Folder;

namespace {

SettingsOverride given(std::vector<const char*> words) {
  words.insert(words.begin(), {"abbe", "render", "scene.sdl"});
  return std::get<RenderCommand>(parse_command_line(static_cast<int>(words.size()), words.data()))
      .settings;
}

RenderSettings settings(const std::vector<const char*>& words) {
  return overridden(RenderSettings{}, given(words));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// What "abbe ARGUMENTS", run in the folder, prints. It must succeed.
std::string run(const Folder& folder, const std::string& arguments) {
  const std::string command =
      "cd '" + folder.path.string() + "' && '" ABBE_EXECUTABLE "' " + arguments + " >out 2>error";
  REQUIRE(std::system(command.c_str()) == 0);
  return content(folder.path / "out");
}

} // namespace

TEST_CASE("noise and time say when to stop, and make the number of samples a limit") {
  const RenderSettings plain = settings({});
  CHECK(plain.noise == 0.0);
  CHECK(plain.seconds == 0.0);
  CHECK_FALSE(plain.may_end_early());
  CHECK_FALSE(plain.keep_errors);
  const RenderSettings both = settings({"--noise", "0.05", "--time", "2.5", "--spp", "100"});
  CHECK(both.noise == 0.05);
  CHECK(both.seconds == 2.5);
  CHECK(both.samples_per_pixel == 100);
  CHECK(both.may_end_early());
  CHECK(settings({"--time", "2.5"}).may_end_early());
  CHECK(settings({"--errors"}).keep_errors);
  CHECK(plain.adaptive == AdaptiveSampling::automatic);
  CHECK(settings({"--adaptive", "on"}).adaptive == AdaptiveSampling::on);
  RenderSettings scene;
  scene.noise = 0.1;
  CHECK(overridden(scene, given({})).noise == 0.1);
  CHECK(overridden(scene, given({"--noise", "0"})).noise == 0.0);
}

TEST_CASE("a rendering with a noise target tells how far it went") {
  const Folder folder;
  std::ofstream(folder.path / "scene.sdl")
      << "imageSize 16 12 background E 0.5 light E 2 3 4 1 glass N-BK7 sphere";
  const std::string r = run(folder, "render scene.sdl --noise 0.9 --spp 100 -o a.exr");
  CHECK(contains(r, "1 tile, at most 100 samples a pixel"));
  CHECK(contains(r, "plan: each tile ends at an estimated relative error of 0.9"));
  CHECK(contains(r, "samples a pixel: 64 to 64, mean 64.0; estimated relative error 0."));
  CHECK_FALSE(contains(r, "above the target"));
  const std::string unreached = run(folder, "render scene.sdl --noise 1e-9 --spp 40 -o a.exr");
  CHECK(contains(unreached, "samples a pixel: 40 to 40, mean 40.0"));
  CHECK(contains(unreached, "; above the target: 1 tile\n"));
  const std::string hurried = run(folder, "render scene.sdl --time 1e-9 -o a.exr");
  CHECK(contains(hurried, "1 to 1, mean 1.0; estimated relative error unknown"));
  CHECK(contains(hurried, "wrote a.exr"));
  const std::string adaptive = run(folder, "render scene.sdl -o a.exr");
  CHECK(contains(adaptive, "1 tile, 16 samples a pixel in the mean"));
  CHECK(contains(adaptive, "samples a pixel: "));
  const std::string even = run(folder, "render scene.sdl --adaptive off -o a.exr");
  CHECK(contains(even, "1 tile, 16 samples a pixel;"));
  CHECK_FALSE(contains(even, "samples a pixel: "));
}
