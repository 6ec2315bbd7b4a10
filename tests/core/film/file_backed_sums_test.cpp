#include "core/film/file_backed_sums.h"
#include "core/film/film.h"
#include "tests/catch.h"

#include <filesystem>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace abbe;

namespace {

namespace fs = std::filesystem;

/// An empty folder, removed at the end.
struct Folder {
  fs::path path =
      fs::temp_directory_path() / ("abbe-sums-" + std::to_string(std::random_device{}()));
  Folder() { fs::create_directory(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path); }
};

} // namespace

TEST_CASE("sums begin at 0 and keep what is added, in memory and in a file") {
  const Folder folder;
  constexpr std::size_t count = 100000;
  FileBackedSums sums[] = {FileBackedSums(count), FileBackedSums(count, folder.path)};
  for (FileBackedSums& s : sums) {
    CHECK(s.size() == count);
    CHECK_FALSE(s.empty());
    CHECK(s[0] == 0);
    CHECK(s[count - 1] == 0);
    for (std::size_t i = 0; i < count; ++i)
      s[i] += static_cast<std::int64_t>(i) << 40;
    for (std::size_t i = 0; i < count; ++i)
      REQUIRE(std::as_const(s)[i] == static_cast<std::int64_t>(i) << 40);
  }
}

TEST_CASE("giving memory back loses nothing") {
  const Folder folder;
  constexpr std::size_t count = 10000;
  FileBackedSums sums[] = {FileBackedSums(count), FileBackedSums(count, folder.path)};
  for (FileBackedSums& s : sums) {
    for (std::size_t i = 0; i < count; ++i)
      s[i] = -static_cast<std::int64_t>(i);
    for (int round = 0; round < 3; ++round)
      s.touched(FileBackedSums::kResidentBytes / sizeof(std::int64_t));
    for (std::size_t i = 0; i < count; ++i)
      REQUIRE(s[i] == -static_cast<std::int64_t>(i));
  }
}

TEST_CASE("the file of sums has no name, so that nothing is left however the process ends") {
  const Folder folder;
  FileBackedSums sums(1000, folder.path);
  sums[999] = 7;
  CHECK(fs::is_empty(folder.path));
  FileBackedSums moved = std::move(sums);
  CHECK(moved[999] == 7);
  CHECK(moved.size() == 1000);
}

TEST_CASE("no sums need no file") {
  const FileBackedSums none, zero(0), in_file(0, "/nowhere");
  CHECK(none.empty());
  CHECK(zero.empty());
  CHECK(in_file.empty());
  none.touched(1);
}

TEST_CASE("a folder that cannot take the file of sums is named, with the size") {
  const auto message = [](const fs::path& folder, std::size_t count) -> std::string {
    try {
      const FileBackedSums sums(count, folder);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  const std::string advice =
      " Give the variable TMPDIR a folder on a disk with room, or take fewer "
      "bands, layers or pixels";
  CHECK(message("/nowhere/at/all", std::size_t{1} << 26) ==
        "/nowhere/at/all: there is no room for a temporary file of 0.50 GiB, for sums of pixels: "
        "No such file or directory." +
            advice);
  // 2^59 bytes are more than any file system's largest file, or disk.
  const Folder folder;
  const std::string full = message(folder.path, std::size_t{1} << 56);
  CHECK_THAT(full, Catch::Matchers::ContainsSubstring(
                       folder.path.string() +
                       ": there is no room for a temporary file of 536870912.00 GiB"));
  CHECK_THAT(full, Catch::Matchers::ContainsSubstring(advice));
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a film has the same bands in memory and in a file, splats too") {
  const Folder folder;
  const PixelWindow window{3, 4, 20, 15};
  const auto layers = beauty_layers({.quantum = 0x1p-40, .bands = 5, .splats = true});
  Film films[] = {Film(window, layers), Film(window, layers, {folder.path, 0})};
  for (Film& film : films) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(0.0f, 2.0f);
    for (std::uint32_t i = 0; i < 3; ++i)
      for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x) {
          std::vector<float> radiance(5);
          for (float& r : radiance)
            r = value(random);
          film.add({x, y, i, true}, {1.0, 1.0, 1.0}, radiance);
          film.add_splat(x, y, {1.0, 1.0, 1.0}, radiance, 0.25);
        }
    film.add_light_passes(2.0);
    film.touched(window.pixel_count());
  }
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      for (int b = 0; b < 5; ++b) {
        REQUIRE(films[0].radiance(x, y, b) > 0.0);
        REQUIRE(films[1].radiance(x, y, b) == films[0].radiance(x, y, b));
      }
}
