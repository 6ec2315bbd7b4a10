#include "core/integrators/bundle_walk.h"

#include "core/bands/band_math.h"
#include "core/optics/fresnel.h"
#include "core/scattering/surface_finish.h"

#include <algorithm>

namespace abbe {
namespace {

/// Paths are ended at random from this many surfaces on; before, nearly all carry much.
constexpr int kSureSurfaces = 5;

} // namespace

BundleWalk::BundleWalk(const Plan& plan, const World& world, double pixel_angle,
                       Transport transport)
    : plan_(plan), world_(world), wavelengths_(plan), fan_(plan, world, pixel_angle),
      scattering_(plan, transport), ones_(1.0f, plan.grid.count()), throughput_(plan.stride),
      transport_(transport), textured_(0.0f, plan.grid.count()) {}

void BundleWalk::begin(const Sampler& sampler, RayCounts& counts) {
  sampler_ = &sampler;
  counts_ = &counts;
  if (!plan_.disperses) { // the place inside the bands and the choice of bands have no effect
    wavelengths_.begin_path(0.5);
    return;
  }
  const dvec2 u = sampler.pair(kWavelength);
  wavelengths_.begin_path(plan_.settings.jitter ? u.x : 0.5);
  band_choice_ = u.y;
}

dvec2 BundleWalk::numbers(SamplePurpose purpose) const {
  return sampler_->pair(purpose + kPerSurface * static_cast<std::uint32_t>(bundle_.depth));
}

const MaterialPlan& BundleWalk::find_material() {
  material_ = &plan_.materials[bundle_.hit.material.index()];
  if (material_->mixture) material_ = &part_of(plan_, *material_, numbers(kSurfaceChoice).y);
  return *material_;
}

void BundleWalk::prepare_scattering() {
  const Hit& hit = bundle_.hit;
  scattering_.prepare(*material_, diffuse_at(plan_, world_, *material_, hit, textured_), hit,
                      bundle_.state.ray.direction, bundle_.first, bundle_.last, throughput_.data(),
                      wavelengths_);
}

Bundle& BundleWalk::push(int first, int last, const float* factors, double weight) {
  const auto w = static_cast<float>(weight);
  if (waiting_.size() == waiting_count_) {
    waiting_.emplace_back();
    throughputs_.resize(waiting_.size() * plan_.stride);
  }
  float* target = throughputs_.data() + waiting_count_ * plan_.stride;
  for (int b = first; b < last; ++b)
    target[b] = throughput_[static_cast<std::size_t>(b)] * factors[b] * w;
  Bundle& next = waiting_[waiting_count_++];
  next.first = first;
  next.last = last;
  return next;
}

bool BundleWalk::resume() {
  if (waiting_count_ == 0) return false;
  bundle_ = waiting_[--waiting_count_];
  const float* stored = throughputs_.data() + waiting_count_ * plan_.stride;
  std::copy(stored + bundle_.first, stored + bundle_.last, throughput_.begin() + bundle_.first);
  return true;
}

void BundleWalk::scale(const float* factors, double weight) {
  const auto w = static_cast<float>(weight);
  for (int b = bundle_.first; b < bundle_.last; ++b)
    throughput_[static_cast<std::size_t>(b)] *= factors[b] * w;
}

/// What the bundle would bring behind its hit: the largest throughput of its bands. Radiance, but
/// not flux, is n^2 times that outside in a medium of index n.
double BundleWalk::importance(MediumId medium) {
  const int first = bundle_.first, last = bundle_.last;
  const auto most = static_cast<double>(largest_of(throughput_.data(), first, last));
  if (transport_ == Transport::flux || !medium.valid()) return most;
  const double n = wavelengths_.indices(medium)[std::max(first, plan_.live_first)];
  return most * n * n;
}

double BundleWalk::share(MediumId medium) {
  return importance(medium) * plan_.shares.of({bundle_.first, bundle_.last});
}

/// Russian roulette on the importance.
bool BundleWalk::survives(MediumId medium) {
  if (bundle_.depth < kSureSurfaces) return true;
  const double chance = importance(medium);
  if (chance >= 1.0) return true;
  if (!(numbers(kScatter).y < chance)) return false;
  scale(ones_.data(), 1.0 / chance);
  return true;
}

void BundleWalk::trace_from(const Bundle& from, const dvec3& direction, bool through, RayKind kind,
                            Bundle& next) {
  set_off(from, direction, through, next);
  world_.find_closest(next.state, next.hit);
  counts_->add(kind, next.state);
}

bool BundleWalk::leave(const dvec3& direction, bool through, RayKind kind) {
  if (!survives(through ? bundle_.hit.medium_after : bundle_.hit.medium_before)) return false;
  trace_from(bundle_, direction, through, kind, bundle_);
  return true;
}

dvec3 BundleWalk::reflected_direction() const {
  const Hit& hit = bundle_.hit;
  return reflected(bundle_.state.ray.direction, hit.entering ? hit.normal : -hit.normal);
}

bool BundleWalk::reflect(double chance) {
  scale(scattering_.reflected(), 1.0 / chance);
  bundle_.density = 0.0;
  return leave(reflected_direction(), false, RayKind::reflected);
}

void BundleWalk::branch_off_reflection(double chance) {
  Bundle& next = push(bundle_.first, bundle_.last, scattering_.reflected(), 1.0 / chance);
  next.density = 0.0;
  trace_from(bundle_, reflected_direction(), false, RayKind::reflected, next);
}

bool BundleWalk::spread(const dvec3& direction, const float* f_cos, double density, double weight) {
  const Hit& hit = bundle_.hit;
  scale(f_cos, weight / density);
  bundle_.density = density;
  bundle_.spread = true;
  if (bundle_.spreads++ == 0) bundle_.first_spread = bundle_.depth;
  bundle_.position_spread = bundle_.direction_spread = 0.0;
  const bool outwards = glm::dot(direction, hit.normal) > 0.0;
  return leave(direction, outwards != hit.entering, RayKind::spread);
}

/// The fan's sub-bundles wait for their turns; the last goes on at once.
bool BundleWalk::refract(double chance) {
  scale(scattering_.transmitted(), 1.0 / chance);
  if (!survives(bundle_.hit.medium_after)) return false;
  const double brought = importance(bundle_.hit.medium_after);
  // Bands under total reflection, and those without power, have no refracted ray. What remains is
  // one run of bands as a rule, and more where n(lambda) turns.
  const auto run_from = [&](int band) {
    const auto passes = [&](int b) { return throughput_[static_cast<std::size_t>(b)] > 0.0f; };
    BandRange run{band, band};
    while (run.first < bundle_.last && !passes(run.first))
      ++run.first;
    run.last =
        all_above_zero(throughput_.data(), run.first, bundle_.last) ? bundle_.last : run.first;
    while (run.last < bundle_.last && passes(run.last))
      ++run.last;
    return run;
  };
  BandRange run = run_from(bundle_.first);
  if (run.empty()) return false;
  for (;;) {
    const BandRange next = run_from(run.last);
    const auto& cells =
        fan_.refract(bundle_, run.first, run.last, brought, wavelengths_, band_choice_, *counts_);
    const std::size_t waiting = next.empty() ? cells.size() - 1 : cells.size();
    for (std::size_t i = 0; i < waiting; ++i)
      go_on_as(cells[i], bundle_,
               push(cells[i].first, cells[i].last, ones_.data(), cells[i].weight));
    if (next.empty()) {
      go_on_as(cells.back(), bundle_, bundle_);
      scale(ones_.data(), cells.back().weight);
      return true;
    }
    run = next;
  }
}

} // namespace abbe
