#include "core/integrators/random_walk.h"

#include "core/bands/passing_runs.h"
#include "core/integrators/straight_on.h"
#include "core/integrators/tree_growth.h"
#include "core/scattering/hit_material.h"

namespace abbe {
namespace {

/// Paths are ended at random from this many surfaces on; before, nearly all carry much.
constexpr int kSureSurfaces = 5;

} // namespace

RandomWalk::RandomWalk(const Plan& plan, const World& world, double pixel_angle,
                       Transport transport)
    : BundleWalk(plan, world, pixel_angle, transport), scattering_(plan, transport),
      textured_(0.0f, plan.grid.count()) {}

void RandomWalk::begin(const Sampler& sampler, RayCounts& counts) {
  sampler_ = &sampler;
  // Without dispersion the place inside the bands and the choice of bands have no effect.
  begin_path(plan_.disperses ? sampler.pair(kWavelength) : dvec2(0.5, 0.0), counts);
}

dvec2 RandomWalk::numbers(SamplePurpose purpose) const {
  // At a pane too something is chosen, and the next surface must not choose by the same numbers.
  const auto surfaces = static_cast<std::uint32_t>(bundle().surfaces());
  return sampler_->pair(purpose + kPerSurface * surfaces);
}

const MaterialPlan& RandomWalk::find_material() {
  material_ = &plan_.materials[bundle().hit.material.index()];
  if (material_->mixture) material_ = &part_of(plan_, *material_, numbers(kMixture).y);
  return *material_;
}

void RandomWalk::prepare_scattering() {
  const Hit& hit = bundle().hit;
  scattering_.prepare(*material_, diffuse_at(plan_, world_, *material_, hit, textured_), hit,
                      bundle().state.ray.direction, throughput(), wavelengths_);
}

/// Russian roulette on what the bundle would bring from a medium.
bool RandomWalk::survives(MediumId medium) {
  if (bundle().depth < kSureSurfaces) return true;
  const double chance = importance(medium) / path_growth(bundle().surfaces());
  if (chance >= 1.0) return true;
  if (!(numbers(kScatter).y < chance)) return false;
  scale(ones_.data(), 1.0 / chance);
  return true;
}

void RandomWalk::go_on(const dvec3& direction, bool through, RayKind kind, double pdf) {
  if (!survives(through ? bundle().hit.medium_after : bundle().hit.medium_before)) return;
  const Route route = route_on(through);
  set_off(bundle(), direction, through, kind, bundle());
  bundle().route = route;
  bundle().pdf = pdf;
  wait();
}

void RandomWalk::reflect(double chance) {
  scale(scattering_.reflected(), reflected_adjoint() / chance);
  go_on(reflected_direction(), false, RayKind::reflected, 0.0);
}

void RandomWalk::pass(double chance) {
  scale(scattering_.transmitted(), 1.0 / chance);
  if (!survives(bundle().hit.medium_after)) return;
  ++bundle().panes;
  go_straight_on(bundle());
  wait();
}

void RandomWalk::scatter(const dvec3& direction, const float* f_cos, double pdf, double weight) {
  scale(f_cos, weight / pdf);
  Bundle& b = bundle();
  b.has_pixel_footprint = false;
  if (b.nonspecular_bounces++ == 0) b.first_nonspecular_depth = b.depth;
  b.separation = b.divergence = 0.0;
  const bool outwards = glm::dot(direction, b.hit.normal) > 0.0;
  go_on(direction, outwards != b.hit.entering, RayKind::scattered, pdf);
}

void RandomWalk::refract(double chance) {
  scale(scattering_.transmitted(), 1.0 / chance);
  const MediumId behind = bundle().hit.medium_after;
  if (!survives(behind)) return;
  const double brought = importance(behind);
  for (const BandRange run : PassingRuns(throughput()))
    branch_off_refraction(run, brought);
}

} // namespace abbe
