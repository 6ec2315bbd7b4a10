#include "tests/io/scene_language/read_scene_helpers.h"

#include "core/cameras/focused_lens.h"
#include "spectral/fraunhofer.h"
#include "tests/catch.h"

#include <cmath>
#include <limits>

using namespace abbe;

namespace {

const std::string kLens = "lensFile lenses/double_gauss_f2.lens ";
const std::string kAbsolute =
    "lensFile \"" ABBE_SOURCE_DIR "/scenes/lenses/double_gauss_f2.lens\" ";

void check_error(const std::string& text, const std::string& message) {
  CHECK_THAT(scene_error(text), Catch::Matchers::ContainsSubstring(message));
}

} // namespace

TEST_CASE("the camera is a pinhole unless told otherwise") {
  const Camera camera = scene_of("").camera;
  CHECK(camera.aperture == 0.0);
  CHECK_FALSE(camera.lens);
  CHECK_FALSE(camera.focus_distance);
}

TEST_CASE("a thin lens by aperture, or by focal length and f-number") {
  const Camera camera = scene_of("aperture 0.25 focusDistance 7").camera;
  CHECK(camera.aperture == 0.25);
  CHECK(camera.focus_distance == 7.0);
  CHECK(camera.field_of_view_deg == 30.0);
  CHECK(scene_of("focusDistance inf").camera.focus_distance ==
        std::numeric_limits<double>::infinity());
  CHECK(scene_of("unit cm focalLength 50 fNumber 2").camera.aperture == Approx(2.5));
  CHECK(scene_of("aperture 9 focalLength 50 fNumber 2").camera.aperture == Approx(25.0));
  CHECK(scene_of("focalLength 50 fNumber 2 filmHeight 24 focusDistance 5000 aperture 9")
            .camera.aperture == 9.0); // the last counts
}

TEST_CASE("the view of a thin lens by its focal length and film") {
  // Focused at infinity the film is at the focal length; at twice the focal length, twice as far.
  const auto view = [](const std::string& focus) {
    const std::string text = "focalLength 50 filmHeight 24 " + focus;
    return std::tan(scene_of(text).camera.field_of_view_deg * 3.141592653589793 / 360.0);
  };
  CHECK(view("focusDistance inf") == Approx(12.0 / 50.0));
  CHECK(view("focusDistance 100") == Approx(12.0 / 100.0));
}

TEST_CASE("a real lens from a file beside the scene") {
  const Scene scene = scene_of(kLens + "unit cm eye 0 0 100 fNumber 4 filmHeight 24");
  REQUIRE(scene.camera.lens);
  CHECK(scene.camera.lens->name == "double_gauss_f2");
  CHECK(scene.camera.lens->surfaces.size() == 11);
  CHECK(scene.camera.aperture == Approx(10.0003721 / 4.0).epsilon(1e-6));
  CHECK(scene.camera.film_height_mm == 24.0);
  CHECK(scene.camera.lens_coating);
  CHECK(focused_lens(scene.camera, scene.mm_per_unit).focus_distance == 1000.0);
  const Camera other = scene_of(kLens + "filmDistance 70 lensCoating off aperture 10").camera;
  CHECK(other.film_distance_mm == 70.0);
  CHECK_FALSE(other.lens_coating);
  CHECK(other.aperture == 10.0);
}

TEST_CASE("errors of the camera's lens") {
  check_error("aperture -1", "s.sdl:1:10: -1 is out of range for aperture (it is the diameter of");
  check_error("fNumber 0", "s.sdl:1:9: 0 is out of range for fNumber (it is focal length by");
  check_error("focalLength 0", "s.sdl:1:13: 0 is out of range for focalLength (it is a length");
  check_error("focusDistance 0", "s.sdl:1:15: 0 is out of range for focusDistance (it is how far");
  check_error("filmHeight 0", "s.sdl:1:12: 0 is out of range for filmHeight (it is the picture's");
  check_error("filmDistance 0", "s.sdl:1:14: 0 is out of range for filmDistance (it is a length");
  check_error("lensCoating 3", "s.sdl:1:13: \"3\" is no choice of lensCoating");
  check_error("lensFile no.lens", "s.sdl:1:10: there is no file \"no_such_folder/no.lens\" (lenses "
                                  "are found relative to the file that names them)");
}

TEST_CASE("what is said of the camera's lens must fit together") {
  CHECK(scene_error("fNumber 2") ==
        "s.sdl:1:1: fNumber stands without focalLength or lensFile (it says nothing alone). Add "
        "focalLength or lensFile, or remove it");
  CHECK(scene_error("filmHeight 2") ==
        "s.sdl:1:1: filmHeight stands without focalLength or lensFile (it says nothing alone). Add "
        "focalLength or lensFile, or remove it");
  CHECK(scene_error("focalLength 2") ==
        "s.sdl:1:1: focalLength stands without fNumber or filmHeight (it says nothing alone). Add "
        "fNumber or filmHeight, or remove it");
  CHECK(scene_error("filmDistance 2") ==
        "s.sdl:1:1: filmDistance stands without lensFile (it says nothing alone). Add lensFile, or "
        "remove it");
  CHECK(scene_error("lensCoating on") ==
        "s.sdl:1:1: lensCoating stands without lensFile (it says nothing alone). Add lensFile, or "
        "remove it");
  CHECK(scene_error("focalLength 50 filmHeight 24") ==
        "s.sdl:1:1: the camera is focused nearer than its focal length (5 mm; there is no image "
        "then). Check focusDistance, or lookAt, and the unit");
  check_error(kAbsolute + "\nfocalLength 50",
              "s.sdl:2:1: focalLength stands beside lensFile (the lens of the file has its own)");
  check_error(kAbsolute + "\nfilmDistance 70 focusDistance 500",
              "s.sdl:2:1: filmDistance stands beside focusDistance (both say where the film is)");
}

TEST_CASE("what a lens cannot do") {
  CHECK(scene_error("\n" + kAbsolute) ==
        "s.sdl:2:1: the lens double_gauss_f2 cannot be set so (it forms no image of what is nearer "
        "than 29.32 mm, its front focus). Check the aperture, the focus (that of lookAt unless "
        "given) and the unit");
  check_error(kAbsolute + "eye 0 0 500 fNumber 1.4", "cannot be set so (it opens to f/2.00 only");
}

TEST_CASE("an error in a lens file names that file") {
  check_error("lensFile \"" ABBE_SOURCE_DIR "/scenes/sphere.sdl\"", ".sdl:8:1: unknown keyword");
}
