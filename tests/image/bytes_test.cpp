#include "core/planning/make_plan.h"
#include "tests/image/picture.h"

#include "tests/io/temporary_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <variant>

using namespace abbe;
using test::Picture;
using test::picture;

// The image depends on scene, settings and seed alone. Pixels are compared as bits, in all bands.

namespace {

Scene small(const std::string& name) {
  Scene scene = test::project_scene(name, 40);
  scene.settings.samples_per_pixel = 4;
  return scene;
}

const auto kScenes = {"sphere", "cube", "prism_view", "lens"};

} // namespace

TEST_CASE("1, 2 and 7 threads make the same bytes") {
  for (const char* name : kScenes) {
    Scene scene = small(name);
    scene.settings.threads = 1;
    const Picture one = picture(scene);
    for (const int threads : {2, 7}) {
      INFO(name << ", " << threads << " threads");
      scene.settings.threads = threads;
      CHECK(picture(scene) == one);
    }
  }
}

TEST_CASE("packets and single rays make the same bytes") {
  for (const char* name : kScenes) {
    INFO(name);
    Scene scene = small(name);
    scene.settings.tracing = Tracing::packets;
    const Picture packets = picture(scene);
    scene.settings.tracing = Tracing::single;
    CHECK(picture(scene) == packets);
  }
}

TEST_CASE("what the plan skips changes no byte") {
  for (const int bands : {81, 27}) {
    for (const char* name : kScenes) {
      INFO(name << ", " << bands << " bands");
      Scene scene = small(name);
      scene.settings.bands = bands;
      scene.settings.skip = true;
      const Picture skipped = picture(scene);
      scene.settings.skip = false;
      CHECK(picture(scene) == skipped);
    }
    // Filter 2a is dark below 410 and above 700 nm, half of the image is empty.
    Scene scene = test::scene_from("lights " ABBE_SOURCE_DIR "/scenes/lights.filter\n"
                                   "imageSize 48 48 samples 4 eye 0 0 9 fieldOfView 40\n"
                                   "light 2a 3 4 5 1 glass SF11 push translate 1 0 0 sphere pop\n"
                                   "defaultMaterials diffuse 0.7 0.5 0.2\n"
                                   "push translate 1 0 -2 square pop");
    scene.settings.bands = bands;
    scene.settings.skip = true;
    CHECK(make_plan(scene, scene.settings).notes.size() >= 4); // bands and tiles are skipped
    const Picture skipped = picture(scene);
    scene.settings.skip = false;
    CHECK(picture(scene) == skipped);
  }
}

TEST_CASE("no single thing that the plan skips changes a byte") {
  // Filter 2a is dark at both ends, and glass of one index is among what is seen.
  Scene scene =
      test::scene_from("lights " ABBE_SOURCE_DIR "/scenes/lights.filter\n"
                       "imageSize 48 48 samples 4 eye 0 0 9 fieldOfView 40\n"
                       "light 2a 3 4 5 1 glass SF11 push translate 1 0 0 sphere pop\n"
                       "diffuse 0 0 0 transparency 1 reflectivity 1 speedOfLight 1.4 vnum 0\n"
                       "push translate 1 2 0 sphere pop\n"
                       "defaultMaterials diffuse 0.7 0.7 0.7\n"
                       "push translate 1 0 -2 square pop");
  const Picture all = picture(scene);
  for (bool Skips::* const skip : {&Skips::empty_tiles, &Skips::dead_bands, &Skips::constant_curves,
                                   &Skips::constant_indices}) {
    scene.settings.skip = Skips();
    scene.settings.skip.*skip = false;
    CHECK(picture(scene) == all);
    scene.settings.skip = Skips(false);
    scene.settings.skip.*skip = true;
    CHECK(picture(scene) == all);
  }
}

// Bundles of camera rays carry the dead bands before the first live one, where n is another.
TEST_CASE("inside dispersive glass and behind a lens, what the plan skips changes no byte") {
  const std::string lamp = "lights " ABBE_SOURCE_DIR "/scenes/lights.filter\n"
                           "imageSize 24 24 samples 4 ";
  const std::string inside = lamp + "eye 0 0.3 0.2 lookAt 0.3 0.1 -1 fieldOfView 70\n"
                                    "light 2a 3 4 5 1 glass SF11 dispersionScale 3 sphere\n"
                                    "defaultMaterials push translate 0 -2 0 rotate -90 1 0 0\n"
                                    "scale 9 9 1 square pop ";
  const std::string behind_lens =
      lamp + "eye 0 0 500 filmHeight 6 fNumber 5.6 light 2a 100 200 300 1\n"
             "lensFile \"" ABBE_SOURCE_DIR "/scenes/lenses/singlet_bk7_50.lens\"\n"
             "defaultMaterials push translate 0 0 -10 scale 50 50 1 square pop\n"
             "glass SF11 scale 8 8 8 sphere ";
  for (const std::string& text : {inside, behind_lens})
    for (const char* integrator : {"whitted", "path"}) {
      Scene scene = test::scene_from(text + "integrator " + integrator);
      INFO(integrator << (text == inside ? ", inside" : ", behind a lens"));
      const Plan plan = make_plan(scene, scene.settings);
      REQUIRE(plan.live_first > 0); // there are dead bands at the blue end
      const Picture skipped = picture(scene);
      scene.settings.skip.dead_bands = false;
      CHECK(picture(scene) == skipped);
    }
}

TEST_CASE("the same seed makes the same bytes, another seed others") {
  Scene scene = small("lens");
  const Picture first = picture(scene);
  CHECK(picture(scene) == first);
  scene.settings.seed = 1;
  CHECK_FALSE(picture(scene) == first);
}

TEST_CASE("a crop shows the bytes of its part of the whole image") {
  Scene scene = small("prism_view");
  const Picture whole = picture(scene);
  scene.settings.crop = PixelWindow{8, 3, 29, 31};
  const Picture part = picture(scene);
  for (int y = 3; y < 31; ++y)
    for (int x = 8; x < 29; ++x)
      for (int c = 0; c < 4; ++c) {
        const auto in_part = static_cast<std::size_t>(((y - 3) * 21 + (x - 8)) * 4 + c);
        const auto in_whole = static_cast<std::size_t>((y * 40 + x) * 4 + c);
        REQUIRE(part.rgba[in_part] == whole.rgba[in_whole]);
      }
}

TEST_CASE("a mesh that is used again makes the bytes of a copy of its file") {
  const test::Folder folder;
  for (const char* name : {"a.obj", "b.obj"})
    std::ofstream(folder.path / name)
        << "v 1 0 0\nv -1 1 0\nv -1 -1 0\nv 0 0 1.5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const auto scene = [&](const std::string& second) {
    const std::string text =
        "imageSize 32 32 samples 4 eye 1 -3 6 fieldOfView 40 light D65 3 4 5 1\n"
        "glass SF11 mesh a.obj push translate 0.5 1 -1 rotate 30 1 0 0 scale "
        "1 -2 1 mesh " +
        second + " pop defaultMaterials push translate 0 0 -3 scale 4 4 1 square pop";
    return read_scene_text(text, folder.path / "s.sdl", [](const std::string&) {});
  };
  const Scene shared = scene("a.obj"), apart = scene("b.obj");
  const auto data = [](const Scene& s, std::size_t i) {
    return std::get<Mesh>(s.shapes[i].shape).vertices().data();
  };
  CHECK(data(shared, 0) == data(shared, 1));
  CHECK(data(apart, 0) != data(apart, 1));
  CHECK(picture(shared) == picture(apart));
}

namespace {

/// One scene at a scale: every length times `s`. The light does not fall off, so nothing else
/// changes.
std::string scaled_scene(double s) {
  const auto n = [s](double v) { return fmt::format("{}", v * s); };
  const std::string all = n(1) + " " + n(1) + " " + n(1);
  return "imageSize 40 40 samples 4 fieldOfView 35 background 0.3 0.4 0.6 globalAmbient 0.2 0.2 "
         "0.2\n"
         "eye " +
         n(0) + " " + n(2) + " " + n(8) +
         "\n"
         "scale " +
         all +
         "\n"
         "light D65 4 6 5 1 glass SF11 push rotate 30 0 1 0 prism pop\n"
         "push translate 1.5 0 1 lens sphere push translate 0.75 0.25 0 sphere pop pop\n"
         "defaultMaterials diffuse 0.7 0.5 0.2 push translate 0 -1 0 rotate -90 1 0 0 scale 6 6 1 "
         "square pop";
}

} // namespace

TEST_CASE("a scene scaled by a power of two makes the same bytes") {
  const Picture original = picture(test::scene_from(scaled_scene(1.0)));
  CHECK(picture(test::scene_from(scaled_scene(1024.0))) == original);
  CHECK(picture(test::scene_from(scaled_scene(0.015625))) == original);
}

TEST_CASE("a scene scaled by 1e4 or 1e-4 makes the same image within noise") {
  const auto mean = [](const Picture& p) {
    double sum = 0.0;
    for (const float v : p.rgba)
      sum += static_cast<double>(v);
    return sum / static_cast<double>(p.rgba.size());
  };
  const double original = mean(picture(test::scene_from(scaled_scene(1.0))));
  CHECK(mean(picture(test::scene_from(scaled_scene(1e4)))) == Approx(original).epsilon(2e-3));
  CHECK(mean(picture(test::scene_from(scaled_scene(1e-4)))) == Approx(original).epsilon(2e-3));
}
