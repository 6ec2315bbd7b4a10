// What the documents tell a reader to write or to run works as it stands: every scene in a fence
// that is tagged sdl, every lens in one tagged lens, and every line "./abbe render ...", "plan" or
// "list". Pictures are made small; each recipe must end well and without a warning.

#include "io/images/read_image.h"
#include "tests/catch.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

using namespace abbe;
namespace fs = std::filesystem;

namespace {

const fs::path kSource = ABBE_SOURCE_DIR;

std::vector<fs::path> documents() {
  std::vector<fs::path> found{kSource / "README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

struct Recipe {
  std::string where, text;
};

/// The text of all fences with this tag.
std::vector<Recipe> fences(const std::string& tag) {
  std::vector<Recipe> found;
  for (const fs::path& document : documents()) {
    std::ifstream file(document);
    bool open = false;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      if (!open && line == "```" + tag) {
        open = true;
        found.push_back({document.filename().string() + ":" + std::to_string(number), ""});
      } else if (open && line == "```") {
        open = false;
      } else if (open) {
        found.back().text += line + "\n";
      }
    }
  }
  return found;
}

/// The lines that run the program to render, plan or list, without their comments. What is left to
/// the reader, such as SCENE, is none.
std::vector<Recipe> commands() {
  std::vector<Recipe> found;
  const std::regex form("^    \\./abbe ((render|plan|list)\\b[^#]*).*");
  for (const fs::path& document : documents()) {
    std::ifstream file(document);
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      std::smatch match;
      if (!std::regex_match(line, match, form) || line.find("SCENE") != line.npos) continue;
      found.push_back({document.filename().string() + ":" + std::to_string(number), match[1]});
    }
  }
  return found;
}

/// A folder with the project's scenes and libraries, in which the program runs.
class Desk {
public:
  Desk() {
    std::string name = (fs::temp_directory_path() / "abbe_recipes_XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
    fs::create_directory_symlink(kSource / "scenes", path / "scenes");
    for (const char* library : {"lights.filter", "all.mtl"})
      fs::copy_file(kSource / "scenes" / library, path / library);
  }
  ~Desk() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  /// What the program says on stderr; "" where it also ends well. Two warnings are told of what
  /// the recipes mean to use: of the thesis's lamp 2a, and of glasses beyond their last wavelength.
  [[nodiscard]] std::string complaint(const std::string& arguments) const {
    const std::string command = "cd '" + path.string() + "' && '" ABBE_EXECUTABLE "' " + arguments +
                                " >/dev/null 2>error.txt";
    const int status = std::system(command.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    std::ifstream file(path / "error.txt");
    std::string said;
    for (std::string line; std::getline(file, line);)
      if (line.find("zeros after the 81 values") == line.npos &&
          line.find("is extrapolated beyond") == line.npos)
        said += line + "\n";
    if (said.empty() && code != 0) said = "exit code " + std::to_string(code);
    return said;
  }

  fs::path path;
};

/// The arguments of a command, but for a small picture of few samples without progress.
std::string small(const std::string& command) {
  if (command.rfind("render", 0) != 0) return command;
  const std::string kept = std::regex_replace(command, std::regex("--(spp|size) +[^ ]+"), "");
  return kept + " --spp 1 --size 16x16 --quiet";
}

} // namespace

TEST_CASE("every scene in the documents is read and rendered without a warning") {
  const Desk desk;
  const std::vector<Recipe> scenes = fences("sdl");
  CHECK(scenes.size() >= 3);
  for (const Recipe& scene : scenes) {
    INFO(scene.where);
    std::ofstream(desk.path / "recipe.sdl") << scene.text;
    CHECK(desk.complaint("render recipe.sdl --spp 1 --size 16x16 --quiet") == "");
  }
}

TEST_CASE("every lens in the documents takes a picture") {
  const Desk desk;
  const std::vector<Recipe> lenses = fences("lens");
  CHECK_FALSE(lenses.empty());
  for (const Recipe& lens : lenses) {
    INFO(lens.where);
    std::ofstream(desk.path / "recipe.lens") << lens.text;
    std::ofstream(desk.path / "recipe.sdl")
        << "eye 0 0 900 background E 0.5 lensFile recipe.lens filmHeight 4";
    CHECK(desk.complaint("render recipe.sdl --spp 1 --size 16x16 --quiet") == "");
  }
}

TEST_CASE("every command in the documents runs without a warning") {
  const Desk desk;
  const std::vector<Recipe> lines = commands();
  CHECK(lines.size() >= 8);
  for (const Recipe& line : lines) {
    INFO(line.where << " " << line.text);
    CHECK(desk.complaint(small(line.text)) == "");
  }
}

// A chart under its own light has a row of greys, from white to black, at its lower edge.
TEST_CASE("the chart of the README is grey where it should be") {
  const Desk desk;
  int charts = 0;
  for (const Recipe& line : commands()) {
    const std::size_t output = line.text.find("-o chart.png");
    if (output == std::string::npos) continue;
    INFO(line.where << " " << line.text);
    REQUIRE(desk.complaint(line.text + " --spp 1 --size 60x40 --quiet") == "");
    const ReflectanceImage chart = read_png(desk.path / "chart.png");
    REQUIRE(chart.width == 60);
    for (int patch = 0; patch < 6; ++patch) {
      const std::size_t pixel = 3 * static_cast<std::size_t>(35 * 60 + 5 + 10 * patch);
      const auto [least, most] =
          std::minmax({chart.rgb[pixel], chart.rgb[pixel + 1], chart.rgb[pixel + 2]});
      CHECK(most - least < 0.04f * most + 0.004f);
    }
    ++charts;
  }
  CHECK(charts == 1);
}
