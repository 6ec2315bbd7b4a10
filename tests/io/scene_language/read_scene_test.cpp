#include "tests/io/scene_language/read_scene_helpers.h"

#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "spectral/rgb_spectrum.h"
#include "tests/catch.h"

#include <unistd.h>

#include <fstream>

using namespace abbe;

namespace {

/// A folder of this test's own, removed with what is in it.
class Folder {
public:
  Folder() { std::filesystem::create_directories(path_ / "sub"); }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }

private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("abbe_read_scene_test." + std::to_string(::getpid()));
};

std::string light(const std::string& name, const std::string& value) {
  std::string text = "filter " + name + " { colour 81";
  for (int i = 0; i < 81; ++i)
    text += ' ' + value;
  return text + " }\n";
}

std::string error_of(const std::filesystem::path& file) {
  try {
    (void)read_scene(file, {});
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("an empty scene is Scene's defaults and the file's title") {
  const Scene scene = scene_of("! nothing\n");
  CHECK(scene.title == "test");
  CHECK(scene.shapes.empty());
  CHECK(scene.lights.empty());
  CHECK(scene.settings.max_depth == RenderSettings{}.max_depth);
  CHECK(scene.background.constant_value() == 0.0);
}

TEST_CASE("settings of scene, camera and film") {
  const Scene scene = scene_of(
      "EYE 1 2 3 lookat 4 5 6 Up 0 0 1 fieldOfView 40 imageSize 320 200\n"
      "crop 10 20 30 40 samples 8 noise 0.05 adaptive off bands 27 seed 18446744073709551615 "
      "integrator whitted\n"
      "filter tent jitter off exact on tolerance 0.5 maxFan 9\n"
      "maxRecursionDepth 5 minReflectivity 0.1 minTransparency 0.2 minThroughput 0\n"
      "unit cm shadows opaque background 0 0.25 +1 globalAmbient D65 0.5");
  CHECK(scene.camera.eye == dvec3(1, 2, 3));
  CHECK(scene.camera.look_at == dvec3(4, 5, 6));
  CHECK(scene.camera.up == dvec3(0, 0, 1));
  CHECK(scene.camera.field_of_view_deg == 40.0);
  const RenderSettings& s = scene.settings;
  CHECK(s.width == 320);
  CHECK(s.height == 200);
  CHECK(s.crop == PixelWindow{10, 20, 30, 40});
  CHECK(s.samples_per_pixel == 8);
  CHECK(s.noise == 0.05);
  CHECK(s.adaptive == AdaptiveSampling::off);
  CHECK(s.bands == 27);
  CHECK(s.seed == 18446744073709551615U);
  CHECK(s.integrator == Integrator::whitted);
  CHECK(s.filter == PixelFilter::tent);
  CHECK_FALSE(s.jitter);
  CHECK(s.exact);
  CHECK(s.tolerance_pixels == 0.5);
  CHECK(s.max_fan == 9);
  CHECK(s.max_depth == 5);
  CHECK(s.min_reflectivity == 0.1);
  CHECK(s.min_transparency == 0.2);
  CHECK(s.min_throughput == 0.0);
  CHECK(s.shadows == ShadowRule::opaque);
  CHECK(scene.mm_per_unit == 10.0);
  CHECK(scene.background == rgb_emission({0.0, 0.25, 1.0}));
  CHECK(to_xyz(scene.global_ambient).y == Approx(0.5));
}

TEST_CASE("every unit is in mm") {
  CHECK(scene_of("unit mm").mm_per_unit == 1.0);
  CHECK(scene_of("unit m").mm_per_unit == 1000.0);
  CHECK(scene_of("unit in").mm_per_unit == 25.4);
  CHECK(scene_of("unit UM").mm_per_unit == 0.001);
}

TEST_CASE("every word that a setting can have") {
  CHECK(scene_of("filter box").settings.filter == PixelFilter::box);
  CHECK(scene_of("filter gaussian").settings.filter == PixelFilter::gaussian);
  CHECK(scene_of("shadows none").settings.shadows == ShadowRule::none);
  CHECK(scene_of("shadows attenuated").settings.shadows == ShadowRule::attenuated);
  CHECK(scene_of("jitter on").settings.jitter);
  CHECK_FALSE(scene_of("exact off").settings.exact);
}

TEST_CASE("a spectrum's factor may be left out before the next keyword") {
  const Scene scene = scene_of("background D65 globalAmbient 2a 2 sphere");
  CHECK(scene.background == *find_illuminant("D65"));
  CHECK(scene.global_ambient.at(700.0) == Approx(2.0 * 0.85 * 0.45));
  CHECK(scene.shapes.size() == 1);
}

TEST_CASE("a scene without library keywords uses the two files beside it") {
  std::vector<std::string> warnings;
  const Scene scene = scene_of("UseMaterial strongorangeyellow sphere light 2a 0 9 0 1", &warnings);
  CHECK(scene.materials.at(0).name == "StrongOrangeYellow");
  CHECK(scene.lights.at(0).spectrum.at(700.0) == Approx(0.85 * 0.45));
  CHECK(warnings.size() == 1); // the zeros of filter 2a
}

TEST_CASE("a scene that names no light leaves the library closed") {
  std::vector<std::string> warnings;
  (void)scene_of("sphere light 0 9 0 1 1 1", &warnings);
  CHECK(warnings.empty());
}

TEST_CASE("named libraries replace the default ones and are found from the scene's folder") {
  const Folder folder;
  folder.write("lights.filter", light("lamp", "0.125"));
  folder.write("sub/a.filter", light("lamp", "0.25"));
  folder.write("sub/b.filter", light("other", "0.5"));
  folder.write("sub/c.mtl", "def red { diffuseAmount 0.75 }");
  const Scene scene = read_scene(
      folder.write("s.sdl", "lights sub/a.filter lights sub/b.filter materials sub/c.mtl\n"
                            "light lamp 0 0 0 1 light other 0 0 0 1 UseMaterial red cube"),
      {});
  CHECK(scene.title == "s");
  CHECK(scene.lights.at(0).spectrum.at(500.0) == 0.25);
  CHECK(scene.lights.at(1).spectrum.at(500.0) == 0.5);
  CHECK(scene.materials.at(0).diffuse.constant_value() == 0.75);
}

TEST_CASE("a library's light hides an illuminant of the same name, with one warning") {
  const Folder folder;
  folder.write("lights.filter", light("d65", "0.125"));
  std::vector<std::string> warnings;
  const auto file = folder.write("s.sdl", "light D65 0 0 0 1\nlight D65 0 0 0 1");
  const Scene scene =
      read_scene(file, [&](const std::string& message) { warnings.push_back(message); });
  CHECK(scene.lights.at(1).spectrum.at(500.0) == 0.125);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == file.string() + ":1:7: \"D65\" is the light of " +
                           (file.parent_path() / "lights.filter").string() +
                           ", which hides the built-in light of this name");
}

TEST_CASE("errors of libraries") {
  const Folder folder;
  const auto library = folder.write("lights.filter", light("lamp", "0.125"));
  const auto scene = [&](const std::string& text) { return folder.write("s.sdl", text); };
  const std::string at = scene("").string();
  CHECK(error_of(scene("lights none.filter")) ==
        at + ":1:8: there is no library \"" + (library.parent_path() / "none.filter").string() +
            "\" (libraries are found relative to the scene's folder). Check the name, or write the "
            "whole path");
  CHECK(error_of(scene("materials none.mtl")) ==
        at + ":1:11: there is no library \"" + (library.parent_path() / "none.mtl").string() +
            "\" (libraries are found relative to the scene's folder). Check the name, or write the "
            "whole path");
  CHECK(error_of(scene("light lamp 0 0 0 1 lights lights.filter")) ==
        at + ":1:27: lights stands too late (a name was looked up before it). Move it before the "
             "first use of a name");
  CHECK(error_of(scene("lights lights.filter lights lights.filter")) ==
        at + ":1:29: " + library.string() + " defines \"lamp\" again (it is already in " +
            library.string() + "). Rename or remove one of them");
  CHECK(error_of(scene("light lump 0 0 0 1")) ==
        at + ":1:7: unknown light \"lump\" (no such name in " + library.string() +
            "; no such illuminant). Did you mean lamp?");
  CHECK(error_of(library.parent_path() / "none.sdl") ==
        (library.parent_path() / "none.sdl").string() +
            ": the file cannot be read (No such file or directory). Check its name and folder");
  folder.write("lights.filter", "filter lamp }");
  CHECK(error_of(scene("background lamp")) ==
        library.string() + ":1:13: \"{\" is missing before \"}\" (an entry is filter NAME { keys "
                           "}). Add it after the name");
}
