#pragma once

#include "core/bands/band_shares.h"
#include "core/bands/band_table.h"
#include "core/bands/index_table.h"
#include "core/drops/drop_phase_function.h"
#include "core/emitters/environment_map.h"
#include "core/plan/camera_matrices.h"
#include "core/plan/material_plan.h"
#include "core/plan/texture_plan.h"
#include "core/scene/scene.h"
#include "geometry/rays/ray_state.h"
#include "spectral/color.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// Something that emits: what the path gathers from it is summed in band accumulator
/// `accumulator`, weighted per band by `factor`.
struct SourcePlan {
  int accumulator = 0;
  BandTable factor;
  int group = -1; ///< of Plan::light_groups; negative: it gives no light
};

/// Drops at the bands. A phase function is there where the scene has such lights.
struct DropsPlan {
  double extinction_per_unit = 0.0;            ///< per scene unit of length
  std::optional<DropPhaseFunction> under_sun;  ///< for parallel light
  std::optional<DropPhaseFunction> near_light; ///< for lights at a place
};

/// A medium at the bands.
struct MediumPlan {
  IndexTable index;
  BandTable absorption_per_unit; ///< per scene unit of length, with what drops take out of a ray
  bool absorbs = false;
  std::optional<DropsPlan> drops;
};

/// A block of pixels rendered by one thread at a time.
struct Tile {
  PixelWindow window;
  bool empty = false; ///< no shape's bounds reach it, so every ray there meets the background
};

/// Turns one band accumulator into colour and mean radiance.
struct AccumulatorPlan {
  std::vector<float> x, y, z; ///< XYZ weights, padded
  BandTable radiance;         ///< mean spectral radiance per unit of the accumulator
};

/// What the sky does to the film. What passes through the scene to the sky is weighed by the
/// colours that its bands of D65 give, so that it is a factor on the picture behind.
struct SkyPlan {
  bool transparent = false;   ///< what passes to the sky is left out of the picture
  bool lets_through = true;   ///< alpha is not 1 everywhere: some of the sky shows nothing
  bool tints = false;         ///< the colour of what passes is kept too
  std::vector<float> x, y, z; ///< the colour of D65 by band, padded
  Xyz clear{1.0, 1.0, 1.0};   ///< the sums of x, y and z over all bands that can carry light
};

/// What a scene needs under given settings, and what may be left out; computed once.
struct Plan {
  RenderSettings settings;
  BandGrid grid{81};
  std::size_t stride = 0;            ///< padded length of a band array
  int first_band = 0, last_band = 0; ///< only these bands can carry light to an observer
  int live_first = 0, live_last = 0; ///< the same, whether or not skipping is on
  std::vector<float> live;           ///< per band 1 where it can carry light, else 0; padded
  int live_count = 0;                ///< of these; fewer than the range has where lights are lines
  BandShares shares;                 ///< of a path that can follow a few of them alone

  std::vector<std::vector<SpectralLine>> lines; ///< by band; see lines_of_bands
  std::vector<SourcePlan> sources; ///< background, ambient light, the lights, emitting materials
  std::vector<std::string> light_groups; ///< names of sources; those of one name are one group
  /// What layers of ids call what they hold; empty where there are no such layers.
  std::vector<std::string> object_names, material_names;
  std::vector<AccumulatorPlan> accumulators;
  std::optional<EnvironmentMap> environment;
  int environment_source = -1;         ///< index into sources, of its light
  std::vector<MaterialPlan> materials; ///< by MaterialId
  TexturePlans textures;
  std::vector<MediumPlan> media; ///< by MediumId
  MediumPlan vacuum;
  std::vector<IndexTable> layers; ///< of thin films and coats
  bool has_drops = false;         ///< some medium has
  bool has_panes = false;         ///< some material lets light straight through

  SkyPlan sky;

  PixelWindow window; ///< what is rendered
  CameraMatrices camera;
  std::vector<Tile> tiles;
  double quantum = 1.0; ///< of the film's sums

  bool disperses = false; ///< some medium or layer has an index that changes with wavelength
  bool caustics = false;  ///< light-side passes have something to do

  std::vector<std::string> notes; ///< what was found and what is left out, for people

  /// True when no roulette is needed: every band may have a sub-bundle of its own.
  [[nodiscard]] bool follows_all() const {
    return settings.exact || settings.max_fan >= live_count;
  }

  /// The wavelength at the place `offset` (0..1) of a band: a line's own where lines are all the
  /// light in the band.
  [[nodiscard]] double wavelength_nm(int band, double offset) const;

  /// The wavelength at that place of bands [first, last) taken as one.
  [[nodiscard]] double shared_wavelength_nm(int first, int last, double offset) const {
    return grid.lower_nm(first) + offset * (grid.width_nm() * (last - first));
  }

  /// True for a boundary between air and drops, or drops and other drops, that is not to be seen.
  [[nodiscard]] bool unseen(const Hit& hit) const {
    if (!has_drops) return false;
    const auto is_air = [this](MediumId id) { return !id.valid() || media[id.index()].drops; };
    return materials[hit.material.index()].clear && is_air(hit.medium_before) &&
           is_air(hit.medium_after);
  }

  /// False when whatever lies between two places either stops all light or none.
  [[nodiscard]] bool dims_on_the_way() const { return has_drops || has_panes; }

  static constexpr int kBackground = 0, kAmbient = 1;
  [[nodiscard]] int light_source(std::size_t light) const { return 2 + static_cast<int>(light); }
  [[nodiscard]] const MediumPlan& medium(MediumId id) const {
    return id.valid() ? media[id.index()] : vacuum;
  }
};

} // namespace abbe
