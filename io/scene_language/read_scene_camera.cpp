// Where the camera stands and what it looks at:
//
//   eye 0 0 5
//   lookAt 0 0 0
//   up 0 1 0
//   fieldOfView 30            ! vertical, in degrees

#include "io/building/check_reach.h"
#include "io/scene_language/read_scene_state.h"

#include <array>

namespace abbe {
namespace {

template <dvec3 Camera::* member>
void read_camera(SceneState& state, Arguments& arguments) {
  state.scene.camera.*member = arguments.vector();
  state.camera_at = arguments.keyword().where;
}

void read_eye(SceneState& state, Arguments& arguments) {
  read_camera<&Camera::eye>(state, arguments);
  check_reach(arguments.keyword().where, "the eye", reach_of(state.scene.camera.eye));
}

void read_field_of_view(SceneState& state, Arguments& arguments) {
  state.scene.camera.field_of_view_deg =
      arguments.number({"the picture's height as an angle, in degrees", 0.0, 180.0, true});
}

constexpr std::array kCameraKeywords{
    SceneKeyword{"eye x y z", read_eye},
    SceneKeyword{"lookAt x y z", read_camera<&Camera::look_at>},
    SceneKeyword{"up x y z", read_camera<&Camera::up>},
    SceneKeyword{"fieldOfView angle", read_field_of_view},
};

} // namespace

std::span<const SceneKeyword> camera_keywords() {
  return kCameraKeywords;
}

} // namespace abbe
