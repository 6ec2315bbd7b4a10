#pragma once

#include "core/plan/plan.h"

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

/// What of a material mirrors or lets light through. Its film, coat or pane becomes a layer of the
/// plan. A part that is below the least that the settings follow is absent.
[[nodiscard]] Bsdf plan_bsdf(const Material& material, const CurveTables& tables, Plan& plan);

/// Has the BSDFs with facets find what these return after one reflection; materials and media are
/// planned.
void plan_albedos(Plan& plan);

/// Says what the integrator does not show of rough surfaces.
void note_surfaces(Plan& plan);

} // namespace abbe
