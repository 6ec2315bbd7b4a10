#include "tests/catch.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct SourceFile {
  std::vector<std::string> includes; ///< what stands between the quotes or angle brackets
  int lines = 0;
};

/// By path relative to the project, with forward slashes.
using Tree = std::map<std::string, SourceFile>;

/// Files whose path begins with `where` may include what begins with `what`.
struct Permission {
  std::string_view where, what;
};

// What a file may include besides the standard library, which all may. Each third party stands
// behind one file.
constexpr Permission kPermissions[] = {
    {"spectral/", "spectral/"},
    {"geometry/", "geometry/"},
    {"geometry/", "glm/"},
    {"geometry/world/world", "embree"},
    {"geometry/meshes/mesh_crossings.cpp", "immintrin.h"}, // eight boxes, four triangles at once
    {"core/", "core/"},
    {"core/", "geometry/"},
    {"core/", "spectral/"},
    {"core/", "glm/"},
    {"core/", "fmt/"},
    {"geometry/meshes/mesh_hierarchy.cpp", "tbb/"},
    {"core/denoise/denoiser.cpp", "tbb/"},
    {"core/integrators/light_pass.cpp", "tbb/"},
    {"core/render/render.cpp", "tbb/"},
    {"core/render/worker_limit.cpp", "tbb/"},
    {"core/adaptive/sample_allocation.cpp", "tbb/"},
    {"core/adaptive/sample_shares.cpp", "tbb/"},
    {"core/film/file_backed_sums.cpp", "fcntl.h"},
    {"core/film/file_backed_sums.cpp", "sys/mman.h"},
    {"core/film/file_backed_sums.cpp", "unistd.h"},
    {"core/bundles/denormals.h", "immintrin.h"},    // flushes denormal numbers
    {"geometry/rays/float_traps.h", "immintrin.h"}, // traps of floating-point exceptions
    {"io/", "io/"},
    {"io/", "core/"},
    {"io/", "geometry/"},
    {"io/", "spectral/"},
    {"io/", "glm/"},
    {"io/", "fmt/"},
    {"io/program/command_line.cpp", "CLI/"},
    {"io/commands/", "CLI/"}, // each command has options of its own
    {"io/program/mpi_main.cpp", "mpi.h"},
    {"io/program/mpi_main.cpp", "fcntl.h"},
    {"io/program/mpi_main.cpp", "unistd.h"},
    {"io/text/read_json.cpp", "nlohmann/"},
    {"io/images/read_exr.cpp", "OpenEXR/"},
    {"io/images/read_exr.cpp", "Imath/"},
    {"io/images/read_png.cpp", "png.h"},
    {"io/images/read_in_child.cpp", "fcntl.h"},
    {"io/images/read_in_child.cpp", "sys/prctl.h"},
    {"io/images/read_in_child.cpp", "sys/resource.h"},
    {"io/images/read_in_child.cpp", "sys/wait.h"},
    {"io/images/read_in_child.cpp", "unistd.h"},
    {"io/images/write_exr.cpp", "OpenEXR/"},
    {"io/images/write_exr.cpp", "Imath/"}, // a part of OpenEXR
    {"io/images/tiff_file.h", "tiffio.h"},
    {"io/images/write_png.cpp", "png.h"},
    {"io/images/icc_profile.cpp", "lcms2.h"},
    {"io/images/ocio_look.cpp", "OpenColorIO/"},
    {"io/files/atomic_file.cpp", "fcntl.h"},
    {"io/files/atomic_file.cpp", "sys/file.h"},
    {"io/files/atomic_file.cpp", "sys/stat.h"},
    {"io/files/atomic_file.cpp", "unistd.h"},
    {"io/files/available_memory.cpp", "sys/resource.h"},
    {"io/files/temporary_names.cpp", "unistd.h"},
    {"io/files/checksum.cpp", "zlib.h"},
    {"io/files/deflate.cpp", "zlib.h"},
    {"io/files/file_watch.cpp", "poll.h"},
    {"io/files/file_watch.cpp", "sys/inotify.h"},
    {"io/files/file_watch.cpp", "unistd.h"},
    {"io/outputs/display_server.cpp", "netdb.h"},
    {"io/outputs/display_server.cpp", "sys/socket.h"},
    {"io/outputs/display_server.cpp", "unistd.h"},
    {"io/preview/preview_server.cpp", "httplib.h"},
    {"io/files/gunzip.cpp", "zlib.h"},
    {"io/files/regular_file.cpp", "fcntl.h"},
    {"io/files/regular_file.cpp", "sys/stat.h"},
    {"io/files/regular_file.cpp", "unistd.h"},
    {"io/console/terminal.cpp", "fcntl.h"},
    {"io/console/terminal.cpp", "unistd.h"},
    {"io/console/progress.cpp", "sys/resource.h"},
    {"io/console/progress.cpp", "unistd.h"},
    {"tests/", ""},
    {"bench/", ""},
};

// Exceptions from these: scenes are built from plain values, so that a reader of any format can.
constexpr Permission kProhibitions[] = {
    {"io/building/", "io/text/token"},
    {"io/building/", "io/text/read_arguments"},
    {"io/building/", "io/libraries/"},
    {"io/building/", "io/meshes/"},
};

bool is_standard(std::string_view include) {
  return include.find_first_of("./") == include.npos;
}

bool may_include(std::string_view file, std::string_view include) {
  const auto fits = [&](const Permission& p) {
    return file.starts_with(p.where) && include.starts_with(p.what);
  };
  return is_standard(include) ||
         (std::ranges::any_of(kPermissions, fits) && std::ranges::none_of(kProhibitions, fits));
}

/// The rooms of a folder, each of which may include those named before it, but none after it.
constexpr std::string_view kFloors[] = {
    "geometry/rays/",  "geometry/solids/", "geometry/meshes/", "geometry/booleans/",
    "geometry/world/", "core/scene/",      "core/bands/",      "core/optics/",
    "core/bsdfs/",     "core/emitters/",   "core/drops/",      "core/plan/",
    "core/sampling/",  "core/cameras/",    "core/film/",       "core/adaptive/",
    "core/bundles/",   "core/scattering/", "core/lights/",     "core/integrators/",
    "core/image/",     "core/denoise/",    "core/planning/",   "core/render/",
    "io/files/",       "io/text/",         "io/images/",       "io/libraries/",
    "io/settings/",    "io/meshes/",       "io/building/",     "io/scene_language/",
    "io/pbrt/",        "io/gltf/",         "io/converting/",   "io/scene_files/",
    "io/selftest/",    "io/states/",       "io/console/",      "io/plots/",
    "io/readings/",    "io/pages/",        "io/outputs/",      "io/preview/",
    "io/manual/",      "io/commands/",     "io/program/",      "bench/measurements/",
    "bench/plots/",    "bench/reports/",   "bench/program/"};

/// The number of the room in which a file lies; none for a file outside the rooms.
std::optional<std::size_t> floor_of(std::string_view path) {
  for (std::size_t i = 0; i < std::size(kFloors); ++i)
    if (path.starts_with(kFloors[i])) return i;
  return std::nullopt;
}

/// True where a file includes a later room of its own folder. kPermissions tells which folders may
/// include which.
bool points_upwards(std::string_view file, std::string_view include) {
  if (file.substr(0, file.find('/')) != include.substr(0, include.find('/'))) return false;
  const auto from = floor_of(file), to = floor_of(include);
  return from && to && *to > *from;
}

std::vector<std::string> forbidden_includes(const Tree& tree) {
  std::vector<std::string> result;
  for (const auto& [path, file] : tree)
    for (const std::string& include : file.includes)
      if (!may_include(path, include) || points_upwards(path, include))
        result.push_back(path + " includes " + include);
  return result;
}

/// The files that lie in a folder with rooms, but in none of them.
std::vector<std::string> without_a_room(const Tree& tree) {
  std::vector<std::string> result;
  for (const auto& [path, file] : tree)
    if ((path.starts_with("geometry/") || path.starts_with("core/") || path.starts_with("io/") ||
         path.starts_with("bench/")) &&
        !floor_of(path))
      result.push_back(path);
  return result;
}

/// Adds "a -> b -> a" to `cycles` for each include, direct or not, of the last file of `chain`
/// that leads back into the chain.
void find_cycles(const Tree& tree, std::vector<std::string>& chain, std::set<std::string>& done,
                 std::vector<std::string>& cycles) {
  const std::string path = chain.back();
  for (const std::string& include : tree.at(path).includes) {
    if (const auto met = std::find(chain.begin(), chain.end(), include); met != chain.end()) {
      std::string cycle;
      for (auto step = met; step != chain.end(); ++step)
        cycle += *step + " -> ";
      cycles.push_back(cycle + include);
    } else if (tree.contains(include) && !done.contains(include)) {
      chain.push_back(include);
      find_cycles(tree, chain, done, cycles);
      chain.pop_back();
    }
  }
  done.insert(path);
}

std::vector<std::string> include_cycles(const Tree& tree) {
  std::vector<std::string> cycles;
  std::set<std::string> done;
  for (const auto& [path, file] : tree) {
    std::vector<std::string> chain{path};
    if (!done.contains(path)) find_cycles(tree, chain, done, cycles);
  }
  return cycles;
}

std::vector<std::string> longer_than(const Tree& tree, int lines) {
  std::vector<std::string> result;
  for (const auto& [path, file] : tree)
    if (file.lines > lines)
      result.push_back(path + " has " + std::to_string(file.lines) + " lines");
  return result;
}

SourceFile parse(std::istream& text) {
  SourceFile file;
  for (std::string line; std::getline(text, line); ++file.lines) {
    std::size_t at = line.find_first_not_of(" \t");
    if (at == line.npos || line[at] != '#') continue;
    at = line.find_first_not_of(" \t", at + 1);
    if (at == line.npos || line.compare(at, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("\"<", at);
    const std::size_t close = line.find_first_of("\">", open + 1);
    if (open != line.npos && close != line.npos)
      file.includes.push_back(line.substr(open + 1, close - open - 1));
  }
  return file;
}

Tree project() {
  Tree tree;
  const fs::path root = ABBE_SOURCE_DIR;
  for (const char* folder : {"spectral", "geometry", "core", "io", "tests", "bench"}) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream text(entry.path());
      tree[entry.path().lexically_relative(root).generic_string()] = parse(text);
    }
  }
  return tree;
}

const std::vector<std::string> kNothing;

} // namespace

TEST_CASE("the project's files are found and read") {
  const Tree tree = project();
  CHECK(tree.size() > 100);
  REQUIRE(tree.contains("core/integrators/whitted.cpp"));
  const SourceFile& file = tree.at("core/integrators/whitted.cpp");
  CHECK(file.lines > 50);
  CHECK(file.includes.front() == "core/integrators/whitted.h");
  CHECK(std::count(file.includes.begin(), file.includes.end(), "algorithm") == 1);
}

TEST_CASE("includes point downwards, and each third party stands behind one file") {
  CHECK(forbidden_includes(project()) == kNothing);
}

TEST_CASE("every file of a folder with rooms lies in one") {
  CHECK(without_a_room(project()) == kNothing);
}

TEST_CASE("no header includes itself, however far around") {
  CHECK(include_cycles(project()) == kNothing);
}

TEST_CASE("no source file is longer than 500 lines") {
  CHECK(longer_than(project(), 500) == kNothing);
}

TEST_CASE("each rule finds what breaks it") {
  const auto broken = [](const std::string& path, const std::string& include) {
    return !forbidden_includes({{path, {{include}, 1}}}).empty();
  };
  CHECK_FALSE(broken("core/bundles/fan.cpp", "vector"));
  CHECK_FALSE(broken("core/bundles/fan.cpp", "geometry/world/world.h"));
  CHECK(broken("spectral/curve.h", "geometry/rays/ray.h"));
  CHECK(broken("spectral/curve.h", "glm/vec3.hpp"));
  CHECK(broken("geometry/rays/ray.h", "spectral/curve.h"));
  CHECK(broken("geometry/solids/sphere.cpp", "embree3/rtcore.h"));
  CHECK(broken("geometry/solids/sphere.cpp", "core/plan/plan.h"));
  CHECK(broken("core/plan/plan.cpp", "io/text/token.h"));
  CHECK(broken("core/plan/plan.cpp", "tbb/parallel_for.h"));
  CHECK(broken("core/plan/plan.cpp", "embree3/rtcore.h"));
  CHECK(broken("io/program/main.cpp", "CLI/CLI.hpp"));
  CHECK(broken("io/program/main.cpp", "mpi.h"));
  CHECK(broken("io/images/write_tiff.cpp", "OpenEXR/ImfHeader.h"));
  CHECK(broken("io/program/main.cpp", "tests/catch.h"));

  CHECK_FALSE(broken("core/film/film.h", "core/scene/pixel_window.h"));
  CHECK(broken("core/scene/scene.h", "core/film/film.h"));
  CHECK(broken("geometry/rays/ray.h", "geometry/world/world.h"));
  CHECK(broken("bench/plots/plot.h", "bench/reports/write_html.h"));
  CHECK_FALSE(broken("bench/plots/plot.h", "core/film/film.h")); // another folder's room
  CHECK(broken("core/lights/lights.cpp", "core/integrators/path.h"));
  CHECK(broken("io/images/write_exr.cpp", "io/program/command_line.h"));
  CHECK(broken("io/building/scene_builder.h", "io/scene_language/read_scene.h"));
  CHECK(broken("io/building/scene_builder.h", "io/text/token.h")); // it takes plain values
  CHECK_FALSE(broken("io/building/scene_builder.h", "io/text/read_error.h"));
  CHECK(without_a_room({{"core/fan.h", {{}, 1}}, {"core/bundles/fan.h", {{}, 1}}}) ==
        std::vector<std::string>{"core/fan.h"});

  const Tree ring{{"a.h", {{"b.h"}, 1}}, {"b.h", {{"c.h", "vector"}, 1}}, {"c.h", {{"b.h"}, 1}}};
  CHECK(include_cycles(ring) == std::vector<std::string>{"b.h -> c.h -> b.h"});
  CHECK(include_cycles({{"a.h", {{"a.h"}, 1}}}) == std::vector<std::string>{"a.h -> a.h"});

  CHECK(longer_than({{"a.h", {{}, 501}}, {"b.h", {{}, 500}}}, 500) ==
        std::vector<std::string>{"a.h has 501 lines"});
}
