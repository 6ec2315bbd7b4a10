#include "bench/program/command_line.h"
#include "tests/catch.h"

#include <algorithm>

using namespace abbe;
using namespace abbe::bench;

namespace {

bench::Options parse(std::vector<const char*> words) {
  words.insert(words.begin(), "abbe bench");
  return bench::parse_command_line(static_cast<int>(words.size()), words.data());
}

} // namespace

TEST_CASE("each measurement has its scenes and its size") {
  const auto rays = parse({"rays"});
  CHECK(rays.measurement == Measurement::rays);
  CHECK(rays.scenes.size() == 4);
  CHECK(rays.render.width == 256);
  CHECK_FALSE(rays.render.bands.has_value());
  CHECK(parse({"bands"}).scenes.size() == 3);
  const auto error = parse({"error", "lens"});
  CHECK(error.measurement == Measurement::error);
  CHECK(error.render.width == 128);
  CHECK(error.error.budgets == std::vector{1, 4, 16, 64});
}

TEST_CASE("all scenes are those that show something") {
  const auto scenes = parse({"rays", "--all"}).scenes;
  const auto has = [&](const char* name) {
    return std::find(scenes.begin(), scenes.end(), name) != scenes.end();
  };
  CHECK(has("lens"));
  CHECK(has("newton"));
  CHECK_FALSE(has("brilliant")); // only for gem.sdl to include
  CHECK(std::is_sorted(scenes.begin(), scenes.end()));
  CHECK(parse({"rays", "--all", "lens"}).exit_code == 2);
}

TEST_CASE("the axes and limits of scaling") {
  const auto usual = parse({"scaling"});
  CHECK(usual.measurement == Measurement::scaling);
  CHECK(usual.scaling.axes.size() == 5);
  CHECK(usual.scaling.most_triangles == 1'000'000);
  CHECK(usual.scenes == std::vector<std::filesystem::path>{"lens"});
  const auto some = parse({"scaling", "lenses", "threads", "--most-lenses", "100", "--scene",
                           "sphere", "--repeats", "2"});
  CHECK(some.scaling.axes == std::vector{Axis::lenses, Axis::threads});
  CHECK(some.scaling.most_lenses == 100);
  CHECK(some.scaling.render.repeats == 2);
  CHECK(some.scenes == std::vector<std::filesystem::path>{"sphere"});
  CHECK(parse({"scaling", "weight"}).exit_code == 2);
}

TEST_CASE("two reports that exist are compared") {
  const char* file = ABBE_SOURCE_DIR "/README.md";
  const auto o = parse({"compare", file, file, "--margin", "0.1"});
  CHECK(o.measurement == Measurement::compare);
  CHECK(o.reports.size() == 2);
  CHECK(o.margin == 0.1);
  CHECK(parse({"compare", file}).exit_code == 2);
  CHECK(parse({"compare", file, "no such file"}).exit_code == 2);
  CHECK(parse({"compare", file, file, "--margin", "-1"}).exit_code == 2);
}

TEST_CASE("where results are written to") {
  const auto o = parse({"plan", "--html", "page.html", "--plots", ABBE_SOURCE_DIR});
  CHECK(o.measurement == Measurement::plan);
  CHECK(o.html == std::filesystem::path("page.html"));
  CHECK(o.plots == std::filesystem::path(ABBE_SOURCE_DIR));
  CHECK(parse({"plan", "--plots", "no such folder"}).exit_code == 2);
}

TEST_CASE("quick runs are small whatever else is asked for") {
  const auto o = parse({"error", "lens", "--quick", "--size", "512x16"});
  CHECK(o.render.repeats == 1);
  CHECK(o.render.width == 32);
  CHECK(o.render.height == 16);
  CHECK(o.error.render.repeats == 1);
  CHECK(o.error.budgets == std::vector{1, 4});
  CHECK(o.error.reference_samples == 8);
  const auto scaling = parse({"scaling", "--quick"}).scaling;
  CHECK(scaling.most_triangles == 1000);
  CHECK(scaling.most_lenses == 100);
  CHECK(scaling.render.width == 32);
}

TEST_CASE("options of a measurement") {
  const auto o =
      parse({"error", "lens", "--vary", "default", "fan=8,tolerance=1", "--budgets", "8", "2",
             "--size", "512x384", "--crop", "1,2,30,40", "--repeats", "3", "--json", "out.json"});
  CHECK(o.error.variations == std::vector<std::string>{"default", "fan=8,tolerance=1"});
  CHECK(o.error.budgets == std::vector{2, 8});
  CHECK(o.render.width == 512);
  CHECK(o.render.height == 384);
  CHECK(o.render.crop == PixelWindow{1, 2, 30, 40});
  CHECK(o.render.repeats == 3);
  CHECK(o.json == std::filesystem::path("out.json"));
}

TEST_CASE("mistakes of usage are answered with exit code 2, help with 0") {
  CHECK(parse({"error"}).exit_code == 2);
  CHECK(parse({}).exit_code == 2);
  CHECK(parse({"rays", "--size", "512"}).exit_code == 2);
  CHECK(parse({"rays", "--bands", "0"}).exit_code == 2);
  CHECK(parse({"--help"}).exit_code == 0);
  CHECK(parse({"--help"}).measurement == Measurement::done);
}
