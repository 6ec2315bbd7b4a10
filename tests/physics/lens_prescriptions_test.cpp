#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"
#include "tests/physics/refraction.h"

#include <array>

using namespace abbe;

namespace {

constexpr std::array kLines_nm{486.1327, 587.5618, 656.2725}; // F, d, C

struct Published {
  const char* scene;
  int surfaces;
  std::array<double, 3> focal_length, back_focal_length; ///< at F, d, C
  double back_vertex;                                    ///< its z
};

// Prescriptions: ray-optics codev/tests/singlet.seq (BSD-3-Clause); Edmund Optics 49-847 and
// Laikin, Lens Design, 4th ed., p. 45 (inch), both from optiland (MIT); Thorlabs AC254-050-A,
// -075-A and -150-A (Zemax files). The focal lengths were computed from the glasses' dispersion by
// paraxial matrices, outside this project.
const Published kLenses[] = {
    {"glass N-BK7 lensElement 10 -20 1 3",
     2,
     {12.909852, 13.048086, 13.110467},
     {12.466873, 12.603515, 12.665185},
     1},
    {"glass N-SF11 lensElement 19.93 inf 7 25.4",
     2,
     {24.711327, 25.397596, 25.684475},
     {20.836458, 21.475412, 21.742934},
     7},
    {"cemented 2 3.3  12.38401 N-BAK1 0.434  -7.9414 SF2 0.321  -48.44396",
     3,
     {20.000540, 20.005995, 20.020487},
     {19.601867, 19.606993, 19.621261},
     0.755},
    {"cemented 2 25.4  33.34 N-BAF10 9  -22.28 SF10 2.5  -291.07",
     3,
     {50.106812, 50.166898, 50.226582},
     {43.359675, 43.444278, 43.511309},
     11.5},
    {"cemented 2 25.4  46.54 N-BK7 7  -33.91 SF5 2.5  -95.54",
     3,
     {74.848608, 74.895938, 74.965584},
     {70.253134, 70.303005, 70.372497},
     9.5},
    {"cemented 2 25.4  91.62 N-BK7 5.7  -66.68 SF5 2.2  -197.7",
     3,
     {150.003843, 149.975759, 150.069350},
     {146.160569, 146.135444, 146.229186},
     7.9},
    // The same elements given one by one, the second moved by a transform.
    {"glass N-BK7 lensElement 91.62 -66.68 5.7 25.4\n"
     "glass SF5 translate 0 0 5.7 lensElement -66.68 -197.7 2.2 25.4",
     3,
     {150.003843, 149.975759, 150.069350},
     {146.160569, 146.135444, 146.229186},
     7.9},
};

} // namespace

TEST_CASE("lenses by their data have their focal lengths at F, d and C") {
  for (const Published& lens : kLenses) {
    INFO(lens.scene);
    const Scene scene = scene_of(lens.scene);
    const World world(scene.shapes, 100.0);
    for (std::size_t line = 0; line < kLines_nm.size(); ++line) {
      int asked = 0;              // twice at each boundary: before and after
      const double height = 1e-3; // paraxial: errors are of order (h/R)^2 < 1e-7
      const Ray out =
          test::through_glass(world, {{0.0, height, -10.0}, {0.0, 0.0, 1.0}}, [&](MediumId id) {
            ++asked;
            return id.valid() ? refractive_index(scene.media[id.index()].index, kLines_nm[line])
                              : 1.0;
          });
      const double slope = out.direction.y / out.direction.z;
      CHECK(asked == 2 * lens.surfaces);
      CHECK(-height / slope == Approx(lens.focal_length[line]).margin(1e-3));
      const double focus = out.origin.z - out.origin.y / slope;
      CHECK(focus - lens.back_vertex == Approx(lens.back_focal_length[line]).margin(1e-3));
    }
  }
}

TEST_CASE("a cemented doublet has no air inside: every ray meets its three surfaces only") {
  const Scene scene = scene_of("cemented 2 25.4  33.34 N-BAF10 9  -22.28 SF10 2.5  -291.07");
  const World world(scene.shapes, 100.0);
  for (double x = -12.6; x < 12.7; x += 0.1)
    for (double y = -12.6; y < 12.7; y += 0.1) {
      if (std::hypot(x, y) > 12.69) continue;
      RayState state{{{x, y, -10.0}, {0, 0, 1}}, {}, {}};
      int count = 0;
      while (const auto hit = world.closest(state)) {
        ++count;
        REQUIRE(hit->medium_before.valid() == (count > 1));
        REQUIRE(hit->medium_after.valid() == (count < 3));
        state = {{hit->point, state.ray.direction}, hit->other_side, hit->nesting_after};
      }
      REQUIRE(count == 3);
    }
}
