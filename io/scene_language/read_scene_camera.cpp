// The camera, the film and how it is sampled:
//
//   eye 0 0 5
//   lookAt 0 0 0
//   up 0 1 0
//   fieldOfView 30            ! vertical, in degrees
//   imageSize 640 480
//   crop 100 100 200 150      ! x0 y0 x1 y1, from the top left; x1 and y1 are outside
//   samples 64
//   noise 0.05                ! then 64 samples are the most
//   filter gaussian

#include "io/scene_language/read_scene_state.h"

#include "spectral/band_grid.h"

#include <array>
#include <limits>

namespace abbe {
namespace {

constexpr double kLargestSide = 65536.0;

template <dvec3 Camera::* member>
void read_camera(SceneState& state, Arguments& arguments) {
  state.scene.camera.*member = arguments.vector();
  state.camera_at = arguments.keyword().where;
}

void read_field_of_view(SceneState& state, Arguments& arguments) {
  state.scene.camera.field_of_view_deg =
      arguments.number({"the picture's height as an angle, in degrees", 0.0, 180.0, true});
}

void read_image_size(SceneState& state, Arguments& arguments) {
  constexpr Range kSide{"a number of pixels", 1.0, kLargestSide};
  state.scene.settings.width = static_cast<int>(arguments.whole_number(kSide));
  state.scene.settings.height = static_cast<int>(arguments.whole_number(kSide));
}

void read_crop(SceneState& state, Arguments& arguments) {
  constexpr Range kEdge{"an edge in pixels", 0.0, kLargestSide};
  std::array<int, 4> edges{};
  for (int& edge : edges)
    edge = static_cast<int>(arguments.whole_number(kEdge));
  const PixelWindow window{edges[0], edges[1], edges[2], edges[3]};
  if (window.width() <= 0 || window.height() <= 0)
    throw ReadError(arguments.keyword().where, "the crop holds no pixel",
                    "its right and lower edges must be beyond the left and upper ones",
                    "Give x0 y0 x1 y1 with x0 < x1 and y0 < y1");
  state.scene.settings.crop = window;
  state.crop_at = arguments.keyword().where;
}

void read_samples(SceneState& state, Arguments& arguments) {
  constexpr Range kCount{"a number of samples per pixel", 1.0, std::numeric_limits<int>::max()};
  state.scene.settings.samples_per_pixel = static_cast<int>(arguments.whole_number(kCount));
}

void read_noise(SceneState& state, Arguments& arguments) {
  state.scene.settings.noise = arguments.number({"a relative error", 0.0, 1.0});
}

void read_adaptive(SceneState& state, Arguments& arguments) {
  state.scene.settings.adaptive =
      arguments.choice<AdaptiveSampling>({{"on", AdaptiveSampling::on},
                                          {"off", AdaptiveSampling::off},
                                          {"automatic", AdaptiveSampling::automatic}});
}

void read_bands(SceneState& state, Arguments& arguments) {
  constexpr Range kCount{"a number of bands", 1.0, BandGrid::kMaxCount};
  state.scene.settings.bands = static_cast<int>(arguments.whole_number(kCount));
}

void read_seed(SceneState& state, Arguments& arguments) {
  state.scene.settings.seed = arguments.seed();
}

void read_integrator(SceneState& state, Arguments& arguments) {
  state.scene.settings.integrator =
      arguments.choice<Integrator>({{"whitted", Integrator::whitted}, {"path", Integrator::path}});
}

void read_filter(SceneState& state, Arguments& arguments) {
  state.scene.settings.filter =
      arguments.choice<PixelFilter>({{"box", PixelFilter::box},
                                     {"tent", PixelFilter::tent},
                                     {"gaussian", PixelFilter::gaussian}});
}

template <bool RenderSettings::* setting>
void read_switch(SceneState& state, Arguments& arguments) {
  state.scene.settings.*setting = arguments.on_off();
}

void read_tolerance(SceneState& state, Arguments& arguments) {
  state.scene.settings.tolerance_pixels = arguments.number({"a distance in pixels"});
}

void read_max_fan(SceneState& state, Arguments& arguments) {
  constexpr Range kCount{"a number of rays", 1.0, BandGrid::kMaxCount};
  state.scene.settings.max_fan = static_cast<int>(arguments.whole_number(kCount));
}

constexpr std::array kKeywords{
    SceneKeyword{"eye x y z", read_camera<&Camera::eye>},
    SceneKeyword{"lookAt x y z", read_camera<&Camera::look_at>},
    SceneKeyword{"up x y z", read_camera<&Camera::up>},
    SceneKeyword{"fieldOfView angle", read_field_of_view},
    SceneKeyword{"imageSize width height", read_image_size},
    SceneKeyword{"crop x0 y0 x1 y1", read_crop},
    SceneKeyword{"samples n", read_samples},
    SceneKeyword{"noise x", read_noise},
    SceneKeyword{"adaptive on|off|automatic", read_adaptive},
    SceneKeyword{"bands n", read_bands},
    SceneKeyword{"seed n", read_seed},
    SceneKeyword{"integrator whitted|path", read_integrator},
    SceneKeyword{"filter box|tent|gaussian", read_filter},
    SceneKeyword{"jitter on|off", read_switch<&RenderSettings::jitter>},
    SceneKeyword{"exact on|off", read_switch<&RenderSettings::exact>},
    SceneKeyword{"tolerance pixels", read_tolerance},
    SceneKeyword{"maxFan n", read_max_fan},
};

} // namespace

std::span<const SceneKeyword> camera_keywords() {
  return kKeywords;
}

} // namespace abbe
