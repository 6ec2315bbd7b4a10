#pragma once

#include "core/film/film.h"
#include "core/plan/plan.h"

#include <cstdint>
#include <optional>

namespace abbe {

// How many bytes a rendering takes at its peak, beside the scene and what threads have of their
// own: its film, what adaptive sampling knows of each pixel, its tiles, and the largest of the
// pictures that are made of the film.

[[nodiscard]] std::uint64_t memory_need(const Scene& scene, const Plan& plan,
                                        const std::optional<BandPlace>& bands);
/// How many bytes of its sums lie in files.
[[nodiscard]] std::uint64_t disk_need(const Scene& scene, const Plan& plan,
                                      const std::optional<BandPlace>& bands);
/// The least that it can be, as far as settings alone tell, which have no plan yet.
[[nodiscard]] std::uint64_t least_memory_need(const RenderSettings& settings);

/// What the plan of a scene takes at the least, which can be told before it is made: its materials,
/// and the tables of indices of its media and layers.
[[nodiscard]] std::uint64_t least_plan_need(const Scene& scene, const RenderSettings& settings);

} // namespace abbe
