#include "core/film/part_layers.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

constexpr ExtraLayer kViewLayers[] = {ExtraLayer::class_direct, ExtraLayer::class_reflection,
                                      ExtraLayer::class_refraction};
constexpr ExtraLayer kArrivalLayers[] = {ExtraLayer::direct, ExtraLayer::indirect,
                                         ExtraLayer::caustic};

double component(const Xyz& color, std::size_t i) {
  return i == 0 ? color.x : i == 1 ? color.y : color.z;
}

/// In whole quanta, rounded down. What is no number is no part of the whole.
std::int64_t rounded_down(double value, double quantum) {
  const double steps = std::floor(value / quantum);
  return std::abs(steps) <= 0x1p62 ? static_cast<std::int64_t>(steps) : 0;
}

} // namespace

std::string light_layer(const std::string& group) {
  return "light:" + group;
}

std::string unit_layer(const std::string& group) {
  return "light:" + group + ".unit";
}

const char* view_layer(View view) {
  switch (view) {
  case View::direct:
    return "class:direct";
  case View::reflection:
    return "class:reflection";
  case View::refraction:
    return "class:refraction";
  }
  return "";
}

const char* arrival_layer(Arrival arrival) {
  switch (arrival) {
  case Arrival::direct:
    return "direct";
  case Arrival::indirect:
    return "indirect";
  case Arrival::caustic:
    return "caustic";
  }
  return "";
}

std::string band_layer(int band) {
  return "band:" + std::to_string(band);
}

std::string splats_of(const std::string& layer) {
  return layer + ".splats";
}

std::vector<LayerForm> part_layers(const Plan& plan, bool splats) {
  const ExtraLayers& asked = plan.settings.layers;
  std::vector<LayerForm> forms;
  const auto add = [&](LayerForm form, bool splatted) {
    forms.push_back(form);
    if (!splats || !splatted) return;
    form.name = splats_of(form.name);
    form.mean = LayerMean::light_passes;
    forms.push_back(std::move(form));
  };
  const auto colors = [&](const std::string& name, bool splatted) {
    add({name, LayerKind::xyz, plan.quantum}, splatted);
  };
  for (const std::string& group : plan.light_groups) {
    if (asked.has_light(group)) colors(light_layer(group), true);
    if (plan.settings.relightable)
      add({unit_layer(group), LayerKind::bands, plan.quantum, plan.grid.count()}, true);
  }
  for (int i = 0; i < kViews; ++i)
    if (asked.has(kViewLayers[i]))
      colors(view_layer(static_cast<View>(i)), static_cast<View>(i) == View::direct);
  for (int i = 0; i < kArrivals; ++i)
    if (asked.has(kArrivalLayers[i]))
      colors(arrival_layer(static_cast<Arrival>(i)), static_cast<Arrival>(i) != Arrival::direct);
  if (plan.settings.band_images)
    for (int b = 0; b < plan.grid.count(); ++b)
      colors(band_layer(b), true);
  return forms;
}

PartLayers::PartLayers(const Plan& plan, Film& film) : plan_(plan), film_(film) {
  for (const std::string& group : plan.light_groups) {
    groups_.push_back(find(light_layer(group)));
    units_.push_back(find(unit_layer(group)));
  }
  for (std::size_t i = 0; i < views_.size(); ++i)
    views_[i] = find(view_layer(static_cast<View>(i)));
  for (std::size_t i = 0; i < arrivals_.size(); ++i)
    arrivals_[i] = find(arrival_layer(static_cast<Arrival>(i)));
  const auto asked = [](const Ids& ids) { return ids.samples.has_value(); };
  divides_ = std::ranges::any_of(groups_, asked) || std::ranges::any_of(units_, asked) ||
             std::ranges::any_of(views_, asked) || std::ranges::any_of(arrivals_, asked);
  if (!film.find(band_layer(0))) return;
  for (int b = 0; b < plan.grid.count(); ++b)
    bands_.push_back(find(band_layer(b)));
}

PartLayers::Ids PartLayers::find(const std::string& layer) const {
  return {film_.find(layer), film_.find(splats_of(layer))};
}

/// As the beauty rounds it.
ColorSteps PartLayers::steps_of(const Xyz& beauty) const {
  ColorSteps whole;
  for (std::size_t i = 0; i < whole.size(); ++i)
    whole[i] = std::llround(component(beauty, i) / plan_.quantum);
  return whole;
}

void PartLayers::add_bands(const Film::Place& place, const Xyz& beauty,
                           std::span<const Xyz> bands) {
  if (!place.refused) divide(place, steps_of(beauty), bands, bands_);
}

void PartLayers::add(const Film::Place& place, const Xyz& beauty, RadianceParts& parts) {
  if (place.refused) return;
  const ColorSteps whole = steps_of(beauty);
  divide(place, whole, parts.groups(), groups_);
  divide(place, whole, parts.views(), views_);
  divide(place, whole, parts.arrivals(), arrivals_);
  for (std::size_t g = 0; g < units_.size(); ++g)
    if (units_[g].samples) film_.add(*units_[g].samples, place, parts.unit_radiance(g));
}

/// All parts are found, also those that no layer is for, so that a part does not depend on which
/// others are asked for.
void PartLayers::divide(const Film::Place& place, const ColorSteps& whole,
                        std::span<const Xyz> parts, std::span<const Ids> layers) {
  if (parts.empty() || std::ranges::none_of(layers, [](const Ids& l) { return bool(l.samples); }))
    return;
  steps_.assign(parts.size(), {});
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::int64_t rest = whole[i];
    std::size_t largest = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      steps_[p][i] = rounded_down(component(parts[p], i), plan_.quantum);
      rest -= steps_[p][i];
      if (steps_[p][i] > steps_[largest][i]) largest = p;
    }
    steps_[largest][i] += rest;
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (layers[p].samples) film_.add(*layers[p].samples, place, steps_[p]);
}

void PartLayers::splat(int x, int y, const Xyz& color, std::span<const float> unit,
                       const SplatPart& part, double u) {
  for (std::size_t b = 0; b < part.bands.size(); ++b)
    film_.splat(*bands_[b].splats, x, y, part.bands[b], u);
  const auto add = [&](const Ids& ids) {
    if (ids.splats) film_.splat(*ids.splats, x, y, color, u);
  };
  if (part.group >= 0) {
    const auto g = static_cast<std::size_t>(part.group);
    add(groups_[g]);
    if (units_[g].splats) film_.splat(*units_[g].splats, x, y, unit, u);
  }
  add(views_[static_cast<std::size_t>(part.view)]);
  add(arrivals_[static_cast<std::size_t>(part.arrival)]);
}

} // namespace abbe
