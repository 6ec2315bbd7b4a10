#pragma once

#include "core/plan/plan.h"

#include <optional>
#include <utility>
#include <vector>

namespace abbe {

/// Curves of materials as tables over the plan's bands.
class CurveTables {
public:
  /// With `keep_constant` off constant curves are stored like any others.
  CurveTables(std::vector<double> nm, bool keep_constant)
      : nm_(std::move(nm)), keep_constant_(keep_constant) {}
  [[nodiscard]] const std::vector<double>& wavelengths_nm() const { return nm_; }
  [[nodiscard]] BandTable of(const Curve& curve) const;

private:
  std::vector<double> nm_;
  bool keep_constant_;
};

/// What the mirror image and the refraction of a material are multiplied by.
struct PartFactors {
  double reflectivity = 1.0, transparency = 1.0;
};

/// A material with a mirror image or a refraction that is fainter in every band than the settings
/// ask for is met as one of two: with a chance that is as large as the part is faint it has the
/// part, brighter by as much, and else it has none. So the part keeps its light in the mean.
struct FaintParts {
  double chance = 0.0; ///< of `with`
  PartFactors with, without;
};
[[nodiscard]] std::optional<FaintParts> faint_parts(const Material& material,
                                                    const CurveTables& tables, const Plan& plan);

/// What of a material mirrors or lets light through. Its film, coat or pane becomes a layer of the
/// plan.
[[nodiscard]] Bsdf plan_bsdf(const Material& material, const PartFactors& factors,
                             const CurveTables& tables, Plan& plan);

/// Has the BSDFs with facets find what these return after one reflection; materials and media are
/// planned.
void plan_albedos(Plan& plan);

/// Says what the integrator does not show of rough surfaces.
void note_surfaces(Plan& plan);

} // namespace abbe
