// What makes the camera more than a pinhole: a thin lens,
//
//   focalLength 50  fNumber 2     ! in mm; or: aperture 0.5, in the scene's unit
//   focusDistance 12
//
// or a real one, from a file:
//
//   lensFile lenses/double_gauss_f2.lens
//   filmHeight 24
//   fNumber 4

#include "core/cameras/focus_distance.h"
#include "core/cameras/focused_lens.h"
#include "io/libraries/read_lens_prescription.h"
#include "io/scene_language/read_scene_state.h"
#include "spectral/fraunhofer.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace abbe {
namespace {

namespace fs = std::filesystem;

void read_aperture(SceneState& state, Arguments& arguments) {
  state.camera_lens.aperture = arguments.number({"the diameter of the entrance pupil"});
  state.camera_lens.f_number.reset();
}

void read_f_number(SceneState& state, Arguments& arguments) {
  const double n = arguments.number({.meaning = "focal length by aperture", .open = true});
  state.camera_lens.f_number = {n, arguments.keyword().where};
}

void read_focal_length(SceneState& state, Arguments& arguments) {
  const double mm = arguments.number({.meaning = "a length in mm", .open = true});
  state.camera_lens.focal_length_mm = {mm, arguments.keyword().where};
}

void read_focus_distance(SceneState& state, Arguments& arguments) {
  state.camera_lens.focus_at = arguments.keyword().where;
  if (is_word(arguments.reader().peek(), "inf")) {
    arguments.reader().next();
    state.camera_lens.focus_distance = std::numeric_limits<double>::infinity();
    return;
  }
  state.camera_lens.focus_distance =
      arguments.number({.meaning = "how far away is sharp", .open = true});
}

void read_film_height(SceneState& state, Arguments& arguments) {
  state.camera_lens.film_height_mm =
      arguments.number({.meaning = "the picture's height on the film, in mm", .open = true});
  state.camera_lens.film_height_at = arguments.keyword().where;
}

void read_film_distance(SceneState& state, Arguments& arguments) {
  state.camera_lens.film_distance_mm =
      arguments.number({.meaning = "a length in mm", .open = true});
  state.camera_lens.film_distance_at = arguments.keyword().where;
}

void read_lens_coating(SceneState& state, Arguments& arguments) {
  state.camera_lens.coating = arguments.on_off();
  state.camera_lens.coating_at = arguments.keyword().where;
}

void read_lens_file(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a file");
  const fs::path file =
      input_file(state.files, name, fs::path(name.where.file).parent_path(),
                 {"file", "lenses are found relative to the file that names them"});
  state.camera_lens.prescription = read_lens_prescription(file, state.warn);
  state.camera_lens.lens_at = arguments.keyword().where;
}

[[noreturn]] void fail_without(const SourcePosition& where, std::string_view keyword,
                               std::string_view missing) {
  throw ReadError(where, fmt::format("{} stands without {}", keyword, missing),
                  "it says nothing alone", fmt::format("Add {}, or remove it", missing));
}

void finish_real_lens(SceneState& state) {
  CameraLensState& given = state.camera_lens;
  if (given.focal_length_mm)
    throw ReadError(given.focal_length_mm->where, "focalLength stands beside lensFile",
                    "the lens of the file has its own", "Remove one of them");
  if (given.film_distance_at && given.focus_at)
    throw ReadError(*given.film_distance_at, "filmDistance stands beside focusDistance",
                    "both say where the film is", "Remove one of them");
  const double mm_per_unit = state.scene.mm_per_unit;
  RealLens lens{std::move(*given.prescription), given.aperture,       given.focus_distance,
                given.film_distance_mm,         given.film_height_mm, given.coating};
  if (given.f_number)
    lens.aperture = LensSystem(lens.prescription).paraxial(kLineD_nm).focal_length() /
                    given.f_number->value / mm_per_unit;
  try {
    (void)focused_lens(lens, state.scene.camera, mm_per_unit);
  } catch (const std::invalid_argument& error) {
    throw ReadError(
        *given.lens_at, fmt::format("the lens {} cannot be set so", lens.prescription.name),
        error.what(), "Check the aperture, the focus (that of lookAt unless given) and the unit");
  }
  state.scene.camera.kind = std::move(lens);
}

void finish_thin_lens(SceneState& state) {
  const CameraLensState& given = state.camera_lens;
  Camera& camera = state.scene.camera;
  ThinLens lens{given.aperture, given.focus_distance};
  if (given.film_distance_at) fail_without(*given.film_distance_at, "filmDistance", "lensFile");
  if (given.coating_at) fail_without(*given.coating_at, "lensCoating", "lensFile");
  if (!given.focal_length_mm) {
    if (given.f_number) fail_without(given.f_number->where, "fNumber", "focalLength or lensFile");
    if (given.film_height_at)
      fail_without(*given.film_height_at, "filmHeight", "focalLength or lensFile");
    if (lens.aperture > 0.0) camera.kind = lens;
    return;
  }
  const auto& [focal_length, where] = *given.focal_length_mm;
  if (!given.f_number && !given.film_height_at)
    fail_without(where, "focalLength", "fNumber or filmHeight");
  if (given.f_number)
    lens.aperture = focal_length / given.f_number->value / state.scene.mm_per_unit;
  if (lens.aperture > 0.0) camera.kind = lens;
  if (!given.film_height_at) return;
  const double focus = focus_distance(camera, given.focus_distance) * state.scene.mm_per_unit;
  if (!(focus > focal_length))
    throw ReadError(where, "the camera is focused nearer than its focal length",
                    fmt::format("{:g} mm; there is no image then", focus),
                    "Check focusDistance, or lookAt, and the unit");
  const double film_distance = focal_length / (1.0 - focal_length / focus);
  camera.field_of_view_deg =
      360.0 / std::numbers::pi * std::atan(0.5 * *given.film_height_mm / film_distance);
}

constexpr std::array kCameraLensKeywords{
    SceneKeyword{"aperture diameter", read_aperture},
    SceneKeyword{"fNumber N", read_f_number},
    SceneKeyword{"focalLength mm", read_focal_length},
    SceneKeyword{"focusDistance distance|inf", read_focus_distance},
    SceneKeyword{"lensFile FILE", read_lens_file},
    SceneKeyword{"filmHeight mm", read_film_height},
    SceneKeyword{"filmDistance mm", read_film_distance},
    SceneKeyword{"lensCoating on|off", read_lens_coating},
};

} // namespace

std::span<const SceneKeyword> camera_lens_keywords() {
  return kCameraLensKeywords;
}

void finish_camera_lens(SceneState& state) {
  if (state.camera_lens.prescription)
    finish_real_lens(state);
  else
    finish_thin_lens(state);
}

} // namespace abbe
