#include "core/cameras/focused_lens.h"

#include "core/cameras/focus_distance.h"
#include "geometry/booleans/lens.h"
#include "spectral/fraunhofer.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace abbe {
namespace {

/// How far the last surface reaches towards the film, from its vertex.
double reach_of_last_surface(const LensSystem& lens) {
  const LensSystem::Surface& last = lens.surfaces().back();
  return std::max(0.0, last.profile.most_sag(last.semi_diameter));
}

} // namespace

double FocusedLens::image_slope() const {
  return film_height / lens.paraxial(kLineD_nm).height_per_slope(film_distance);
}

FocusedLens focused_lens(const RealLens& lens, const Camera& camera, double mm_per_unit) {
  FocusedLens result{LensSystem(lens.prescription), 0.0, 0.0, 0.0};
  if (lens.aperture > 0.0) result.lens.set_entrance_pupil_diameter(lens.aperture * mm_per_unit);
  const ParaxialLens paraxial = result.lens.paraxial(kLineD_nm);
  if (lens.film_distance_mm) {
    result.film_distance = *lens.film_distance_mm;
    const double sharp = paraxial.object_distance(result.film_distance);
    result.focus_distance = sharp > 0.0 ? sharp : std::numeric_limits<double>::infinity();
  } else {
    result.focus_distance = focus_distance(camera, lens.focus_distance) * mm_per_unit;
    result.film_distance = paraxial.image_distance(result.focus_distance);
    if (!(result.focus_distance > -paraxial.front_focal_length()))
      throw std::invalid_argument(
          fmt::format("it forms no image of what is nearer than {:.4g} mm, its front focus",
                      -paraxial.front_focal_length()));
  }
  if (!(result.film_distance > reach_of_last_surface(result.lens)))
    throw std::invalid_argument(
        fmt::format("the film would stand in its glass, {:.4g} mm behind its last vertex",
                    result.film_distance));
  const double slope = 2.0 * std::tan(camera.field_of_view_deg * std::numbers::pi / 360.0);
  result.film_height =
      lens.film_height_mm.value_or(slope * paraxial.height_per_slope(result.film_distance));
  if (!(result.film_height > 0.0))
    throw std::invalid_argument("no field of view fits its film there; filmHeight is needed");
  return result;
}

} // namespace abbe
