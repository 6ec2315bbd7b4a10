#pragma once

#include "core/bsdfs/bsdf.h"
#include "core/planning/make_plan.h"
#include "core/scattering/surface_incidence.h"
#include "tests/render_text.h"

#include <string>
#include <vector>

namespace abbe::test {

/// A surface of a scene's first material between air and the scene's first medium, if it has one.
struct Surface {
  Plan plan;
  PathWavelengths wavelengths;
  Hit hit;
  std::vector<float> ones, reflected, transmitted, f_cos;
  Incidence in;

  explicit Surface(const std::string& text)
      : plan(planned(text)), wavelengths(plan), ones(plan.stride, 1.0f), reflected(plan.stride),
        transmitted(plan.stride), f_cos(plan.stride) {
    wavelengths.begin_path(0.5);
    if (!plan.media.empty()) hit.medium_after = MediumId{0};
    in = surface_incidence(bsdf(), hit, {0, plan.grid.count()}, wavelengths);
    in.live = in.ground = ones.data();
    in.transport = Transport::flux;
  }
  [[nodiscard]] const Bsdf& bsdf() const { return plan.materials.at(0).bsdf; }

private:
  static Plan planned(const std::string& text) {
    const Scene scene = scene_from("integrator path background E 1 bands 5 " + text);
    return make_plan(scene, scene.settings);
  }
};

/// A material for each type of the set.
inline const std::vector<std::string> kOneOfEach = {"cube",
                                                    "diffuse 1 1 1 coat 1.5 cube",
                                                    "reflectivity 0.7 cube",
                                                    "metal Au cube",
                                                    "glass SF11 cube",
                                                    "metal Au roughness 0.5 cube",
                                                    "glass SF11 roughness 0.5 cube",
                                                    "thinGlass 3 SF11 square"};

} // namespace abbe::test
