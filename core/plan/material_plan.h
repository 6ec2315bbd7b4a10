#pragma once

#include "core/bands/band_table.h"
#include "core/bsdfs/bsdf.h"
#include "core/bsdfs/phong.h"
#include "geometry/rays/ray_state.h"

#include <optional>

namespace abbe {

/// Two materials in one surface, by index into Plan::materials: a ray meets one of them.
struct MixturePlan {
  int first = -1, second = -1;
  double share = 0.0; ///< the chance of the first
  BsdfFacts facts;    ///< of either: paths follow what one of them does
  bool lit = false;   ///< either is
};

/// A material at the bands: light of its own, and the thesis's sum of Lambert's part, Phong's
/// highlight, and a BSDF that mirrors or lets light through.
struct MaterialPlan {
  BandTable ambient;
  int emission_source = -1; ///< index into Plan::sources; negative: emits nothing
  bool emits_behind = true;
  BandTable diffuse;
  int texture = -1; ///< index into TexturePlans::textures, in place of `diffuse`; negative: none
  Phong phong;
  Bsdf bsdf;
  bool clear = false;                 ///< lets everything through and adds nothing
  std::optional<MixturePlan> mixture; ///< in place of all else; see part_of

  [[nodiscard]] BsdfFacts facts() const { return mixture ? mixture->facts : facts_of(bsdf); }
  /// True when lights reach it: it has a diffuse part or a highlight.
  [[nodiscard]] bool lit() const {
    return mixture ? mixture->lit : !diffuse.zero() || phong.present() || texture >= 0;
  }
  /// True when a ray that meets the surface sees light that it gives off.
  [[nodiscard]] bool emits(const Hit& hit) const {
    return emission_source >= 0 && (hit.entering || emits_behind);
  }
};

} // namespace abbe
