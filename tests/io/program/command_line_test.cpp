#include "io/program/command_line.h"

#include "core/image/display.h"
#include "io/console/exit_codes.h"
#include "tests/catch.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

using namespace abbe;
namespace fs = std::filesystem;

namespace {

Command parse(std::vector<const char*> words) {
  words.insert(words.begin(), "abbe");
  return parse_command_line(static_cast<int>(words.size()), words.data());
}

RenderCommand parse_render(std::vector<const char*> words) {
  words.insert(words.begin(), "render");
  return std::get<RenderCommand>(parse(words));
}

/// The settings that options after a scene's name give.
RenderSettings settings(std::vector<const char*> words) {
  words.insert(words.begin(), "scene.sdl");
  return overridden(RenderSettings{}, parse_render(words).settings);
}

/// The exit code of a command line that is wrong, and says so.
int exit_code_of(const std::vector<const char*>& words) {
  std::ostringstream told;
  std::streambuf* const saved = std::cerr.rdbuf(told.rdbuf());
  const Command command = parse(words);
  std::cerr.rdbuf(saved);
  CHECK_FALSE(told.str().empty());
  return std::get<Answered>(command).exit_code;
}

const std::string kScene = "imageSize 16 12 samples 2 background E 0.5 light E 2 3 4 1\n"
                           "glass N-BK7 sphere\n";

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Outcome {
  int exit_code = 0;
  std::string out, error;
};

/// A folder that goes away with its object, in which the program runs.
class Folder {
public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "abbe_test_XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
    write("scene.sdl", kScene);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  /// All names in the folder.
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(path_))
      result.insert(entry.path().filename().string());
    return result;
  }
  /// Runs "abbe ARGUMENTS" through the shell.
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    const Folder outputs{};
    const std::string command = "cd '" + path_.string() + "' && { '" ABBE_EXECUTABLE "' " +
                                arguments + "; } >'" + (outputs / "out").string() + "' 2>'" +
                                (outputs / "error").string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(outputs / "out"),
            content(outputs / "error")};
  }

private:
  fs::path path_;
};

/// True when the process has a handler for SIGINT, as Linux tells.
bool catches_interrupt(pid_t process) {
  std::istringstream status(content(fs::path("/proc") / std::to_string(process) / "status"));
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:"))
      return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1u) != 0;
  return false;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

} // namespace

TEST_CASE("every setting of the command line replaces the scene's") {
  const RenderSettings s = settings({"--size",
                                     "320x200",
                                     "--bands",
                                     "27",
                                     "--spp",
                                     "64",
                                     "--crop",
                                     "1,2,30,40",
                                     "--depth",
                                     "7",
                                     "--cutoff",
                                     "0.25",
                                     "--shadows",
                                     "opaque",
                                     "--filter",
                                     "tent",
                                     "--exact",
                                     "--tolerance",
                                     "0.5",
                                     "--fan",
                                     "12",
                                     "--jitter",
                                     "off",
                                     "--seed",
                                     "18446744073709551615",
                                     "--threads",
                                     "3",
                                     "--skip",
                                     "off",
                                     "--tracing",
                                     "single",
                                     "--integrator",
                                     "whitted"});
  CHECK(s.width == 320);
  CHECK(s.height == 200);
  CHECK(s.bands == 27);
  CHECK(s.samples_per_pixel == 64);
  CHECK(s.crop == PixelWindow{1, 2, 30, 40});
  CHECK(s.max_depth == 7);
  CHECK(s.min_throughput == 0.25);
  CHECK(s.shadows == ShadowRule::opaque);
  CHECK(s.filter == PixelFilter::tent);
  CHECK(s.exact);
  CHECK(s.tolerance_pixels == 0.5);
  CHECK(s.max_fan == 12);
  CHECK_FALSE(s.jitter);
  CHECK(s.seed == 18446744073709551615ull);
  CHECK(s.threads == 3);
  CHECK(s.skip == Skips(false));
  CHECK(s.tracing == Tracing::single);
}

TEST_CASE("what the command line does not name stays as the scene has it") {
  RenderSettings scene;
  scene.width = 77;
  scene.seed = 5;
  scene.jitter = false;
  scene.filter = PixelFilter::box;
  scene.crop = PixelWindow{1, 2, 3, 4};
  const RenderSettings s = overridden(scene, parse_render({"a.sdl", "--bands", "9"}).settings);
  CHECK(s.bands == 9);
  CHECK(s.width == 77);
  CHECK(s.seed == 5);
  CHECK_FALSE(s.jitter);
  CHECK(s.filter == PixelFilter::box);
  CHECK(s.crop == scene.crop);
}

TEST_CASE("outputs are named one by one and have their formats") {
  const RenderCommand o =
      parse_render({"a.sdl", "-o", "a.exr", "--output", "b/c.png", "--spectral", "cube.exr",
                    "--exposure", "-1.5", "--gamut", "clip", "--exr-pixel", "float", "--tiff-depth",
                    "32", "--png-depth", "16", "-q"});
  CHECK(o.scene_path == "a.sdl");
  CHECK(o.outputs == std::vector<fs::path>{"a.exr", "b/c.png"});
  CHECK(o.spectral_output == fs::path("cube.exr"));
  const DisplaySettings display = overridden(DisplaySettings{}, o.display);
  CHECK(display.exposure_ev == -1.5);
  CHECK(display.gamut == GamutMapping::clip);
  CHECK(o.output.exr_pixel == ExrPixel::single);
  CHECK(o.output.tiff_depth == TiffDepth::float32);
  CHECK(o.output.png_bits == 16);
  CHECK(o.quiet);
  CHECK(parse_render({"-o", "x.exr", "a.sdl"}).scene_path == "a.sdl");
}

TEST_CASE("the display's settings replace the scene's, each by itself") {
  DisplaySettings scene;
  scene.space = find_color_space("ntsc").value();
  scene.gamut = GamutMapping::clip;
  scene.white_point = WhitePoint::at({0.3, 0.3});
  const auto settings = [&](std::vector<const char*> words) {
    words.insert(words.begin(), "scene.sdl");
    return overridden(scene, parse_render(words).display);
  };
  const DisplaySettings plain = settings({});
  CHECK(plain.space == scene.space);
  CHECK(plain.gamut == GamutMapping::clip);
  CHECK(plain.white_point == scene.white_point);
  CHECK_FALSE(plain.transfer.has_value());
  CHECK(encoding_of(plain).transfer.exponent == 2.2);
  CHECK(settings({"--display", "P3"}).space.name == "Display P3");
  CHECK(settings({"--gamut", "scale"}).gamut == GamutMapping::scale);
  CHECK(settings({"--transfer", "rec709"}).transfer == find_transfer("rec709"));
  CHECK(settings({"--transfer", "1.8"}).transfer == power_transfer(1.8));
  CHECK(settings({"--white-point", "0.3457,0.3585"}).white_point ==
        WhitePoint::at({0.3457, 0.3585}));
  CHECK_FALSE(settings({"--white-point", "none"}).white_point.has_value());
  const auto d50 = settings({"--white-point", "d50"}).white_point;
  REQUIRE(d50.has_value());
  CHECK(d50->cie1931_2deg.x == Approx(0.3457).margin(5.1e-5));
  CHECK(d50->cie1964_10deg.x == Approx(0.34773).margin(2e-4));
}

TEST_CASE("--exr-space names the primaries of EXR") {
  const auto space = [](const char* word) {
    return parse_render({"a.sdl", "--exr-space", word}).output.exr_space;
  };
  CHECK(parse_render({"a.sdl"}).output.exr_space == SceneLinearSpace::rec709);
  CHECK(space("rec709") == SceneLinearSpace::rec709);
  CHECK(space("acescg") == SceneLinearSpace::acescg);
  CHECK(space("aces2065-1") == SceneLinearSpace::aces2065_1);
  CHECK(space("rec2020") == SceneLinearSpace::rec2020);
}

TEST_CASE("a file after -o is the last one that it takes") {
  const auto merge = std::get<MergeCommand>(parse({"merge", "-o", "x.exr", "1.state", "2.state"}));
  CHECK(merge.outputs == std::vector<fs::path>{"x.exr"});
  CHECK(merge.parts == std::vector<fs::path>{"1.state", "2.state"});
}

TEST_CASE("plan and list are commands of their own") {
  const auto plan = std::get<PlanCommand>(parse({"plan", "a.sdl", "--bands", "3"}));
  CHECK(overridden(RenderSettings{}, plan.settings).bands == 3);
  const auto list = std::get<ListCommand>(parse({"list", "lights", "my.filter"}));
  CHECK(list.what == "lights");
  CHECK(list.library == fs::path("my.filter"));
}

TEST_CASE("a command line that cannot be understood ends with 2") {
  CHECK(exit_code_of({}) == kExitUsage);
  CHECK(exit_code_of({"paint"}) == kExitUsage);
  CHECK(exit_code_of({"render"}) == kExitUsage);
  CHECK(exit_code_of({"list"}) == kExitUsage);
  CHECK(exit_code_of({"list", "shapes", "--plot", "D65"}) == kExitUsage);
  CHECK(exit_code_of({"list", "glasses", "--plot-file", "a.png"}) == kExitUsage); // of what?
  CHECK(exit_code_of({"list", "--plot", "D65", "--plot-file", "a.exr"}) == kExitUsage);
  CHECK(exit_code_of({"plan", "a.sdl", "-o", "a.exr"}) == kExitUsage); // plan writes nothing
  const std::vector<std::vector<const char*>> wrong = {
      {"--colour"},           {"b.sdl"},
      {"--size", "12"},       {"--size", "0x3"},
      {"--size", "3x70000"},  {"--size", "3x4x5"},
      {"--size", "3x"},       {"--size", "99999999999x1"},
      {"--size", "4x4x"},     {"--spp", "0x10"},
      {"--crop", "1,2,3"},    {"--crop", "1,2,3,b"},
      {"--bands", "0"},       {"--bands", "406"},
      {"--bands", "1.5"},     {"--spp", "0"},
      {"--fan", "0"},         {"--depth", "-1"},
      {"--threads", "0"},     {"--seed", "-1"},
      {"--seed", "1e3"},      {"--seed", "18446744073709551616"},
      {"--cutoff", "nan"},    {"--cutoff", "-1"},
      {"--tolerance", "nan"}, {"--tolerance", "-0.1"},
      {"--exposure", "inf"},  {"--exposure", "nan"},
      {"--jitter", "maybe"},  {"--filter", "sinc"},
      {"--gamut", "rotate"},  {"--tiff-depth", "12"},
      {"--png-depth", "32"},  {"--integrator", "photons"},
      {"--shadows"},          {"--observer", "5"},
      {"--display", "crt"},   {"--transfer", "0"},
      {"--transfer", "log"},  {"--white-point", "D66"},
      {"--white-point", "1"}, {"--white-point", "0.3,0"},
      {"--white-point", "x"}, {"--white-point", "0.1,0.01"},
      {"--exr-space", "p3"},  {"--noise", "1.5"},
      {"--noise", "nan"},     {"--noise", "-0.1"},
      {"--time", "-1"},       {"--time", "inf"},
  };
  for (const auto& words : wrong) {
    std::vector<const char*> all{"render", "a.sdl"};
    all.insert(all.end(), words.begin(), words.end());
    INFO(words.front() << " " << words.back());
    CHECK(exit_code_of(all) == kExitUsage);
  }
}

TEST_CASE("help and version are printed and end with 0") {
  const Folder folder;
  const Outcome version = folder.run("--version");
  CHECK(version.exit_code == 0);
  CHECK(version.out.starts_with("abbe 0."));
  CHECK(contains(version.out, "(Embree "));
  const Outcome help = folder.run("--help");
  CHECK(help.exit_code == 0);
  for (const char* word : {"render", "plan", "list", "--version"})
    CHECK(contains(help.out, word));
  const Outcome render_help = folder.run("render --help");
  CHECK(render_help.exit_code == 0);
  for (const char* word :
       {"--spp", "--display", "--transfer", "--white-point", "--gamut", "--exr-space", "--observer",
        "display-p3", "--spectral", "--exact", "--threads", "SCENE"})
    CHECK(contains(render_help.out, word));
  CHECK(help.error.empty());
}

TEST_CASE("render writes NAME.exr and NAME.tiff where it runs, and tells what it did") {
  const Folder folder;
  const Outcome r = folder.run("render scene.sdl");
  CHECK(r.exit_code == 0);
  CHECK(folder.names() == std::set<std::string>{"scene.sdl", "scene.exr", "scene.tiff"});
  CHECK(contains(r.out, "plan: 1 shape, 1 light, 1 medium (1 dispersive)"));
  CHECK(contains(r.out, "plan: N-BK7: n_d 1.51680, V_d 64.17"));
  CHECK(contains(r.out, "rays: 384 camera")); // 16 x 12 pixels with 2 samples
  CHECK(contains(r.out, "refused samples: 0 not finite, 0 negative, 0 overflow"));
  CHECK(contains(r.out, "peak memory: "));
  CHECK(contains(r.out, "wrote scene.exr"));
  CHECK(contains(r.error, "100 %")); // in a log, plain lines
  CHECK(r.error.find_first_of("\r\x1b") == std::string::npos);
}

TEST_CASE("two runs give the same bytes in every output, and other threads do too") {
  const Folder folder;
  const std::string outputs = " -o 1.exr -o 1.tiff -o 1.png --spectral 1s.exr";
  REQUIRE(folder.run("render scene.sdl" + outputs).exit_code == 0);
  std::string others = outputs;
  std::replace(others.begin(), others.end(), '1', '2');
  REQUIRE(folder.run("render scene.sdl --threads 5" + others).exit_code == 0);
  for (const std::string name : {"1.exr", "1.tiff", "1.png", "1s.exr"}) {
    INFO(name);
    std::string other = name;
    other[0] = '2';
    CHECK(content(folder / name).size() > 100);
    CHECK((content(folder / name) == content(folder / other))); // the bytes are not to be shown
  }
  REQUIRE(folder.run("render scene.sdl --seed 1" + others).exit_code == 0);
  CHECK((content(folder / "1.exr") != content(folder / "2.exr")));
}

TEST_CASE("--quiet prints nothing") {
  const Folder folder;
  const Outcome r = folder.run("render scene.sdl --quiet -o a.png");
  CHECK(r.exit_code == 0);
  CHECK(r.out.empty());
  CHECK(r.error.empty());
  CHECK(fs::exists(folder / "a.png"));
}

TEST_CASE("a typo in the scene is told with its place, and nothing is written") {
  const Folder folder;
  folder.write("typo.sdl", "imageSize 16 12\nglass N-BK7\n  sphrere\n");
  const Outcome r = folder.run("render typo.sdl");
  CHECK(r.exit_code == 2);
  CHECK(r.error.starts_with("typo.sdl:3:3: unknown keyword \"sphrere\""));
  CHECK(r.out.empty());
  CHECK(folder.names() == std::set<std::string>{"scene.sdl", "typo.sdl"});
}

TEST_CASE("what cannot be written or rendered is told before the work, and nothing is written") {
  const Folder folder;
  fs::create_directory(folder / "folder.exr");
  const std::set<std::string> before = folder.names();
  const auto refuses = [&](const std::string& options, const std::string& message) {
    const Outcome r = folder.run("render scene.sdl " + options);
    INFO(options << ": " << r.error);
    CHECK(r.exit_code == 2);
    CHECK(contains(r.error, message));
    CHECK(r.out.find("rays") == std::string::npos);
    CHECK(folder.names() == before);
  };
  refuses("--colour", "--colour");
  refuses("--size 12", "\"12\" is not a size such as 640x480");
  refuses("--crop 0,0,17,12", "the crop 0,0,17,12 is not a part of the 16 x 12 image");
  refuses("-o a.exr -o b.jpg", "b.jpg: no picture can be written under this name");
  refuses("-o a", "The name should end in .exr, .tif, .tiff or .png");
  refuses("-o missing/a.exr", "there is no folder missing");
  refuses("-o folder.exr", "this is a folder");
  refuses("--spectral a.tiff", "all bands go into an EXR");
  refuses("-o a.exr --spectral ./a.exr", "two outputs would have this name");
  const Outcome missing = folder.run("render other.sdl");
  CHECK(missing.exit_code == 2);
  CHECK(contains(missing.error, "other.sdl: the file cannot be read"));
  if (::geteuid() != 0) { // to root everything can be written
    fs::create_directory(folder / "locked");
    fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    CHECK(folder.run("render scene.sdl -o locked/a.exr").exit_code == 2);
  }
}

TEST_CASE("a failed run leaves the old picture") {
  const Folder folder;
  folder.write("scene.exr", "old");
  CHECK(folder.run("render scene.sdl --crop 5,5,5,5").exit_code == 2);
  CHECK(content(folder / "scene.exr") == "old");
}

TEST_CASE("plan tells what a scene needs and writes nothing") {
  const Folder folder;
  const Outcome r = folder.run("plan scene.sdl --size 1024x1024");
  CHECK(r.exit_code == 0);
  CHECK(contains(r.out, "plan: 1 shape, 1 light, 1 medium (1 dispersive)"));
  CHECK(contains(r.out, "tiles show the background alone"));
  CHECK(folder.names() == std::set<std::string>{"scene.sdl"});
  CHECK(folder.run("plan scene.sdl --crop 9,9,1,1").exit_code == 2);
}

TEST_CASE("list names glasses, lights and materials") {
  const Folder folder;
  const Outcome glasses = folder.run("list glasses");
  CHECK(glasses.exit_code == 0);
  CHECK(contains(glasses.out, "N-BK7                     1.51680"));
  CHECK(contains(folder.run("list lights").out, "D65"));
  CHECK(contains(folder.run("list materials").out, "no material library here"));

  const std::string scenes = ABBE_SOURCE_DIR "/scenes/";
  const Outcome lights = folder.run("list lights '" + scenes + "lights.filter'");
  CHECK(lights.exit_code == 0);
  CHECK(contains(lights.out, "\n2a "));
  CHECK(contains(lights.out, "D65"));
  CHECK(contains(folder.run("list materials '" + scenes + "all.mtl'").out, "StrongOrangeYellow"));
  CHECK(folder.run("list lights missing.filter").exit_code == 2);
  CHECK(contains(folder.run("list metals").out, "\nAu "));
}

TEST_CASE("list --plot draws one curve, in the terminal or as a PNG") {
  const Folder folder;
  const Outcome text = folder.run("list --plot N-BK7");
  CHECK(text.exit_code == 0);
  CHECK(text.out.starts_with("N-BK7: refractive index\n"));
  const Outcome file = folder.run("list lights --plot sodium --plot-file a.png");
  CHECK(file.exit_code == 0);
  CHECK(content(folder / "a.png").substr(1, 3) == "PNG");
  const Outcome wrong = folder.run("list --plot nothing");
  CHECK(wrong.exit_code == 2);
  CHECK(contains(wrong.error, "there is nothing called \"nothing\" to plot"));
  const Outcome library =
      folder.run("list materials '" ABBE_SOURCE_DIR "/scenes/all.mtl' --plot strongorangeyellow");
  CHECK(library.out.starts_with("StrongOrangeYellow: reflectance\n"));
  folder.write("lights.filter", content(ABBE_SOURCE_DIR "/scenes/lights.filter"));
  CHECK(folder.run("list lights --plot 2a").out.starts_with("2a: light"));
}

TEST_CASE("a reader that goes away early does no harm") {
  const Folder folder;
  const Outcome r = folder.run("list glasses | head -1");
  CHECK(r.exit_code == 0);
  CHECK(r.out.starts_with("glass "));
  CHECK(std::count(r.out.begin(), r.out.end(), '\n') == 1);
  CHECK(r.error.empty());
}

TEST_CASE("Ctrl-C writes what is done under a name of its own and ends with 130") {
  const Folder folder;
  folder.write("scene.exr", "old");
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) { // far more samples than can be done
    if (::chdir((folder / "").c_str()) != 0 || !std::freopen("out", "w", stdout) ||
        !std::freopen("error", "w", stderr))
      std::_Exit(99);
    ::execl(ABBE_EXECUTABLE, "abbe", "render", "scene.sdl", "--spp", "1000000", nullptr);
    std::_Exit(98);
  }
  for (int i = 0; i < 500 && !catches_interrupt(child); ++i)
    ::usleep(10000);
  const bool ready = catches_interrupt(child);
  ::usleep(200000); // time for the first tiles
  ::kill(child, ready ? SIGINT : SIGKILL);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 130);
  CHECK(contains(content(folder / "error"), "interrupted: what was done is in scene.partial.exr"));
  CHECK(content(folder / "scene.partial.exr").starts_with("\x76\x2f\x31\x01")); // an EXR
  CHECK((content(folder / "scene.exr") == "old"));
  CHECK(folder.names() ==
        std::set<std::string>{"error", "out", "scene.exr", "scene.partial.exr", "scene.sdl"});
}
