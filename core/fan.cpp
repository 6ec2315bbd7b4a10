#include "core/fan.h"

#include "core/materials/fresnel.h"

#include <algorithm>
#include <cmath>

namespace abbe {

Fan::Fan(const Plan& plan, const World& world, double pixel_angle)
    : plan_(plan), world_(world), pixel_angle_(pixel_angle),
      band_rays_(static_cast<std::size_t>(plan.grid.count())) {}

void Fan::prepare(const Bundle& bundle, int first, int last, PathWavelengths& wavelengths) {
  incoming_ = &bundle;
  const Hit& hit = *bundle.hit;
  const dvec3& direction = bundle.state.ray.direction;
  facing_normal_ = hit.entering ? hit.normal : -hit.normal;
  cos_i_ = std::min(1.0, std::abs(glm::dot(direction, facing_normal_)));
  n_before_ = wavelengths.indices(hit.medium_before);
  n_after_ = wavelengths.indices(hit.medium_after);
  for (int b = first; b < last; ++b)
    band_rays_[static_cast<std::size_t>(b)].traced = false;
  cells_.clear();
  // Snell's law, differentiated: a small change of the incoming direction comes out scaled by
  // n_i cos i / (n_t cos t).
  const int middle = (first + last) / 2;
  const double eta = n_after_[middle] / n_before_[middle];
  const double cos_t = refracted_cosine(cos_i_, eta).value_or(0.0);
  position_spread_ = bundle.position_spread + bundle.direction_spread * hit.t;
  carried_direction_spread_ = bundle.direction_spread * cos_i_ / std::max(eta * cos_t, 1e-3);
}

RayState Fan::refracted_state(double n_before, double n_after) const {
  const Hit& hit = *incoming_->hit;
  const double eta = n_after / n_before;
  const double cos_t = refracted_cosine(cos_i_, eta).value_or(0.0);
  RayState state;
  state.ray.origin = hit.point;
  state.ray.direction =
      refracted(incoming_->state.ray.direction, facing_normal_, cos_i_, cos_t, eta);
  state.contacts = hit.other_side;
  state.nesting = hit.nesting_after;
  return state;
}

void Fan::trace_bands(RayCounts& counts) {
  packet_states_.clear();
  for (const int b : wanted_) {
    BandRay& ray = band_rays_[static_cast<std::size_t>(b)];
    ray.state = refracted_state(n_before_[b], n_after_[b]);
    packet_states_.push_back(ray.state);
  }
  packet_hits_.resize(wanted_.size());
  world_.closest(packet_states_, packet_hits_, plan_.settings.tracing);
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    BandRay& ray = band_rays_[static_cast<std::size_t>(wanted_[i])];
    ray.hit = packet_hits_[i];
    ray.traced = true;
  }
  counts.add(RayKind::refracted, packet_states_);
  wanted_.clear();
}

void Fan::add_band(int band, float weight) {
  FanCell& cell = cells_.emplace_back();
  cell.weight = weight;
  cell.bundle.first = band;
  cell.bundle.last = band + 1;
  cell.bundle.state = band_rays_[static_cast<std::size_t>(band)].state;
  cell.bundle.hit = band_rays_[static_cast<std::size_t>(band)].hit;
}

void Fan::add_shared(Range range, PathWavelengths& wavelengths) {
  const BandRay& a = band_rays_[static_cast<std::size_t>(range.first)];
  const BandRay& b = band_rays_[static_cast<std::size_t>(range.last - 1)];
  const Hit& hit = *incoming_->hit;
  FanCell& cell = cells_.emplace_back();
  cell.shared = true;
  cell.bundle.first = range.first;
  cell.bundle.last = range.last;
  cell.bundle.state =
      refracted_state(wavelengths.shared_index(hit.medium_before, range.first, range.last),
                      wavelengths.shared_index(hit.medium_after, range.first, range.last));
  cell.bundle.position_spread = position_spread_;
  cell.bundle.direction_spread =
      carried_direction_spread_ + glm::distance(a.state.ray.direction, b.state.ray.direction);
}

void Fan::add_undivided(Range range) {
  FanCell& cell = cells_.emplace_back();
  cell.shared = true;
  cell.bundle.first = range.first;
  cell.bundle.last = range.last;
  cell.bundle.state = refracted_state(n_before_[range.first], n_after_[range.first]);
  cell.bundle.position_spread = position_spread_;
  cell.bundle.direction_spread = carried_direction_spread_;
}

/// A band that shares another's ray into a denser medium meets the parallel face behind it with
/// sin = sin(i) / n_shared; it can only leave there while n_own sin < 1. True when all of the
/// range's bands can, so that none is caught inside where its own ray would not have been.
bool Fan::all_would_leave(Range range) const {
  const double a = n_after_[range.first] / n_before_[range.first];
  const double b = n_after_[range.last - 1] / n_before_[range.last - 1];
  const double ratio = std::min(a, b) / std::max(a, b);
  return cos_i_ * cos_i_ > 1.0 - ratio * ratio;
}

/// Rays of the outermost bands of the range are traced already.
bool Fan::may_share(Range range) const {
  if (!all_would_leave(range)) return false;
  const BandRay& a = band_rays_[static_cast<std::size_t>(range.first)];
  const BandRay& b = band_rays_[static_cast<std::size_t>(range.last - 1)];
  const double tolerance = plan_.settings.tolerance_pixels * pixel_angle_;
  const double parted =
      carried_direction_spread_ + glm::distance(a.state.ray.direction, b.state.ray.direction);
  if (!a.hit && !b.hit) return parted <= tolerance;
  if (!a.hit || !b.hit || a.hit->shape != b.hit->shape || a.hit->face != b.hit->face) return false;
  // A path that goes on from there takes the parted directions along, over ways not known yet.
  const MaterialPlan& material = plan_.materials[a.hit->material.index()];
  if ((material.reflects || material.transmits) && parted > tolerance) return false;
  const double way = std::max(a.hit->t, b.hit->t);
  const double spread = position_spread_ + carried_direction_spread_ * way +
                        glm::distance(a.hit->point, b.hit->point);
  return spread <= tolerance * (incoming_->path_length + incoming_->hit->t + way);
}

void Fan::want(int band) {
  BandRay& ray = band_rays_[static_cast<std::size_t>(band)];
  if (ray.traced) return;
  ray.traced = true;
  wanted_.push_back(band);
}

/// How many sub-bundles of a range may be followed. The noise of a branch kept as m of them goes as
/// importance^2 / m and its cost as m, so the least noise for a given cost is had with m in
/// proportion to importance.
std::size_t Fan::sub_bundles_allowed(Range range, double importance) const {
  const double bands = range.last - range.first;
  if (plan_.follows_all()) return static_cast<std::size_t>(bands);
  const double live = std::max(plan_.live_count, 1);
  const double share = plan_.settings.max_fan * bands / live * std::min(importance, 1.0);
  return static_cast<std::size_t>(std::max(1.0, std::round(share)));
}

/// The rule where no pixel's width says what is close together: equal parts, as many as allowed.
void Fan::cut(Range whole, double importance) {
  const int bands = whole.last - whole.first;
  const int parts = std::min(static_cast<int>(sub_bundles_allowed(whole, importance)), bands);
  strata_.clear();
  for (int i = 0; i < parts; ++i)
    strata_.push_back({whole.first + bands * i / parts, whole.first + bands * (i + 1) / parts});
}

/// Halves ranges of bands, all of one size before the next smaller, until each may share a ray or
/// the path's share of sub-bundles is used up.
void Fan::part(Range whole, double importance, PathWavelengths& wavelengths, RayCounts& counts) {
  const std::size_t most = sub_bundles_allowed(whole, importance);
  strata_.clear();
  ranges_.assign(1, whole);
  while (!ranges_.empty()) {
    for (const Range& r : ranges_) {
      want(r.first);
      want(r.last - 1);
    }
    trace_bands(counts);
    next_ranges_.clear();
    std::size_t waiting = ranges_.size();
    for (const Range& r : ranges_) {
      --waiting;
      if (r.last - r.first == 1) {
        add_band(r.first, 1.0f);
      } else if (may_share(r)) {
        add_shared(r, wavelengths);
      } else if (cells_.size() + strata_.size() + next_ranges_.size() + waiting + 2 > most) {
        strata_.push_back(r);
      } else {
        const int middle = r.first + (r.last - r.first) / 2;
        next_ranges_.push_back({r.first, middle});
        next_ranges_.push_back({middle, r.last});
      }
    }
    std::swap(ranges_, next_ranges_);
  }
}

/// Of each range that could not be parted further one band goes on for all, with equal chances.
void Fan::keep_one_of_each_stratum(double choice, RayCounts& counts) {
  const auto kept = [&](const Range& r) {
    const int size = r.last - r.first;
    return r.first + std::min(static_cast<int>(choice * size), size - 1);
  };
  for (const Range& r : strata_)
    want(kept(r));
  trace_bands(counts);
  for (const Range& r : strata_)
    add_band(kept(r), static_cast<float>(r.last - r.first));
}

void Fan::trace_shared_cells(RayCounts& counts) {
  packet_states_.clear();
  for (const FanCell& cell : cells_)
    if (cell.shared) packet_states_.push_back(cell.bundle.state);
  packet_hits_.resize(packet_states_.size());
  world_.closest(packet_states_, packet_hits_, plan_.settings.tracing);
  counts.add(RayKind::refracted, packet_states_);
  std::size_t next = 0;
  for (FanCell& cell : cells_)
    if (cell.shared) cell.bundle.hit = packet_hits_[next++];
}

const std::vector<FanCell>& Fan::refract(const Bundle& bundle, int first, int last,
                                         double importance, PathWavelengths& wavelengths,
                                         double choice, RayCounts& counts) {
  prepare(bundle, first, last, wavelengths);
  const Hit& hit = *bundle.hit;
  const auto achromatic = [&](MediumId id) { return plan_.medium(id).index.achromatic(); };
  if (achromatic(hit.medium_before) && achromatic(hit.medium_after)) {
    add_undivided({first, last});
  } else if (plan_.settings.exact) {
    for (int b = first; b < last; ++b)
      want(b);
    trace_bands(counts);
    for (int b = first; b < last; ++b)
      add_band(b, 1.0f);
  } else {
    if (bundle.spread)
      cut({first, last}, importance);
    else
      part({first, last}, importance, wavelengths, counts);
    keep_one_of_each_stratum(choice, counts);
  }
  trace_shared_cells(counts);
  for (FanCell& cell : cells_) {
    cell.bundle.depth = bundle.depth + 1;
    cell.bundle.spread = bundle.spread;
    cell.bundle.spreads = bundle.spreads;
    cell.bundle.first_spread = bundle.first_spread;
    cell.bundle.path_length = bundle.path_length + hit.t;
  }
  return cells_;
}

} // namespace abbe
