#pragma once

#include "core/lights/emission_goals.h"
#include "core/lights/illumination.h"
#include "core/lights/light_disc.h"
#include "core/lights/light_reach.h"
#include "core/sampling/sampler.h"

#include <optional>

namespace abbe {

// See light_kinds.h for what these functions answer.

[[nodiscard]] std::optional<dvec3> position(const DirectionalLight& light);
[[nodiscard]] Illumination illumination(const DirectionalLight& light, const dvec3& point);
[[nodiscard]] std::optional<LightDisc> disc(const DirectionalLight& light);
[[nodiscard]] LightReach reach(const DirectionalLight& light, double value);
[[nodiscard]] double power(const DirectionalLight& light, double value, double scene_disc);
[[nodiscard]] double brightest(const DirectionalLight& light, double value, double nearest);
[[nodiscard]] bool endless_flux(const DirectionalLight& light);
[[nodiscard]] double aim(const DirectionalLight& light, double value, EmissionGoals& goals);
[[nodiscard]] std::optional<LightRay> emit(const DirectionalLight& light,
                                           const EmissionGoals& goals, const Sampler& sampler);

} // namespace abbe
