#pragma once

#include "core/bundles/bundle.h"
#include "core/bundles/statistics.h"
#include "geometry/world/world.h"

namespace abbe {

// A path has two kinds of steps. *Shading* says what happens where a bundle's ray has met a
// surface: it adds light to the film and leaves bundles that wait, most of them untraced.
// *Extending* finds what a waiting bundle's ray meets, and does nothing else; so any number of
// bundles may be extended together, in any order. A bundle of a Fan that had to trace rays to learn
// which bands may share one brings its hit along, and is not traced again.

/// Finds what the bundle's ray meets next, unless that is known.
inline void extend(Bundle& bundle, const World& world, RayCounts& counts) {
  if (bundle.traced) return;
  if (bundle.straight_on)
    world.find_closest(bundle.state, kInfinity, bundle.passage, bundle.hit);
  else
    world.find_closest(bundle.state, bundle.hit);
  counts.add(bundle.kind, bundle.state);
  bundle.traced = true;
}

} // namespace abbe
