#include "io/selftest/absorption_rows.h"

#include "io/selftest/small_picture.h"

#include <cmath>
#include <string>

namespace abbe {
namespace {

constexpr double kNm = 550.0;

/// Radiance behind a slab 2 units thick of the index of air, before a sky of radiance 1.
double through_slab(const std::string& unit, double angle_deg) {
  return radiance_seen("background E 1 unit " + unit +
                           " defaultMaterials reflectivity 1 transparency 1 speedOfLight 1 "
                           "absorption 0.3 scale 100 100 1 cube",
                       kNm, angle_deg);
}

/// A card that reflects a half, seen from 5 mm in a medium that a lamp which does not fall off
/// stands in 2 mm before the card.
double card_in_medium(const std::string& integrator) {
  return rendered("integrator " + integrator +
                  " background 0 0 0 light E 0 0 2 1 maxRecursionDepth 1\n"
                  "eye 3 0 4 lookAt 0 0 0 fieldOfView 0.0001 imageSize 1 1 samples 4\n"
                  "defaultMaterials ambient 0 0 0 specular 0 0 0 diffuse 0.5 0.5 0.5 square\n"
                  "defaultMaterials reflectivity 1 transparency 1\n"
                  "speedOfLight 0.7 absorption 0.1 scale 9 9 9 cube\n")
      .film.radiance(0, 0, 34);
}

} // namespace

SelftestRows absorption_rows() {
  constexpr const char* kSubject = "absorption";
  constexpr const char* kSource = "Beer-Lambert, exp(-a l)";
  return {{kSubject, "0.3 / mm, 2 mm", kSource, std::exp(-0.6), through_slab("mm", 0.0), 1e-6},
          {kSubject, "0.3 / mm, 2 cm", kSource, std::exp(-6.0), through_slab("cm", 0.0), 1e-6},
          {kSubject, "0.3 / mm, 2 mm seen at 60 deg", kSource, std::exp(-1.2),
           through_slab("mm", 60.0), 1e-6},
          {kSubject, "0.1 / mm, lamp, card and eye, whitted", kSource, 0.5 * std::exp(-0.7),
           card_in_medium("whitted"), 2e-5},
          {kSubject, "0.1 / mm, lamp, card and eye, path", kSource, 0.5 * std::exp(-0.7),
           card_in_medium("path"), 2e-5}};
}

} // namespace abbe
