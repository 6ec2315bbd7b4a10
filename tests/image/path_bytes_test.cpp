#include "core/planning/make_plan.h"
#include "tests/image/picture.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using namespace abbe;
using test::Picture;
using test::picture;

// The image of `path`, light-side passes included, depends on scene, settings and seed alone.
// Pixels are compared as bits, in all bands.

namespace {

// 4608 light paths a pass, three tasks; nine tiles of 16 pixels or fewer.
const std::string kSmall = "integrator path imageSize 24 24 samples 4 lightPaths 2 ";

const std::string kRoom =
    "push scale 4 4 4\n"
    "def wall { push translate 0 0 -1 square pop }\n"
    "diffuse 0.7 0.7 0.7 use wall rotate 90 0 1 0 diffuse 0.7 0.1 0.1 use wall\n"
    "rotate 180 0 1 0 diffuse 0.1 0.6 0.1 use wall diffuse 0.7 0.7 0.7\n"
    "rotate 90 1 0 0 use wall rotate 180 1 0 0 use wall pop\n";

const std::string kLamp = "defaultMaterials emissive E 4 emissiveSides front\n"
                          "push translate 0 3.9 0 rotate 90 1 0 0 square pop defaultMaterials\n";

struct Case {
  const char* name;
  std::string text;
  bool light_side = true; ///< light paths are followed
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"box with an area lamp",
       kSmall + "eye 0 0 3.9 lookAt 0 0 0 fieldOfView 90 " + kLamp + kRoom +
           "push translate 1 -3 0 rotate 20 0 1 0 cube pop",
       false},
      {"box with a glass ball and a mirror",
       kSmall + "eye 0 0 3.9 lookAt 0 0 0 fieldOfView 90 " + kLamp + kRoom +
           "glass SF11 push translate 0 -2 0 sphere pop\n"
           "defaultMaterials reflectivity 0.9 fresnel off diffuse 0 0 0\n"
           "push translate -3.9 0 0 rotate 90 0 1 0 scale 2 2 1 square pop"},
      {"prism with a spotlight",
       kSmall +
           "eye -3 3 9 lookAt 2 0 0 fieldOfView 40 falloff square intensity 1600 softEdge 0.5\n"
           "spotlight D65 -4.6654423 -1.8996736 0 1 4.1654423 2.765699 0 2\n"
           "glass SF11 polyhedron vertices 6 -1 0 1  1 0 1  0 1.7320508 1\n"
           "  -1 0 -1  0 1.7320508 -1  1 0 -1\n"
           "defaultMaterials translate 5.5 -2 0 rotate -90 0 1 0 scale 9 9 1 square"},
      {"rough glass",
       kSmall + "eye 0 2 6 fieldOfView 40 falloff square intensity 30 light D65 2 4 1 1\n"
                "defaultMaterials push translate 0 -1 0 rotate -90 1 0 0 scale 4 4 1 square pop\n"
                "glass SF11 roughness 0.4 sphere roughness 0 translate 1.5 0 1 scale 0.6 0.6 0.6 "
                "sphere"},
      {"thin lens",
       kSmall + "eye 0 2 6 fieldOfView 40 aperture 0.5 falloff square intensity 30\n"
                "light D65 2 4 1 1\n"
                "defaultMaterials push translate 0 -1 0 rotate -90 1 0 0 scale 4 4 1 square pop\n"
                "glass SF11 sphere"},
      {"real lens", kSmall + "eye 0 0 500 filmHeight 6 fNumber 5.6\n"
                             "lensFile \"" ABBE_SOURCE_DIR "/scenes/lenses/singlet_bk7_50.lens\"\n"
                             "sun 1 2 1 D65\n"
                             "defaultMaterials push translate 0 0 -10 scale 50 50 1 square pop\n"
                             "glass SF11 scale 8 8 8 sphere"},
      {"drops", kSmall + "unit m eye 0 2 0 lookAt 0 14 -60 fieldOfView 74 light D65 0 0.176 1 0\n"
                         "drops 2e-6 push translate 0 3900 -300 scale 10000 4000 100 cube pop\n"
                         "glass SF11 push translate 0 4 -15 scale 3 3 3 sphere pop\n"
                         "defaultMaterials push rotate -90 1 0 0 plane pop"},
  };
  return all;
}

} // namespace

TEST_CASE("path: 1, 2 and 7 threads make the same bytes") {
  for (const Case& c : cases()) {
    Scene scene = test::scene_from(c.text);
    REQUIRE(make_plan(scene, scene.settings).caustics == c.light_side);
    scene.settings.threads = 1;
    const Picture one = picture(scene);
    for (const int threads : {2, 7}) {
      INFO(c.name << ", " << threads << " threads");
      scene.settings.threads = threads;
      CHECK(picture(scene) == one);
    }
  }
}

TEST_CASE("path: packets and single rays make the same bytes") {
  for (const Case& c : cases()) {
    INFO(c.name);
    Scene scene = test::scene_from(c.text);
    scene.settings.tracing = Tracing::packets;
    const Picture packets = picture(scene);
    scene.settings.tracing = Tracing::single;
    CHECK(picture(scene) == packets);
  }
}

TEST_CASE("path: bands in a file are the bytes of bands in memory") {
  const BandPlace in_file{std::filesystem::temp_directory_path(), 0};
  for (const Case& c : cases()) {
    INFO(c.name);
    Scene scene = test::scene_from(c.text);
    scene.settings.threads = 7;
    CHECK(picture(scene, in_file) == picture(scene));
  }
}

TEST_CASE("path: adaptive sampling gives the same bytes on any number of threads") {
  for (const Case& c : cases()) {
    INFO(c.name);
    Scene scene = test::scene_from(c.text);
    scene.settings.adaptive = AdaptiveSampling::on;
    scene.settings.samples_per_pixel = 8;
    scene.settings.threads = 1;
    const Picture one = picture(scene);
    scene.settings.threads = 7;
    CHECK(picture(scene) == one);
  }
}

TEST_CASE("path: what the plan skips changes no byte") {
  for (const Case& c : cases()) {
    INFO(c.name);
    Scene scene = test::scene_from(c.text);
    scene.settings.skip = true;
    const Picture skipped = picture(scene);
    scene.settings.skip = false;
    CHECK(picture(scene) == skipped);
  }
  // A light that is dark in most bands, and an image that is half empty.
  Scene scene = test::scene_from("lights " ABBE_SOURCE_DIR "/scenes/lights.filter\n" + kSmall +
                                 "imageSize 48 48 eye 0 0 9 fieldOfView 40 falloff square\n"
                                 "intensity 30 light 2a 3 4 5 1\n"
                                 "glass SF11 push translate 1 0 0 sphere pop\n"
                                 "defaultMaterials diffuse 0.7 0.5 0.2\n"
                                 "push translate 1 0 -2 square pop");
  scene.settings.skip = true;
  const Picture skipped = picture(scene);
  scene.settings.skip = false;
  CHECK(picture(scene) == skipped);
}

TEST_CASE("path: a crop with splats shows what the whole image shows, within noise") {
  // A crop has fewer pixels, so fewer light paths: not the same bytes, but the same light.
  Scene scene = test::scene_from(cases()[2].text);
  scene.settings.light_paths = 40.0;
  const auto sum = [](const Film& film) {
    double total = 0.0;
    for (int y = 6; y < 18; ++y)
      for (int x = 12; x < 24; ++x)
        total += film.color(x, y).y;
    return total;
  };
  const double whole = sum(test::render_scene(scene, false).film);
  scene.settings.light_paths = 160.0;
  scene.settings.crop = PixelWindow{12, 6, 24, 18};
  CHECK(sum(test::render_scene(scene, false).film) == Approx(whole).epsilon(0.02));
}
