#pragma once

#include "core/cameras/focused_lens.h"

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace abbe {

/// Where light for a point of the film comes through the plane of the lens's last vertex: an
/// ellipse that holds the pupils of all wavelengths. The first axis points away from the film's
/// middle, on the point's side.
struct PupilEllipse {
  double center = 0.0; ///< on the first axis
  glm::dvec2 semi_axes{0.0};

  [[nodiscard]] double area() const;
};

/// The pupils of a focused lens by the distance from the film's middle, precomputed so that few
/// rays are shot at what lets none through [KMH95]. They are found by rays: along spokes from a
/// point inside a pupil, its edge is where they begin to be stopped, as it is one convex area in
/// all that is known as a lens.
class ExitPupil {
public:
  /// `film_radius` is the largest distance that will be asked for.
  ExitPupil(const FocusedLens& lens, double film_radius);

  /// The ellipse for a point of the film; null where it gets no light.
  [[nodiscard]] const PupilEllipse* at(double film_radius) const;

  /// The light for the film's middle at the d line: pi sin^2 of the widest ray's angle. It is the
  /// irradiance there for a radiance of 1 in front of the lens.
  [[nodiscard]] double axial_irradiance() const { return axial_irradiance_; }

private:
  double interval_;
  double axial_irradiance_;
  std::vector<PupilEllipse> ellipses_; ///< of intervals of film radii, up to where light ends
};

} // namespace abbe
