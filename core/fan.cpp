#include "core/fan.h"

#include "core/materials/fresnel.h"

#include <algorithm>
#include <cmath>

namespace abbe {

Fan::Fan(const Plan& plan, const World& world, double pixel_angle)
    : plan_(plan), world_(world), pixel_angle_(pixel_angle),
      states_(2 * static_cast<std::size_t>(plan.grid.count())), hits_(states_.size()),
      ray_of_band_(static_cast<std::size_t>(plan.grid.count())) {}

void Fan::prepare(const Bundle& bundle, int first, int last, PathWavelengths& wavelengths) {
  incoming_ = &bundle;
  const Hit& hit = bundle.hit;
  const dvec3& direction = bundle.state.ray.direction;
  facing_normal_ = hit.entering ? hit.normal : -hit.normal;
  cos_i_ = std::min(1.0, std::abs(glm::dot(direction, facing_normal_)));
  n_before_ = wavelengths.indices(hit.medium_before);
  n_after_ = wavelengths.indices(hit.medium_after);
  std::fill(ray_of_band_.begin() + first, ray_of_band_.begin() + last, -1);
  ray_count_ = traced_count_ = 0;
  cells_.clear();
  // Snell's law, differentiated: a small change of the incoming direction comes out scaled by
  // n_i cos i / (n_t cos t).
  const int middle = (first + last) / 2;
  const double eta = n_after_[middle] / n_before_[middle];
  const double cos_t = refracted_cosine(cos_i_, eta).value_or(0.0);
  position_spread_ = bundle.position_spread + bundle.direction_spread * hit.t;
  carried_direction_spread_ = bundle.direction_spread * cos_i_ / std::max(eta * cos_t, 1e-3);
}

/// The incoming ray refracted; its number.
std::size_t Fan::add_ray(double n_before, double n_after) {
  const Hit& hit = incoming_->hit;
  const double eta = n_after / n_before;
  const double cos_t = refracted_cosine(cos_i_, eta).value_or(0.0);
  RayState& state = states_[ray_count_];
  state.ray.origin = hit.point;
  state.ray.direction =
      refracted(incoming_->state.ray.direction, facing_normal_, cos_i_, cos_t, eta);
  state.contacts = hit.other_side;
  state.nesting = hit.nesting_after;
  return ray_count_++;
}

const dvec3& Fan::direction_of(int band) const {
  return states_[static_cast<std::size_t>(ray_of_band_[static_cast<std::size_t>(band)])]
      .ray.direction;
}

const Hit& Fan::hit_of(int band) const {
  return hits_[static_cast<std::size_t>(ray_of_band_[static_cast<std::size_t>(band)])];
}

void Fan::want(int band) {
  int& ray = ray_of_band_[static_cast<std::size_t>(band)];
  if (ray < 0) ray = static_cast<int>(add_ray(n_before_[band], n_after_[band]));
}

void Fan::trace_new_rays(RayCounts& counts) {
  if (traced_count_ == ray_count_) return;
  const std::size_t count = ray_count_ - traced_count_;
  const auto states = std::span(states_).subspan(traced_count_, count);
  world_.find_closest(states, std::span(hits_).subspan(traced_count_, count),
                      plan_.settings.tracing);
  counts.add(RayKind::refracted, states);
  traced_count_ = ray_count_;
}

void Fan::add_band(int band, float weight) {
  const auto ray = static_cast<std::size_t>(ray_of_band_[static_cast<std::size_t>(band)]);
  cells_.push_back({band, band + 1, weight, false, &states_[ray], &hits_[ray]});
}

FanCell& Fan::add_shared_ray(BandRange range, double n_before, double n_after) {
  const std::size_t ray = add_ray(n_before, n_after);
  return cells_.emplace_back(FanCell{range.first, range.last, 1.0f, true, &states_[ray],
                                     &hits_[ray], position_spread_, carried_direction_spread_});
}

void Fan::add_shared(BandRange range, PathWavelengths& wavelengths) {
  const Hit& hit = incoming_->hit;
  const double parted = glm::distance(direction_of(range.first), direction_of(range.last - 1));
  add_shared_ray(range, wavelengths.shared_index(hit.medium_before, range.first, range.last),
                 wavelengths.shared_index(hit.medium_after, range.first, range.last))
      .direction_spread += parted;
}

void Fan::add_undivided(BandRange range) {
  add_shared_ray(range, n_before_[range.first], n_after_[range.first]);
}

/// A band that shares another's ray into a denser medium meets the parallel face behind it with
/// sin = sin(i) / n_shared; it can only leave there while n_own sin < 1. True when all of the
/// range's bands can, so that none is caught inside where its own ray would not have been.
bool Fan::all_would_leave(BandRange range) const {
  const double a = n_after_[range.first] / n_before_[range.first];
  const double b = n_after_[range.last - 1] / n_before_[range.last - 1];
  const double ratio = std::min(a, b) / std::max(a, b);
  return cos_i_ * cos_i_ > 1.0 - ratio * ratio;
}

/// Rays of the outermost bands of the range are traced already.
bool Fan::may_share(BandRange range) const {
  if (!all_would_leave(range)) return false;
  const Hit &a = hit_of(range.first), &b = hit_of(range.last - 1);
  const double tolerance = plan_.settings.tolerance_pixels * pixel_angle_;
  const double parted = carried_direction_spread_ +
                        glm::distance(direction_of(range.first), direction_of(range.last - 1));
  if (!a.met() && !b.met()) return parted <= tolerance;
  if (!a.met() || a.shape != b.shape || a.face != b.face) return false;
  // A path that goes on from there takes the parted directions along, over ways not known yet.
  const MaterialPlan& material = plan_.materials[a.material.index()];
  if ((material.reflects || material.transmits) && parted > tolerance) return false;
  const double way = std::max(a.t, b.t);
  const double spread =
      position_spread_ + carried_direction_spread_ * way + glm::distance(a.point, b.point);
  return spread <= tolerance * (incoming_->path_length + incoming_->hit.t + way);
}

/// How many sub-bundles of a range may be followed. The noise of a branch kept as m of them goes as
/// importance^2 / m and its cost as m, so the least noise for a given cost is had with m in
/// proportion to importance.
std::size_t Fan::sub_bundles_allowed(BandRange range, double importance) const {
  const double bands = range.size();
  if (plan_.follows_all()) return static_cast<std::size_t>(bands);
  const double live = std::max(plan_.live_count, 1);
  const double share = plan_.settings.max_fan * bands / live * std::min(importance, 1.0);
  return static_cast<std::size_t>(std::max(1.0, std::round(share)));
}

/// The rule where no pixel's width says what is close together: equal parts, as many as allowed.
void Fan::cut(BandRange whole, double importance) {
  const int bands = whole.size();
  const int parts = std::min(static_cast<int>(sub_bundles_allowed(whole, importance)), bands);
  strata_.clear();
  for (int i = 0; i < parts; ++i)
    strata_.push_back({whole.first + bands * i / parts, whole.first + bands * (i + 1) / parts});
}

/// Halves ranges of bands, all of one size before the next smaller, until each may share a ray or
/// the path's share of sub-bundles is used up.
void Fan::part(BandRange whole, double importance, PathWavelengths& wavelengths,
               RayCounts& counts) {
  const std::size_t most = sub_bundles_allowed(whole, importance);
  strata_.clear();
  ranges_.assign(1, whole);
  while (!ranges_.empty()) {
    for (const BandRange& r : ranges_) {
      want(r.first);
      want(r.last - 1);
    }
    trace_new_rays(counts);
    next_ranges_.clear();
    std::size_t waiting = ranges_.size();
    for (const BandRange& r : ranges_) {
      --waiting;
      if (r.size() == 1) {
        add_band(r.first, 1.0f);
      } else if (may_share(r)) {
        add_shared(r, wavelengths);
      } else if (cells_.size() + strata_.size() + next_ranges_.size() + waiting + 2 > most) {
        strata_.push_back(r);
      } else {
        const int middle = r.first + (r.size()) / 2;
        next_ranges_.push_back({r.first, middle});
        next_ranges_.push_back({middle, r.last});
      }
    }
    std::swap(ranges_, next_ranges_);
  }
}

/// Of each range that could not be parted further one band goes on for all, with equal chances.
void Fan::keep_one_of_each_stratum(double choice) {
  const auto kept = [&](const BandRange& r) {
    const int size = r.size();
    return r.first + std::min(static_cast<int>(choice * size), size - 1);
  };
  for (const BandRange& r : strata_) {
    want(kept(r));
    add_band(kept(r), static_cast<float>(r.size()));
  }
}

const std::vector<FanCell>& Fan::refract(const Bundle& bundle, int first, int last,
                                         double importance, PathWavelengths& wavelengths,
                                         double choice, RayCounts& counts) {
  prepare(bundle, first, last, wavelengths);
  const auto achromatic = [&](MediumId id) { return plan_.medium(id).index.achromatic(); };
  if (achromatic(bundle.hit.medium_before) && achromatic(bundle.hit.medium_after)) {
    add_undivided({first, last});
  } else if (plan_.settings.exact) {
    for (int b = first; b < last; ++b) {
      want(b);
      add_band(b, 1.0f);
    }
  } else {
    if (bundle.spread)
      cut({first, last}, importance);
    else
      part({first, last}, importance, wavelengths, counts);
    keep_one_of_each_stratum(choice);
  }
  trace_new_rays(counts);
  return cells_;
}

void go_on_as(const FanCell& cell, const Bundle& bundle, Bundle& next) {
  next.first = cell.first;
  next.last = cell.last;
  next.path_length = bundle.path_length + bundle.hit.t;
  next.state = *cell.state;
  next.hit = *cell.hit;
  next.depth = bundle.depth + 1;
  next.passed = 0.0;
  next.density = 0.0;
  next.spreads = bundle.spreads;
  next.first_spread = bundle.first_spread;
  next.spread = bundle.spread;
  next.position_spread = cell.position_spread;
  next.direction_spread = cell.direction_spread;
}

} // namespace abbe
