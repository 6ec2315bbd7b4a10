#include "core/lights/light_hierarchy.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace abbe {
namespace {

/// A number just below 1: what is left of one in [0, 1) after a choice stays there.
constexpr double kBelowOne = 1.0 - 0x1p-53;

dvec3 middle(const Bounds& box) {
  return 0.5 * (box.lower + box.upper);
}

/// What it costs to have these lights in one node: how much they give, how far apart they stand and
/// how differently they shine.
double cost(const LightReach& reach, double least_size2) {
  const dvec3 size = reach.box().upper - reach.box().lower;
  return reach.strength() * std::max(glm::dot(size, size), least_size2) * reach.solid_angle();
}

struct Cut {
  int axis = 0;
  double place = 0.0; ///< lights whose middle lies below go to the left
  double cost = std::numeric_limits<double>::infinity();
};

/// The best of the cuts at twelfths of the extent of all middles.
Cut best_cut(std::span<const LightReach> lights, std::span<const int> indices) {
  constexpr std::size_t kBins = 12;
  Bounds middles;
  for (const int i : indices) {
    const dvec3 m = middle(lights[static_cast<std::size_t>(i)].box());
    middles = middles.joined({m, m});
  }
  const dvec3 extent = middles.upper - middles.lower;
  const double least_size2 = 1e-12 * glm::dot(extent, extent);
  Cut best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(extent[axis] > 0.0)) continue;
    std::array<std::optional<LightReach>, kBins> bins;
    for (const int i : indices) {
      const LightReach& light = lights[static_cast<std::size_t>(i)];
      const double part = (middle(light.box())[axis] - middles.lower[axis]) / extent[axis];
      auto& bin = bins[std::min(static_cast<std::size_t>(part * kBins), kBins - 1)];
      bin = bin ? bin->joined(light) : light;
    }
    std::array<double, kBins> above{}; // the cost of the bins from each one on
    std::optional<LightReach> sum;
    for (std::size_t b = kBins; b-- > 1;) {
      if (bins[b]) sum = sum ? sum->joined(*bins[b]) : *bins[b];
      above[b] = sum ? cost(*sum, least_size2) : std::numeric_limits<double>::infinity();
    }
    sum.reset();
    for (std::size_t b = 0; b + 1 < kBins; ++b) {
      if (bins[b]) sum = sum ? sum->joined(*bins[b]) : *bins[b];
      if (!sum) continue;
      const double both = cost(*sum, least_size2) + above[b + 1];
      if (both < best.cost)
        best = {axis, middles.lower[axis] + extent[axis] * static_cast<double>(b + 1) / kBins,
                both};
    }
  }
  return best;
}

} // namespace

LightHierarchy::LightHierarchy(std::span<const LightReach> lights)
    : leaves_(lights.size(), kNone), distant_irradiance_(lights.size(), 0.0) {
  std::vector<int> near;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (!lights[i].is_distant()) {
      near.push_back(static_cast<int>(i));
      continue;
    }
    distant_.push_back(static_cast<int>(i));
    distant_irradiance_[i] = lights[i].strength();
    all_distant_ += lights[i].strength();
  }
  nodes_.reserve(2 * near.size());
  if (near.empty()) return;
  build(lights, near, kNone);
  choose_front();
}

/// Opens the node that is largest for what it gives, again and again.
void LightHierarchy::choose_front() {
  const auto worth = [&](int id) {
    const LightReach& reach = node(id).reach;
    const dvec3 size = reach.box().upper - reach.box().lower;
    return node(id).light == kNone ? reach.strength() * glm::length(size) : -1.0;
  };
  front_ = {0};
  while (front_.size() < kFront) {
    const auto widest = std::ranges::max_element(front_, {}, worth);
    if (worth(*widest) < 0.0) break; // all are lights
    const Node& opened = node(*widest);
    *widest = opened.left;
    front_.push_back(opened.right);
  }
  for (const int id : front_)
    nodes_[static_cast<std::size_t>(id)].in_front = true;
}

int LightHierarchy::build(std::span<const LightReach> lights, std::span<int> indices, int parent) {
  const int id = static_cast<int>(nodes_.size());
  nodes_.push_back({lights[static_cast<std::size_t>(indices.front())], parent});
  const auto self = [&]() -> Node& { return nodes_[static_cast<std::size_t>(id)]; };
  if (indices.size() == 1) {
    self().light = indices.front();
    leaves_[static_cast<std::size_t>(indices.front())] = id;
    return id;
  }
  const Cut cut = best_cut(lights, indices);
  auto border = std::ranges::partition(indices, [&](int i) {
                  return middle(lights[static_cast<std::size_t>(i)].box())[cut.axis] < cut.place;
                }).begin();
  // Lights at one place, or all but at one, are halved by their number.
  if (border == indices.begin() || border == indices.end())
    border = indices.begin() + static_cast<std::ptrdiff_t>(indices.size() / 2);
  const auto left_size = static_cast<std::size_t>(border - indices.begin());
  const int left = build(lights, indices.first(left_size), id);
  const int right = build(lights, indices.subspan(left_size), id);
  self().reach = node(left).reach.joined(node(right).reach);
  self().left = left;
  self().right = right;
  return id;
}

LightHierarchy::Weights LightHierarchy::weigh(const dvec3& place) const {
  Weights weights;
  for (std::size_t i = 0; i < front_.size(); ++i)
    weights.all += weights.front[i] = node(front_[i]).reach.at(place);
  weights.all += all_distant_;
  return weights;
}

/// The chance of the left half; negative where none of both is lit by.
double LightHierarchy::left_part(const Node& inner, const dvec3& place) const {
  const double left = node(inner.left).reach.at(place);
  const double both = left + node(inner.right).reach.at(place);
  return both > 0.0 ? left / both : -1.0;
}

std::optional<LightHierarchy::Chosen> LightHierarchy::choose(const dvec3& place, double u) const {
  const Weights weights = weigh(place);
  if (!(weights.all > 0.0)) return std::nullopt;
  double rest = u * weights.all;
  for (const int light : distant_) {
    const double irradiance = distant_irradiance_[static_cast<std::size_t>(light)];
    if (rest < irradiance) return Chosen{light, irradiance / weights.all};
    rest -= irradiance;
  }
  // Rounding may leave a little over: it goes to the last that gives anything.
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < front_.size(); ++i) {
    if (!(weights.front[i] > 0.0)) continue;
    last = i;
    if (rest < weights.front[i]) break;
    rest -= weights.front[i];
  }
  if (!last)
    return Chosen{distant_.back(),
                  distant_irradiance_[static_cast<std::size_t>(distant_.back())] / weights.all};
  u = std::min(rest / weights.front[*last], kBelowOne);
  double chance = weights.front[*last] / weights.all;
  const Node* at = &node(front_[*last]);
  while (at->light == kNone) {
    const double part = left_part(*at, place);
    if (part < 0.0) return std::nullopt;
    const bool goes_left = u < part;
    const double taken = goes_left ? part : 1.0 - part;
    u = std::min((goes_left ? u : u - part) / taken, kBelowOne);
    chance *= taken;
    at = &node(goes_left ? at->left : at->right);
  }
  return Chosen{at->light, chance};
}

double LightHierarchy::chance(int light, const dvec3& place) const {
  const Weights weights = weigh(place);
  if (!(weights.all > 0.0)) return 0.0;
  const int leaf = leaves_[static_cast<std::size_t>(light)];
  if (leaf == kNone) return distant_irradiance_[static_cast<std::size_t>(light)] / weights.all;
  double chance = 1.0;
  int id = leaf;
  for (; !node(id).in_front; id = node(id).parent) {
    const Node& above = node(node(id).parent);
    const double part = left_part(above, place);
    if (part < 0.0) return 0.0;
    chance *= id == above.left ? part : 1.0 - part;
  }
  const auto i = static_cast<std::size_t>(std::ranges::find(front_, id) - front_.begin());
  return chance * weights.front[i] / weights.all;
}

} // namespace abbe
