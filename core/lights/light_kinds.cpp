#include "core/lights/light_kinds.h"

namespace abbe {

std::optional<dvec3> position(const Light& light) {
  return std::visit([](const auto& kind) { return position(kind); }, light.kind);
}

Illumination illumination(const Light& light, const dvec3& point) {
  return std::visit([&](const auto& kind) { return illumination(kind, point); }, light.kind);
}

std::optional<LightDisc> disc(const Light& light) {
  return std::visit([](const auto& kind) { return disc(kind); }, light.kind);
}

LightReach reach(const Light& light, double value) {
  return std::visit([&](const auto& kind) { return reach(kind, value); }, light.kind);
}

double power(const Light& light, double value, double scene_disc) {
  return std::visit([&](const auto& kind) { return power(kind, value, scene_disc); }, light.kind);
}

double brightest(const Light& light, double value, double nearest) {
  return std::visit([&](const auto& kind) { return brightest(kind, value, nearest); }, light.kind);
}

bool endless_flux(const Light& light) {
  return std::visit([](const auto& kind) { return endless_flux(kind); }, light.kind);
}

double aim(const Light& light, double value, EmissionGoals& goals) {
  return std::visit([&](const auto& kind) { return aim(kind, value, goals); }, light.kind);
}

std::optional<LightRay> emit(const Light& light, const EmissionGoals& goals,
                             const Sampler& sampler) {
  return std::visit([&](const auto& kind) { return emit(kind, goals, sampler); }, light.kind);
}

} // namespace abbe
