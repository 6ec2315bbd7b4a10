#include "core/bundles/fan.h"

#include "core/optics/fresnel.h"
#include "core/optics/shading_side.h"

#include <algorithm>
#include <cmath>

namespace abbe {

Fan::Fan(const Plan& plan, const World& world, double pixel_angle)
    : plan_(plan), world_(world), tolerance_(plan.settings.tolerance_pixels * pixel_angle),
      directions_(static_cast<std::size_t>(plan.grid.count())),
      states_(2 * static_cast<std::size_t>(plan.grid.count())), hits_(states_.size()),
      ray_of_band_(static_cast<std::size_t>(plan.grid.count())) {}

void Fan::prepare(const Bundle& bundle, BandRange bands, PathWavelengths& wavelengths) {
  incoming_ = &bundle;
  ++boundary_;
  const Hit& hit = bundle.hit;
  const dvec3& direction = bundle.state.ray.direction;
  facing_normal_ = hit.facing_shading_normal();
  cos_i_ = std::min(1.0, std::abs(glm::dot(direction, facing_normal_)));
  n_before_ = wavelengths.indices(hit.medium_before);
  n_after_ = wavelengths.indices(hit.medium_after);
  std::fill(ray_of_band_.begin() + bands.first, ray_of_band_.begin() + bands.last, -1);
  ray_count_ = traced_count_ = 0;
  cells_.clear();
  // Snell's law, differentiated: a small change of the incoming direction comes out scaled by
  // n_i cos i / (n_t cos t).
  const int middle = (bands.first + bands.last) / 2;
  const double eta = n_after_[middle] / n_before_[middle];
  const double cos_t = refracted_cosine(cos_i_, eta).value_or(0.0);
  separation_ = bundle.separation + bundle.divergence * hit.t;
  divergence_ = bundle.divergence * cos_i_ / std::max(eta * cos_t, 1e-3);
}

/// The direction of a band's own ray.
const dvec3& Fan::refracted_direction(int band) {
  BandDirection& kept = directions_[static_cast<std::size_t>(band)];
  if (kept.boundary != boundary_) {
    kept.boundary = boundary_;
    kept.direction = refracted_direction(n_before_[band], n_after_[band]);
  }
  return kept.direction;
}

dvec3 Fan::refracted_direction(double n_before, double n_after) const {
  const double eta = n_after / n_before;
  const double cos_t = refracted_cosine(cos_i_, eta).value_or(0.0);
  const dvec3 direction =
      refracted(incoming_->state.ray.direction, facing_normal_, cos_i_, cos_t, eta);
  if (incoming_->hit.bent) [[unlikely]]
    return kept_on_side(direction, incoming_->hit.facing_normal(), false);
  return direction;
}

double Fan::adjoint_of(double n_before, double n_after) const {
  const double eta = n_after / n_before;
  const double cos_t = refracted_cosine(cos_i_, eta).value_or(0.0);
  const dvec3& from = incoming_->state.ray.direction;
  return adjoint_factor(from, refracted(from, facing_normal_, cos_i_, cos_t, eta), facing_normal_,
                        incoming_->hit.normal);
}

/// Adds a ray that goes on behind the hit, and returns its number.
std::size_t Fan::add_ray(const dvec3& direction) {
  const Hit& hit = incoming_->hit;
  RayState& state = states_[ray_count_];
  state.ray.origin = hit.point;
  state.ray.direction = direction;
  hit.go_on(true, state.contacts, state.nesting);
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
  if (ray < 0) ray = static_cast<int>(add_ray(refracted_direction(band)));
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
  cells_.push_back({{band, band + 1}, weight, false, &states_[ray], &hits_[ray]});
  if (incoming_->hit.bent) [[unlikely]]
    cells_.back().adjoint = adjoint_of(n_before_[band], n_after_[band]);
}

FanCell& Fan::add_shared_ray(BandRange range, double n_before, double n_after) {
  const std::size_t ray = add_ray(refracted_direction(n_before, n_after));
  FanCell& cell = cells_.emplace_back(
      FanCell{range, 1.0f, true, &states_[ray], &hits_[ray], separation_, divergence_});
  if (incoming_->hit.bent) [[unlikely]]
    cell.adjoint = adjoint_of(n_before, n_after);
  return cell;
}

void Fan::add_shared(BandRange range, PathWavelengths& wavelengths) {
  const Hit& hit = incoming_->hit;
  const double parted = glm::distance(direction_of(range.first), direction_of(range.last - 1));
  add_shared_ray(range, wavelengths.shared_index(hit.medium_before, range),
                 wavelengths.shared_index(hit.medium_after, range))
      .divergence += parted;
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

/// A path that meets something that mirrors or refracts takes parted directions along, over
/// distances that are not known yet.
bool Fan::goes_on_behind(const Hit& hit) const {
  return plan_.materials[hit.material.index()].facts().goes_on();
}

/// The angle between the rays of the outermost bands, with what earlier surfaces have done.
double Fan::parted(BandRange range) {
  return divergence_ +
         glm::distance(refracted_direction(range.first), refracted_direction(range.last - 1));
}

/// Requires that rays of the outermost bands of the range have been traced.
bool Fan::may_share(BandRange range) const {
  if (!all_would_leave(range)) return false;
  const Hit &a = hit_of(range.first), &b = hit_of(range.last - 1);
  const double apart =
      divergence_ + glm::distance(direction_of(range.first), direction_of(range.last - 1));
  if (!a.met() && !b.met()) return apart <= tolerance_;
  if (!a.met() || a.shape != b.shape || a.face != b.face) return false;
  if (goes_on_behind(a) && apart > tolerance_) return false;
  const double length = std::max(a.t, b.t);
  const double separation = separation_ + divergence_ * length + glm::distance(a.point, b.point);
  return separation <= tolerance_ * (incoming_->path_length + incoming_->hit.t + length);
}

/// How many sub-bundles of a range may be followed. The noise of a branch kept as m of them goes as
/// importance^2 / m and its cost as m, so a given cost leaves the least noise with m in proportion
/// to importance.
std::size_t Fan::sub_bundles_allowed(BandRange range) const {
  if (plan_.follows_all()) return static_cast<std::size_t>(range.size());
  const double share =
      plan_.settings.max_fan * plan_.shares.of(range) * std::min(limits_.importance, 1.0);
  return static_cast<std::size_t>(std::max(1.0, std::round(share)));
}

/// The rule where no pixel's width says what is close together: it cuts the bands into equal parts,
/// as many as are allowed.
void Fan::cut(BandRange whole) {
  const int parts = std::min(static_cast<int>(sub_bundles_allowed(whole)), whole.size());
  strata_.clear();
  for (BandRange rest = whole; !rest.empty();) {
    const int left = parts - static_cast<int>(strata_.size());
    const int end = left > 1 && rest.size() > 1 ? plan_.shares.place(rest, 1.0 / left) : rest.last;
    strata_.push_back({rest.first, end});
    rest.first = end;
  }
}

/// Where as many ranges as are allowed are still too far parted in direction, and the rays of
/// the bands that are kept of them find nothing on which they could end, no range may be shared:
/// the rays that would prove it need not be traced. Fills `strata_` then.
bool Fan::part_by_directions(BandRange whole, std::size_t most, RayCounts& counts) {
  strata_.assign(1, whole);
  for (std::size_t i = 0; strata_.size() < most && i < strata_.size();) {
    const BandRange r = strata_[i];
    if (r.size() == 1) {
      ++i;
      continue;
    }
    if (parted(r) <= tolerance_) return false;
    const int middle = plan_.shares.middle(r);
    strata_.erase(strata_.begin() + static_cast<std::ptrdiff_t>(i));
    strata_.push_back({r.first, middle});
    strata_.push_back({middle, r.last});
  }
  for (const BandRange& r : strata_)
    if (r.size() > 1 && parted(r) <= tolerance_) return false;
  for (const BandRange& r : strata_)
    want(plan_.shares.keep_one(r, limits_.choice).band);
  trace_new_rays(counts);
  return std::all_of(strata_.begin(), strata_.end(), [&](const BandRange& r) {
    const Hit& hit = hit_of(plan_.shares.keep_one(r, limits_.choice).band);
    return !hit.met() || goes_on_behind(hit);
  });
}

/// Rays of the outermost bands of each range, traced together, tell whether it may share one.
struct Fan::Judge {
  Fan& fan;
  RayCounts& counts;

  void prepare(std::span<const BandRange> ranges) {
    for (const BandRange& r : ranges) {
      fan.want(r.first);
      fan.want(r.last - 1);
    }
    fan.trace_new_rays(counts);
  }
  [[nodiscard]] BandVerdict judge(BandRange range) const {
    return range.size() == 1 || fan.may_share(range) ? BandVerdict::together : BandVerdict::apart;
  }
};

void Fan::part(BandRange whole, PathWavelengths& wavelengths, RayCounts& counts) {
  const std::size_t most = sub_bundles_allowed(whole);
  if (part_by_directions(whole, most, counts)) return;
  strata_.clear();
  for (const BandPart& part : partition_.part(whole, plan_.shares, most, Judge{*this, counts}))
    switch (part.kind) {
    case BandPart::Kind::single:
      add_band(part.bands.first, 1.0f);
      break;
    case BandPart::Kind::shared:
      add_shared(part.bands, wavelengths);
      break;
    case BandPart::Kind::represented:
      strata_.push_back(part.bands);
      break;
    }
}

/// In each range that could not be parted further one band goes on for all.
void Fan::keep_one_of_each_stratum() {
  for (const BandRange& r : strata_) {
    const auto [band, weight] = plan_.shares.keep_one(r, limits_.choice);
    want(band);
    add_band(band, weight);
  }
}

/// The only cell has the only ray, and no hit is needed to know it.
const std::vector<FanCell>& Fan::untraced() {
  cells_.front().hit = nullptr;
  return cells_;
}

const std::vector<FanCell>& Fan::refract(const Bundle& bundle, BandRange bands,
                                         const Limits& limits, PathWavelengths& wavelengths,
                                         RayCounts& counts) {
  prepare(bundle, bands, wavelengths);
  limits_ = limits;
  if (bands.size() == 1) {
    want(bands.first);
    add_band(bands.first, 1.0f);
    return untraced();
  }
  const auto achromatic = [&](MediumId id) { return plan_.medium(id).index.achromatic(); };
  if (achromatic(bundle.hit.medium_before) && achromatic(bundle.hit.medium_after)) {
    add_shared_ray(bands, n_before_[bands.first], n_after_[bands.first]);
    return untraced();
  }
  if (plan_.settings.exact) {
    for (int b = bands.first; b < bands.last; ++b) {
      want(b);
      add_band(b, 1.0f);
    }
  } else {
    if (bundle.has_pixel_footprint)
      part(bands, wavelengths, counts);
    else
      cut(bands);
    keep_one_of_each_stratum();
  }
  trace_new_rays(counts);
  return cells_;
}

void go_on_as(const FanCell& cell, const Bundle& bundle, Bundle& next) {
  next.bands = cell.bands;
  next.path_length = bundle.path_length + bundle.hit.t;
  next.state = *cell.state;
  next.kind = RayKind::refracted;
  next.route = let_through(bundle.route);
  next.traced = cell.hit != nullptr;
  next.straight_on = false;
  next.view = view_on(bundle, RayKind::refracted);
  next.depth = bundle.depth + 1;
  next.panes = bundle.panes;
  next.unseen_length = 0.0;
  next.pdf = 0.0;
  next.nonspecular_bounces = bundle.nonspecular_bounces;
  next.first_nonspecular_depth = bundle.first_nonspecular_depth;
  next.has_pixel_footprint = bundle.has_pixel_footprint;
  next.separation = cell.separation;
  next.divergence = cell.divergence;
  if (cell.hit) next.hit = *cell.hit;
}

} // namespace abbe
