#include "io/libraries/read_library.h"
#include "io/libraries/read_materials.h"
#include "io/libraries/standard_lights.h"
#include "spectral/color_difference.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <algorithm>

using namespace abbe;

namespace {

Curve lamp(const std::string& name) {
  return standard_light({TokenKind::word, name, {}}).value();
}

/// How far the two oranges of the scenes are apart, to an eye adapted to the lamps.
double difference(const std::vector<Curve>& lamps) {
  const auto library = read_materials(ABBE_SOURCE_DIR "/scenes/metamers.mtl", {});
  const auto seen = [&](const char* name) {
    Xyz sum;
    for (const Curve& light : lamps)
      sum += to_xyz(light.times(finish(*find_entry(library, name)).diffuse));
    return sum;
  };
  Xyz white;
  for (const Curve& light : lamps)
    white += to_xyz(light);
  // A single line leaves Z at 0, which CIELAB cannot divide by: there, compare by lightness.
  const double floor = 1e-3 * white.y;
  white = {std::max(white.x, floor), white.y, std::max(white.z, floor)};
  return delta_e_2000(to_lab(seen("FrontOrange"), white), to_lab(seen("BackOrange"), white));
}

} // namespace

TEST_CASE("the oranges of the metamerism scenes match in daylight and part under other lamps") {
  CHECK(difference({lamp("D65")}) < 1.0);
  CHECK(difference({lamp("sodium")}) > 10.0);
  CHECK(difference({lamp("line(541)"), lamp("line(640)")}) > 10.0);
  CHECK(difference({lamp("FL11")}) > 10.0); // a common triphosphor tube
}

TEST_CASE("the metamerism scenes show one ball, the other, or both") {
  // Points on the lit sides of the front and the back ball.
  const auto luminances = [](const char* name) {
    const Scene scene = test::project_scene(name, 64);
    const Film film = std::move(test::render_scene(scene, false).film);
    return std::pair(film.color(39, 32).y, film.color(22, 24).y);
  };
  const auto [front_white, back_white] = luminances("metamerism_white");
  CHECK(front_white == Approx(back_white).epsilon(0.4)); // shading differs, colour does not
  const auto [front_sodium, back_sodium] = luminances("metamerism_front");
  CHECK(front_sodium > 5.0 * back_sodium);
  const auto [front_lines, back_lines] = luminances("metamerism_back");
  CHECK(back_lines > 3.0 * front_lines);
}
