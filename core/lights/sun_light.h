#pragma once

#include "core/lights/emission_goals.h"
#include "core/lights/illumination.h"
#include "core/lights/light_disc.h"
#include "core/lights/light_reach.h"
#include "core/sampling/sampler.h"

#include <optional>

namespace abbe {

// See light_kinds.h for what these functions answer.

[[nodiscard]] std::optional<dvec3> position(const SunLight& light);
[[nodiscard]] Illumination illumination(const SunLight& light, const dvec3& point);
[[nodiscard]] std::optional<LightDisc> disc(const SunLight& light);
[[nodiscard]] LightReach reach(const SunLight& light, double value);
[[nodiscard]] double power(const SunLight& light, double value, double scene_disc);
[[nodiscard]] double brightest(const SunLight& light, double value, double nearest);
[[nodiscard]] bool endless_flux(const SunLight& light);
[[nodiscard]] double aim(const SunLight& light, double value, EmissionGoals& goals);
[[nodiscard]] std::optional<LightRay> emit(const SunLight& light, const EmissionGoals& goals,
                                           const Sampler& sampler);

} // namespace abbe
