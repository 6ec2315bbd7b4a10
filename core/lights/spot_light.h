#pragma once

#include "core/lights/emission_goals.h"
#include "core/lights/illumination.h"
#include "core/lights/light_disc.h"
#include "core/lights/light_reach.h"
#include "core/sampling/sampler.h"

#include <optional>

namespace abbe {

// See light_kinds.h for what these functions answer.

[[nodiscard]] std::optional<dvec3> position(const SpotLight& light);
[[nodiscard]] Illumination illumination(const SpotLight& light, const dvec3& point);
[[nodiscard]] std::optional<LightDisc> disc(const SpotLight& light);
[[nodiscard]] LightReach reach(const SpotLight& light, double value);
[[nodiscard]] double power(const SpotLight& light, double value, double scene_disc);
[[nodiscard]] double brightest(const SpotLight& light, double value, double nearest);
[[nodiscard]] bool endless_flux(const SpotLight& light);
[[nodiscard]] double aim(const SpotLight& light, double value, EmissionGoals& goals);
[[nodiscard]] std::optional<LightRay> emit(const SpotLight& light, const EmissionGoals& goals,
                                           const Sampler& sampler);

} // namespace abbe
