#include "core/cameras/lens_system.h"

#include "core/optics/fresnel.h"
#include "spectral/fraunhofer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace abbe {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The largest x in [0, upper) for which `holds` is true, when it is true below some x and false
/// above: halved until doubles allow no more.
template <class Predicate>
double largest(double upper, const Predicate& holds) {
  double yes = 0.0, no = upper;
  for (;;) {
    const double middle = 0.5 * (yes + no);
    if (!(middle > yes && middle < no)) return yes;
    (holds(middle) ? yes : no) = middle;
  }
}

Ray parallel_ray(double height) {
  return {{0.0, height, 0.0}, {0.0, 0.0, 1.0}};
}

} // namespace

double ParaxialLens::image_distance(double object_distance) const {
  if (std::isinf(object_distance)) return back_focal_length();
  return -(a * object_distance + b) / (c * object_distance + d);
}

double ParaxialLens::object_distance(double image_distance) const {
  return -(d * image_distance + b) / (c * image_distance + a);
}

LensSystem::LensSystem(const LensPrescription& prescription) : stop_(prescription.stop) {
  if (prescription.surfaces.empty()) throw std::invalid_argument("it has no surface");
  if (stop_ >= prescription.surfaces.size()) throw std::invalid_argument("it has no stop");
  add_surfaces(prescription);
  const double power = -paraxial(kLineD_nm).c;
  if (!(power > 0.0 && std::isfinite(power)))
    throw std::invalid_argument("it does not gather light: its focal length is not positive");
  size_surfaces(prescription);
}

void LensSystem::add_surfaces(const LensPrescription& prescription) {
  std::vector<Dispersion> laws{ConstantIndex{1.0}};
  double vertex = 0.0;
  std::size_t before = 0;
  for (const PrescribedSurface& surface : prescription.surfaces) {
    const auto known = std::find(laws.begin(), laws.end(), surface.medium_after);
    const auto after = static_cast<std::size_t>(known - laws.begin());
    if (known == laws.end()) laws.push_back(surface.medium_after);
    LensProfile profile{surface.radius_mm == 0.0 ? 0.0 : 1.0 / surface.radius_mm, surface.conic,
                        surface.even_terms};
    if (!profile.spherical() && !surface.semi_diameter_mm)
      throw std::invalid_argument("an aspheric surface has no semi-diameter");
    if (surface.semi_diameter_mm && !profile.spherical() &&
        !profile.reaches(*surface.semi_diameter_mm))
      throw std::invalid_argument("a conic surface ends before its semi-diameter");
    surfaces_.push_back({vertex, profile.curvature, surface.semi_diameter_mm.value_or(kInfinite),
                         before, after, !profile.spherical(), profile});
    vertex += surface.thickness_mm;
    before = after;
  }
  if (before != 0) throw std::invalid_argument("there is no air behind its last surface");
  for (const Dispersion& law : laws)
    media_.emplace_back(law);
}

void LensSystem::size_surfaces(const LensPrescription& prescription) {
  Surface& stop = surfaces_[stop_];
  if (std::isinf(stop.semi_diameter)) {
    if (!prescription.f_number)
      throw std::invalid_argument("its stop has no semi-diameter, and there is no f-number");
    const double height = 0.5 * paraxial(kLineD_nm).focal_length() / *prescription.f_number;
    stop.semi_diameter = marginal_heights(height)[stop_];
    if (std::isnan(stop.semi_diameter))
      throw std::invalid_argument("it cannot be opened to its f-number");
  }
  const auto unknown = [](const Surface& s) { return std::isinf(s.semi_diameter); };
  if (std::none_of(surfaces_.begin(), surfaces_.end(), unknown)) return;
  const auto passes_stop = [&](double height) {
    return marginal_heights(height)[stop_] <= stop.semi_diameter;
  };
  double beyond = stop.semi_diameter;
  while (passes_stop(beyond))
    beyond *= 2.0;
  const std::vector<double> marginal = marginal_heights(largest(beyond, passes_stop));
  const std::vector<double> chief = chief_heights(prescription.half_field_deg);
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (Surface& s = surfaces_[i]; unknown(s)) {
      const double c = s.curvature;
      const double whole = c == 0.0 ? kInfinite : std::abs(1.0 / c);
      s.semi_diameter = std::min(marginal[i] + std::abs(chief[i]), whole);
      if (!std::isfinite(s.semi_diameter))
        throw std::invalid_argument("the beam through its stop does not come through it");
    }
}

/// The heights at which a ray of parallel light meets each surface, at the d line; NaN from where
/// on it does not come through, but for the surface whose clear aperture it misses.
std::vector<double> LensSystem::marginal_heights(double entrance_height) const {
  std::vector<double> heights(surfaces_.size(), std::numeric_limits<double>::quiet_NaN());
  (void)trace(parallel_ray(entrance_height), indices(kLineD_nm), false, heights);
  return heights;
}

/// The paraxial heights at each surface of the ray that passes the middle of the stop, at the d
/// line.
std::vector<double> LensSystem::chief_heights(double half_field_deg) const {
  const std::vector<double> n = indices(kLineD_nm);
  const auto heights_of = [&](double height, double slope) {
    std::vector<double> heights;
    double vertex = 0.0;
    for (const Surface& s : surfaces_) {
      height += slope * (s.vertex - vertex);
      heights.push_back(height);
      vertex = s.vertex;
      slope = (n[s.before] * slope -
               height * s.profile.vertex_curvature() * (n[s.after] - n[s.before])) /
              n[s.after];
    }
    return heights;
  };
  const std::vector<double> parallel = heights_of(1.0, 0.0), inclined = heights_of(0.0, 1.0);
  if (!(std::abs(parallel[stop_]) > 0.0))
    throw std::invalid_argument("its stop lies at the focus of the surfaces before it");
  const double slope = std::tan(half_field_deg * std::numbers::pi / 180.0);
  const double height = -inclined[stop_] / parallel[stop_];
  std::vector<double> heights;
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    heights.push_back(slope * (height * parallel[i] + inclined[i]));
  return heights;
}

bool LensSystem::achromatic() const {
  return std::all_of(media_.begin(), media_.end(),
                     [](const IndexTable& index) { return index.achromatic(); });
}

void LensSystem::look_up_indices(double lambda_nm, std::span<double> n) const {
  for (std::size_t i = 0; i < media_.size(); ++i)
    n[i] = media_[i].at(lambda_nm);
}

std::vector<double> LensSystem::indices(double lambda_nm) const {
  std::vector<double> n(media_.size());
  look_up_indices(lambda_nm, n);
  return n;
}

ParaxialLens LensSystem::paraxial(double lambda_nm) const {
  const std::vector<double> n = indices(lambda_nm);
  // n' u' = n u - y c (n' - n) at a surface, y' = y + t u' behind it [BW99, 4.4].
  const auto follow = [&](double height, double slope, double& last_height, double& last_slope) {
    double vertex = 0.0;
    for (const Surface& s : surfaces_) {
      height += slope * (s.vertex - vertex);
      vertex = s.vertex;
      slope = (n[s.before] * slope -
               height * s.profile.vertex_curvature() * (n[s.after] - n[s.before])) /
              n[s.after];
    }
    last_height = height;
    last_slope = slope;
  };
  ParaxialLens lens;
  follow(1.0, 0.0, lens.a, lens.c);
  follow(0.0, 1.0, lens.b, lens.d);
  return lens;
}

/// Follows a ray through all surfaces in turn, from whichever side its direction says. `heights`,
/// unless empty, gets its distance from the axis at each surface it meets.
///
/// With z measured from the vertex, a sphere of curvature c is c (x^2 + y^2 + z^2) = 2 z. A ray
/// that passes the vertex's plane at (x, y) with direction (L, M, N) meets it at t with c t^2 - 2 G
/// t + F = 0, G = N - c (x L + y M), F = c (x^2 + y^2); of the two roots the one near the vertex is
/// F / (G +- sqrt(G^2 - c F)), and the square root is the cosine of incidence [Welford86, 4.3].
std::optional<LensRay> LensSystem::trace(const Ray& ray, std::span<const double> n, bool uncoated,
                                         std::span<double> heights) const {
  dvec3 p = ray.origin, d = ray.direction;
  const bool forward = d.z > 0.0;
  const double sign = forward ? 1.0 : -1.0;
  double transmittance = 1.0;
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const std::size_t i = forward ? k : surfaces_.size() - 1 - k;
    const Surface& s = surfaces_[i];
    if (!(sign * d.z > 0.0)) return std::nullopt;
    const double to_plane = (s.vertex - p.z) / d.z;
    const dvec3 q = {p.x + to_plane * d.x, p.y + to_plane * d.y, 0.0};
    const double c = s.curvature;
    double to_surface = 0.0, cos_i = 0.0;
    if (!s.aspheric) [[likely]] {
      const double g = sign * (d.z - c * (q.x * d.x + q.y * d.y));
      const double f = c * (q.x * q.x + q.y * q.y);
      const double square = g * g - c * f;
      if (!(square >= 0.0)) return std::nullopt;
      cos_i = std::sqrt(square);
      if (!(g + cos_i > 0.0)) return std::nullopt; // beyond the equator of the sphere
      to_surface = sign * f / (g + cos_i);
    } else {
      to_surface = meet_profile(s.profile, s.semi_diameter, q, d);
    }
    if (k > 0 && to_plane + to_surface < 0.0) return std::nullopt; // surfaces cross there
    const dvec3 local = q + to_surface * d;
    p = {local.x, local.y, local.z + s.vertex};
    const double height2 = p.x * p.x + p.y * p.y;
    if (!heights.empty()) heights[i] = std::sqrt(height2);
    if (height2 > s.semi_diameter * s.semi_diameter) return std::nullopt;
    const double n_i = n[forward ? s.before : s.after], n_t = n[forward ? s.after : s.before];
    if (n_i == n_t) continue;
    dvec3 normal = {c * local.x, c * local.y, c * local.z - 1.0};
    if (s.aspheric) [[unlikely]] {
      const double slope = 2.0 * s.profile.slope(height2);
      normal = glm::normalize(dvec3(slope * local.x, slope * local.y, -1.0));
      cos_i = -sign * glm::dot(normal, d);
      if (!(cos_i >= 0.0)) return std::nullopt; // it has met the surface from behind
    }
    const double eta = n_t / n_i;
    const auto cos_t = refracted_cosine(std::min(cos_i, 1.0), eta);
    if (!cos_t) return std::nullopt;
    if (uncoated) transmittance *= 1.0 - fresnel_reflectance(std::min(cos_i, 1.0), *cos_t, eta);
    d = refracted(d, sign * normal, cos_i, *cos_t, eta);
  }
  return LensRay{{p, d}, transmittance};
}

std::optional<LensRay> LensSystem::trace_from_film(const Ray& ray, std::span<const double> n,
                                                   bool uncoated) const {
  if (!(ray.direction.z < 0.0)) return std::nullopt;
  return trace(ray, n, uncoated, {});
}

std::optional<LensRay> LensSystem::trace_from_object(const Ray& ray, std::span<const double> n,
                                                     bool uncoated) const {
  if (!(ray.direction.z > 0.0)) return std::nullopt;
  return trace(ray, n, uncoated, {});
}

double LensSystem::entrance_pupil_diameter() const {
  const std::vector<double> n = indices(kLineD_nm);
  const double first = surfaces_.front().semi_diameter;
  const auto passes = [&](double height) {
    return trace_from_object(parallel_ray(height), n).has_value();
  };
  return 2.0 * (passes(first) ? first : largest(first, passes));
}

void LensSystem::set_entrance_pupil_diameter(double diameter) {
  const double widest = entrance_pupil_diameter();
  if (diameter > widest)
    throw std::invalid_argument(fmt::format("it opens to f/{:.2f} only, a beam of {:.4g} mm",
                                            paraxial(kLineD_nm).focal_length() / widest, widest));
  surfaces_[stop_].semi_diameter = marginal_heights(0.5 * diameter)[stop_];
}

} // namespace abbe
