#pragma once

#include "core/lights/directional_light.h"
#include "core/lights/point_light.h"
#include "core/lights/spot_light.h"
#include "core/lights/sun_light.h"

namespace abbe {

// What is asked of a light, whatever its kind. Each question is one visit without a default, so
// each kind answers all of them, by functions of the same name that take the kind. The compiler
// lists what a new kind lacks in light_kinds.cpp. The visits take a Light and not a LightKind: any
// kind turns into a LightKind by itself, and a function that is missing would call the visit again.

/// Where a light stands; none for light that comes from infinitely far away.
[[nodiscard]] std::optional<dvec3> position(const Light& light);

/// How a light shines on a point.
[[nodiscard]] Illumination illumination(const Light& light, const dvec3& point);

/// The disc of directions that a light fills, seen from anywhere; none for a light that is seen in
/// one direction.
[[nodiscard]] std::optional<LightDisc> disc(const Light& light);

/// What a light of this value can send to a place, for the choice among lights.
[[nodiscard]] LightReach reach(const Light& light, double value);

/// What light paths choose their lights in proportion to: the flux that a light of this value sends
/// out, or sends through a disc about the scene, of the given area, where it does not fall off with
/// distance.
[[nodiscard]] double power(const Light& light, double value, double scene_disc);

/// The most that a light of this value counts for when the film's quantum is chosen. Lights that
/// fall off count at the distance `nearest`, or not at all where that is 0.
[[nodiscard]] double brightest(const Light& light, double value, double nearest);

/// True for a light at a place whose light does not fall off with distance: it has no flux.
[[nodiscard]] bool endless_flux(const Light& light);

/// The flux that a light of this value, which has one, sends to the goals. Goals that it does not
/// shine on are removed.
[[nodiscard]] double aim(const Light& light, double value, EmissionGoals& goals);

/// A ray of the light towards its goals. Nothing where it sends no light.
[[nodiscard]] std::optional<LightRay> emit(const Light& light, const EmissionGoals& goals,
                                           const Sampler& sampler);

} // namespace abbe
