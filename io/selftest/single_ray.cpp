#include "io/selftest/single_ray.h"

#include "core/optics/fresnel.h"

#include <stdexcept>

namespace abbe {

RayState refracted_at(const Hit& hit, const Ray& ray, double n_before, double n_after) {
  const dvec3 facing = hit.entering ? hit.normal : -hit.normal;
  const double cos_i = -glm::dot(ray.direction, facing);
  const double eta = n_after / n_before;
  const auto cos_t = refracted_cosine(cos_i, eta);
  if (!cos_t) throw std::runtime_error("total internal reflection");
  return hit.going_on(refracted(ray.direction, facing, cos_i, *cos_t, eta), true);
}

SingleRay refracted_through(const World& world, const Ray& ray, double n) {
  return refracted_through(world, ray, [n](MediumId id) { return id.valid() ? n : 1.0; });
}

} // namespace abbe
