#include "core/film/film_row.h"
#include "io/files/checksum.h"
#include "io/states/read_state.h"
#include "io/states/write_state.h"
#include "io/text/read_error.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"
#include "tests/render_text.h"

#include <atomic>
#include <fstream>
#include <string>

using namespace abbe;
using test::content;
using test::Folder;

namespace {

/// A glass ball on a floor under a lamp, seen through a crop.
Scene glass(const std::string& settings) {
  return test::scene_from(settings +
                          " imageSize 24 16 crop 1 2 23 15 bands 5 eye 0 1.2 5 fieldOfView 40\n"
                          "background 0.1 0.1 0.2\n"
                          "falloff square intensity 4 light E 1 3 2 1\n"
                          "defaultMaterials diffuse 0.7 0.7 0.7\n"
                          "push rotate -90 1 0 0 scale 4 4 1 square pop\n"
                          "glass N-SF11 push translate 0 0.8 0 scale 0.7 0.7 0.7 sphere pop\n");
}

struct Stage {
  Scene scene;
  Plan plan = make_plan(scene, scene.settings);
  World world = World(scene.shapes, farthest_coordinate(scene));

  [[nodiscard]] SampleRange all() const { return {0, plan.settings.samples_per_pixel}; }
  [[nodiscard]] RenderState begin() const { return begin_rendering(scene, plan, BandPlace{}); }
  bool go_on(RenderState& state, const RenderControl& control = {}) const {
    return render(scene, plan, world, all(), state, control);
  }
};

const StateInfo kInfo{"1.2", 77, "a b.sdl", {{"a b.sdl", 12, 34}}, {{"--seed", "5"}}, 40, {2, 3}};

RenderState read(const std::filesystem::path& file) {
  StateReader reader(file);
  return reader.read({});
}

/// All bytes of a film.
std::vector<std::int64_t> numbers(const Film& film) {
  std::vector<std::int64_t> all;
  FilmRow row;
  for (int y = film.window().y0; y < film.window().y1; ++y) {
    get_row(film, y, row);
    all.insert(all.end(), row.counts.begin(), row.counts.end());
    all.insert(all.end(), row.covered.begin(), row.covered.end());
    for (const PixelStrata& strata : row.strata)
      all.insert(all.end(), {strata.boundary, strata.first});
    for (const LayerRow& layer : row.layers) {
      all.insert(all.end(), layer.sums.begin(), layer.sums.end());
      all.insert(all.end(), layer.first_sums.begin(), layer.first_sums.end());
    }
  }
  return all;
}

/// Renders a few samples of a small picture and keeps the state.
std::filesystem::path small_state(const Folder& folder) {
  Scene scene = glass("integrator path");
  scene.settings.samples_per_pixel = 2;
  scene.settings.crop = PixelWindow{10, 6, 13, 8};
  const Stage stage{std::move(scene)};
  RenderState state = stage.begin();
  stage.go_on(state);
  write_state(folder.path / "a.state", kInfo, state);
  return folder.path / "a.state";
}

void put(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// Why a file is refused; empty when it is not.
std::string refusal(const std::filesystem::path& file) {
  try {
    StateReader(file).check();
  } catch (const ReadError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

} // namespace

// Stopped after 1, 2, 3 ... calls of the progress, written, read and gone on from each time.
TEST_CASE("a state that goes through files ends as if it had not been interrupted") {
  struct Case {
    const char* settings;
    AdaptiveSampling adaptive;
    double noise;
    bool errors;
  };
  StateInfo whole_info = kInfo;
  whole_info.part = {};
  const Folder folder;
  for (const auto& [settings, adaptive, noise, errors] :
       {Case{"integrator whitted", AdaptiveSampling::off, 0.0, true},
        Case{"integrator path maxRecursionDepth 3", AdaptiveSampling::off, 0.0, false},
        Case{"integrator path", AdaptiveSampling::on, 0.0, false},
        Case{"integrator path sky transparent", AdaptiveSampling::off, 0.05, false}}) {
    INFO(settings);
    Scene scene = glass(settings);
    scene.settings.adaptive = adaptive;
    scene.settings.noise = noise;
    scene.settings.keep_errors = errors;
    scene.settings.samples_per_pixel = noise > 0.0 ? 96 : 40;
    const Stage stage{std::move(scene)};
    RenderState whole = stage.begin();
    REQUIRE(stage.go_on(whole));
    int stops = 0;
    RenderState state = stage.begin();
    for (bool complete = false; !complete;) {
      std::atomic<bool> stop = false;
      const auto tell = [&](const RenderProgress&) { stop = true; };
      complete = stage.go_on(state, {.progress = tell, .stop = &stop, .pause_after = 0.001});
      stops += complete ? 0 : 1;
      write_state(folder.path / "a.state", whole_info, state);
      state = read(folder.path / "a.state");
    }
    CHECK(stops > 1);
    const bool same = numbers(state.film) == numbers(whole.film); // they are long
    CHECK(same);
    CHECK(state.film.light_passes() == whole.film.light_passes());
    CHECK(state.rays.total() == whole.rays.total());
    CHECK(state.rays.splats == whole.rays.splats);
    CHECK(state.done == whole.done);
    CHECK(folder.file_count() == 1);
  }
}

TEST_CASE("a state tells what it is the state of") {
  const Folder folder;
  const StateReader reader(small_state(folder));
  const StateInfo& info = reader.info();
  CHECK(info.version == "1.2");
  CHECK(info.build == 77);
  CHECK(info.scene == "a b.sdl");
  REQUIRE(info.files.size() == 1);
  CHECK(info.files[0].path == "a b.sdl");
  CHECK(info.files[0].size == 12);
  CHECK(info.files[0].checksum == 34);
  CHECK(info.settings == KeptSettings{{"--seed", "5"}});
  CHECK(info.samples == 40);
  CHECK(info.part == RenderPart{2, 3});
  CHECK(reader.done() == 2);
  CHECK(reader.has_bands());
  CHECK(reader.window() == PixelWindow{10, 6, 13, 8});
  CHECK(reader.tiles() == 1);
}

TEST_CASE("a state of which any byte has changed is refused") {
  const Folder folder;
  const std::filesystem::path file = small_state(folder);
  const std::string bytes = content(file);
  REQUIRE(refusal(file).empty());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ (1 << i % 8));
    put(file, changed);
    const std::string reason = refusal(file);
    INFO(i);
    REQUIRE_FALSE(reason.empty());
    if (i < 8) REQUIRE(contains(reason, "this is not the state of a rendering"));
    if (i >= 8 && i < 12) REQUIRE(contains(reason, "this program reads version 1"));
  }
}

TEST_CASE("a state that is cut off anywhere, or goes on, is refused") {
  const Folder folder;
  const std::filesystem::path file = small_state(folder);
  const std::string bytes = content(file);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    put(file, bytes.substr(0, size));
    INFO(size);
    REQUIRE(contains(refusal(file), size == 0 ? "not the state" : "it is incomplete"));
  }
  put(file, bytes + "x");
  CHECK(contains(refusal(file), "something follows its last block"));
}

TEST_CASE("files that are no states are refused") {
  const Folder folder;
  put(folder.path / "a.exr", "\x76\x2f\x31\x01 and more");
  CHECK(contains(refusal(folder.path / "a.exr"), "this is not the state of a rendering"));
  CHECK(contains(refusal(folder.path), "it is a folder"));
  CHECK(contains(refusal(folder.path / "none"), "No such file"));
}

// The check value that every description of CRC-32 gives.
TEST_CASE("the checksum is that of zip and PNG") {
  CHECK(Checksum().add("123456789").value() == 0xcbf43926);
  CHECK(Checksum().add("1234").add("").add("56789").value() == 0xcbf43926);
}
