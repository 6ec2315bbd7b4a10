#pragma once

#include "core/bands/index_table.h"
#include "core/cameras/lens_profile.h"
#include "core/scene/lens_prescription.h"
#include "geometry/rays/ray.h"

#include <optional>
#include <span>
#include <vector>

namespace abbe {

/// What a lens does to rays close to its axis, at one wavelength [BW99, 4.4]. The film's side is
/// the image side; both are in air.
struct ParaxialLens {
  // A ray at height y with slope u at the first vertex leaves the last vertex at height a y + b u
  // with slope c y + d u.
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0;

  [[nodiscard]] double focal_length() const { return -1.0 / c; }
  /// From the last vertex to the focus of parallel light from in front.
  [[nodiscard]] double back_focal_length() const { return -a / c; }
  /// From the first vertex to the front focus; less than 0 in front of it, as a rule.
  [[nodiscard]] double front_focal_length() const { return d / c; }
  /// From the last vertex to the rear principal plane.
  [[nodiscard]] double rear_principal_plane() const { return (1.0 - a) / c; }
  /// From the first vertex to the front principal plane.
  [[nodiscard]] double front_principal_plane() const { return (d - 1.0) / c; }
  /// From the last vertex to the image of an object that lies this far, up to infinity, in front of
  /// the first vertex. Not positive where the image is virtual.
  [[nodiscard]] double image_distance(double object_distance) const;
  /// The inverse of image_distance; infinite or not positive where no real object is imaged there.
  [[nodiscard]] double object_distance(double image_distance) const;
  /// How high the ray that passes the first vertex with slope 1 is, this far behind the last one.
  [[nodiscard]] double height_per_slope(double image_distance) const {
    return b + d * image_distance;
  }
};

/// A ray that has come through a lens.
struct LensRay {
  Ray ray; ///< its origin lies on the last surface it passed; unit direction
  double transmittance = 1.0;
};

/// A camera lens, ready to trace rays through: exact, sequential, in double precision, by Snell's
/// law at each surface. Its frame has the first vertex at the origin and the axis along z, towards
/// the film; lengths are in mm.
///
/// A surface without a semi-diameter gets the one that rays through the stop need, within its
/// radius of curvature: the height of the marginal ray, exact, and that of the paraxial chief ray
/// at the prescription's half field, added. The stop then follows from the f-number.
class LensSystem {
public:
  struct Surface {
    double vertex;             ///< its z
    double curvature;          ///< 1 / radius
    double semi_diameter;      ///< rays that meet it farther from the axis are stopped
    std::size_t before, after; ///< media; 0 is air
    bool aspheric;             ///< it is more than its curvature
    LensProfile profile;       ///< all of its shape
  };

  /// Throws std::invalid_argument for a prescription that describes no lens.
  explicit LensSystem(const LensPrescription& prescription);

  [[nodiscard]] const std::vector<Surface>& surfaces() const { return surfaces_; }
  [[nodiscard]] std::size_t stop() const { return stop_; }
  [[nodiscard]] double last_vertex() const { return surfaces_.back().vertex; }
  [[nodiscard]] std::size_t media() const { return media_.size(); }
  [[nodiscard]] bool achromatic() const;

  /// Each medium's index at a wavelength; `n` has `media()` entries.
  void look_up_indices(double lambda_nm, std::span<double> n) const;
  [[nodiscard]] std::vector<double> indices(double lambda_nm) const;

  [[nodiscard]] ParaxialLens paraxial(double lambda_nm) const;

  /// A ray from the film's side, with unit direction towards -z, as it leaves the first surface.
  /// Nothing where it is vignetted: it misses a surface's clear aperture or is totally reflected.
  /// `n` are the media's indices. With `uncoated`, the transmittance is that of Fresnel's
  /// equations for unpolarised light, else 1; light that is reflected is lost either way.
  [[nodiscard]] std::optional<LensRay> trace_from_film(const Ray& ray, std::span<const double> n,
                                                       bool uncoated = false) const;
  /// The same for a ray from in front, with direction towards +z, as it leaves the last surface.
  [[nodiscard]] std::optional<LensRay> trace_from_object(const Ray& ray, std::span<const double> n,
                                                         bool uncoated = false) const;

  /// The diameter of the beam of parallel light along the axis that passes, at the d line.
  [[nodiscard]] double entrance_pupil_diameter() const;
  /// Opens or closes the stop so that a beam of this diameter passes it. Throws
  /// std::invalid_argument when the lens does not open as far.
  void set_entrance_pupil_diameter(double diameter);

private:
  void add_surfaces(const LensPrescription& prescription);
  void size_surfaces(const LensPrescription& prescription);
  [[nodiscard]] std::vector<double> marginal_heights(double entrance_height) const;
  [[nodiscard]] std::vector<double> chief_heights(double half_field_deg) const;
  [[nodiscard]] std::optional<LensRay> trace(const Ray& ray, std::span<const double> n,
                                             bool uncoated, std::span<double> heights) const;

  std::vector<Surface> surfaces_;
  std::size_t stop_ = 0;
  std::vector<IndexTable> media_; ///< air first
};

} // namespace abbe
