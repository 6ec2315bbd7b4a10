#pragma once

#include "core/bands/band_span.h"
#include "core/film/light_class.h"
#include "core/plan/plan.h"
#include "spectral/color.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace abbe {

/// What one camera sample gathers, divided in three ways: by the group of lights that it comes
/// from, by how the camera sees it, and by how it has come there. Each of the three adds up to the
/// sample's colour but for rounding.
class RadianceParts {
public:
  /// Keeps a reference.
  explicit RadianceParts(const Plan& plan);

  void clear();
  /// Says what the light that comes next is a part of.
  void classify(View view, Arrival arrival) {
    view_ = static_cast<std::size_t>(view);
    arrival_ = static_cast<std::size_t>(arrival);
  }
  /// As RadianceSums::add.
  void add(const SourcePlan& source, BandSpan<const float> throughput, const BandTable& reflectance,
           float factor);

  [[nodiscard]] std::span<const Xyz> groups() const { return groups_; }
  [[nodiscard]] std::span<const Xyz> views() const { return views_; }
  [[nodiscard]] std::span<const Xyz> arrivals() const { return arrivals_; }
  /// Of a relightable rendering: the mean spectral radiance per band that a group would bring under
  /// light of equal energy and of value 1. The span is valid until the next call.
  [[nodiscard]] std::span<const float> unit_radiance(std::size_t group);

private:
  void add_unit(std::size_t group, BandSpan<const float> throughput, const BandTable& reflectance,
                float factor);

  const Plan& plan_;
  std::vector<Xyz> groups_;
  std::array<Xyz, kViews> views_;
  std::array<Xyz, kArrivals> arrivals_;
  std::size_t view_ = 0, arrival_ = 0;
  std::vector<double> unit_; ///< by group, Plan::stride bands each; empty unless relightable
  std::vector<float> radiance_;
};

} // namespace abbe
