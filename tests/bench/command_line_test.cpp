#include "bench/command_line.h"
#include "tests/catch.h"

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
