#include "io/selftest/lens_rows.h"

#include "io/selftest/expected_index.h"
#include "io/selftest/single_ray.h"
#include "io/selftest/small_picture.h"

#include <string>

namespace abbe {
namespace {

// Prescriptions: ray-optics codev/tests/singlet.seq (BSD-3-Clause); Edmund Optics 49-847 and
// Laikin, Lens Design, 4th ed., p. 45 (inch), both from optiland (MIT); Thorlabs AC254-050-A,
// -075-A and -150-A (Zemax files).
constexpr PublishedLens kLenses[] = {
    {"singlet of N-BK7, f/5",
     "glass N-BK7 lensElement 10 -20 1 3",
     2,
     {12.909852, 13.048086, 13.110467},
     {12.466873, 12.603515, 12.665185},
     1},
    {"Edmund 49-847, N-SF11",
     "glass N-SF11 lensElement 19.93 inf 7 25.4",
     2,
     {24.711327, 25.397596, 25.684475},
     {20.836458, 21.475412, 21.742934},
     7},
    {"achromat of Laikin's",
     "cemented 2 3.3  12.38401 N-BAK1 0.434  -7.9414 SF2 0.321  -48.44396",
     3,
     {20.000540, 20.005995, 20.020487},
     {19.601867, 19.606993, 19.621261},
     0.755},
    {"achromat AC254-050-A",
     "cemented 2 25.4  33.34 N-BAF10 9  -22.28 SF10 2.5  -291.07",
     3,
     {50.106812, 50.166898, 50.226582},
     {43.359675, 43.444278, 43.511309},
     11.5},
    {"achromat AC254-075-A",
     "cemented 2 25.4  46.54 N-BK7 7  -33.91 SF5 2.5  -95.54",
     3,
     {74.848608, 74.895938, 74.965584},
     {70.253134, 70.303005, 70.372497},
     9.5},
    {"achromat AC254-150-A",
     "cemented 2 25.4  91.62 N-BK7 5.7  -66.68 SF5 2.2  -197.7",
     3,
     {150.003843, 149.975759, 150.069350},
     {146.160569, 146.135444, 146.229186},
     7.9},
    // The same elements given one by one, the second moved by a transform.
    {"AC254-150-A as two lenses",
     "glass N-BK7 lensElement 91.62 -66.68 5.7 25.4\n"
     "glass SF5 translate 0 0 5.7 lensElement -66.68 -197.7 2.2 25.4",
     3,
     {150.003843, 149.975759, 150.069350},
     {146.160569, 146.135444, 146.229186},
     7.9},
};

/// A biconvex lens as an intersection of two balls, |R| = 100 and 10 thick in the middle.
constexpr const char* kTwoBalls = "glass N-BK7 intersection\n"
                                  "push translate 0 0 100 scale 100 100 100 sphere pop\n"
                                  "push translate 0 0 -90 scale 100 100 100 sphere pop";

/// The lensmaker's equation for a thick lens, 1/f = (n-1) (1/R1 - 1/R2 + (n-1) t / (n R1 R2)).
double lensmaker(double n) {
  const double r1 = 100.0, r2 = -100.0, t = 10.0;
  return 1.0 / ((n - 1.0) * (1.0 / r1 - 1.0 / r2 + (n - 1.0) * t / (n * r1 * r2)));
}

constexpr const char* kLineNames[] = {"F", "d", "C"};

void add_intersection_of_balls(SelftestRows& rows) {
  const Scene scene = scene_of_text(kTwoBalls);
  const World world(scene.shapes, 100.0);
  const auto n = expected_index("N-BK7");
  for (std::size_t line = 0; line < kGlassLines_nm.size(); ++line)
    rows.push_back({"lens", std::string("two balls of N-BK7, f at ") + kLineNames[line],
                    "lensmaker's equation", lensmaker(n[line]),
                    paraxial_focus(world, scene, kGlassLines_nm[line]).focal_length, 3e-5, "mm"});
}

void add_published(SelftestRows& rows, const PublishedLens& lens) {
  const Scene scene = scene_of_text(lens.scene);
  const World world(scene.shapes, 100.0);
  std::array<double, 3> back{};
  for (std::size_t line = 0; line < back.size(); ++line) {
    const ParaxialFocus f = paraxial_focus(world, scene, kGlassLines_nm[line]);
    back[line] = f.focus - lens.back_vertex;
    rows.push_back({"lens", std::string(lens.name) + ", f at " + kLineNames[line],
                    "paraxial matrices", lens.focal_length[line], f.focal_length, 1e-4, "mm"});
  }
  rows.push_back({"lens", std::string(lens.name) + ", focus of F less C", "paraxial matrices",
                  lens.back_focal_length[0] - lens.back_focal_length[2], back[0] - back[2], 1e-5,
                  "mm"});
}

} // namespace

std::span<const PublishedLens> published_lenses() {
  return kLenses;
}

ParaxialFocus paraxial_focus(const World& world, const Scene& scene, double lambda_nm) {
  const double height = 1e-3; // the errors of this height are of order (h/R)^2 < 1e-7
  const auto [ray, boundaries] =
      refracted_through(world, {{0.0, height, -10.0}, {0.0, 0.0, 1.0}}, [&](MediumId id) {
        return id.valid() ? refractive_index(scene.media[id.index()].index, lambda_nm) : 1.0;
      });
  const double slope = ray.direction.y / ray.direction.z;
  return {-height / slope, ray.origin.z - ray.origin.y / slope, boundaries};
}

SelftestRows lens_rows() {
  SelftestRows rows;
  add_intersection_of_balls(rows);
  for (const std::size_t i : {1u, 3u, 5u}) // one singlet, two achromats
    add_published(rows, kLenses[i]);
  return rows;
}

} // namespace abbe
